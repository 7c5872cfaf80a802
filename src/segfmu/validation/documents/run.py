"""What `segfmu simulate --json` prints."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated

from segfmu.validation.criteria import DRIVES
from segfmu.validation.documents.document import Part, ResultDocument, Text
from segfmu.validation.documents.plan import Use, bound_uses
from segfmu.validation.files.keys import Key
from segfmu.validation.runs import Run


class DrivePeak(Part):
    """What a drive has reached in the run."""

    drive: Annotated[str, Key("bridge, trolley or hoist")]
    force_N: Annotated[float, Key("largest magnitude of the force", "N")]
    velocity_m_s: Annotated[float, Key("largest magnitude of the velocity", "m/s")]


class Measure(Part):
    """A measure of the run against what is allowed."""

    name: Annotated[str, Key("what is measured")]
    unit: Annotated[str, Key("of both numbers")]
    value: Annotated[float, Key("measured")]
    allowed: Annotated[float, Key("the most that is allowed")]
    passed: Annotated[bool, Key("whether the value is allowed")]
    set_by: Annotated[str, Key("key of the mission, or bound, that sets what is allowed")]


class RunDocument(ResultDocument):
    """A mission that was co-simulated."""

    mission: Annotated[Text, Key("name of the mission")]
    passed: Annotated[bool, Key("the verdict")]
    duration_s: Annotated[float, Key("planned duration", "s")]
    end_s: Annotated[float, Key("end of the run", "s")]
    measures: Annotated[list[Measure], Key("what the verdict follows from")]
    peaks: Annotated[list[DrivePeak], Key("of every drive")]
    drives: Annotated[list[Use], Key("use of the known bounds of the drives; empty: none is known")]
    notes: Annotated[list[str], Key("what to know of the run, a sentence each")]
    files: Annotated[list[Text], Key("table, plot and report; the FMUs are beside them")]


def run_document(run: Run, files: Sequence[str]) -> RunDocument:
    """The document of a run."""
    found = run.criteria
    return RunDocument(
        mission=run.mission.name, passed=run.passed, duration_s=found.duration,
        end_s=float(run.time[-1]),
        measures=[
            Measure(name=row.name, unit=row.unit, value=row.value, allowed=row.allowed,
                    passed=row.passed, set_by=row.key)
            for row in found.rows
        ],
        peaks=[
            DrivePeak(drive=drive, force_N=found.peak_force[drive],
                      velocity_m_s=found.peak_velocity[drive])
            for drive in DRIVES
        ],
        drives=bound_uses(found.uses), notes=list(run.notes), files=list(files),
    )
