"""Temporary folders go even where their removal was interrupted."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
import pytest

from segfmu import folders
from segfmu.cosim import write_csv
from segfmu.errors import InputError
from segfmu.fmu.placing import placing
from segfmu.validation.output import folder

LEFT = """
import shutil, sys
from segfmu import folders

def fail(*_, **__):
    if sys.argv[1] == "interrupted":
        raise SystemExit(143)

folder = folders.make_folder()
(folder / "file").touch()
print(folder)
remove = shutil.rmtree
shutil.rmtree = fail
try:
    folders.remove_folder(folder)
finally:
    shutil.rmtree = remove
"""


@pytest.mark.parametrize(("removal", "code"), [("interrupted", 143), ("failing", 0)])
def test_what_is_left_goes_at_the_end(removal: str, code: int, tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-c", LEFT, removal], capture_output=True, text=True, timeout=60,
        env={"TMPDIR": str(tmp_path)},
    )
    assert done.returncode == code
    assert done.stdout.startswith(str(tmp_path))
    assert not list(tmp_path.iterdir())


@pytest.mark.skipif(not hasattr(os, "fork"), reason="this system has no fork")
def test_a_process_that_is_forked_leaves_the_folders_of_the_first(tmp_path: Path) -> None:
    script = (
        "import os, sys\nfrom segfmu import folders\nfolder = folders.make_folder()\n"
        "child = os.fork()\nif child == 0:\n    sys.exit()\nos.waitpid(child, 0)\n"
        "sys.exit(0 if folder.exists() else 1)\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", script], env={"TMPDIR": str(tmp_path)}, timeout=60, check=False
    )
    assert done.returncode == 0
    assert not list(tmp_path.iterdir())


def test_a_folder_can_be_in_another_and_goes_with_its_block(tmp_path: Path) -> None:
    with folders.work_folder(tmp_path) as folder:
        assert folder.parent == tmp_path and folder.is_dir()
        (folder / "file").touch()
    assert not list(tmp_path.iterdir())


def test_the_place_of_temporary_files_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "nowhere"))
    with pytest.raises(InputError, match=r"temporary files cannot be written in .*nowhere: No such"
                       r".*; the variable TMPDIR can name another folder"):
        folders.make_folder()


def test_folders_are_made_below_each_other_however_many(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    deep = Path(*["d"] * 1200)
    try:
        write_csv(deep / "rows.csv", np.zeros(1, [("time", float)]))
        with placing([deep / "a" / "b" / "one.fmu"]) as work:
            (work / "one.fmu").touch()
        assert folder(deep / "c") == deep / "c"
        assert {path.name for path in deep.iterdir()} == {"rows.csv", "a", "c"}
    finally:
        # what Python of some versions removes step by step within each other
        subprocess.run(["rm", "-rf", "d"], check=True)
