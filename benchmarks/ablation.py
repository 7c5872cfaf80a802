"""Each way of planning switched off: which plans last longer without it, and which are refused.

A way is switched off in a copy of the package, by a first statement in functions of the kernels in
C, which are compiled again.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

import numpy as np

from benchmarks.report import Part, Record, Section, Settings
from segfmu.kernels.planner.records import LoopArc

ROOT = Path(__file__).parents[1]
KERNELS = Path("segfmu") / "kernels"
# function of the kernels -> what it does instead
WAYS: dict[str, dict[str, str]] = {
    "passing profiles": {
        "passing_either_way": "return count;", "passing_form": "return 0;",
        "slower_form": "return 0;",
    },
    "more starts of passing profiles": {
        "plan_thoroughly": "return;", "touching_form": "return count;",
    },
    "dips": {"shorter_dipped": "return count;", "timed_dipped": "return -1.0;"},
    "levels next to one ramp": {"loop_form": "return count;", "timed_loop": "return;"},
    "folds of these levels": {
        "loop_form": f"if (last > {LoopArc.SINGLE:d}) last = {LoopArc.SINGLE:d};",
    },
    "first members among rising ones": {"rising_member": "return -1.0;"},
    "steeper rises": {"smoothness_share": "return 0.0;"},
    "lower cruise velocities": {"slower_cruise": "return 0;"},
    "braking where it is not needed": {"may_last_longer": "return 0;"},
    "limits reached for an instant": {"insert_instant": "return 0;"},
    "limits touched": {"touch_limit": "return 0;"},
    "limits that come down in steps": {"tighten": "return 0;"},
    "a slower pace": {"slow_down": "return 0;"},
    "much shorter starts": {"shorter_solution": "return 0;"},
    "slower passing profiles": {"slower_passing": "return -1.0;"},
    "least and largest distance": {"between_extremes": "return -1.0;"},
    "leads over levels": {"search_levels": "return;", "goes_on_at_level": "return 0;"},
    "ends of stages of leads": {"improve_ends": "return;"},
    "leads along the old plan": {"follow_plan": "return;"},
    "free states moved one by one": {"polish_state": "return;"},
}
LIMITED = () if sysconfig.get_config_var("Py_GIL_DISABLED") else ("-DPy_LIMITED_API=0x030B0000",)
OPTIONS = (
    "-std=c99", "-O2", "-ffp-contract=off", "-w", "-fPIC", "-shared", "-fno-math-errno",
    "-fno-trapping-math", *LIMITED,
)
COMMAND = ("-m", "benchmarks.real_work")
GROUPS = {"3, 4": ("3", "4"), "5, 6": ("5", "6")}
# of a duration; what makes fewer plans longer than this is of no use
LONGER = 1.01
# kind of work -> smoothness -> durations [s], None where refused
Durations = dict[str, dict[str, list[float | None]]]


def switched_off(source: str, functions: dict[str, str]) -> str:
    """The kernels with another first statement in some functions."""
    for name, statement in functions.items():
        source, count = re.subn(
            rf"(^static \w+ {name}\([^;{{]*\) \{{\n)", rf"\g<1> {statement}", source, flags=re.M
        )
        if count != 1:
            raise LookupError(f"kernels.c has {count} functions {name}, expected one")
    return source


def build(functions: dict[str, str], folder: Path) -> Path:
    """A copy of the package in a folder whose kernels lack some functions."""
    compiler = shutil.which("cc")
    if compiler is None:
        raise LookupError("there is no C compiler cc on the path; install one")
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(
        ROOT / "src" / "segfmu", folder / "segfmu",
        ignore=shutil.ignore_patterns("__pycache__", "binaries", "_compiled*"),
    )
    sources = folder / KERNELS / "c"
    changed = switched_off((sources / "kernels.c").read_text("utf-8"), functions)
    (sources / "kernels.c").write_text(changed, encoding="utf-8")
    subprocess.run(
        [compiler, *OPTIONS, f"-I{sysconfig.get_path('include')}", str(sources / "module.c"),
         str(sources / "kernels.c"), "-lm", "-o", str(folder / KERNELS / "_compiled.abi3.so")],
        check=True,
    )
    return folder


def durations(package: Path, count: int) -> Durations:
    """What the kernels of a copy plan."""
    file = package / "durations.json"
    subprocess.run(
        [sys.executable, *COMMAND, str(count), str(file)], check=True,
        cwd=ROOT, env=os.environ | {"PYTHONPATH": str(package)},
    )
    found: Durations = json.loads(file.read_text("utf-8"))
    return found


def effects(way: str, whole: Durations, without: Durations) -> list[Record]:
    """Rows of the kinds of work that need a way; one row if there is none."""
    rows: list[Record] = []
    for kind, by_smoothness in whole.items():
        for group, numbers in GROUPS.items():
            a = np.array([d for n in numbers for d in by_smoothness[n]], dtype=np.float64)
            b = np.array([d for n in numbers for d in without[kind][n]], dtype=np.float64)
            refused = int((np.isnan(b) & ~np.isnan(a)).sum())
            both = ~np.isnan(a) & ~np.isnan(b) & (a > 0.0)
            ratio = b[both] / a[both]
            longer = 100.0 * float(np.mean(ratio > LONGER)) if ratio.size else 0.0
            if refused or longer > 0.0:
                rows.append({
                    "without": way, "kind of work": kind, "n": group, "plans": int(both.sum()),
                    "refused anew": refused, f"over {LONGER:g}, %": longer,
                    "95 %": float(np.quantile(ratio, 0.95)), "largest": float(ratio.max()),
                })
    return rows or [{
        "without": way, "kind of work": "none", "n": "", "plans": 0, "refused anew": 0,
        f"over {LONGER:g}, %": 0.0, "95 %": 1.0, "largest": 1.0,
    }]


def measure(settings: Settings) -> Part:
    """One table: what each way shortens."""
    count = max(settings.samples, 64)
    folder = settings.folder.resolve() / "ablation"
    whole = durations(build({}, folder / "whole"), count)
    rows: list[Record] = []
    for way, functions in WAYS.items():
        package = build(functions, folder / re.sub(r"\W+", "-", way))
        rows += effects(way, whole, durations(package, count))
    return Part("Each way of planning switched off", (Section("What needs it", rows),), (
        f"{count} problems of a kind and smoothness; missions with free states and plans within "
        "drives less often, and at n = 4 alone",
    ))
