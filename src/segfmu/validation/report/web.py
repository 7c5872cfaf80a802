"""How templates, styles and scripts become one HTML file."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable
from importlib.metadata import version
from importlib.resources import files
from typing import Any

# behind the hyphen of an exponent browsers break lines
POWER = re.compile(r"[+-]?\d[\d.,]*e[+-]\d+")


def filled(
    template: str, parts: Iterable[str], package: str = "segfmu.validation.report", **values: Any
) -> str:
    """A template of a package's folder `web` with `values`, and as `parts` the texts it names.

    Parts that the package does not have are those of reports.
    """
    from jinja2 import Environment, StrictUndefined

    texts = {name: _text(package, name) for name in parts}
    surroundings = Environment(
        autoescape=True, undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True
    )
    surroundings.filters["whole"] = _whole
    return surroundings.from_string(_text(package, template)).render(
        parts=texts, version=version("segfmu"), **values
    )


def _whole(text: str) -> Any:
    """A text as HTML, in which every number with an exponent stays on one line."""
    from markupsafe import Markup, escape

    return Markup(POWER.sub(r'<span class="number">\g<0></span>', str(escape(text))))


def _text(package: str, name: str) -> str:
    own = files(package) / "web" / name
    found = own if own.is_file() else files("segfmu.validation.report") / "web" / name
    return found.read_text(encoding="utf-8")


def as_json(content: Any) -> str:
    """JSON that cannot end the element of HTML that it is in."""
    text = json.dumps(content, separators=(",", ":"), allow_nan=False)
    return text.replace("<", "\\u003c")
