"""Runs of campaigns as scenario files."""

from __future__ import annotations

import zipfile
from pathlib import Path

import pytest

from segfmu.validation.campaigns.campaign import load_campaign
from segfmu.validation.campaigns.replay import find_run, write_run
from segfmu.validation.files.scenario_file import load_scenario
from tests.validation.campaigns.files import CAMPAIGN, MODELS, SCENARIO, write

NAMED = """
name = "c"
scenarios = ["s.toml"]
sampling.kind = "matrix"
[[factors]]
name = "which"
key = "{key}"
values = ["one{end}", "two{end}"]
"""
LISTS = """
[[fmus]]
name = "probe"
path = "one.fmu"
[[profiles]]
file = "one.csv"
"""
DESCRIPTION = """
<fmiModelDescription fmiVersion="2.0" modelName="Probe" guid="probe">
  <CoSimulation modelIdentifier="Probe"/>
  <ModelVariables>
    <ScalarVariable name="x" valueReference="0"><Real/></ScalarVariable>
  </ModelVariables>
  <ModelStructure/>
</fmiModelDescription>
"""


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


@pytest.mark.parametrize(("key", "end"), [
    ("mission", ".toml"), ("fmus.probe.path", ".fmu"), ("profiles.0.file", ".csv"),
])
def test_files_are_beside_the_campaign_that_names_them(
    key: str, end: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """They were looked for in the working folder, and runs beside their own file."""
    path = write(tmp_path / "own", NAMED.format(key=key, end=end), SCENARIO + LISTS)
    for name in ("one", "two"):
        text = (MODELS / "inteco.toml").read_text(encoding="utf-8")
        crane = (MODELS / "crane_inteco.toml").as_posix()
        (path.parent / f"{name}.toml").write_text(text.replace("crane_inteco.toml", crane), "utf-8")
        with zipfile.ZipFile(path.parent / f"{name}.fmu", "w") as archive:
            archive.writestr("modelDescription.xml", DESCRIPTION)
        (path.parent / f"{name}.csv").write_text("time,wind.x\n0,0\n1,0\n", encoding="utf-8")
    (tmp_path / "out").mkdir()
    monkeypatch.chdir(tmp_path)
    campaign = load_campaign(Path("own/c.toml"))
    file = write_run(Path("out"), campaign, find_run(Path("out"), campaign, 1))
    found = load_scenario(file).file
    names = {
        "mission": found.mission, "fmus": found.fmus[0].path, "profiles": found.profiles[0].file,
    }
    assert Path(str(names[key.partition(".")[0]])) == path.parent / f"two{end}"
