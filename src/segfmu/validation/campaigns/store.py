"""The folder of a campaign: runs as they come, in Parquet files that appear when complete.

`campaign.json` says which campaign it is, `parts` has the runs so far, `runs.parquet` all of them.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import asdict
from errno import EACCES, EAGAIN, EDEADLK
from pathlib import Path
from time import monotonic
from typing import TYPE_CHECKING, Any

from segfmu.cosim.result import replacing
from segfmu.errors import InputError, first_line
from segfmu.validation.campaigns.campaign import Campaign, Run
from segfmu.validation.campaigns.probability import Probability
from segfmu.validation.campaigns.rare import Found, RareProbability
from segfmu.validation.campaigns.worker import Outcome
from segfmu.validation.files.campaign_tables import FactorTable
from segfmu.validation.output import require_there

if TYPE_CHECKING:
    import pyarrow

ABOUT, TABLE, PARTS, LOCK = "campaign.json", "runs.parquet", "parts", ".segfmu.lock"
SUMMARY = "results.json"
CAMPAIGN_FILES = (ABOUT, TABLE, SUMMARY)
RARE = "probabilities.json"
# s; runs that are not yet written are lost if the process is killed
FLUSH = 1.0


class Store:
    """The results of a campaign in a folder; a context manager that keeps others from it.

    Parameters
    ----------
    folder : Path
        It exists.
    campaign : Campaign

    Raises
    ------
    InputError
        If the folder has results of another campaign or cannot be written.
    """

    def __init__(self, folder: Path, campaign: Campaign) -> None:
        self._folder, self._campaign = folder, campaign
        self._schema = _schema(campaign)
        self._waiting: list[dict[str, Any]] = []
        self._flushed = monotonic()
        self._require_own()
        (folder / PARTS).mkdir(exist_ok=True)
        for left in (folder / PARTS).glob("*.part"):
            left.unlink()
        numbers = [int(p.stem) for p in (folder / PARTS).glob("*.parquet")]
        self._part = max(numbers, default=0)

    def add(self, made: Iterable[tuple[Run, Outcome]]) -> None:
        """Take runs, and write them after a second at the latest, with `flush`.

        Raises
        ------
        InputError
            When they cannot be written.
        """
        self._waiting += [self._row(run, outcome) for run, outcome in made]
        self.flush(FLUSH)

    def flush(self, patience: float = 0.0) -> None:
        """Write runs that wait, if the last time was so long ago [s]."""
        if not self._waiting or monotonic() - self._flushed < patience:
            return
        import pyarrow

        table = pyarrow.Table.from_pylist(self._waiting, self._schema)
        self._write(self._folder / PARTS / f"{self._part + 1:06d}.parquet", table)
        self._part += 1
        self._waiting, self._flushed = [], monotonic()

    def finish(self) -> pyarrow.Table:
        """Write all runs in the order of their numbers as one table, and remove the parts."""
        table = self.rows()
        self._write(self._folder / TABLE, table)
        for path in (self._folder / PARTS).glob("*.parquet"):
            path.unlink()
        with suppress(OSError):
            (self._folder / PARTS).rmdir()
        return table

    def _write(self, path: Path, table: pyarrow.Table) -> None:
        """Write a table; it appears when it is complete and on the disk."""
        import pyarrow.parquet

        # in a folder that is made again a part would pass for all
        require_there([self._folder / ABOUT])
        with replacing(path) as temporary, temporary.open("wb") as file:
            pyarrow.parquet.write_table(table, file)
            file.flush()
            os.fsync(file.fileno())

    def _require_own(self) -> None:
        path = self._folder / ABOUT
        own = {
            "name": self._campaign.source.file.name, "file": str(self._campaign.source.path),
            "draws": self._campaign.draws, "searched": self._campaign.searched,
            "factors": [f.name for f in self._campaign.factors],
            "criteria": list(self._campaign.criteria),
            "requirements": self._campaign.requirements, "evidence": self._campaign.evidence,
            "units": dict(self._campaign.units),
            "fingerprint": self._campaign.fingerprint(),
        }
        if path.exists():
            if _about(path).get("fingerprint") != own["fingerprint"]:
                raise InputError(
                    f"{self._folder} has results of another campaign, or of this one before its "
                    "files changed; give a new folder"
                )
            return
        with replacing(path) as temporary:
            temporary.write_text(json.dumps(own, indent=2) + "\n", encoding="utf-8")

    def _row(self, run: Run, outcome: Outcome) -> dict[str, Any]:
        row = {
            "run": run.number, "scenario": self._campaign.source.file.scenarios[run.scenario],
            **self._campaign.values(run), "passed": outcome.passed,
            "error": outcome.error or None, "arrival": outcome.arrival,
        }
        for found in outcome.findings:
            row[f"margin.{found.name}"] = found.margin
            row[f"bound.{found.name}"] = found.bound
            row[f"holds.{found.name}"] = found.passed
        return row

    def rows(self) -> pyarrow.Table:
        """All runs so far, written, in the order of their numbers, each once."""
        import pyarrow

        self.flush()
        whole = self._folder / TABLE
        paths = [whole] if whole.exists() else []
        paths += sorted((self._folder / PARTS).glob("*.parquet"))
        if not paths:
            return self._schema.empty_table()
        table = pyarrow.concat_tables([read_table(p, self._schema) for p in paths])
        first = table.append_column("row", pyarrow.array(range(table.num_rows)))
        first = first.group_by("run", use_threads=False).aggregate([("row", "min")])
        places = first.sort_by("run")["row_min"]
        return table.take(places).combine_chunks()


def _schema(campaign: Campaign) -> pyarrow.Schema:
    import pyarrow

    number, truth = pyarrow.float64(), pyarrow.bool_()
    names = {"int": pyarrow.int64(), "float": number, "bool": truth, "str": pyarrow.string()}
    fields = [("run", pyarrow.int64()), ("scenario", pyarrow.string())]
    fields += [(f.name, names[_kind(f)]) for f in campaign.factors]
    fields += [("passed", truth), ("error", pyarrow.string()), ("arrival", number)]
    for name in campaign.criteria:
        fields += [(f"margin.{name}", number), (f"bound.{name}", number), (f"holds.{name}", truth)]
    return pyarrow.schema(fields)


def _kind(factor: FactorTable) -> str:
    """The type of a factor's values, by its name."""
    if factor.variants is not None:
        return "str"
    if factor.range is not None:
        return "int" if factor.integer and not factor.relative else "float"
    kinds = {type(v).__name__ for v in factor.values or ()}
    if kinds == {"int"} and not factor.relative:
        return "int"
    return "float" if kinds & {"int", "float"} else kinds.pop()


def read_table(path: Path, schema: pyarrow.Schema | None = None) -> pyarrow.Table:
    """A table of runs.

    Raises
    ------
    InputError
        If it cannot be read, or lacks a column of the schema.
    """
    import pyarrow.parquet

    try:
        if schema is not None:
            _require_columns(schema, pyarrow.parquet.read_schema(path))
        return pyarrow.parquet.read_table(path, schema=schema)
    except (OSError, pyarrow.ArrowException) as error:
        reason = first_line(error)
        raise InputError(
            f"{path}: no table of runs: {reason}; without this file its runs are repeated"
        ) from None


def _require_columns(schema: pyarrow.Schema, found: pyarrow.Schema) -> None:
    """Raise for a column that a file lacks, which pyarrow fills with nothing."""
    import pyarrow

    missing = next((name for name in schema.names if name not in found.names), None)
    if missing is not None:
        raise pyarrow.ArrowInvalid(f"there is no column {missing}")


def _about(path: Path) -> dict[str, Any]:
    try:
        found = json.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror or error}") from None
    except ValueError as error:
        raise InputError(
            f"{path}: cannot be read: {error}; give a new folder, in which the campaign begins anew"
        ) from None
    return found if isinstance(found, dict) else {}


@contextmanager
def alone(folder: Path) -> Iterator[None]:
    """Keep other campaigns from a folder; the system lets go of it when the process ends.

    Raises
    ------
    InputError
        If another campaign is running there.
    """
    path = folder / LOCK
    with path.open("w", encoding="utf-8") as file:
        try:
            _lock(file.fileno())
        except OSError as error:
            reason = f"cannot be locked: {error.strerror}"
            if error.errno in (EACCES, EAGAIN, EDEADLK):
                reason = "another campaign is running in this folder"
            raise InputError(f"{folder}: {reason}") from None
        yield
    # another one may have opened it meanwhile; it stays


def _lock(descriptor: int) -> None:
    if os.name == "nt":
        import msvcrt

        msvcrt.locking(descriptor, msvcrt.LK_NBLCK, 1)  # type: ignore[attr-defined,unused-ignore]
    else:
        import fcntl

        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)


def write_probabilities(folder: Path, found: Mapping[str, Found]) -> None:
    """Write what a search for rare failures found, by the names of criteria."""
    content = {name: asdict(probability) for name, probability in found.items()}
    with replacing(folder / RARE) as temporary:
        temporary.write_text(json.dumps(content, indent=2) + "\n", encoding="utf-8")


def read_probabilities(folder: Path) -> dict[str, Found]:
    """What `write_probabilities` wrote; empty for a campaign that is no such search.

    Raises
    ------
    InputError
        If it cannot be read.
    """
    path = folder / RARE
    if not path.exists():
        return {}
    try:
        return {
            name: Probability(**values) if "draws" in values else RareProbability(**values)
            for name, values in _about(path).items()
        }
    except TypeError as error:
        raise InputError(f"{path}: no probabilities: {error}") from None


def about(folder: Path) -> dict[str, Any]:
    """What a `CampaignResult` says of the campaign in a folder, beside its table.

    Raises
    ------
    InputError
        If there is none.
    """
    found = _about(folder / ABOUT)
    try:
        # campaigns of older versions have no draws, searches, requirements and units
        return {
            "name": found["name"], "factors": tuple(found["factors"]),
            "criteria": tuple(found["criteria"]), "draws": found.get("draws", 0),
            "searched": tuple(found.get("searched", ())),
            "named": tuple(found.get("requirements", ())),
            "evidence": tuple(tuple(entry) for entry in found.get("evidence", ())),
            "units": {name: str(unit) for name, unit in dict(found.get("units", {})).items()},
        }
    except KeyError as key:
        raise InputError(f"{folder / ABOUT}: no campaign: {key} is missing") from None
    except (TypeError, ValueError) as error:
        raise InputError(f"{folder / ABOUT}: no campaign: {error}") from None
