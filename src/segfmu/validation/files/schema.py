"""JSON schemas of all files, for editors that complete and check TOML."""

from __future__ import annotations

from typing import Any

from segfmu.validation.files.campaign_tables import CampaignFile
from segfmu.validation.files.crane_file import CraneFile
from segfmu.validation.files.keys import Table
from segfmu.validation.files.mission import Mission
from segfmu.validation.files.scenario_tables import ScenarioFile

KINDS: dict[str, type[Table]] = {
    "mission": Mission, "crane": CraneFile, "scenario": ScenarioFile, "campaign": CampaignFile,
}
DIALECT = "https://json-schema.org/draft/2020-12/schema"


def file_schema(kind: str) -> dict[str, Any]:
    """The schema of a kind of file."""
    found = KINDS[kind].model_json_schema()
    parts = found.get("$defs", {})
    for part in (found, *parts.values()):
        _shorten(part)
    if kind == "mission":
        # a table of its own: what differs needs none of the keys
        parts["TrueCrane"] = {k: v for k, v in parts["CraneFile"].items() if k != "required"}
        keys = found["properties"]
        keys["true_crane"] = _table(keys["true_crane"], "TrueCrane")
        crane = _table(keys["crane"], "CraneFile")
        name = {"type": "string", "minLength": 1, "description": "name of a crane file"}
        keys["crane"] = {
            "description": crane["description"], "anyOf": [name, {"$ref": crane["$ref"]}],
        }
        points = keys["waypoints"]
        name = {"type": "string", "minLength": 1, "description": "name of a CSV file"}
        keys["waypoints"] = {
            "description": points.pop("description"), "anyOf": [name, points],
        }
    if kind == "scenario":
        found["properties"]["base"] = {
            "type": "string", "minLength": 1,
            "description": "scenario file that all else is merged into",
        }
        # a base may have what is required
        found["anyOf"] = [{"required": ["base"]}, {"required": found.pop("required")}]
    return {"$schema": DIALECT, "title": f"segfmu {kind} file", **{
        k: v for k, v in found.items() if k != "title"
    }}


def _table(key: dict[str, Any], name: str) -> dict[str, Any]:
    return {"$ref": f"#/$defs/{name}", "description": key["description"]}


def _shorten(part: dict[str, Any]) -> None:
    """Drop titles that repeat the key, and null, which TOML does not have."""
    for key in part.get("properties", {}).values():
        key.pop("title", None)
        if key.get("default", 0) is None:
            del key["default"]
        choices = [c for c in key.get("anyOf", ()) if c != {"type": "null"}]
        if len(choices) == 1:
            del key["anyOf"]
            key.update({k: v for k, v in choices[0].items() if k not in key})
