"""A crane file with fitted values: the user's own text, in which only these differ."""

from __future__ import annotations

from datetime import date
from pathlib import Path
from typing import Any

import tomlkit
from tomlkit.items import InlineTable

from segfmu.cosim.result import replacing
from segfmu.validation.files.crane_file import CraneFile
from segfmu.validation.files.crane_parameters import check
from segfmu.validation.files.reading import checked
from segfmu.validation.identification.possible import require_possible
from segfmu.validation.identification.result import Estimate, Identification, Untold
from segfmu.validation.texts import encodable
from segfmu.validation.units import pretty


def write(found: Identification, path: Path) -> Path:
    """Write the crane file; raises as `crane_text`, and if it cannot be written."""
    text = crane_text(found, path)
    with replacing(path) as temporary:
        temporary.write_text(text, encoding="utf-8")
    return path


def crane_text(found: Identification, path: Path) -> str:
    """What the crane file has; each fitted value has its interval and the logs as a comment.

    Raises
    ------
    InputError
        If an estimate is none that a crane has or its file, at this path, may have.
    """
    require_possible(found.impossible)
    if found.source is None:
        document = tomlkit.document()
        document.update(found.nominal.model_dump(exclude_unset=True))
    else:
        document = tomlkit.parse(found.source.read_text(encoding="utf-8-sig"))
    names = encodable(", ".join(dict.fromkeys(Path(p.log).name for p in found.fitted)))
    for estimate in found.estimates:
        _set(document, estimate.key, estimate.rounded, _source(estimate, names))
    for untold in found.untold:
        _note(document, untold, names)
    text = tomlkit.dumps(document)
    check(checked(CraneFile, document.unwrap(), str(path)), str(path))
    return text


def _source(estimate: Estimate, names: str) -> str:
    interval = f"{pretty(estimate.low)} to {pretty(estimate.high)} (95 %)"
    return f"{estimate.unit}, {interval}, identified from {names}, {date.today()}"


def _set(document: Any, key: str, value: float, comment: str) -> None:
    *tables, name = key.split(".")
    table = document
    for part in tables:
        if part not in table:
            table[part] = {} if isinstance(table, InlineTable) else tomlkit.table()
        table = table[part]
    table[name] = tomlkit.item(value)
    _comment(table, name, comment)


def _note(document: Any, untold: Untold, names: str) -> None:
    """Say at a value that is there that the logs do not tell it."""
    *tables, name = untold.key.split(".")
    table = document
    for part in tables:
        table = table.get(part, {})
    if name in table:
        before = table[name].trivia.comment.lstrip("# ")
        _comment(table, name, f"{before}; not told by {names}".lstrip("; "))


def _comment(table: Any, name: str, text: str) -> None:
    # a table on one line has no place for comments of its own
    if not isinstance(table, InlineTable):
        table[name].comment(text)
