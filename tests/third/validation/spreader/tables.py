"""`[spreader]` in crane files."""

from typing import Annotated

from segfmu.validation.files.keys import Key, Quantity, Table


class SpreaderTable(Table):
    """A spreader."""

    mass: Annotated[Quantity, Key("mass of the spreader", "kg", ("spreader.mass",))]
