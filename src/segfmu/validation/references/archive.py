"""The references in an FMU's archive: experiments, tables, reports."""

from __future__ import annotations

import csv
import io
import posixpath
import zipfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar
from urllib.parse import unquote
from xml.etree import ElementTree as ET

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.errors import InputError
from segfmu.fmu.standard.ls_ref import (
    FOLDER,
    MANIFEST,
    PARAMETERS,
    TABLE,
    Experiment,
    File,
    Related,
    read_experiments,
    read_manifest,
)
from segfmu.planning.rows import UNIT, number_of

Read = TypeVar("Read")
# as tables and parameter sets write them
TRUTH = {"true": "1", "false": "0"}


@dataclass(frozen=True, eq=False)
class Columns:
    """A table: "time" and columns that are numbers, and the names of those that are not."""

    numbers: dict[str, FloatArray]
    texts: tuple[str, ...]


@dataclass(frozen=True, eq=False)
class Case:
    """An experiment with what belongs to it.

    Attributes
    ----------
    name : str
    start, stop, step : float
        Times of the experiment and communication step [s].
    references : Columns
        Results that are expected.
    values : dict of str
        Parameters and start values.
    stimuli : dict of str to ndarray
        "time" and inputs; empty without any.
    """

    name: str
    start: float
    stop: float
    step: float
    references: Columns
    values: dict[str, Any]
    stimuli: dict[str, FloatArray]


@dataclass(frozen=True, eq=False)
class References:
    """What an archive proves itself with.

    Attributes
    ----------
    cases : tuple of Case
        What can be repeated.
    reports : tuple of Related
        What was said of the results.
    missing : tuple of str
        Files that the archive lists and does not have, or that cannot be read here.
    """

    cases: tuple[Case, ...]
    reports: tuple[Related, ...]
    missing: tuple[str, ...]


def read_references(path: Path) -> References:
    """The references of an FMU.

    An experiment without times, and a result without an experiment, are of the experiment that the
    model description tells; without that, they have the times of the results.

    Raises
    ------
    InputError
        For a file that is no archive, has no references, or no results that can be repeated.
    """
    try:
        with zipfile.ZipFile(path) as archive:
            found = _Reader(path, archive).references()
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror or error}") from None
    except (zipfile.BadZipFile, NotImplementedError, RuntimeError) as error:
        raise InputError(f"{path}: not a readable FMU: {error}") from None
    if not found.cases:
        lacking = "".join(f"; {text}" for text in found.missing)
        raise InputError(f"{path}: no reference result that can be repeated{lacking}")
    return found


class _Reader:
    def __init__(self, path: Path, archive: zipfile.ZipFile) -> None:
        self._path, self._archive = path, archive
        self._names = set(archive.namelist())
        self._missing: list[str] = []

    def references(self) -> References:
        if MANIFEST not in self._names:
            raise InputError(
                f"{self._path}: has no references ({MANIFEST}); segfmu build --references writes "
                "them"
            )
        try:
            listed = read_manifest(self._archive.read(MANIFEST))
        except ValueError as error:
            raise InputError(f"{self._path}: {MANIFEST}: {error}") from None
        tests = [file for file in listed if file.role.split("/")[0] == "experiment"]
        told = [(f, self._read(f.source, FOLDER, read_experiments)) for f in tests]
        unread = [file.source for file, found in told if found is None]
        cases, used = [], set()
        for file, found in told:
            for one in found or ():
                base = posixpath.dirname(_place(file.source, FOLDER))
                if one.references is not None:
                    used.add(_place(one.references.source, base))
                    cases.append(self._case(one, base))
        for file in listed:
            if file.role != "result" or _place(file.source, FOLDER) in used:
                continue
            if unread:
                self._missing.append(f"{file.source}: may be of {unread[0]}, which cannot be read")
                continue
            default = Experiment(
                file.description or file.source, references=File(file.source, file.type)
            )
            cases.append(self._case(default, FOLDER))
        reports = tuple(file for file in listed if file.role == "report")
        return References(tuple(c for c in cases if c), reports, tuple(self._missing))

    def _case(self, one: Experiment, base: str) -> Case | None:
        """What belongs to an experiment; None if a part of it is missing or not known."""
        if one.other:
            self._missing.append(f"{one.name}: has an element {one.other}, which is not known")
            return None
        before = len(self._missing)
        table = self._typed(one.references, base, TABLE, _columns)
        stimuli = self._typed(one.stimuli, base, TABLE, _columns)
        values = self._typed(one.parameters, base, PARAMETERS, _parameters)
        if stimuli is not None and stimuli.texts:
            self._missing.append(f"{one.name}: {', '.join(stimuli.texts)}: inputs are no numbers")
        if table is None or len(self._missing) > before:
            return None
        return Case(
            one.name, *self._times(one, table.numbers["time"]), table, values or {},
            stimuli.numbers if stimuli else {},
        )

    def _times(self, one: Experiment, rows: FloatArray) -> tuple[float, float, float]:
        default = self._default()
        told = zip(
            (one.start, one.stop, one.step), ("startTime", "stopTime", "stepSize"), strict=True
        )
        start, stop, step = (float(default[k]) if v is None and k in default else v
                             for v, k in told)
        gaps = np.diff(rows)
        shortest = float(gaps[gaps > 0.0].min()) if (gaps > 0.0).any() else float(rows[-1])
        return (
            float(rows[0]) if start is None else start, float(rows[-1]) if stop is None else stop,
            shortest if step is None else step,
        )

    def _default(self) -> dict[str, str]:
        try:
            root = ET.fromstring(self._archive.read("modelDescription.xml"))
        except (KeyError, ET.ParseError):
            return {}
        element = root.find("DefaultExperiment")
        return {} if element is None else dict(element.attrib)

    def _typed(
        self, file: File | None, base: str, wanted: str, read: Callable[[bytes], Read]
    ) -> Read | None:
        if file is None:
            return None
        if file.type != wanted:
            self._missing.append(f"{file.source}: is of type {file.type}, {wanted} can be read")
            return None
        return self._read(file.source, base, read)

    def _read(self, source: str, base: str, read: Callable[[bytes], Read]) -> Read | None:
        name = _place(source, base)
        if name not in self._names:
            self._missing.append(f"{source}: is not in the archive")
            return None
        try:
            return read(self._archive.read(name))
        except ValueError as error:
            self._missing.append(f"{source}: {error}")
            return None


def _place(source: str, base: str) -> str:
    """The name in the archive of a URI relative to a folder of it."""
    return posixpath.normpath(posixpath.join(base, unquote(source)))


def _columns(text: bytes) -> Columns:
    """A CSV file."""
    names, *rows = list(csv.reader(io.StringIO(text.decode("utf-8-sig")))) or [[]]
    names = [UNIT.sub("", name).strip() for name in names]
    rows = [row for row in rows if row]
    if "time" not in names or not rows:
        raise ValueError("no table with a column time and rows")
    if any(len(row) != len(names) for row in rows):
        raise ValueError("rows with more or fewer values than names")
    numbers, texts = {}, []
    for name, column in zip(names, zip(*rows, strict=True), strict=True):
        try:
            numbers[name] = np.array([number_of(TRUTH.get(t.strip(), t.strip())) for t in column])
        except ValueError:
            texts.append(name)
    # an event has a row before and one behind
    if "time" not in numbers:
        raise ValueError("its times are no numbers")
    if not np.all(np.diff(numbers["time"]) >= 0.0):
        raise ValueError("its times do not increase")
    return Columns(numbers, tuple(texts))


def _parameters(text: bytes) -> dict[str, Any]:
    """Values of a parameter set (SSP 1.0 or 2.0) by name."""
    found: dict[str, Any] = {}
    try:
        root = ET.fromstring(text)
    except ET.ParseError as error:
        raise ValueError(f"no XML: {error}") from None
    for element in root.iter():
        if element.tag.rpartition("}")[2] == "Parameter":
            for value in element:
                kind = value.tag.rpartition("}")[2]
                if value.get("value") is not None:
                    found[element.get("name", "")] = _value(kind, value.get("value", ""))
    return found


def _value(kind: str, text: str) -> Any:
    if kind in ("String", "Enumeration"):
        return text
    if kind == "Boolean":
        return text in ("true", "1")
    numbers = [float(part) for part in text.split()]
    exact = numbers if kind.startswith(("Real", "Float")) else [int(n) for n in numbers]
    return exact[0] if len(exact) == 1 else exact
