"""Shared by both FMUs of the crane with a hook: its parameters."""

from __future__ import annotations

from segfmu.fmu.standard.spec import Variable, parameter


def hook_parameters(which: str) -> list[Variable]:
    """`hook.*`, the same in both FMUs; `which` names the crane in the descriptions."""
    return [
        parameter("hook.mass", 0.1, "kg", f"{which}: mass of the hook", minimum=1e-9),
        parameter(
            "hook.sling", 0.3, "m", f"{which}: length of the sling, from hook to load",
            minimum=1e-9,
        ),
    ]
