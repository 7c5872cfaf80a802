"""JSON schemas of what commands print with --json."""

from __future__ import annotations

from typing import Any

from pydantic.json_schema import models_json_schema

from segfmu.validation.documents.document import RefusalDocument, ResultDocument
from segfmu.validation.documents.plan import PlanDocument
from segfmu.validation.documents.run import RunDocument
from segfmu.validation.documents.suite import SuiteDocument
from segfmu.validation.files.schema import DIALECT

DOCUMENTS: dict[str, type[ResultDocument]] = {
    "plan": PlanDocument, "simulate": RunDocument, "validate": SuiteDocument,
}


def document_schema(command: str) -> dict[str, Any]:
    """The schema of what a command prints: its result, or why it was refused."""
    models = (DOCUMENTS[command], RefusalDocument)
    _, found = models_json_schema([(model, "serialization") for model in models])
    for part in found["$defs"].values():
        for key in part["properties"].values():
            key.pop("title", None)
    refs = [{"$ref": f"#/$defs/{model.__name__}"} for model in models]
    return {"$schema": DIALECT, "title": f"segfmu {command} --json", "anyOf": refs, **found}
