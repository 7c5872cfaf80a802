"""The tutorial, followed in an empty folder, gives what it shows."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from matplotlib.testing.compare import compare_images

from tests.compiler import needs_native
from tests.tutorial import commands, follow, pictures

# RMS of differences of pixels, of 255: fonts may be drawn with other edges; make pictures renews
DIFFERENCE = 2.0


def test_it_is_short() -> None:
    assert 5 <= len(commands()) <= 15


@needs_native
@pytest.mark.skipif(shutil.which("bash") is None, reason="the listings need bash")
def test_it_runs_as_printed_and_gives_its_pictures(tmp_path: Path) -> None:
    work = tmp_path / "work"
    work.mkdir()
    done = follow(work)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "1 of 1 scenarios as expected" in done.stdout
    assert pictures()
    for name, kept in pictures().items():
        # the comparison writes beside both
        shown = shutil.copyfile(kept, tmp_path / f"shown_{name}")
        assert compare_images(str(shown), str(work / "out" / name), tol=DIFFERENCE) is None
