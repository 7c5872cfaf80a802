"""Shared by both FMUs of the gantry crane: parameters of the crane, and the bus between them."""

from __future__ import annotations

from segfmu.fmu.standard.spec import Terminal, Variable, parameter
from segfmu.kernels.crane.records import DRIVES

SETPOINTS = Terminal(
    "setpoints", "setpoints of the drives and the reference that belongs to them",
    ("force", "velocity", "reference"),
)


def crane_parameters(which: str) -> list[Variable]:
    """`crane.*`, the same in both FMUs; `which` names the crane in the descriptions."""
    masses = (
        ("bridge_mass", 2.2, "mass of the bridge, which moves in x together with the trolley"),
        ("trolley_mass", 1.155, "mass of the trolley, which moves in y on the bridge"),
        ("payload_mass", 1.0, "mass of the load"),
    )
    return [
        *(
            parameter(f"crane.{n}", start, "kg", f"{which}: {text}", minimum=1e-9)
            for n, start, text in masses
        ),
        parameter("crane.gravity", 9.81, "m/s2", f"{which}: gravity", minimum=1e-9),
        parameter("crane.rope_min", 0.16, "m", f"{which}: shortest rope; 0: no bound", minimum=0.0),
        parameter("crane.rope_max", 1.5, "m", f"{which}: longest rope; 0: no bound", minimum=0.0),
    ]


def friction_parameters() -> list[Variable]:
    """`friction.*` of the axes, the same in both FMUs."""
    rows = []
    for drive in DRIVES:
        name = f"friction.{drive}"
        rows += [
            parameter(
                f"{name}.viscous", 0.0, "N.s/m", f"viscous friction of the {drive}", minimum=0.0
            ),
            parameter(
                f"{name}.coulomb", 0.0, "N", f"Coulomb friction of the {drive}", minimum=0.0
            ),
            parameter(
                f"{name}.static", 0.0, "N",
                f"static friction of the {drive}; 0: as Coulomb friction", minimum=0.0,
            ),
            parameter(
                f"{name}.drag", 0.0, "N", f"friction of the {drive} is drag * v |v|, v in m/s",
                minimum=0.0,
            ),
        ]
    return [
        *rows,
        parameter(
            "friction.width", 1e-3, "m/s",
            "velocity over which static friction falls to Coulomb friction", minimum=1e-9,
        ),
        parameter(
            "friction.presliding", 1e-5, "m", "displacement at which a contact begins to slide",
            minimum=1e-9,
        ),
    ]
