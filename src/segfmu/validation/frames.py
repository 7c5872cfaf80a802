"""Tables of pandas, which is optional."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from segfmu.errors import InputError

if TYPE_CHECKING:
    import pandas


def frame(columns: Mapping[str, Any], index: str | None = None) -> pandas.DataFrame:
    """A table of columns; one of them can be its index.

    Raises
    ------
    InputError
        If pandas is not installed.
    """
    try:
        import pandas
    except ModuleNotFoundError:
        raise InputError(
            "to_pandas needs pandas: pip install pandas, or the extra segfmu[pandas]"
        ) from None
    table = pandas.DataFrame(dict(columns))
    return table if index is None else table.set_index(index)
