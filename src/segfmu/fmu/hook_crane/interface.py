"""Interface of HookCrane: that of GantryCrane, with a hook between rope and load."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

from segfmu.crane.hook.feedback import HookWeights
from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.hook import hook_parameters
from segfmu.fmu.standard.spec import (
    Spec,
    Variable,
    derivative,
    output,
    parameter,
    signal,
    started,
    triple,
)
from segfmu.kernels.hook.records import HookWeighing

SLING = ("sling.x.angle", "sling.y.angle", "sling.x.rate", "sling.y.rate")
UNITS = ("rad", "rad", "rad/s", "rad/s")
ACCELERATIONS = ("sling.x.acceleration", "sling.y.acceleration")


@cache
def spec() -> Spec:
    """The interface of HookCrane."""
    plain = gantry_crane.spec()
    inputs = plain.where("input")
    rest = tuple(v for v in plain.variables if v.causality != "input")
    own = replace(
        plain,
        name="HookCrane",
        description="Dynamics of a gantry crane whose load hangs by a sling on a hook, a double "
        "pendulum in space, from Lagrange's equations; drives, friction, end stops, sensors, wind "
        "and payload changes as on a real crane, ideal by default",
        variables=(
            *inputs, *_inputs(), *rest, *_outputs(), *hook_parameters("true crane"), *_weights(),
        ),
    )
    return started(
        held(own), {"feedback.enabled": False, "feedback.source": "measured"}
    )


def _inputs() -> list[Variable]:
    return [
        signal(f"reference.{name}", unit, f"reference of {name}, for the start")
        for name, unit in zip(SLING, UNITS, strict=True)
    ]


def _outputs() -> list[Variable]:
    rows = [
        output(name, unit, f"true {name}", start=0.0)
        for name, unit in zip(SLING, UNITS, strict=True)
    ]
    rows += triple("hook.position", "m", "true position of the hook")
    rows += triple("hook.velocity", "m/s", "true velocity of the hook")
    rows.append(output("sling.tension", "N", "tension of the sling"))
    rows += [
        output(f"sway.frequency.{n}", "rad/s", f"natural frequency of hook and load, {text}, for "
               "the present rope and small swings below a carriage at rest")
        for n, text in (("slow", "to the same side"), ("fast", "to opposite sides"))
    ]
    return rows


def _weights() -> list[Variable]:
    """Of the feedback of measured signals: its sling, and what `HookWeights` has."""
    chosen = HookWeights()
    sling = parameter(
        "feedback.sling", 0.0, "m",
        "length of the sling that the feedback is designed for; 0: hook.sling", minimum=0.0,
    )
    return [sling] + [
        parameter(
            variable, getattr(chosen, variable.rpartition(".")[2]), None,
            f"feedback of source measured, dimensionless: {field.meaning}", minimum=0.0,
        )
        for field in HookWeighing.FIELDS.values() for variable in field.variables
    ]


def held(own: Spec) -> Spec:
    """Add start values of the inputs that hold the crane in its initial position.

    If an importer connects nothing, the load hangs at rest instead of falling.
    """
    starts = {v.name: v.start for v in own.variables}
    mass = float(starts["crane.payload_mass"] or 0.0) + float(starts["hook.mass"] or 0.0)
    depth = float(starts["rope.length"] or 0.0) + float(starts["hook.sling"] or 0.0)
    return started(gantry_crane.held(own), {
        "force.hoist": -mass * float(starts["crane.gravity"] or 0.0),
        "reference.load.position.z": -depth,
    })


def native_spec(own: Spec | None = None) -> Spec:
    """The interface of the native HookCrane, from that of `spec` or with other start values.

    Raises
    ------
    InputError
        For weights for which no design of the gantry crane's feedback exists.
    """
    plain = gantry_crane.native_spec(own or spec())
    accelerations = [
        Variable(n, "Real", "local", "continuous", f"acceleration of {n.rpartition('.')[0]}",
                 unit="rad/s2")
        for n in ACCELERATIONS
    ]
    rates = [
        derivative(angle, plain.variable(rate))
        for angle, rate in zip(SLING[:2], SLING[2:], strict=True)
    ]
    states = (
        *plain.states, *zip(SLING, (*(r.name for r in rates), *ACCELERATIONS), strict=True)
    )
    *variables, last = plain.variables
    # hook and sling are not in the gantry crane's derivatives
    return replace(
        plain, variables=(*variables, *accelerations, *rates, last), states=states,
        dependencies=_dependencies(plain), orders=0, partials=(), terminals=(),
    )


def _dependencies(plain: Spec) -> tuple[tuple[str, tuple[str, ...]], ...]:
    """Those of the gantry crane, where what depends on the rope's sway does on the sling's too."""
    found = {
        name: (*known, *SLING) if "sway.x.angle" in known and len(known) > 1 else known
        for name, known in plain.dependencies
    }
    places = dict(plain.dependencies)["load.position.x"]
    acting = found["sway.x.acceleration"]
    own = {name: (name,) for name in SLING} | dict.fromkeys(ACCELERATIONS, acting)
    own |= {f"der({angle})": (rate,) for angle, rate in zip(SLING[:2], SLING[2:], strict=True)}
    for axis in "xyz":
        own[f"hook.position.{axis}"] = places
        own[f"hook.velocity.{axis}"] = dict(plain.dependencies)["load.velocity.x"]
    own["sling.tension"] = acting
    own |= {f"sway.frequency.{name}": ("rope.length", "time") for name in ("slow", "fast")}
    return tuple((found | own).items())
