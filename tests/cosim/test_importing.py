"""The listings of docs/importing, run as they are, in the tools that are installed."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from segfmu import cli
from tests.cosim.importers import require, threads

ROOT = Path(__file__).parents[2]
PAGES = ROOT / "docs" / "importing"
# page -> the package that its listings import, and the versions of FMI of each
LISTINGS = {
    "casadi": ("casadi", ((2, 3),)), "ecos": ("ecospy", ((2,), (3,))),
    "fmpy": ("fmpy", ((2,), (2,))), "libcosim": ("libcosimpy", ((2,), (2,))),
}
EACH = [
    (page, i, fmi) for page, (_, listed) in LISTINGS.items()
    for i, versions in enumerate(listed) for fmi in versions
]
TARGET = (1.0, 0.8)


def listings(page: str) -> list[str]:
    return re.findall(r"```python\n(.*?)```", (PAGES / f"{page}.md").read_text(), re.S)


@pytest.fixture(scope="module")
def folders(tmp_path_factory: pytest.TempPathFactory) -> dict[int, Path]:
    """Folders in which `out` was built as the pages say, by version of FMI."""
    found = {}
    for fmi, option in ((2, ["--ssp"]), (3, ["--fmi", "3"])):
        found[fmi] = tmp_path_factory.mktemp(f"fmi{fmi}")
        arguments = [str(ROOT / "models" / "paper.toml"), *option, "-o", str(found[fmi] / "out")]
        cli.app(["build", *arguments], standalone_mode=False)
    return found


@pytest.mark.parametrize(("page", "index", "fmi"), EACH)
def test_listing_brings_the_load_to_its_target(folders, page: str, index: int, fmi: int) -> None:
    package, listed = LISTINGS[page]
    require(package)
    texts = listings(page)
    assert len(texts) == len(listed)
    code = texts[index]
    if page == "ecos":
        code = f"import ctypes\nctypes.CDLL({str(threads())!r}, ctypes.RTLD_GLOBAL)\n" + code
    result = subprocess.run(
        [sys.executable, "-c", code], cwd=folders[fmi], capture_output=True, text=True,
        timeout=300,
    )
    assert result.returncode == 0, result.stderr[-2000:]
    lines = [s for s in result.stdout.splitlines() if re.fullmatch(r"[-\d.e]+ [-\d.e]+", s)]
    assert np.allclose([float(x) for x in lines[-1].split()], TARGET, rtol=0.0, atol=1e-5)


def test_every_page_is_in_the_index() -> None:
    index = (PAGES / "README.md").read_text()
    linked = set(re.findall(r"\]\((\w+\.md)\)", index))
    assert linked == {p.name for p in PAGES.glob("*.md")} - {"README.md"}
