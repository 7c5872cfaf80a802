"""A third crane: folders of its own in `third`, and five edits of a copy of the package."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import segfmu
from tests.test_seam import SOURCE, TOUCHED

THIRD = Path(__file__).parent / "third"
LAYERS = ("kernels", "crane", "fmu", "validation")
CHOSEN = "    elif int({0}[{1}.SUSPENSION]) == spreader_code():\n        {2}\n    else:\n        "
# what stands in a file, and what comes in its place
EDITS = {
    "kernels/crane/suspension.py": (
        ("\n\ndef has_tackle", "from segfmu.kernels.spreader.suspended import (\n"
         "    spreader_code,\n    spreader_driven,\n    spreader_inverse,\n    spreader_rhs,\n)\n"
         "\n\ndef has_tackle"),
        ("    else:\n        crane_rhs(", CHOSEN.format(
            "plant", "Plant", "spreader_rhs(plant, state, work, derivative)") + "crane_rhs("),
        ("    else:\n        crane_driven(", CHOSEN.format(
            "plant", "Plant", "spreader_driven(plant, state, work, derivative)")
         + "crane_driven("),
        ("    else:\n        crane_flat_inverse(", CHOSEN.format(
            "resistance", "Resistance",
            "spreader_inverse(flat, resistance, force, state, acceleration)")
         + "crane_flat_inverse("),
        ("return plant[Plant.PAYLOAD_MASS]",
         "return plant[Plant.PAYLOAD_MASS] + plant[Plant.TACKLE_MASS]"),
    ),
    "crane/flat_models.py": (
        ("MODELS = (GANTRY, HOOK)", "MODELS = (GANTRY, HOOK, SPREADER)"),
        ("from segfmu.errors", "from segfmu.crane.spreader.model import SPREADER\n"
         "from segfmu.errors"),
    ),
    "fmu/pairs.py": (
        ("PAIRS = (GANTRY, HOOK)", "PAIRS = (GANTRY, HOOK, SPREADER)"),
        ("from segfmu.fmu.standard", "from segfmu.fmu.spreader.pair import SPREADER\n"
         "from segfmu.fmu.standard"),
    ),
    "validation/files/crane_models.py": (
        ("FURTHER = (HOOK,)", "FURTHER = (HOOK, SPREADER)"),
        ("class ModelTables(Table):\n", "class ModelTables(Table):\n    spreader: Annotated["
         "SpreaderTable | None, Key(\"spreader on the rope\")] = None\n"),
        ("\nif TYPE_CHECKING", "from segfmu.validation.spreader.model import SPREADER\n"
         "from segfmu.validation.spreader.tables import SpreaderTable\n\nif TYPE_CHECKING"),
    ),
    "__init__.py": (
        ("\"segfmu.crane.hook\": (\"HookCrane\",),", "\"segfmu.crane.hook\": (\"HookCrane\",),\n"
         "    \"segfmu.crane.spreader\": (\"SpreaderCrane\",),"),
    ),
}


@pytest.fixture(scope="module")
def package(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the package, without compiled kernels, in which the third crane is registered."""
    copy = tmp_path_factory.mktemp("third") / "segfmu"
    shutil.copytree(SOURCE, copy, ignore=shutil.ignore_patterns("__pycache__", "*.so", "*.pyd"))
    for layer in LAYERS:
        shutil.copytree(THIRD / layer, copy / layer, dirs_exist_ok=True)
    for name, edits in EDITS.items():
        path = copy / name
        text = path.read_text(encoding="utf-8")
        for old, new in edits:
            assert text.count(old) == 1, (name, old)
            text = text.replace(old, new)
        path.write_text(text, encoding="utf-8")
    return copy


def test_no_other_file_is_edited() -> None:
    assert set(EDITS) == set(TOUCHED["registrations"])
    assert len(EDITS) == 5
    for layer in LAYERS:
        assert [p.name for p in (THIRD / layer).iterdir()] == ["spreader"]
        assert not (SOURCE / layer / "spreader").exists()


def test_a_third_crane_is_planned_simulated_and_read_from_files(package: Path) -> None:
    """Its plan within drives lasts as long as that of a gantry crane with both masses."""
    done = subprocess.run(
        [sys.executable, str(THIRD / "check.py")], cwd=package.parent, capture_output=True,
        env={**os.environ, "PYTHONPATH": str(package.parent), "SEGFMU_INTERPRETED": "1"},
        text=True, check=False,
    )
    assert done.returncode == 0, done.stderr
    heavy = segfmu.Crane(2.2, 1.155, 1.5, rope_min=0.2, rope_max=1.5)
    along = [segfmu.Waypoint([0.0, 0.0, z]) for z in (-0.9, -0.6)]
    bounds = segfmu.ActuatorBounds(force=[4.0, 3.0, 17.0], velocity=0.6)
    found = segfmu.plan_actuated(heavy, along, None, bounds).trajectory.duration
    assert float(done.stdout) == pytest.approx(found, rel=1e-9)


def test_its_kernels_are_translated_with_the_others(package: Path) -> None:
    """Its entry point is found, and its kernels are in the one module that becomes C."""
    code = (
        "from segfmu.codegen.amalgam import amalgamated\n"
        "from segfmu.kernels.entry_points import ENTRY_POINTS\n"
        "assert 'spreader_inverse' in {p.name for p in ENTRY_POINTS}\n"
        "assert 'def spreader_rhs' in amalgamated()\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=package.parent, capture_output=True,
        env={**os.environ, "PYTHONPATH": str(package.parent), "SEGFMU_INTERPRETED": "1"},
        text=True, check=False,
    )
    assert done.returncode == 0, done.stderr
