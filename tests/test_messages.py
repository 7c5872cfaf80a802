"""No message stands twice: what both languages say comes from kernels/messages.py."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

SOURCE = Path(__file__).parents[1] / "src" / "segfmu"
# words that a message has at least, and consecutive ones that make two messages the same
LEAST, WORDS = 4, 5

PYTHON = [p for p in sorted(SOURCE.rglob("*.py")) if p != SOURCE / "kernels" / "messages.py"]
C = sorted((SOURCE / "fmu").glob("**/c/*.[ch]"))

COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
LITERAL = r'"(?:[^"\\\n]|\\.)*"'
# adjacent literals are one
LITERALS = re.compile(rf"{LITERAL}(?:\s*{LITERAL})*")
VALUE = re.compile(r"%[-+ 0-9.]*l*[a-zA-Z]")


def words(text: str) -> tuple[str, ...]:
    """Words of a text in lower case; values have become `%` and are none."""
    return tuple(re.findall(r"[a-z_]+|%", text.lower()))


def runs(texts: Iterator[str]) -> set[tuple[str, ...]]:
    """All runs of so many words without a value, and whole texts that are shorter."""
    found = set()
    for text in texts:
        own = words(text)
        size = min(WORDS, len(own))
        if size >= LEAST:
            found |= {own[i : i + size] for i in range(len(own) - size + 1)}
    return {r for r in found if "%" not in r}


def of_python(source: str) -> Iterator[str]:
    """String literals of a module but docstrings, formatted values as `%`."""
    tree = ast.parse(source)
    parts = {
        id(p) for n in ast.walk(tree) if isinstance(n, ast.JoinedStr) for p in ast.walk(n)
    } | {
        id(n.value) for n in ast.walk(tree)
        if isinstance(n, ast.Expr) and isinstance(n.value, ast.Constant)
    }
    for node in ast.walk(tree):
        if isinstance(node, ast.JoinedStr):
            yield "".join(
                str(v.value) if isinstance(v, ast.Constant) else " % " for v in node.values
            )
        elif isinstance(node, ast.Constant) and id(node) not in parts:
            yield node.value if isinstance(node.value, str) else ""


def of_c(source: str) -> Iterator[str]:
    """String literals of a file in C, conversions as `%`."""
    for found in LITERALS.finditer(COMMENT.sub("", source)):
        text = "".join(p[1:-1] for p in re.findall(LITERAL, found.group()))
        yield VALUE.sub(" % ", text)


def shared(python: Iterator[str], c: Iterator[str]) -> set[str]:
    """Runs of words that stand in both."""
    return {" ".join(r) for r in runs(python) & runs(c)}


def texts(paths: list[Path], literals) -> Iterator[str]:
    for path in paths:
        yield from literals(path.read_text(encoding="utf-8"))


def test_no_message_stands_in_both_languages() -> None:
    assert shared(texts(PYTHON, of_python), texts(C, of_c)) == set()


def test_the_search_finds_a_message_that_does() -> None:
    python = 'raise ValueError(\n    f"{name}: the rope must not "\n    f"be {n:g} m long"\n)\n'
    c = 'say(m, "%s: the rope must"\n    " not be %.6g m long", name, 1.0);\n'
    assert shared(of_python(python), of_c(c)) == {
        "the rope must not be",
    }
    # neither docstrings nor comments are messages, nor is what stands around a value
    assert not shared(of_python('"""The rope must not be long."""\n'), of_c(c))
    assert not shared(of_python(python), of_c('/* "the rope must not be long" */'))
    assert not shared(of_python('x = f"the rope must {n} not be"'), of_c(c))
    # a short one is the same as a whole alone
    short = 'say("rope must not be");'
    assert shared(of_python('x = "Rope must not be"'), of_c(short)) == {"rope must not be"}


def test_the_search_reads_all_of_it() -> None:
    assert len(PYTHON) > 100 and len(C) > 20
    said = " ".join(texts(C, of_c))
    for text in ("gains of feedback.table", "is not allowed", "was missed by"):
        assert text in said
