"""The documentation page inside an FMU, from its specification."""

from __future__ import annotations

from html import escape

from segfmu.fmu.standard.spec import Spec, Variable

STYLE = """
body { font: 16px/1.5 system-ui, sans-serif; margin: 2rem auto; max-width: 62rem; padding: 0 1rem;
  color: #1c2733; }
h1, h2 { line-height: 1.2; color: #12395b; } h2 { margin-top: 2.2rem; }
table { border-collapse: collapse; width: 100%; font-size: 14px; }
th, td { text-align: left; padding: .3rem .6rem; border-bottom: 1px solid #d8e0e8;
  vertical-align: top; }
th { background: #eef3f8; } code { background: #f2f5f8; padding: 0 .2rem; }
pre { background: #f2f5f8; padding: .8rem; overflow-x: auto; }
"""

TITLES = {
    "input": "Inputs",
    "output": "Outputs",
    "local": "Local variables",
    "calculatedParameter": "Calculated parameters",
    "parameter": "Parameters",
}


def page(spec: Spec, version: str, about: str) -> str:
    """The page's HTML text; `about` is the model's own part of it."""
    tables = "".join(
        f"<h2>{title}</h2>{_table(rows)}"
        for causality, title in TITLES.items()
        if (rows := tuple(v for v in spec.variables if v.causality == causality))
    )
    return (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
        f"<title>{spec.name}</title><style>{STYLE}</style></head><body>"
        f"<h1>{spec.name}</h1><p><strong>{escape(spec.description)}.</strong> "
        f"segfmu {escape(version)}; SI units.</p>{about}{tables}</body></html>\n"
    )


def _table(rows: tuple[Variable, ...]) -> str:
    body = "".join(
        f"<tr><td><code>{escape(v.name)}</code></td><td>{escape(v.unit or '-')}</td>"
        f"<td>{_start(v)}</td><td>{escape(v.description)}{_choices(v)}</td></tr>"
        for v in rows
    )
    return (
        "<table><tr><th>name</th><th>unit</th><th>start</th><th>meaning</th></tr>"
        f"{body}</table>"
    )


def _start(variable: Variable) -> str:
    if variable.start is None:
        return "-"
    if variable.enumeration is not None:
        return variable.enumeration.items[int(variable.start) - 1]
    return str(variable.start).lower() if variable.kind == "Boolean" else f"{variable.start:g}"


def _choices(variable: Variable) -> str:
    if variable.enumeration is None:
        return ""
    return f" ({', '.join(variable.enumeration.items)})"
