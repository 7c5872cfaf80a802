"""What a campaign found as JSON, for programs that do not read Parquet."""

from __future__ import annotations

import json
from dataclasses import asdict
from math import isfinite
from pathlib import Path
from typing import Any

from segfmu.cosim.result import replacing
from segfmu.validation.campaigns.result import CampaignResult
from segfmu.validation.campaigns.store import SUMMARY
from segfmu.validation.campaigns.summary import Summary


def write_summary(result: CampaignResult) -> Path:
    """Write `results.json` beside the table of runs; returns the file.

    Raises
    ------
    InputError
        When it cannot be written.
    """
    content = {
        "campaign": result.name, "passed": result.passed, "runs": result.table.num_rows,
        "errors": len(result.errors), "searched": list(result.searched),
        "requirements": [
            {"requirement": one.name, "verdict": one.verdict,
             "evidence": [asdict(evidence) for evidence in one.evidence]}
            for one in result.requirements
        ],
        "criteria": [_entry(result, s) for s in result.summaries],
    }
    path = result.folder / SUMMARY
    with replacing(path) as temporary:
        text = json.dumps(content, indent=2, allow_nan=False) + "\n"
        temporary.write_text(text, encoding="utf-8")
    return path


def _entry(result: CampaignResult, row: Summary) -> dict[str, Any]:
    known = row.worst is not None and isfinite(row.worst)
    entry: dict[str, Any] = {
        "criterion": row.criterion, "judged": row.judged, "held": row.held,
        # JSON has neither NaN nor infinity
        "worst_margin": row.worst if known else None, "unit": row.unit or None,
        "worst_run": row.run, "worst_case": None, "replay": None, "fails": None,
    }
    if row.run is not None:
        entry |= {"worst_case": result.values(row.run), "replay": result.command(row.run)}
    if row.fails is not None:
        low, high = row.fails.interval
        entry["fails"] = {
            **asdict(row.fails), "low": low, "high": high, "told": str(row.fails),
        }
    return entry
