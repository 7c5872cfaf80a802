"""The reference page of mission, crane, scenario and campaign files, from the models.

`python -m segfmu.validation.files.reference FILE` writes it again.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from itertools import groupby
from math import degrees
from pathlib import Path
from typing import Any

from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.validation.files.campaign_tables import CampaignFile
from segfmu.validation.files.crane_file import CraneFile
from segfmu.validation.files.crane_parameters import WITHOUT_KEY
from segfmu.validation.files.keys import Entry, Table, entries
from segfmu.validation.files.mission import Mission
from segfmu.validation.files.scenario_tables import ScenarioFile

BANNER = "<!-- Written by `make generate` from src/segfmu/validation; do not edit. -->"
INTRODUCTION = """# Mission, crane, scenario and campaign files

For those who write these files. All are TOML in UTF-8; angles are in deg, all else in SI units. A
key that is left out has the default. Any other key is an error.

- A *mission* says what the load has to do, and names its crane: `crane = "crane.toml"`, relative to
  the mission, or a table `[crane]` with the same keys.
- A *crane file* says all that is known of a crane. Its bounds hold in every plan. Plan and
  feedforward are for `crane`; `[true_crane]` states, with the same keys, what differs from it in
  the crane that is simulated. The feedback in GantryCrane is designed for the load of `crane`, and
  for all else of the simulated crane.
- A *scenario* has a mission, what disturbs it, and criteria ([validation](validation.md)).
- A *campaign* runs scenarios many times ([campaigns](campaign.md)).

`segfmu init` writes a commented mission and crane. `segfmu schema mission` prints the JSON schema,
with which an editor completes and checks: for Taplo and Even Better TOML, write it to
`mission.schema.json` and begin the mission with `#:schema ./mission.schema.json`.
"""
BASE = """`base` names a scenario file that all other keys are merged into. An instant is a time
[s], or `"start"`, `"arrival"` or `"end"`, plus or minus a time: `"arrival + 1"`."""


def page() -> str:
    """The page as Markdown."""
    lines = [BANNER, "", INTRODUCTION, "## Mission", ""]
    lines += _tables(Mission, skip=("crane", "true_crane"))
    lines += ["## Crane", "", "The last column names the parameter of GantryCrane that takes the "
              "value. Where GantryFeedforward has a parameter of this name, it takes it too.", ""]
    lines += _tables(CraneFile)
    lines += ["## Parameters of GantryCrane without a key", "", "| parameter | why |", "|---|---|"]
    lines += [f"| `{name}` | {why} |" for name, why in WITHOUT_KEY.items()]
    lines += ["", "## Scenario", "", BASE, ""]
    lines += _tables(ScenarioFile)
    lines += ["## Campaign", ""]
    lines += _tables(CampaignFile)
    return "\n".join(lines).rstrip("\n") + "\n"


def _tables(kind: type[Table], skip: tuple[str, ...] = ()) -> Iterator[str]:
    """A section for the keys of the file, then one for each table, or for several of one kind."""
    every = list(entries(kind))
    yield from _section([e for e in every if len(e.path) == 1 and _plain(e, skip)], kind)
    tables = [e for e in every if e.kind is not None and e.path[0] not in skip]
    for (inner, _), group in groupby(tables, lambda e: (e.kind, e.path[:-1])):
        alike = list(group)
        names = (".".join(e.path) for e in alike)
        titles = (f"`[[{n}]]`" if alike[0].listed else f"`[{n}]`" for n in names)
        meanings = "; ".join(e.key.meaning for e in alike)
        yield from (f"### {', '.join(titles)}", "", f"{meanings[0].upper()}{meanings[1:]}.", "")
        rows = [e for e in every if e.path[:-1] == alike[0].path and e.kind is None]
        if rows and inner is not None:
            yield from _section(rows, inner)


def _plain(entry: Entry, skip: tuple[str, ...]) -> bool:
    return entry.kind is None or entry.path[0] in skip


def _section(rows: list[Entry], kind: type[Table]) -> Iterator[str]:
    fed = any(e.feeds for e in rows)
    yield "| key | unit | values | default | meaning |" + (" parameter |" if fed else "")
    yield "|---|---|---|---|---|" + ("---|" if fed else "")
    for e in rows:
        cells = [f"`{e.path[-1]}`", e.key.unit, _values(kind, e), default(e), e.key.meaning]
        if fed:
            cells.append(", ".join(f"`{name.replace('{}', '*')}`" for name in e.key.feeds))
        yield f"| {' | '.join(cells)} |"
    yield ""


def default(entry: Entry) -> str:
    """What holds without the key."""
    if entry.field.is_required():
        return "required"
    value = entry.field.get_default(call_default_factory=True)
    if entry.key.default or value is None:
        return entry.key.default or _start(entry)
    return f"`{_toml(value)}`"


def _start(entry: Entry) -> str:
    """The start value of the parameter that a key sets."""
    variable = gantry_crane.spec().variable(entry.feeds[0])
    value = variable.start
    assert value is not None
    if variable.enumeration is not None:
        return f"`{_toml(variable.enumeration.items[int(value) - 1])}`"
    if variable.kind == "Boolean":
        return f"`{_toml(bool(value))}`"
    return f"{degrees(value) if entry.key.unit == 'deg' else value:.6g}"


def _toml(value: Any) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    return f'"{value}"' if isinstance(value, str) else str(value)


def _values(kind: type[Table], entry: Entry) -> str:
    """What a key takes, in words."""
    if entry.kind is not None:
        return "table, or name of a file" if entry.path == ("crane",) else "table"
    found = kind.model_json_schema()["properties"][entry.path[-1]]
    choices = [c for c in found.get("anyOf", [found]) if c != {"type": "null"}]
    text = " or ".join(_kind(c) for c in choices)
    return f"{text}: {', '.join(entry.key.parts)}" if entry.key.parts else text


def _kind(choice: dict[str, Any]) -> str:
    if "const" in choice or "enum" in choice:
        return " or ".join(f"`{_toml(v)}`" for v in choice.get("enum", [choice.get("const")]))
    if choice.get("type") == "array":
        items = _kind(choice["items"])
        least, most = choice.get("minItems"), choice.get("maxItems")
        return f"{most} {_many(items)}" if least == most and most else f"list of {_many(items)}"
    if "anyOf" in choice:
        return " or ".join(_kind(c) for c in choice["anyOf"])
    words = {
        "number": "number", "integer": "integer", "boolean": "boolean",
        "object": "table", "": "number, text or boolean",
    }
    return f"{words.get(choice.get('type', ''), 'text')}{_range(choice)}"


def _many(kind: str) -> str:
    return kind.replace("number", "numbers", 1) if kind.startswith("number") else kind


def _range(choice: dict[str, Any]) -> str:
    low, high = choice.get("minimum"), choice.get("maximum")
    if "exclusiveMinimum" in choice:
        return f" above {choice['exclusiveMinimum']:g}"
    if low is not None and high is not None:
        return f" {low:g} to {high:g}"
    return "" if low is None else f" from {low:g}"


def main() -> None:
    """Write the page to the file that is named."""
    Path(sys.argv[1]).write_text(page(), encoding="utf-8")


if __name__ == "__main__":
    main()
