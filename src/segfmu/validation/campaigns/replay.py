"""A run of a campaign as a scenario file, which `segfmu validate` runs."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from segfmu.cosim.result import replacing
from segfmu.errors import InputError
from segfmu.validation.campaigns.campaign import Campaign, Run
from segfmu.validation.campaigns.sampling import known_value
from segfmu.validation.campaigns.store import TABLE, read_table
from segfmu.validation.files.scenario_file import inherit


def run_name(number: int) -> str:
    """The name of the file of a run."""
    return f"run_{number}.toml"


def find_run(folder: Path, campaign: Campaign, number: int) -> Run:
    """A run by its number; one of a search is among those that the folder has.

    Raises
    ------
    InputError
        If there is no run of this number.
    """
    if campaign.searched:
        return _searched(folder, campaign, number)
    if not 0 <= number < len(campaign.runs):
        raise InputError(
            f"{campaign.source.path}: no run {number}; they are 0 to {len(campaign.runs) - 1}"
        )
    return campaign.runs[number]


def _searched(folder: Path, campaign: Campaign, number: int) -> Run:
    if not (folder / TABLE).exists():
        raise InputError(
            f"{campaign.source.path}: a search chooses its runs as it goes, and {folder} has none "
            "that is complete; run the campaign first"
        )
    table = read_table(folder / TABLE)
    if not 0 <= number < table.num_rows:
        raise InputError(
            f"{campaign.source.path}: {folder} has no run {number}; they are 0 to "
            f"{table.num_rows - 1}"
        )
    (row,) = table.slice(number, 1).to_pylist()
    sample = {f.name: known_value(f, row[f.name]) for f in campaign.factors}
    return Run(number, campaign.source.file.scenarios.index(row["scenario"]), sample)


def write_run(folder: Path, campaign: Campaign, run: Run) -> Path:
    """Write a run as a scenario that inherits from its own; returns the file.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    source = campaign.source
    base = source.scenarios[run.scenario].path.resolve()
    content = inherit(source.changes, campaign.changes(run))
    content.setdefault("name", f"{source.file.name}, run {run.number}")
    told = ", ".join(f"{n} {v}" for n, v in run.sample.items())
    lines = [f"# Run {run.number} of {source.file.name}{': ' if told else ''}{told}"]
    lines += [f"{_text(n)} = {_toml(v)}" for n, v in {"base": str(base), **content}.items()]
    path = folder / run_name(run.number)
    with replacing(path) as temporary:
        temporary.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


def _toml(value: Any) -> str:
    """A value of a TOML file on one line."""
    if isinstance(value, Mapping):
        return f"{{ {', '.join(f'{_text(n)} = {_toml(v)}' for n, v in value.items())} }}"
    if isinstance(value, list | tuple):
        return f"[{', '.join(map(_toml, value))}]"
    if isinstance(value, str):
        return _text(value)
    return str(value).lower() if isinstance(value, bool) else repr(value)


def _text(value: str) -> str:
    # TOML has no pairs of surrogates, as JSON has them in place of characters beyond 16 bits
    return json.dumps(value, ensure_ascii=False)
