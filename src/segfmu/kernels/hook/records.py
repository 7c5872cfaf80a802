"""Records of a crane whose load hangs by a sling on a hook."""

from segfmu.kernels.crane.records import AXES, DRIVES, Coordinates, Masses
from segfmu.kernels.records import Record, field


class HookMasses(Masses):
    """Masses and gravity, hook and sling."""

    HOOK_MASS = field("mass of the hook", "kg", variables=("hook.mass",))
    SLING = field("length of the sling, from hook to load", "m", variables=("hook.sling",))


class HookCoordinates(Coordinates):
    """Generalised coordinates; angles of the rope are those of the hook below the trolley."""

    SLING_ANGLE = field(
        "angles of the sling against the vertical, as those of the rope", "rad", size=2,
        variables=("sling.x.angle", "sling.y.angle"),
    )


class HookState(HookCoordinates):
    """State of crane, hook and load."""

    VELOCITY = field(
        "rates of the positions", "m/s", size=3,
        variables=("bridge.velocity", "trolley.velocity", "rope.velocity"),
    )
    RATE = field(
        "rates of the rope's angles", "rad/s", size=2, variables=("sway.x.rate", "sway.y.rate")
    )
    SLING_RATE = field(
        "rates of the sling's angles", "rad/s", size=2, variables=("sling.x.rate", "sling.y.rate")
    )


class HookInverse(Record):
    """Results of the flat inverse."""

    FORCE = field(
        "forces of the drives", "N", size=3, variables=[f"force.{d}" for d in DRIVES]
    )
    STATE = field(
        "state of crane, hook and load", size=HookState.SIZE, of=HookState,
        variables=[f"reference.{v}" for f in HookState.FIELDS.values() for v in f.variables],
    )
    ACCELERATION = field(
        "second derivatives of the coordinates", size=HookCoordinates.SIZE,
        variables=[*(f"reference.{a}.acceleration" for a in AXES), *("",) * 4],
    )
