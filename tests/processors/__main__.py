"""Do durations depend on processor or compiler, or on how a problem is written?

`python -m tests.processors --count 1000` plans random problems with the linear algebra of other
processors, with kernels of other compilers, and in other places, directions and units. It prints a
line for each, and ends with 1 if a duration differs by more than 1e-9.
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from tests.processors.agreement import Difference, durations
from tests.processors.problems import Problem, problems, rewritten
from tests.processors.variants import Variant, builds, processors

PARTS = ("processors", "compilers", "rewritten")


def differences(
    given: list[Problem], parts: list[str], folder: Path
) -> Iterator[Difference | Variant]:
    """What each variant differs by, and variants that are skipped."""
    expected = durations(given, folder)
    variants: list[Iterator[Variant]] = []
    variants += [processors()] if "processors" in parts else []
    variants += [builds(folder)] if "compilers" in parts else []
    for some in variants:
        for variant in some:
            if variant.skipped:
                yield variant
            else:
                yield Difference(variant.name, durations(given, folder, variant), expected)
    if "rewritten" in parts:
        for name, changed, factors in rewritten(given):
            found = durations(changed, folder)
            yield Difference(name, np.where(found > 0.0, found / factors, found), expected)


def main() -> int:
    """The command."""
    parser = argparse.ArgumentParser(description="Durations on other processors.")
    parser.add_argument("--count", type=int, default=1000, help="problems, about")
    parser.add_argument("--parts", nargs="+", choices=PARTS, default=list(PARTS))
    parser.add_argument("--kinds", nargs="+", help="only kinds that begin so")
    parser.add_argument("--smoothness", type=int, nargs="+", default=[2, 3, 4, 5, 6])
    parser.add_argument("--offenders", type=Path, help="file for the problems that differ")
    asked = parser.parse_args()
    given = [
        p for p in problems(asked.count)
        if p["n"] in asked.smoothness
        and (asked.kinds is None or p["kind"].startswith(tuple(asked.kinds)))
    ]
    print(f"{len(given)} problems")
    wrong = 0
    lines = []
    with tempfile.TemporaryDirectory() as folder:
        for found in differences(given, asked.parts, Path(folder)):
            if isinstance(found, Variant):
                print(f"{found.name:34} skipped: {found.skipped}", flush=True)
                continue
            print(found, flush=True)
            wrong += len(found.wrong)
            kinds = Counter(f"{given[i]['kind']}, n = {given[i]['n']}" for i in found.wrong)
            for kind, count in sorted(kinds.items()):
                print(f"    {count:5} {kind}", flush=True)
            lines += [
                f"{found.name}: {found.expected[i]!r} s, now {found.found[i]!r} s: "
                f"{json.dumps(given[i])}" for i in found.wrong
            ]
    if asked.offenders is not None:
        asked.offenders.write_text("".join(f"{line}\n" for line in lines), "utf-8")
    return int(wrong > 0)


if __name__ == "__main__":
    sys.exit(main())
