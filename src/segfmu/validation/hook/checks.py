"""What a crane with a hook does not have, and which values of a mission do not fit one."""

from __future__ import annotations

from typing import TYPE_CHECKING

from segfmu.errors import InputError

if TYPE_CHECKING:
    from segfmu.validation.files.crane_file import CraneFile
    from segfmu.validation.files.mission import Mission

# hook over load; the fast swing is as the root of it faster than the slow one
LIGHTEST = 1e-4
# keys of [controller] that the feedback with a hook has
TAKEN = ("enabled", "source", "sample_time", "fade")


def check_crane(crane: CraneFile) -> None:
    """Refuse what a crane with a hook cannot do.

    Raises
    ------
    InputError
        For the first key that does not fit.
    """
    assert crane.hook is not None
    least = LIGHTEST * crane.payload_mass
    if crane.hook.mass < least:
        raise InputError(
            f"hook.mass: {crane.hook.mass:g} kg swings against a load of {crane.payload_mass:g} kg "
            f"too fast to be followed; give it {least:g} kg or more, or leave [hook] out"
        )
    own = crane.controller
    if own.source == "state":
        raise InputError(
            'controller.source: with a hook it is "measured", as no gains are by the true state; '
            "leave it out"
        )
    for name, field in type(own).model_fields.items():
        if name not in TAKEN and getattr(own, name) != field.default:
            raise InputError(
                f"controller.{name}: the feedback with a hook is a design of its own, which takes "
                f"{', '.join(TAKEN)}; leave it out"
            )
    if crane.travel.slack != "error":
        raise InputError(
            'travel.slack: with a hook a slack rope or sling is an error; use "error", or leave it '
            "out"
        )


def check_mission(mission: Mission) -> None:
    """Refuse what a mission asks of a hook in vain.

    Raises
    ------
    InputError
        For the first key that does not fit.
    """
    assert mission.crane.hook is not None
    _check_smoothness(mission)
    if mission.simulation.feedback_source == "state":
        raise InputError(
            'simulation.feedback_source: with a hook it is "measured"; leave it out'
        )
    for number, box in enumerate(mission.obstacles, 1):
        if box.rope:
            raise InputError(
                f"obstacles.{number}.rope: rope and sling of a crane with a hook are not judged; "
                "write rope = false, and a margin that keeps them off"
            )
    for i, entry in enumerate(mission.waypoints, 1):
        if entry.position[2] >= -mission.crane.hook.sling:
            raise InputError(
                f"waypoints.{i}.position: z {entry.position[2]} m puts the hook at the trolley or "
                f"above; z must be below -{mission.crane.hook.sling:g} m, the sling (hook.sling of "
                "the crane)"
            )


def _check_smoothness(mission: Mission) -> None:
    own = mission.smoothness
    if own == 6:
        return
    way = "write smoothness = 6, or leave it out"
    if own < 5:
        raise InputError(
            f"smoothness: {own} is too low for a hook, as the carriages' velocities need the fifth "
            f"derivative of the load's position; {way}"
        )
    driven = (mission.simulation.drive or mission.simulated.drive) == "velocity"
    if not driven or mission.build_bounds() is not None:
        why = "the bounds of drives are judged by" if driven else "force drives need"
        raise InputError(
            f"smoothness: 5 is too low, as {why} forces, which with a hook need the sixth "
            f"derivative of the load's position; {way}"
        )
