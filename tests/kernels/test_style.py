"""How kernels and the C of the FMUs are written: names instead of numbers, few arguments."""

from __future__ import annotations

from pathlib import Path

import pytest

from segfmu.codegen.functions import functions
from tests.kernels.counts import c_subscripts, python_subscripts

SOURCE = Path(__file__).parents[2] / "src" / "segfmu"
KERNELS = sorted(p for p in (SOURCE / "kernels").glob("*/*.py") if not p.name.startswith("_"))
GENERATED_C = {"kernels.c", "kernels.h", "records.h", "messages.c", "messages.h", "module.c"}
C_FILES = sorted(
    p
    for folder in ("fmu", "kernels/c")
    for p in (SOURCE / folder).rglob("*.[ch]")
    # fmi/ has the headers of the FMI standard
    if p.parent.name != "fmi" and p.name not in GENERATED_C
)


def name(path: Path) -> str:
    return str(path.relative_to(SOURCE))


@pytest.mark.parametrize("path", KERNELS, ids=name)
def test_kernels_name_the_places_of_their_arrays(path: Path) -> None:
    assert python_subscripts(path.read_text(encoding="utf-8")) == []


@pytest.mark.parametrize("path", C_FILES, ids=name)
def test_c_names_the_places_of_its_arrays(path: Path) -> None:
    assert c_subscripts(path.read_text(encoding="utf-8")) == []


def test_files_are_found() -> None:
    names = {name(path) for path in KERNELS + C_FILES}
    assert {"kernels/planner/search.py", "kernels/rig/rig.py", "kernels/c/plan.c",
            "fmu/native/c/glue.h", "fmu/crane/c/crane.h"} <= names
    assert len(KERNELS) > 40


@pytest.mark.parametrize(
    "text",
    ["a[3]", "a[3 + i]", "a[i, 7]", "a[3 * i + 1]", "a[4:9, :]", "a[-3]", "a[0:1:3]",
     "a[b[5]]", "a[R.X + 3]", "a[0] = a[3]", "a[min(i, 4)]", "a[i][3]"],
)
def test_literal_subscripts_are_found(text: str) -> None:
    assert python_subscripts(f"def f(a):\n    {text}\n")


@pytest.mark.parametrize(
    "text",
    ["a[2]", "a[i + 1, 2]", "a[R.X + axis]", "a[0] * 3", "a[-1]", "a['3']", "f(3, a[i])",
     "# a[3]", "'a[3]'"],
)
def test_other_subscripts_are_not_counted(text: str) -> None:
    assert not python_subscripts(f"def f(a):\n    {text}\n    return 0\n")


@pytest.mark.parametrize(
    "text",
    ["x[4]", "x[i + 5]", "double x[3];", "x[y[7]]", "x[0x10]", "x[3u]", "x[ROW * 4 + 1]",
     "x[-3]", "x[1][3]", 'f("[", x[3])'],
)
def test_literal_subscripts_in_c_are_found(text: str) -> None:
    assert c_subscripts(text)


@pytest.mark.parametrize(
    "text",
    ["x[2]", "x[i + 1]", "double x[AXES_SIZE];", "x[V4]", "x[0] + 7", "/* x[3] */", "// x[3]",
     '"x[3]"', "int64_t x[2]", "x[ROW_3]", "'['"],
)
def test_other_subscripts_in_c_are_not_counted(text: str) -> None:
    assert not c_subscripts(text)


def test_kernels_take_few_arguments() -> None:
    counts = {f.name: len(f.arguments) for f in functions()}
    assert [n for n, count in counts.items() if count > 11] == []
    assert sum(count <= 7 for count in counts.values()) >= 0.9 * len(counts)
    # neither the kernels written here nor the generated ones are left out
    assert (counts["rig_step"], counts["crane_driven"]) == (9, 7)
