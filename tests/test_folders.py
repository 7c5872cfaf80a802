"""Temporary folders go even where their removal was interrupted."""

from __future__ import annotations

import subprocess
import sys

INTERRUPTED = """
import shutil
from segfmu import folders

folder = folders.make_folder()
(folder / "file").touch()
print(folder)
remove = shutil.rmtree
shutil.rmtree = lambda *_, **__: (_ for _ in ()).throw(SystemExit(143))
try:
    folders.remove_folder(folder)
finally:
    shutil.rmtree = remove
"""


def test_what_is_left_goes_at_the_end(tmp_path) -> None:
    done = subprocess.run(
        [sys.executable, "-c", INTERRUPTED], capture_output=True, text=True, timeout=60,
        env={"TMPDIR": str(tmp_path)},
    )
    assert done.returncode == 143
    assert done.stdout.startswith(str(tmp_path))
    assert not list(tmp_path.iterdir())
