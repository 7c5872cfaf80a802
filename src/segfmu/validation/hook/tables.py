"""`[hook]` in crane files."""

from __future__ import annotations

from typing import Annotated

from segfmu.validation.files.keys import Key, Quantity, Table


class HookTable(Table):
    """A hook between rope and load, which makes a double pendulum."""

    mass: Annotated[Quantity, Key("mass of the hook", "kg", ("hook.mass",))]
    sling: Annotated[
        Quantity, Key("length of the sling, from hook to load", "m", ("hook.sling",))
    ]
