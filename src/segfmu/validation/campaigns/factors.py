"""From values of factors to changes of a scenario."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import Any

from segfmu.arrays import shown
from segfmu.errors import InputError
from segfmu.validation.campaigns.sampling import Sample
from segfmu.validation.files.campaign_tables import FactorTable
from segfmu.validation.files.reading import merged
from segfmu.validation.files.scenario_file import CHANGES, Source, build_scenario, inherit

# below these, the rest of a key is one name: variables of FMUs have dots
NAMES = (("parameters", 1), ("events", 2), ("fmus", 2))


def changes(source: Source, factors: Sequence[FactorTable], sample: Sample) -> dict[str, Any]:
    """What a sample changes in a scenario.

    Raises
    ------
    InputError
        For a key whose value has to be a number and is none, or that names no entry of a list.
    """
    found: dict[str, Any] = {}
    for factor in factors:
        if factor.name not in sample:
            continue
        value = sample[factor.name]
        if factor.variants is not None:
            own: dict[str, Any] = factor.variants[value]
        else:
            own = _keyed(source, found, factor, value)
        found = inherit(found, own)
    return found


def told(factor: FactorTable, value: Any) -> str:
    """A factor and its value in messages, which count entries of lists from 1, as keys do not."""
    counted = any(part.isdecimal() for part in (factor.key or "").split("."))
    where = f" ({factor.key}, which counts from 0)" if counted else ""
    return f"factor {factor.name} = {value}{where}"


def nominal(source: Source, factor: FactorTable) -> Any:
    """The value that the files have; None if they do not say it."""
    if factor.key is None:
        return None
    first, *rest = _parts(factor.key, source, {})
    try:
        return _found(_view(source, {}, first), rest)
    except InputError:
        return None


def _keyed(
    source: Source, before: Mapping[str, Any], factor: FactorTable, value: Any
) -> dict[str, Any]:
    assert factor.key is not None
    first, *rest = _parts(factor.key, source, before)
    view = _view(source, before, first)
    if factor.relative:
        known = _found(view, rest)
        if isinstance(known, bool) or not isinstance(known, int | float):
            if known is None:
                # a key that there is not has a better message
                build_scenario(source, {first: _assigned(view, rest, value, factor)})
            got = "" if known is None else f", but {shown(known)}"
            raise InputError(
                f"factors: {factor.name}: relative: {factor.key} is no number in the files{got}"
            )
        value = known * value
    return {first: _assigned(view, rest, value, factor)}


def _parts(key: str, source: Source, before: Mapping[str, Any]) -> list[str]:
    """A key as names of tables and places in lists."""
    parts = key.split(".")
    for first, depth in NAMES:
        if parts[0] == first:
            head = parts[:depth + 1]
            if first == "parameters" or parts[depth:depth + 1] == ["values"]:
                return [*head, ".".join(parts[depth + 1:])] if parts[depth + 1:] else head
    return parts


def _view(source: Source, before: Mapping[str, Any], first: str) -> Any:
    """A table of the scenario with its defaults, and with what it takes from mission and crane."""
    if "mission" in before:
        return _tables(Source(source.path, inherit(source.data, before))).get(first)
    known = _tables(source).get(first)
    if first not in (*CHANGES, "controller", "plan"):
        return inherit({first: known}, {first: before[first]})[first] if first in before else known
    view = known or {}
    crane = merged(before.get("crane", {}), {"controller": before.get("controller", {})})
    if first == "true_crane":
        view = merged(view, crane)
    if first == "controller":
        view = merged(view, before.get("crane", {}).get("controller", {}))
    return merged(view, before.get(first, {}))


@lru_cache(maxsize=64)
def _tables(source: Source) -> dict[str, Any]:
    """All tables of a checked scenario and its mission."""
    scenario = build_scenario(source)
    mission = scenario.mission.model_dump(exclude_none=True)
    return {
        **scenario.file.model_dump(exclude_unset=True),
        "crane": mission["crane"], "controller": mission["crane"]["controller"],
        "true_crane": scenario.mission.simulated.model_dump(exclude_none=True),
        "limits": mission.get("limits"), "simulation": mission["simulation"], "plan": mission,
    }


def _found(node: Any, path: Sequence[str]) -> Any:
    """The value at a path; None where there is none."""
    for part in path:
        if isinstance(node, list):
            node = node[_place(node, part)]
        else:
            node = node.get(part) if isinstance(node, Mapping) else None
    return node


def _assigned(node: Any, path: Sequence[str], value: Any, factor: FactorTable) -> Any:
    """The changes that set a value: tables with the path alone, lists as a whole."""
    if not path:
        return value
    first, *rest = path
    if isinstance(node, list):
        place = _place(node, first)
        own = _assigned(node[place], rest, value, factor)
        if isinstance(own, dict) and isinstance(node[place], Mapping):
            own = merged(node[place], own)
        return [*node[:place], own, *node[place + 1:]]
    if node is not None and not isinstance(node, Mapping):
        raise InputError(f"factors: {factor.name}: {factor.key}: {first} is below a value")
    return {first: _assigned((node or {}).get(first), rest, value, factor)}


def _place(entries: list[Any], part: str) -> int:
    """The place of an entry, by its number from 0 on or its name."""
    names = [e.get("name") if isinstance(e, Mapping) else None for e in entries]
    if part in names:
        return names.index(part)
    if part.isdecimal() and int(part) < len(entries):
        return int(part)
    raise InputError(
        f"factors: a list has no entry {part}; give its name, or its place from 0 to "
        f"{len(entries) - 1}"
    )
