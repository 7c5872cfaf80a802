"""What an identification found as JSON."""

from __future__ import annotations

import json
from dataclasses import asdict
from math import isfinite
from pathlib import Path
from typing import Any

from segfmu.cosim.result import replacing
from segfmu.validation.identification.prediction import Prediction
from segfmu.validation.identification.result import Identification


def write_results(found: Identification, path: Path) -> Path:
    """Write the file; returns it.

    Raises
    ------
    InputError
        When it cannot be written.
    """
    content = {
        "crane": None if found.source is None else str(found.source),
        "converged": found.converged,
        "estimates": [_known(asdict(one)) for one in found.estimates],
        "untold": [asdict(one) for one in found.untold],
        "fitted": [_part(p) for p in found.fitted],
        "predicted": [_part(p) for p in found.predicted],
    }
    with replacing(path) as temporary:
        text = json.dumps(content, indent=2, allow_nan=False) + "\n"
        temporary.write_text(text, encoding="utf-8")
    return path


def _part(part: Prediction) -> dict[str, Any]:
    return {
        **_known({"log": part.log, "load": part.load}),
        "signals": [_known(asdict(one)) for one in part.signals],
        "outside": [asdict(one) for one in part.outside],
    }


def _known(entry: dict[str, Any]) -> dict[str, Any]:
    """Without NaN, which JSON has not: it is the fit of what does not move."""
    return {n: None if isinstance(v, float) and not isfinite(v) else v for n, v in entry.items()}
