"""Campaign files: scenarios, factors that differ from run to run, and how they are sampled."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from segfmu.errors import InputError
from segfmu.validation.files.campaign_tables import CampaignFile, Changed, FactorTable
from segfmu.validation.files.kinds import require_kind
from segfmu.validation.files.reading import checked, read
from segfmu.validation.files.scenario_file import (
    Source,
    inherit,
    located,
    located_value,
    read_source,
)


@dataclass(frozen=True)
class CampaignSource:
    """A campaign and its scenarios as files have them.

    Attributes
    ----------
    path : Path
        The campaign's file.
    file : CampaignFile
        Values and variants of factors have paths in place of names of files.
    changes : mapping
        Of all scenarios.
    scenarios : tuple of Source
        With these changes.
    """

    path: Path
    file: CampaignFile
    changes: Mapping[str, Any]
    scenarios: tuple[Source, ...]


def read_campaign(path: Path) -> CampaignSource:
    """Read a campaign file and its scenarios; check all that is the campaign's own.

    Raises
    ------
    InputError
        One line with the file, the key, the value and what is allowed.
    """
    data = read(path)
    # of a link to itself there is no place
    place = path.resolve()
    require_kind("campaign", data, path)
    file = checked(CampaignFile, data, str(path))
    file = file.model_copy(update={"factors": [_placed(place, f) for f in file.factors]})
    checked(Changed, {"changes": file.changes}, str(path))
    own = located(place, file.changes)
    found = []
    for name in file.scenarios:
        try:
            source = read_source(place.parent / name)
        except InputError as error:
            raise InputError(f"{path}: scenarios: {error}") from None
        found.append(Source(source.path, inherit(source.data, own)))
    return CampaignSource(path, file, own, tuple(found))


def _placed(campaign: Path, factor: FactorTable) -> FactorTable:
    if factor.variants is None:
        values = [located_value(campaign, factor.key or "", v) for v in factor.values or ()]
        return factor.model_copy(update={"values": values or None})
    variants = {n: located(campaign, changes) for n, changes in factor.variants.items()}
    return factor.model_copy(update={"variants": variants})
