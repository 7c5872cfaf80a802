"""A run of a campaign as a scenario file, which `segfmu validate` runs."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from segfmu.cosim.result import replacing
from segfmu.errors import InputError
from segfmu.validation.campaigns.campaign import Campaign
from segfmu.validation.files.scenario_file import inherit


def write_run(folder: Path, campaign: Campaign, number: int) -> Path:
    """Write a run as a scenario that inherits from its own; returns the file.

    Raises
    ------
    InputError
        If there is no run of this number, or the file cannot be written.
    """
    if not 0 <= number < len(campaign.runs):
        raise InputError(
            f"{campaign.source.path}: no run {number}; they are 0 to {len(campaign.runs) - 1}"
        )
    run, source = campaign.runs[number], campaign.source
    base = source.scenarios[run.scenario].path.resolve()
    content = inherit(source.changes, campaign.changes(run))
    content.setdefault("name", f"{source.file.name}, run {number}")
    told = ", ".join(f"{n} {v}" for n, v in run.sample.items())
    lines = [f"# Run {number} of {source.file.name}{': ' if told else ''}{told}"]
    lines += [f"{json.dumps(n)} = {_toml(v)}" for n, v in {"base": str(base), **content}.items()]
    path = folder / f"run_{number}.toml"
    with replacing(path) as temporary:
        temporary.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


def _toml(value: Any) -> str:
    """A value of a TOML file on one line."""
    if isinstance(value, Mapping):
        return f"{{ {', '.join(f'{json.dumps(n)} = {_toml(v)}' for n, v in value.items())} }}"
    if isinstance(value, list | tuple):
        return f"[{', '.join(map(_toml, value))}]"
    return json.dumps(value) if isinstance(value, bool | str) else repr(value)
