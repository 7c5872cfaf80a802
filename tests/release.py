"""What a release needs to agree on: `python -m tests.release`; part of `make release`."""

from __future__ import annotations

import re
import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).parents[1]
# file -> where its version is
PLACES = {
    "CITATION.cff": r"^version: (\S+)$",
    "src/segfmu/fmu/modelica/library/package.mo": r'^    version = "([^"]+)",$',
}
SECTION = re.compile(r"^## \[([^\]]+)\](?: - (\S+))?\n(.*?)(?=^## \[|\Z)", re.MULTILINE | re.DOTALL)


def version() -> str:
    """The version that pyproject.toml states."""
    text = (ROOT / "pyproject.toml").read_text(encoding="utf-8")
    found: str = tomllib.loads(text)["project"]["version"]
    return found


def places() -> dict[str, str]:
    """Versions that other files state."""
    return {
        name: re.findall(pattern, (ROOT / name).read_text(encoding="utf-8"), re.MULTILINE)[0]
        for name, pattern in PLACES.items()
    }


def faults() -> list[str]:
    """What is not ready, a line each."""
    own = version()
    found = [f"{name} has version {other}, pyproject.toml {own}" for name, other in places().items()
             if other != own]
    sections = {name: (date, body) for name, date, body in
                SECTION.findall((ROOT / "CHANGELOG.md").read_text(encoding="utf-8"))}
    date, body = sections.get(own, ("", ""))
    if not re.fullmatch(r"\d{4}-\d{2}-\d{2}", date) or not body.strip():
        found.append(f"CHANGELOG.md has no section [{own}] with a date and entries")
    if sections.get("Unreleased", ("", ""))[1].strip():
        found.append("CHANGELOG.md has entries under [Unreleased]")
    return found


if __name__ == "__main__":
    found = faults()
    for line in found:
        print(line, file=sys.stderr)
    sys.exit(bool(found))
