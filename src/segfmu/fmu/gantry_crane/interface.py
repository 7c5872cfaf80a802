"""Interface of GantryCrane: the crane's dynamics with sampled sway feedback."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Any

from segfmu.crane.feedback import SwayFeedback
from segfmu.crane.plant import TOLERANCE
from segfmu.fmu.gantry import SETPOINTS, crane_parameters
from segfmu.fmu.gantry_crane.feedback_parameters import (
    estimates,
    feedback_parameters,
    lqr_from,
    nominal_from,
    weight_parameters,
)
from segfmu.fmu.gantry_crane.rig_parameters import rig_parameters
from segfmu.fmu.standard.spec import (
    Array,
    Enumeration,
    Spec,
    Variable,
    choice,
    derivative,
    output,
    parameter,
    signal,
    started,
    time,
    triple,
)
from segfmu.kernels.control.records import GainsRow
from segfmu.kernels.crane.records import DRIVES
from segfmu.kernels.rig.records import Outputs

MODES = Enumeration("DriveMode", ("force", "velocity"), "what the drives follow")
# rope lengths in the table of gains
MOST_ROWS = 17

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
    rows = _described_outputs()
    return [*rows, *_further_outputs({v.name for v in rows})]


def _described_outputs() -> list[Variable]:
    """Those that have a text of their own here."""
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
    return [*rows, *_energies(), *estimates()]


def _further_outputs(listed: set[str]) -> list[Variable]:
    """Outputs of the record that have no text of their own here: as the record describes them."""
    rows = [
        output(name, declared.unit or None, declared.meaning)
        for declared in Outputs.FIELDS.values()
        for name in declared.variables if name not in listed
    ]
    # deflections of contacts are micrometres
    return [replace(v, nominal=1e-5) if v.name in DEFLECTIONS else v for v in rows]


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


@cache
def spec() -> Spec:
    """The interface of GantryCrane."""
    return held(Spec(
        "GantryCrane",
        "Dynamics of a 3-DOF gantry crane from Lagrange's equations, driven by force or velocity "
        "setpoints, with a sampled sway feedback about a reference state; drives, friction, end "
        "stops, sensors, wind and payload changes as on a real crane, ideal by default",
        (
            *_inputs(),
            *_outputs(),
            *crane_parameters("true crane"),
            choice("drive.mode", MODES, "force", "what the drives follow"),
            parameter(
                "start.on_reference", True, None,
                "start where the reference is at initialisation; start values of the state are "
                "then deviations, counted from the start values of the reference",
                kind="Boolean",
            ),
            parameter(
                "setpoint.lead", 0.0, "s",
                "that of GantryFeedforward; above 0, inputs set after a step are those of the end "
                "of the next one, and no reference for the errors yet", minimum=0.0,
            ),
            *rig_parameters(),
            *feedback_parameters(),
        ),
        stop_time=8.0,
        step_size=0.001,
    ))


def held(own: Spec) -> Spec:
    """Add start values of the inputs that hold the crane in its initial position.

    If an importer connects nothing, the load hangs at rest instead of falling.
    """
    starts: dict[str, Any] = {v.name: v.start for v in own.variables}
    place = [starts[name] for name in STATE[:3]]
    weight = starts["crane.payload_mass"] * starts["crane.gravity"]
    values = {f"reference.{name}": p for name, p in zip(STATE[:3], place, strict=True)}
    load = (*place[:2], -place[2])
    values |= {f"reference.load.position.{a}": p for a, p in zip("xyz", load, strict=True)}
    return started(own, values | {"force.hoist": -weight})


DEFLECTIONS = tuple(f"friction.{d}.deflection" for d in DRIVES)
# State of model exchange: the crane's, the deflections of its contacts, then the integrated powers.
STATES = (*STATE, *DEFLECTIONS, "energy.drives", "energy.wind", "energy.dissipated")
# Derivatives that are outputs.
SHOWN = dict(zip(STATE[:5], STATE[5:], strict=True)) | {
    "energy.wind": "power.wind", "energy.dissipated": "power.friction",
}
ACCELERATIONS = (
    "bridge.acceleration", "trolley.acceleration", "rope.acceleration", "sway.x.acceleration",
    "sway.y.acceleration",
)
RATES = (
    *(f"der({n})" for n in STATE[:5]), *ACCELERATIONS, *(f"{n}_rate" for n in DEFLECTIONS),
    "power.drives", *(f"der({n})" for n in STATES[-2:]),
)

# what gains are by
GAINED = (*STATE, "the velocity that corrections have added")

# Correction of each axis, and the indices of its gains among the ten states.
GAINS = {
    drive: [
        (name.rpartition(".")[2], place)
        for place, name in enumerate(GainsRow.FIELDS[drive.upper()].variables) if name
    ]
    for drive in DRIVES
}


def native_spec(own: Spec | None = None) -> Spec:
    """The interface of the native GantryCrane, from that of `spec` or with other start values.

    The table of gains takes the place of the weights of the LQR design; it is designed here with
    the start values of crane and weights. Names of the derivatives and of time are added.

    Raises
    ------
    InputError
        For weights for which no design exists.
    """
    own = own or spec()
    weights = [v.name for v in weight_parameters()]
    kept = [v for v in own.variables if v.name not in weights]
    table = _table({v.name: v.start for v in own.variables}, weights)
    rates = [_local(n, u, f"acceleration of {n.rpartition('.')[0]}")
             for n, u in zip(ACCELERATIONS, (*["m/s2"] * 3, *["rad/s2"] * 2), strict=True)]
    rates += [_local(f"{n}_rate", "m/s", f"derivative of {n}") for n in DEFLECTIONS]
    rates.append(_local("power.drives", "W", "power of all drives"))
    rates += [derivative(state, own.variable(rate)) for state, rate in SHOWN.items()]
    return replace(
        own, variables=(*kept, *table, *rates, time()), arrays=_table_arrays(),
        states=tuple(zip(STATES, RATES, strict=True)), dependencies=_dependencies(),
        orders=1, partials=("ModelExchange",), terminals=(SETPOINTS,),
        constants=(
            ("TOLERANCE", TOLERANCE),
        ),
    )


def _local(name: str, unit: str, description: str) -> Variable:
    return Variable(name, "Real", "local", "continuous", description, unit=unit)


def _dependencies() -> tuple[tuple[str, tuple[str, ...]], ...]:
    """Dependencies of the unknowns of model exchange: states, inputs with direct effect, time."""
    forces = tuple(f"force.{d}" for d in DRIVES) + tuple(f"velocity.{d}" for d in DRIVES)
    winds = tuple(f"wind.{a}" for a in "xyz")
    acting = (*STATE, *DEFLECTIONS, *forces, *winds, "time")
    targets = tuple(f"reference.load.position.{a}" for a in "xyz")
    found: dict[str, tuple[str, ...]] = {n: (n,) for n in STATES}
    found |= {f"measured.{n}": (n,) for n in STATE[:5]}
    for i, axis in enumerate("xyz"):
        found[f"load.position.{axis}"] = STATE[:5]
        found[f"load.velocity.{axis}"] = STATE
        found[f"error.load.{axis}"] = (*STATE[:5], targets[i])
    found["error.load.norm"] = (*STATE[:5], *targets)
    for drive in DRIVES:
        for name in ("force", "saturated", "power"):
            found[f"drive.{drive}.{name}"] = acting
    found |= {f"der({n})": (rate,) for n, rate in SHOWN.items()}
    found |= dict.fromkeys((*RATES[5:], "power.wind", "power.friction", "rope.force"), acting)
    for drive, axis in zip(DRIVES, ("bridge", "trolley", "rope"), strict=True):
        deflection = f"friction.{drive}.deflection"
        found[f"{deflection}_rate"] = (f"{axis}.velocity", deflection)
    found["energy.kinetic"], found["energy.potential"] = STATE, STATE[:5]
    found["energy.work"] = ("energy.drives", "energy.wind")
    found["energy.imbalance"] = STATES
    # nothing is known of the others
    further = _further_outputs({v.name for v in _described_outputs()})
    found |= {v.name: (*STATES, *forces, *winds, "time", *targets) for v in further}
    return tuple(found.items())


def _table(starts: dict[str, Any], weights: list[str]) -> list[Variable]:
    """The table of gains; its description lists the weights, which are no variables here."""
    feedback, driven = _designed(starts)
    used = len(feedback.lengths)
    told = ", ".join(f"{n.rpartition('.')[2]} {starts[n]!r}" for n in weights)
    rows = [
        parameter(
            "feedback.table.count", used, None,
            f"rope lengths in the table of gains; its start values are those of weights {told}",
            kind="Integer", minimum=1, maximum=MOST_ROWS,
        ),
        choice(
            "feedback.table.mode", MODES, MODES.items[driven],
            "drive.mode that the gains in the table are for",
        ),
        parameter(
            "feedback.table.payload_mass", feedback.payload, "kg",
            "mass of the load that the gains in the table are for", minimum=1e-9,
        ),
    ]
    unit = "m/s2" if driven else "N"
    for i in range(1, MOST_ROWS + 1):
        row = min(i, used) - 1
        name = f"feedback.table[{i}]"
        rows.append(
            parameter(
                f"{name}.length", float(feedback.lengths[row]), "m", "rope length of a row",
                minimum=1e-9, tunable=True, computed=True,
            )
        )
        for axis, drive in enumerate(GAINS):
            for quantity, place in GAINS[drive]:
                rows.append(
                    parameter(
                        f"{name}.{drive}.{quantity}", float(feedback.gains[row, axis, place]),
                        None, f"gain of the {drive} [{unit}] by the error of {GAINED[place]} in SI "
                        "units", tunable=True, computed=True,
                    )
                )
    return rows


def _designed(starts: dict[str, Any]) -> tuple[SwayFeedback, bool]:
    """The LQR design for the crane of the start values, and whether it is for velocity drives."""
    crane = nominal_from(starts.__getitem__)
    driven = MODES.items[int(starts["drive.mode"]) - 1] == "velocity"
    feedback = lqr_from(
        lambda n: starts.get(n, 0.0), crane, float(starts["rope.length"]), MOST_ROWS
    )
    return feedback, driven


def _table_arrays() -> tuple[Array, ...]:
    rows = range(1, MOST_ROWS + 1)
    lengths = Array(
        "feedback.table.length", tuple(f"feedback.table[{i}].length" for i in rows),
        "feedback.table.count", 1, "rope lengths of the table of gains",
    )
    gains = [
        Array(
            f"feedback.table.{drive}",
            tuple(f"feedback.table[{i}].{drive}.{q}" for i in rows for q, _ in quantities),
            "feedback.table.count", len(quantities),
            f"gains of the {drive} by the errors of {', '.join(q for q, _ in quantities)}",
        )
        for drive, quantities in GAINS.items()
    ]
    return lengths, *gains
