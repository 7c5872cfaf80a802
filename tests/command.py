"""The command in the process of the tests, where it needs no imports."""

from __future__ import annotations

import subprocess
import sys
from contextlib import chdir, redirect_stderr, redirect_stdout
from io import StringIO
from pathlib import Path

import pytest

from segfmu import cli


def called(*words: str, cwd: Path) -> subprocess.CompletedProcess[str]:
    """Exit code and texts of `segfmu` with these words, called in a folder."""
    said, complained = StringIO(), StringIO()
    with pytest.MonkeyPatch.context() as patch, chdir(cwd):
        patch.setattr(sys, "argv", ["segfmu", *words])
        # what the usage is told of is then the first word of these
        patch.setattr(sys.modules["__main__"], "__package__", None)
        with redirect_stdout(said), redirect_stderr(complained):
            code = cli.run()
    return subprocess.CompletedProcess(words, code, said.getvalue(), complained.getvalue())
