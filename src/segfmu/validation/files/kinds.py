"""The four kinds of file, told apart by keys that only one of them has."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from segfmu.errors import InputError

# kind -> its own keys, and what takes such a file
KINDS = {
    "crane": (
        ("bridge_mass", "trolley_mass", "payload_mass"),
        'a mission names it, as crane = "crane.toml"',
    ),
    "mission": (("waypoints",), "segfmu plan, build and simulate take it"),
    "scenario": (("criteria", "events", "profiles"), "segfmu validate takes it"),
    "campaign": (("scenarios", "sampling", "factors"), "segfmu campaign takes it"),
}


def require_kind(kind: str, data: Mapping[str, Any], where: object) -> None:
    """Refuse a file of another kind.

    Raises
    ------
    InputError
        With the kind that it is, and what takes it.
    """
    if data.keys() & set(KINDS[kind][0]):
        return
    for other, (own, taken) in KINDS.items():
        if data.keys() & set(own):
            raise InputError(f"{where}: this is a {other} file, not a {kind} file; {taken}")
