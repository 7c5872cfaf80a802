"""Shared by both FMUs of the gantry crane: parameters `crane.*`, and the bus that connects them."""

from __future__ import annotations

from segfmu.fmu.standard.spec import Terminal, Variable, parameter

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
