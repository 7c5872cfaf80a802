"""The commands of the tutorial, run as printed. As a module it renews the tutorial's pictures."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

DOCS = Path(__file__).parents[1] / "docs"
PAGE = DOCS / "tutorial.md"
BLOCK = re.compile(r"^```sh\n(.*?)^```$", re.MULTILINE | re.DOTALL)
PICTURE = re.compile(r"!\[[^\]]*\]\((images/tutorial/([\w.]+))\)")
HERE_DOCUMENT = re.compile(r"^(cat > \S+) <<'END'\n.*?^END$", re.MULTILINE | re.DOTALL)


def script() -> str:
    """All listings in their order."""
    return "".join(BLOCK.findall(PAGE.read_text(encoding="utf-8")))


def commands() -> list[str]:
    """The commands, without what is written into files."""
    return HERE_DOCUMENT.sub(r"\1", script()).splitlines()


def pictures() -> dict[str, Path]:
    """Pictures that the page shows, by the names of the files that the commands write."""
    return {name: DOCS / path for path, name in PICTURE.findall(PAGE.read_text(encoding="utf-8"))}


def follow(folder: Path) -> subprocess.CompletedProcess[str]:
    """Run the commands in a folder, with the `segfmu` of this interpreter."""
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    return subprocess.run(
        ["bash", "-e", "-c", script()], cwd=folder, env={**os.environ, "PATH": path},
        capture_output=True, text=True, timeout=900, check=False,
    )


def main() -> None:
    """Follow the tutorial in an empty folder and keep its pictures."""
    with tempfile.TemporaryDirectory() as folder:
        done = follow(Path(folder))
        if done.returncode:
            sys.exit(done.stdout + done.stderr)
        for name, kept in pictures().items():
            kept.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(Path(folder) / "out" / name, kept)


if __name__ == "__main__":
    main()
