"""`segfmu.campaign` in scripts."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from tests.compiler import needs_native
from tests.validation.campaigns.files import CAMPAIGN, write

SCRIPT = """
import segfmu

print("begun")
segfmu.campaign("c.toml", "out", jobs=1)
"""


@needs_native
def test_a_script_without_a_guard_is_told_how_to_have_one(tmp_path: Path) -> None:
    write(tmp_path, CAMPAIGN)
    (tmp_path / "script.py").write_text(SCRIPT)
    done = subprocess.run(
        [sys.executable, "script.py"], cwd=tmp_path, capture_output=True, text=True, check=False,
        timeout=120,
    )
    *_, last = done.stderr.splitlines()
    assert done.returncode == 1
    assert last.startswith("segfmu.errors.InputError: workers of this machine do not start")
    assert 'the call belongs below if __name__ == "__main__":' in last
    # that of the worker is refused before it reads, builds or writes anything
    errors = [line for line in done.stderr.splitlines() if line.startswith("segfmu.errors.")]
    assert "a worker of a campaign came to the call that started it" in errors[0]
    assert len(errors) == 2 and done.stdout.splitlines() == ["begun", "begun"]
