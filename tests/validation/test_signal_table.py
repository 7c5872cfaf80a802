"""What is no table of signals is refused in one line."""

from __future__ import annotations

from pathlib import Path

import pytest

from segfmu.errors import InputError
from segfmu.validation.signal_table import read_table


@pytest.mark.parametrize(("text", "told"), [
    ("", "no column time"),
    ("time,a\n", "there is no row of numbers"),
    ("time,a\n0,1\n1,2\n2\n", "no table of numbers: the number of columns changed"),
    ("time,a\n0,1\n1,fast\n", "no table of numbers: could not convert string 'fast'"),
    ("time,a\n0,1,2\n", "2 names but rows of 3 numbers"),
    ("time,a,a\n0,1,2\n", "two columns have one name"),
    ("time,a\n1,1\n1,2\n", "time does not increase"),
    ("time,a\nnan,1\n1,2\n", "time does not increase"),
])
def test_a_table_is_refused_in_one_line(tmp_path: Path, text: str, told: str) -> None:
    path = tmp_path / "log.csv"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(InputError) as error:
        read_table(path)
    message = str(error.value)
    assert message.startswith(f"{path}: {told}")
    assert "\n" not in message and "usecols" not in message
