"""The table of a report that traces requirements to their evidence."""

from __future__ import annotations

from collections.abc import Sequence

from segfmu.validation.report.page import Cell, Section, Table
from segfmu.validation.requirements import Requirement

COLOURS = {True: "good", False: "bad", None: "soft"}


def requirement_sections(requirements: Sequence[Requirement]) -> list[Section]:
    """Requirement, criterion, evidence, verdict; nothing without requirements."""
    rows: list[tuple[Cell, ...]] = []
    for one in requirements:
        verdict = (one.verdict, COLOURS[one.holds])
        for i, evidence in enumerate(one.evidence):
            last: Cell = verdict if i == 0 else ("", "")
            rows.append((one.name if i == 0 else "", evidence.criterion, evidence.found, last))
        if not one.evidence:
            rows.append((one.name, "", "no criterion names it", verdict))
    if not rows:
        return []
    heads = ("requirement", "criterion", "evidence", "verdict")
    return [Section("Requirements", tables=[Table("What shows that they are met", heads, rows)])]
