"""What fmpy finds in an archive; a name that many archives have is parsed once."""

from __future__ import annotations

from pathlib import Path

import pytest
from fmpy.validation import validate_fmu
from lark import Lark

# grammars and names that follow them: fmpy takes 5 ms for a name, archives have up to 800
legal: set[tuple[str, str]] = set()


def faults(path: Path) -> list[str]:
    """What is wrong, also with names and structure."""
    parse = Lark.parse

    def once(parser: Lark, name: str) -> None:
        if (parser.source_grammar, name) not in legal:
            parse(parser, name)
            legal.add((parser.source_grammar, name))

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Lark, "parse", once)
        found: list[str] = validate_fmu(str(path))
    return found
