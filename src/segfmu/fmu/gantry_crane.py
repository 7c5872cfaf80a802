"""Interface of GantryCrane: the crane's dynamics with sampled sway feedback."""

from __future__ import annotations

from segfmu.fmu.rig_parameters import DRIVES, rig_parameters
from segfmu.fmu.spec import (
    Enumeration,
    Spec,
    Variable,
    choice,
    crane_parameters,
    output,
    parameter,
    signal,
    triple,
)

MODES = Enumeration("DriveMode", ("force", "velocity"), "what the drives follow")

# Names of the state's ten components, in the kernels' order.
STATE = (
    "bridge.position", "trolley.position", "rope.length", "sway.x.angle", "sway.y.angle",
    "bridge.velocity", "trolley.velocity", "rope.velocity", "sway.x.rate", "sway.y.rate",
)
UNITS = ("m", "m", "m", "rad", "rad", "m/s", "m/s", "m/s", "rad/s", "rad/s")


def _inputs() -> list[Variable]:
    rows = [signal(f"force.{d}", "N", f"force setpoint of the {d} drive") for d in DRIVES]
    rows += [signal(f"velocity.{d}", "m/s", f"velocity setpoint of the {d} drive") for d in DRIVES]
    rows += [
        signal(f"reference.{name}", unit, f"reference of {name}")
        for name, unit in zip(STATE, UNITS, strict=True)
    ]
    rows += [
        signal(f"reference.load.position.{a}", "m", f"reference of the load's position, {a}")
        for a in "xyz"
    ]
    rows += [signal(f"wind.{a}", "N", f"external force on the load, {a}") for a in "xyz"]
    return rows


def _outputs() -> list[Variable]:
    rows = [
        output(name, unit, f"true {name}", start=0.5 if name == "rope.length" else 0.0)
        for name, unit in zip(STATE, UNITS, strict=True)
    ]
    rows += [
        output(f"measured.{name}", unit, f"measured {name}")
        for name, unit in zip(STATE[:5], UNITS[:5], strict=True)
    ]
    rows += triple("load.position", "m", "true position of the load")
    rows += triple("load.velocity", "m/s", "true velocity of the load")
    rows += triple("error.load", "m", "load minus its reference")
    rows.append(output("error.load.norm", "m", "distance of the load from its reference"))
    for drive in DRIVES:
        rows.append(output(f"drive.{drive}.force", "N", f"force that the {drive} drive applies"))
        rows.append(
            output(
                f"drive.{drive}.saturated", None,
                f"{drive} drive at a bound at some time in the last step", kind="Boolean",
            )
        )
        rows.append(output(f"drive.{drive}.power", "W", f"power of the {drive} drive"))
    return [*rows, *_energies()]


def _energies() -> list[Variable]:
    return [
        output("rope.force", "N", "force on the rope, tension is negative"),
        output("payload.mass", "kg", "present mass of the load"),
        output("energy.kinetic", "J", "kinetic energy of bridge, trolley and load"),
        output("energy.potential", "J", "potential energy of the load, zero at the trolley"),
        output("energy.work", "J", "work of drives and wind since the start"),
        output("energy.drives", "J", "work of the drives since the start"),
        output("energy.wind", "J", "work of the wind since the start"),
        output("energy.payload", "J", "energy that payload changes brought since the start"),
        output("energy.dissipated", "J", "energy that friction took since the start"),
        output("energy.imbalance", "J", "error of the balance of these by integration"),
        output("power.wind", "W", "power of the wind"),
        output("power.friction", "W", "power that friction dissipates"),
    ]


def _feedback() -> list[Variable]:
    weights = (
        ("position", "carriage and rope position"), ("angle", "sway angles"),
        ("velocity", "carriage and rope velocity"), ("rate", "sway rates"), ("effort", "effort"),
    )
    return [
        parameter(
            "feedback.enabled", True, None, "sway feedback acts", kind="Boolean", tunable=True
        ),
        parameter("feedback.sample_time", 0.01, "s", "period of the feedback", minimum=1e-6),
        parameter(
            "feedback.payload_mass", 0.0, "kg",
            "mass of the load that the feedback is designed for; 0: crane.payload_mass",
            minimum=0.0,
        ),
        *(
            parameter(
                f"feedback.weight.{name}", 1.0, None,
                f"weight of the {text} in the dimensionless LQR design", minimum=0.0,
            )
            for name, text in weights
        ),
    ]


def spec() -> Spec:
    """The interface of GantryCrane."""
    return Spec(
        "GantryCrane",
        "Dynamics of a 3-DOF gantry crane from Lagrange's equations, driven by force or velocity "
        "setpoints, with a sampled sway feedback about a reference state; drives, friction, end "
        "stops, sensors, wind and payload changes as on a real crane, ideal by default",
        (
            *_inputs(),
            *_outputs(),
            *crane_parameters("true crane"),
            choice("drive.mode", MODES, "force", "what the drives follow"),
            *rig_parameters(),
            *_feedback(),
        ),
        stop_time=8.0,
        step_size=0.001,
    )
