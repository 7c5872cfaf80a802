"""What a further crane touches outside its own folders: the files whose code names the hook."""

from __future__ import annotations

import re
import tokenize
from pathlib import Path

SOURCE = Path(__file__).parents[1] / "src" / "segfmu"
OWN = re.compile(r"kernels/(hook|c)/|fmu/hook_|(.*/)?_?hook", re.IGNORECASE)
HOOK = re.compile("hook", re.IGNORECASE)
COMMENT = re.compile(r"/\*.*?\*/|//[^\n]*", re.DOTALL)

# in the order of CONTRIBUTING.md; a file goes from here as it no longer needs to know the hook
TOUCHED = {
    "tables of all cranes": (
        "kernels/entry_points.py", "codegen/__main__.py", "crane/kinds.py", "crane/flat_models.py",
        "crane/__init__.py", "__init__.py", "fmu/models.py", "fmu/pairs.py",
        "fmu/modelica/package.py", "fmu/modelica/library/package.mo", "validation/files/objects.py",
    ),
    "what hangs on the rope": (
        "kernels/crane/records.py", "kernels/crane/suspension.py", "kernels/crane/inverse.py",
        "kernels/crane/bounds.py", "kernels/crane/plant.py", "kernels/rig/records.py",
        "kernels/rig/setup.py", "crane/parameters.py", "crane/plant.py", "crane/rig.py",
        "crane/rope.py", "crane/contacts.py", "fmu/crane/c/crane.c", "fmu/crane/c/crane.h",
    ),
    "what there is not": (
        "kernels/messages.py", "kernels/clearance/records.py", "crane/actuators.py",
        "validation/archives.py", "validation/identification/identify.py",
        "validation/live/page.py",
    ),
    "keys of files": (
        "validation/files/crane_file.py", "validation/files/crane_parameters.py",
        "validation/files/controller_tables.py", "validation/files/mission.py",
        "validation/files/mission_checks.py", "validation/files/scenario_tables.py",
        "validation/scenario.py", "validation/planned.py",
    ),
    "what is shown": (
        "fmu/modelica/drawing.py", "validation/report/run_page.py", "validation/report/scene.py",
        "validation/report/web/page.css", "validation/report/web/scene.js",
        "validation/report/web/view.js",
    ),
    "baselines": tuple(
        f"validation/baselines/{name}.py"
        for name in ("course", "methods", "one_load", "swings", "trapezoids")
    ),
    # the lifting gear of the gantry crane
    "another hook": ("crane/stability.py", "validation/files/template.py"),
}


def code(path: Path) -> str:
    """A file without comments and docstrings."""
    if path.suffix != ".py":
        return COMMENT.sub("", path.read_text(encoding="utf-8"))
    with path.open("rb") as lines:
        return " ".join(
            token.string for token in tokenize.tokenize(lines.readline)
            if token.type != tokenize.COMMENT and not token.string.startswith('"""')
        )


def test_files_that_know_the_hook_are_these() -> None:
    found = {
        name for path in SOURCE.rglob("*")
        if path.suffix in {".py", ".c", ".h", ".mo", ".js", ".css"}
        and not OWN.match(name := path.relative_to(SOURCE).as_posix())
        and HOOK.search(code(path))
    }
    assert found == {name for names in TOUCHED.values() for name in names}
