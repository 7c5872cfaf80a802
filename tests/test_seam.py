"""What a further crane touches outside its own folders: registrations, and nothing else."""

from __future__ import annotations

import re
import tokenize
from pathlib import Path

from segfmu.crane import flat_models
from segfmu.fmu.pairs import PAIRS
from segfmu.validation.files import crane_models
from segfmu.validation.files.crane_file import CraneFile
from segfmu.validation.files.keys import entries

SOURCE = Path(__file__).parents[1] / "src" / "segfmu"
OWN = re.compile(r"kernels/(hook|c)/|fmu/hook_|(.*/)?_?hook", re.IGNORECASE)
HOOK = re.compile("hook", re.IGNORECASE)
COMMENT = re.compile(r"/\*.*?\*/|//[^\n]*", re.DOTALL)

# as CONTRIBUTING.md has them
TOUCHED = {
    "registrations": (
        "kernels/crane/suspension.py", "crane/flat_models.py", "fmu/pairs.py",
        "validation/files/crane_models.py", "__init__.py",
    ),
    # the lifting gear of the gantry crane
    "another hook": ("crane/stability.py", "validation/files/template.py"),
}


def code(path: Path) -> str:
    """A file without comments and docstrings."""
    if path.suffix != ".py":
        return COMMENT.sub("", path.read_text(encoding="utf-8"))
    with path.open("rb") as lines:
        return " ".join(
            token.string for token in tokenize.tokenize(lines.readline)
            if token.type != tokenize.COMMENT and not token.string.startswith('"""')
        )


def test_files_that_know_the_hook_are_these() -> None:
    found = {
        name for path in SOURCE.rglob("*")
        if path.suffix in {".py", ".c", ".h", ".mo", ".js", ".css"}
        and not OWN.match(name := path.relative_to(SOURCE).as_posix())
        and HOOK.search(code(path))
    }
    assert found == {name for names in TOUCHED.values() for name in names}


def test_every_layer_has_the_same_models() -> None:
    """A model that is registered in one layer alone would be refused late, or not at all."""
    parameters = [model.parameters for model in crane_models.MODELS]
    assert parameters == [model.parameters for model in flat_models.MODELS]
    assert [model.pair for model in crane_models.MODELS] == list(PAIRS)
    for model in crane_models.FURTHER:
        assert CraneFile.model_fields[model.key].default is None
        signals = {v.name for v in model.pair.plant().where("output")}
        assert set(model.shown) <= signals
        table = {key for _, key, _ in model.parts}
        assert table <= {name for f in entries(CraneFile) if f.path[0] == model.key
                         for name in f.path[1:]}
