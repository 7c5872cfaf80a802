"""TOML files, read and checked; an error is one line that names file and key."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator, Mapping
from difflib import get_close_matches
from pathlib import Path
from typing import Any, TypeVar

from pydantic import ValidationError
from pydantic_core import ErrorDetails

from segfmu.arrays import shown
from segfmu.errors import InputError, first_line
from segfmu.validation.files.keys import Entry, Table, entries

Checked = TypeVar("Checked", bound=Table)

# a mission with the most waypoints takes 60 kB
LARGEST = 4_000_000
# characters of a wrong value that are shown
SHOWN = 60
# findings about the size of a number: the entry of their context, and words
SIZES = {
    "greater_than": ("gt", "above"), "greater_than_equal": ("ge", "at least"),
    "less_than": ("lt", "below"), "less_than_equal": ("le", "at most"),
}
# findings about the length of a list, likewise
LENGTHS = {"too_short": ("min_length", "at least"), "too_long": ("max_length", "at most")}
# what tomllib says of keys and tables that are there twice, and a line that begins with one
DOUBLE = re.compile("Cannot (overwrite|declare|mutate)")
_PART = r"""(?:"(?:[^"\\]|\\.)*"|'[^']*'|[^\s"'=#.,\[\]{}]+)"""
_NAME = rf"({_PART}(?:\s*\.\s*{_PART})*)\s*"
KEY = re.compile(rf"\s*(?:{_NAME}=|\[+\s*(?![\d+-]){_NAME}\]+\s*(?:#|$))")
# findings about the type of a value, and words
TYPES = {"model_type": "table", "dict_type": "table", "list_type": "list"}


def read(path: Path) -> dict[str, Any]:
    """The content of a TOML file, with or without a byte order mark.

    Raises
    ------
    InputError
        If it cannot be read, is too large, or is not TOML.
    """
    try:
        with path.open("rb") as file:
            data = file.read(LARGEST + 1)
        if len(data) > LARGEST:
            most = LARGEST // 1_000_000
            raise InputError(f"{path}: larger than {most} MB, no file of a crane or what it does")
        return _parsed(path, data.decode("utf-8-sig"))
    except IsADirectoryError:
        raise InputError(f"{path}: this is a folder; name a file in it") from None
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    except UnicodeDecodeError:
        raise InputError(f"{path}: not a text file in UTF-8") from None
    except InputError:
        raise
    except ValueError as error:
        # a path with a null character
        raise InputError(f"{path}: cannot be read: {error}") from None


def of_named(file: Path, key: str, named: Path, error: InputError) -> InputError:
    """The error of a file that another one names, relative to that one as it was named."""
    link = ""
    if file.is_symlink() and not named.exists():
        link = (
            f"; {file} is a link, and what it names is looked for beside the link, not beside "
            f"{file.resolve()}"
        )
    return InputError(f"{file}: {key}: {error}{link}")


def _parsed(path: Path, text: str) -> dict[str, Any]:
    """The tables of a text; integers beyond those of TOML are refused, as nothing takes them."""
    try:
        found = tomllib.loads(text)
        key = next((key for key, value in leaves(found) if _is_long(value)), None)
        if key is None:
            return found
        cause = f"{key} has more than the 64 bits of an integer"
    except tomllib.TOMLDecodeError as error:
        cause = _doubled(text, first_line(error))
    except RecursionError:
        cause = "tables or lists in each other too deep"
    except ValueError:
        # an integer of more digits than Python reads
        lines = enumerate(text.splitlines(), 1)
        most, line = max((max(map(len, re.findall(r"[\d_]+", t)), default=0), n) for n, t in lines)
        cause = f"a number of {most} digits (at line {line})"
    raise InputError(f"{path}: not valid TOML: {cause}")


def _doubled(text: str, cause: str) -> str:
    """What is wrong with a text; of a key or table that is there twice its name and line."""
    if not DOUBLE.match(cause):
        return cause
    # the cause has the end of the value
    end = re.search(r"line (\d+)", cause)
    lines = text.split("\n")[: int(end[1]) if end else None]
    found = [(n, key[1] or key[2]) for n, line in enumerate(lines, 1) if (key := KEY.match(line))]
    if not found:
        return cause
    number, name = found[-1]
    return f"{name} is there twice (at line {number})"


def leaves(data: Any, name: str = "") -> Iterator[tuple[str, Any]]:
    """All values of a table, and of those in it, with their keys; a list is one value."""
    if not isinstance(data, Mapping):
        yield name, data
        return
    for key, value in data.items():
        yield from leaves(value, f"{name}.{key}" if name else str(key))


def _is_long(value: Any) -> bool:
    """Whether a value is an integer beyond those of TOML, or has one."""
    if isinstance(value, list):
        return any(_is_long(v) for v in value)
    if isinstance(value, Mapping):
        return any(_is_long(v) for v in value.values())
    return isinstance(value, int) and not -(2**63) <= value < 2**63


def checked(kind: type[Checked], data: Mapping[str, Any], where: str) -> Checked:
    """The table that the content of a file describes; `where` names the file.

    Raises
    ------
    InputError
        For the first key that is wrong.
    """
    try:
        return kind.model_validate(data)
    except ValidationError as error:
        raise InputError(f"{where}: {problem(kind, data, error)}") from None


def merged(base: Mapping[str, Any], changes: Mapping[str, Any]) -> dict[str, Any]:
    """A table with changes; tables within are merged too."""
    result = dict(base)
    for name, value in changes.items():
        old = result.get(name)
        both = isinstance(old, Mapping) and isinstance(value, Mapping)
        result[name] = merged(old, value) if both else value  # type: ignore[arg-type]
    return result


def problem(kind: type[Table], data: Mapping[str, Any], error: ValidationError) -> str:
    """The first finding as `key: what is wrong, got value`.

    A misspelt key, or one of another table, is before a missing one.
    """
    problems = error.errors(include_url=False)
    for found in problems:
        found["loc"] = _keys(data, found["loc"])
    unknown = [p for p in problems if p["type"] == "extra_forbidden"]
    misspelt = [p for p in unknown if _similar(kind, p["loc"])]
    misplaced = [p for p in unknown if _suggestion(kind, p["loc"])]
    others = len({p["loc"] for p in problems}) - 1
    more = f" (and {others} more)" if others else ""
    return f"{_finding(kind, [*misspelt, *misplaced, *problems][0])}{more}".replace("\n", " ")


def _keys(data: Any, place: tuple[int | str, ...]) -> tuple[int | str, ...]:
    """A place in a file without the names that pydantic gives to the types of a value."""
    found = []
    for part in place:
        if isinstance(part, str) and isinstance(data, str | int | float | list):
            continue
        found.append(part)
        if isinstance(data, Mapping):
            data = data.get(part)
        elif isinstance(data, list) and isinstance(part, int) and part < len(data):
            data = data[part]
        else:
            data = None
    return tuple(found)


def _finding(kind: type[Table], problem: ErrorDetails) -> str:
    key, entry = _named(kind, problem["loc"])
    if problem["type"] == "missing":
        return f"{key}: this key is missing"
    if problem["type"] == "extra_forbidden":
        return f"{_short(key)}: unknown key{_suggestion(kind, problem['loc'])}"
    text = _text(problem, entry)
    single = isinstance(problem["input"], str | int | float) or (entry and entry.kind is None)
    if problem["type"] == "value_error" and not single:
        # of a table: the text names the keys that do not fit each other
        return f"{key}: {text}" if key else text
    # of a list that is too long nobody would count what is shown
    long = problem["type"] == "too_long" and not (entry and entry.key.parts)
    got = len(problem["input"]) if long else shown(problem["input"])
    return f"{key or 'file'}: {text}, got {got}"


def _text(problem: ErrorDetails, entry: Entry | None) -> str:
    """What is wrong with a value, in words."""
    kind, context = problem["type"], problem.get("ctx", {})
    if kind in TYPES:
        return f"must be a {TYPES[kind]}"
    if kind in SIZES:
        name, words = SIZES[kind]
        unit = f" {entry.key.unit}" if entry and entry.key.unit else ""
        return f"must be {words} {context[name]:g}{unit}"
    if kind in LENGTHS:
        name, words = LENGTHS[kind]
        parts = entry.key.parts if entry else ()
        if parts:
            return f"must have {len(parts)} values ({', '.join(parts)})"
        return f"must have {words} {context[name]} value{'s' * (context[name] != 1)}"
    text = problem["msg"].replace("Value error, ", "")
    return text.replace("Input should be", "must be").replace("String should", "must")


def _named(kind: type[Table], place: tuple[int | str, ...]) -> tuple[str, Entry | None]:
    """A place in a file as words, with the axis of a number in a list, and its entry."""
    names = tuple(p for p in place if isinstance(p, str))
    entry = next((e for e in entries(kind) if e.path == names), None)
    words = [str(p + 1) if isinstance(p, int) else str(p) for p in place]
    parts = entry.key.parts if entry else ()
    if parts and isinstance(place[-1], int):
        return f"{'.'.join(words[:-1])}, {parts[place[-1]]}", entry
    return ".".join(words), entry


def _short(text: str) -> str:
    return text if len(text) <= SHOWN else f"{text[:SHOWN - 3]}..."


def _suggestion(kind: type[Table], place: tuple[int | str, ...]) -> str:
    """The key that may be meant: a similar one in this table, or one of this name elsewhere."""
    near = _similar(kind, place)
    if near:
        return f"; did you mean {near[0]}?"
    table = tuple(p for p in place[:-1] if isinstance(p, str))
    elsewhere = [e.path for e in entries(kind) if e.path[-1] == place[-1]]
    # those of tables within this one first
    elsewhere.sort(key=lambda path: path[: len(table)] != table)
    names = ", ".join(".".join(path) for path in elsewhere[:4])
    return f"; it is a key elsewhere: {names}" if names else ""


def _similar(kind: type[Table], place: tuple[int | str, ...]) -> list[str]:
    """The most similar key of the same table, if there is one."""
    *tables, name = (p for p in place if isinstance(p, str))
    names = [e.path[-1] for e in entries(kind) if list(e.path[:-1]) == tables]
    return get_close_matches(name.lower(), names, n=1)
