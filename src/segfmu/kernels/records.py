"""Names for the entries of the kernels' flat arrays.

A record names the entries of an array, or the rows of one with two dimensions. It is declared once.
The indices in the kernels, the C enumerations of c/records.h, the mapping from an FMU's variables,
and docs/records.md all follow from it:

    class Clock(Record):
        "Times of a rig."
        START = field("time of the start", "s")
        STOPS = field("end stops of bridge and trolley", "m", size=2)

`Clock.START` is 0, `Clock.STOPS` is 1 and `Clock.SIZE` is 3: plain integers, with which the
translator to C replaces the names. A kernel writes `clock[Clock.STOPS + axis]`, and for an array
with named rows `memory[Memory.CLOCK, Clock.START]`.

A record that derives from another one begins with its fields, so an array of the longer one can be
passed where the shorter one is expected. If fields are rows, `COLUMNS` is the length of the longest
row.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any, ClassVar


@dataclass(frozen=True)
class Field:
    """One field of a record.

    Attributes
    ----------
    meaning : str
    unit : str
        Empty for a number without one.
    size : int
        Entries, or rows.
    of : type of Record, optional
        Record of the entries of this field, or of each of its rows.
    variables : tuple of str
        FMU variables that feed it, one per entry, with an empty name for an entry without one;
        empty if none feeds any. In a record that is a row of a table, `{}` stands for the number
        of the row, from 1.
    base : int
        Value of the variable that is 0 in the record; items of an enumeration count from 1.
    """

    meaning: str
    unit: str
    size: int
    of: type[Record] | None
    variables: tuple[str, ...]
    base: int = 0


def field(
    meaning: str,
    unit: str = "",
    *,
    size: int = 1,
    of: type[Record] | None = None,
    variables: Sequence[str] = (),
    base: int = 0,
) -> Any:
    """Declare a field; in the finished record its name is the index of its first entry.

    Parameters are those of `Field`. The return type is that of the finished name.
    """
    if variables and len(variables) != size:
        raise AssertionError(f"{meaning}: {len(variables)} variables for {size} entries")
    return Field(meaning, unit, size, of, tuple(variables), base)


class Record:
    """Base of all records: fields in the order of their indices, those of the base first.

    Attributes
    ----------
    FIELDS : dict of str to Field
    SIZE : int
        Entries, or rows.
    COLUMNS : int
        Entries of the longest row, if fields are rows with named entries; else 0.
    """

    FIELDS: ClassVar[dict[str, Field]] = {}
    SIZE: ClassVar[int] = 0
    COLUMNS: ClassVar[int] = 0

    def __init_subclass__(cls) -> None:
        own = {n: f for n, f in vars(cls).items() if isinstance(f, Field)}
        place = cls.SIZE
        for name, declared in own.items():
            setattr(cls, name, place)
            place += declared.size
        cls.SIZE = place
        cls.FIELDS = cls.FIELDS | own
        rows = [f.of for f in cls.FIELDS.values() if f.of is not None]
        cls.COLUMNS = max((r.COLUMNS or r.SIZE for r in rows), default=0)

    @classmethod
    @cache
    def feeds(cls) -> tuple[tuple[int, str, int], ...]:
        """Index, variable and base of all entries that FMU variables feed."""
        return tuple(
            (getattr(cls, name) + i, variable, declared.base)
            for name, declared in cls.FIELDS.items()
            for i, variable in enumerate(declared.variables) if variable
        )

    @classmethod
    def fill(cls, record: Any, value: Callable[[str], Any], row: int = 1) -> None:
        """Fill a record, an array (SIZE,), with the variables that feed it; `value` by name.

        row : which row of a table the record is, from 1.
        """
        for place, variable, base in cls.feeds():
            named = variable.format(row) if "{" in variable else variable
            record[place] = float(value(named)) - base


def c_name(declared: type) -> str:
    """The C prefix of the fields of a record or of codes."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "_", declared.__name__).upper()


class Codes:
    """Base of enumerations in kernels: names with integer values."""

    @classmethod
    def items(cls) -> dict[str, int]:
        """Names and values in the order of declaration."""
        return {n: v for n, v in vars(cls).items() if n.isupper() and isinstance(v, int)}
