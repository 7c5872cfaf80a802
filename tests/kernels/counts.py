"""Counts of a kernel's text: literal subscripts, arguments, lines."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator

# Larger integers in subscripts are places of a record, which have names.
LARGEST = 2

_C_NO_CODE = re.compile(r'/\*.*?\*/|//[^\n]*|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'', re.DOTALL)
_C_INTEGER = re.compile(r"(?<![\w.])(0[xX][0-9a-fA-F]+|\d+)[uUlL]*(?![\w.])")


def python_subscripts(text: str) -> list[str]:
    """Subscripts in Python in which a literal integer above `LARGEST` stands, `line: text`."""
    found = []
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Subscript) and any(_large(part) for part in ast.walk(node.slice)):
            found.append(f"{node.lineno}: {ast.unparse(node)}")
    return found


def _large(node: ast.AST) -> bool:
    return isinstance(node, ast.Constant) and type(node.value) is int and node.value > LARGEST


def c_subscripts(text: str) -> list[str]:
    """The same of C; extents in declarations count as well."""
    code = _C_NO_CODE.sub(lambda m: re.sub(r"[^\n]", " ", m.group()), text)
    return [
        f"{code.count(chr(10), 0, start) + 1}: [{inside}]"
        for start, inside in _brackets(code)
        if any(int(number, 0 if number[:2] in ("0x", "0X") else 10) > LARGEST
               for number in _C_INTEGER.findall(inside))
    ]


def _brackets(code: str) -> Iterator[tuple[int, str]]:
    """Place and content of every pair of brackets, those within others too."""
    opened: list[int] = []
    for i, character in enumerate(code):
        if character == "[":
            opened.append(i)
        elif character == "]":
            start = opened.pop()
            yield start, code[start + 1 : i]
