"""Packages of SSP as other readers have them, in both versions."""

from __future__ import annotations

import zipfile
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from fmpy import read_model_description
from lxml import etree

from segfmu.fmu.pairs import GANTRY

SETS = [f"resources/{n}.ssv" for n in (*GANTRY.names, "choices")]
DOCUMENTS = {"SystemStructure.ssd": "SystemStructureDescription.xsd"} | dict.fromkeys(
    SETS, "SystemStructureParameterValues.xsd"
)


def entries_of(package: Path) -> dict[str, bytes]:
    """The files of a package by name."""
    with zipfile.ZipFile(package) as opened:
        return {n: opened.read(n) for n in opened.namelist()}


def variables_of(archives: Iterable[Path]) -> dict[str, dict[str, Any]]:
    """Variables of both FMUs as another reader has them."""
    return {
        name: {v.name: v for v in read_model_description(str(path)).modelVariables}
        for name, path in zip(GANTRY.names, archives, strict=True)
    }


def findings(schemas: Path, document: str, text: bytes) -> list[str]:
    """What a schema finds in a document of a package."""
    schema = etree.XMLSchema(file=str(schemas / DOCUMENTS[document]))
    schema.validate(etree.fromstring(text))
    return [f"{e.line}: {e.message}" for e in schema.error_log]
