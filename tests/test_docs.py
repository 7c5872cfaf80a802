"""Every path, make target and command that the documentation names exists."""

from __future__ import annotations

import importlib.util
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from segfmu.cli import app

ROOT = Path(__file__).parents[1]
SOURCE = ROOT / "src" / "segfmu"

PAGES = sorted(
    page
    for pattern in ("*.md", "docs/**/*.md", "fmus/*/*.md", "models/**/*.md")
    for page in ROOT.glob(pattern)
    if page.name != "CHANGELOG.md"  # names files as they were
)

CODE = re.compile(r"`([^`\n]+)`|^(?: {4}|\$ )(\S.*)$", re.MULTILINE)
FENCED = re.compile(r"^```(?:sh)?\n(.*?)^```$", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"\]\(([^)#\s]+)(?:#[^)]*)?\)")
FILE = re.compile(
    r"(?<![\w/.*<{-])((?:[\w.-]+/)*[\w-][\w.-]*\.(?:py|md|toml|html|json|c|h|mo))(?![\w/*-])"
)
FOLDER = re.compile(r"^((?:src|docs|tests|fmus|models|examples|kernels|fmu|crane)/[\w/.-]*[\w/])$")
SOURCE_FILE = re.compile(r"(?<![\w/.*<{-])((?:[\w-]+/)+[\w-]+\.(?:py|md))(?![\w/*-])")
MODULE = re.compile(r"python -m ((?:segfmu|tests|benchmarks)[\w.]*)")

# what commands write, and files of the reader's own
WRITTEN = (
    "out", "dist", "build", "fmus/dist", "/home", "sources", "documentation", "resources", "hall",
    "yard", "scenarios",
)
OTHERS = {
    "mission.toml", "crane.toml", "report.html", "./mission.schema.json", "mission.schema.json",
    "campaign.json", "new.toml", "verdict.json",
    "gust.py", "sway_damper.py", "sway_damper.toml", "conftest.py", "test_crane.py",
    "package.mo", "MyMission.mo", "Mission.mo", "feeds.c",
    "GantryFeedforward_me_FMU.mo", "GantryCrane_me_FMU.mo", "feeds.h",
    "variables.c", "variables.h",
}


def _commands(text: str) -> Iterator[str]:
    """Code in a page, line by line."""
    for inline, block in CODE.findall(text):
        yield inline or block
    for block in FENCED.findall(text):
        yield from block.splitlines()


def _exists(page: Path, name: str) -> bool:
    """Whether a file is in the repository, the package, or beside the page."""
    if name.startswith(WRITTEN) or name in OTHERS:
        return True
    if any((folder / name).exists() for folder in (ROOT, SOURCE, page.parent)):
        return True
    # a bare name after one with its folder: `kernels/c/kernels.c`, `kernels.h`
    return "/" not in name and any((*SOURCE.rglob(name), *(ROOT / "tests").rglob(name)))


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_files_exist(page: Path) -> None:
    text = page.read_text(encoding="utf-8")
    named = {
        match for code in _commands(text) for pattern in (FILE, FOLDER)
        for match in pattern.findall(code)
    }
    missing = sorted(name for name in named if not _exists(page, name))
    links = (link for link in LINK.findall(text) if "://" not in link)
    missing += sorted(link for link in links if not (page.parent / link).exists())
    assert not missing, f"{page.name} names what does not exist: {', '.join(missing)}"


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_commands_exist(page: Path) -> None:
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    targets = set(re.findall(r"^([a-z][a-z-]*):", makefile, re.MULTILINE))
    commands = {command.name or command.callback.__name__ for command in app.registered_commands}  # type: ignore[union-attr]
    for code in _commands(page.read_text(encoding="utf-8")):
        for target in re.findall(r"\bmake ([a-z][a-z-]*)", code):
            assert target in targets, f"{page.name}: make {target}"
        for command in re.findall(r"(?:^|\s)segfmu ([a-z]+)", code):
            assert command in commands, f"{page.name}: segfmu {command}"
        for module in MODULE.findall(code):
            assert importlib.util.find_spec(module) is not None, f"{page.name}: {module}"


def test_campaigns_have_folders_of_their_own() -> None:
    """A folder with the results of another one is refused: the pages could not be followed."""
    places: dict[str, set[str]] = {}
    for page in PAGES:
        for code in _commands(page.read_text(encoding="utf-8")):
            for campaign, folder in re.findall(r"segfmu campaign (\S+) -o (\S+)", code):
                places.setdefault(folder, set()).add(campaign)
    assert len(places) > 5 and all(len(campaigns) == 1 for campaigns in places.values()), places


def test_sources_name_files_that_exist() -> None:
    kernels = SOURCE / "kernels"
    for source in (file for kind in ("py", "c", "h") for file in SOURCE.rglob(f"*.{kind}")):
        for name in SOURCE_FILE.findall(source.read_text(encoding="utf-8")):
            found = any((base / name).exists() for base in (ROOT, SOURCE, kernels, source.parent))
            assert found, f"{source.relative_to(ROOT)} names {name}"
