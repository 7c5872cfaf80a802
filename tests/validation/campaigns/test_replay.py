"""Runs of campaigns as scenario files."""

from __future__ import annotations

from pathlib import Path

import pytest

from segfmu.validation.campaigns.campaign import load_campaign
from segfmu.validation.campaigns.replay import find_run, write_run
from segfmu.validation.files.scenario_file import load_scenario
from tests.validation.campaigns.files import CAMPAIGN, write


@pytest.mark.parametrize("name", ["\U0001f3d7 hall", "Säule \u2264 1 m", 'a "b" \\ <c> & # d'])
def test_names_of_any_characters_are_read_again(name: str, tmp_path: Path) -> None:
    told = name.replace("\\", "\\\\").replace('"', '\\"')
    text = CAMPAIGN.replace('name = "c"', f'name = "{told}"').replace('"design"', f'"{told}"')
    text += (
        f'\n[[changes.criteria]]\nname = "{told}"\nsignal = "sway.total"\nbound = 0.1\n'
        f'text = "{told}"\n'
    )
    campaign = load_campaign(write(tmp_path / "\U0001f3d7", text))
    scenario = load_scenario(write_run(tmp_path, campaign, find_run(tmp_path, campaign, 3)))
    assert scenario.file.name == f"{name}, run 3"
    assert [c.text for c in scenario.file.criteria if c.name == name] == [name]
