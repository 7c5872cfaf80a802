"""Interface of Pendulum: the trolley's acceleration and the rope are inputs."""

from __future__ import annotations

from dataclasses import replace

from segfmu.fmu.standard.spec import Spec, Variable, derivative, output, parameter, time

INPUTS = (
    ("reference.bridge.acceleration", 0.0, "m/s2", "acceleration of the trolley"),
    ("reference.rope.length", 0.5, "m", "length of the rope"),
    ("reference.rope.velocity", 0.0, "m/s", "velocity of the rope, positive pays out"),
)


def spec() -> Spec:
    """The interface on either backend."""
    return Spec(
        "Pendulum", "A load on a rope below a trolley that moves along a line",
        (
            *(
                Variable(name, "Real", "input", "continuous", text, start, unit)
                for name, start, unit, text in INPUTS
            ),
            output("sway.angle", "rad", "sway angle", start=0.0),
            output("sway.rate", "rad/s", "its rate", start=0.0),
            output("load.offset", "m", "place of the load, from that of the trolley"),
            parameter("crane.gravity", 9.81, "m/s2", "gravity", minimum=1e-9),
        ),
        stop_time=5.0, step_size=0.01,
    )


def native_spec(own: Spec) -> Spec:
    """The same with states for model exchange."""
    acceleration = Variable(
        "sway.acceleration", "Real", "local", "continuous", "acceleration of the angle",
        unit="rad/s2",
    )
    rate = derivative("sway.angle", own.variable("sway.rate"))
    known = ("sway.angle", "sway.rate", *(name for name, *_ in INPUTS))
    return replace(
        own, variables=(*own.variables, rate, acceleration, time()),
        states=(("sway.angle", rate.name), ("sway.rate", acceleration.name)),
        dependencies=(
            ("sway.angle", ("sway.angle",)), ("sway.rate", ("sway.rate",)),
            (rate.name, ("sway.rate",)),
            ("sway.acceleration", known), ("load.offset", ("sway.angle", "reference.rope.length")),
        ),
        partials=(),
    )
