"""References in FMUs: FMPy repeats ours, and ours repeats what others write after the drafts."""

from __future__ import annotations

import io
import sys
import zipfile
from math import sqrt
from pathlib import Path

import fmpy
import numpy as np
import pytest

from segfmu import cli
from segfmu.errors import InputError
from segfmu.fmu import models
from segfmu.fmu.build import build_all
from segfmu.fmu.choice import Choice
from segfmu.fmu.standard.ls_ref import FOLDER, MANIFEST, read_experiments, read_manifest
from segfmu.validation.archives import build
from segfmu.validation.references.archive import read_references
from segfmu.validation.references.repeat import repeat
from tests.campaign import soaked
from tests.compiler import needs_native, require_native
from tests.cosim.probe.build import build as build_probe
from tests.fmu.pendulum.model import PENDULUM

PAPER = Path(__file__).parents[3] / "models" / "paper.toml"
# as the example of the draft 1.0.0-alpha.1 is written
EXAMPLE = """<?xml version="1.0" encoding="UTF-8"?>
<fmiReferences
    xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"
    xsi:noNamespaceSchemaLocation="../../schema/fmi3LayeredStandardReferenceManifest.xsd"
    xmlns:fmi-ls="http://fmi-standard.org/fmi-ls-manifest"
    fmi-ls:fmi-ls-name="org.fmi-standard.fmi-ls-ref"
    fmi-ls:fmi-ls-version="1.0.0-alpha.1"
    fmi-ls:fmi-ls-description="Layered Standard providing information on related files.">
    <Related type="text/modelica" source="modelica/Pendulum.mo" role="model" description="Model">
        <Annotations><Annotation type="com.example.tool">
            <tool:metadata xmlns:tool="com.example.tool" reviewedBy="alice"/>
        </Annotation></Annotations>
    </Related>
    <Related type="application/x-ssp-parameter-set" source="moon.ssv" role="parameter">
        <Label name="variant:moon" description="Gravity of the moon"/>
    </Related>
    {related}
</fmiReferences>
"""
TESTS = """<Related type="application/x-ma-ls-experiments" source="tests/smoke%20tests.exp"
        role="experiment" description="Smoke Tests of FMU"/>"""
RESULT = """<Related type="text/csv" source="out.csv" role="result"
        description="Output of the default experiment"/>"""
# the example of the experiments' draft, whose times are attributes of the experiment
OLD = """<Experiments name="Smoke Tests">
    <Experiment name="steady" startTime="0.0" stopTime="2.0" stepSize="0.001" tolerance="0.004">
        <Stimuli source="in.csv"/>
        <References source="ref.csv"/>
    </Experiment>
    <Experiment name="dynamic" startTime="0.0" stopTime="2.0" stepSize="0.001">
        <Parameters source="../moon.ssv"/>
        <References source="slow.hdf5" type="application/hdf5"/>
    </Experiment>
</Experiments>
"""
# its schema has them in an element of their own, and experiments of other kinds
NEW = """<Experiments name="Smoke Tests">
    <Experiment name="moon">
        <TransientSimulation startTime="0" stopTime="2" stepSize="0.001"/>
        <Parameters source="../moon.ssv"/>
        <Stimuli source="in.csv"/>
        <References source="moon.csv"/>
    </Experiment>
    <Experiment name="rest"><SteadyState/><References source="ref.csv"/></Experiment>
</Experiments>
"""
MOON = """<ssv:ParameterSet version="1.0" name="moon"
    xmlns:ssv="http://ssp-standard.org/SSP1/SystemStructureParameterValues">
    <ssv:Parameters>
        <ssv:Parameter name="crane.gravity"><ssv:Real value="1.62" unit="m/s2"/></ssv:Parameter>
    </ssv:Parameters>
</ssv:ParameterSet>
"""
TIMES = np.linspace(0.0, 2.0, 201)
# m/s2, m
PUSH, ROPE = 0.01, 0.5
INPUTS = f'"time","reference.bridge.acceleration"\n0,{PUSH}\n5,{PUSH}\n'


def table(gravity: float) -> str:
    """Small swings about the angle at which a pushed pendulum rests, and a column of texts."""
    rate = sqrt(gravity / ROPE)
    angle = -PUSH / gravity * (1.0 - np.cos(rate * TIMES))
    rows = (f"{t:.12g},{a:.12g},Set me!" for t, a in zip(TIMES, angle, strict=True))
    return "\n".join(("time,sway.angle,String_output", *rows)) + "\n"


def archive(pendulum: Path, target: Path, files: dict[str, str]) -> Path:
    """The pendulum's FMU with files in the folder of the layered standard."""
    with zipfile.ZipFile(pendulum) as old, zipfile.ZipFile(target, "w") as new:
        for info in old.infolist():
            new.writestr(info, old.read(info))
        for name, content in files.items():
            new.writestr(f"{FOLDER}/{name}", content)
    return target


def foreign(related: str, experiments: str = "") -> dict[str, str]:
    """What another tool wrote."""
    return {
        "fmi-ls-manifest.xml": EXAMPLE.format(related=related), "moon.ssv": MOON,
        "tests/smoke tests.exp": experiments, "tests/in.csv": INPUTS,
        "tests/ref.csv": table(9.81), "tests/moon.csv": table(1.62), "tests/slow.hdf5": "",
    }


def rewritten(path: Path, name: str, content: str) -> Path:
    """An archive with another text in one of its references."""
    target = path.with_name(f"other_{path.name}")
    with zipfile.ZipFile(path) as old, zipfile.ZipFile(target, "w") as new:
        for info in old.infolist():
            own = info.filename == f"{FOLDER}/{name}"
            new.writestr(info, content if own else old.read(info))
    return target


def compared(monkeypatch: pytest.MonkeyPatch, *arguments: object) -> int:
    monkeypatch.setattr(sys, "argv", ["segfmu", "compare", *map(str, arguments)])
    return cli.run()


@pytest.fixture(scope="module", params=[3, *soaked(2)])
def proven(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """Planner and crane of the paper's mission, with references."""
    require_native()
    folder = tmp_path_factory.mktemp("proven")
    archives = build(PAPER, folder, fmi=request.param, references=True)
    assert sorted(folder.iterdir()) == sorted(archives)
    return [archives.feedforward, archives.crane]


@pytest.fixture(scope="module", params=[2, *soaked(3)])
def pendulum(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    require_native()
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(models, "_registered", dict(models._registered))
        models.register(PENDULUM)
        folder = tmp_path_factory.mktemp("pendulum")
        return build_all(folder, Choice(True, request.param), [PENDULUM.spec()])[0]


def test_fmpy_repeats_both(proven: list[Path]) -> None:
    for path in proven:
        with zipfile.ZipFile(path) as content:
            files = {r.role: r.source for r in read_manifest(content.read(MANIFEST))}
            told = content.read(f"{FOLDER}/{files['experiment/smoke-test']}")
            (one,) = read_experiments(told)
            texts = {n: content.read(f"{FOLDER}/{n}").decode() for n in (
                files["result"], *([one.stimuli.source] if one.stimuli else []))}
        assert one.references is not None and one.references.source == files["result"]
        expected = np.genfromtxt(
            io.StringIO(texts[files["result"]]), delimiter=",", names=True, deletechars=""
        )
        given = None
        if one.stimuli is not None:
            given = np.genfromtxt(
                io.StringIO(texts[one.stimuli.source]), delimiter=",", names=True, deletechars=""
            )
        names = list(expected.dtype.names or ())
        found = fmpy.simulate_fmu(
            str(path), start_time=one.start, stop_time=one.stop, output_interval=one.step,
            step_size=one.step, input=given, output=names[1:], fmi_type="CoSimulation",
        )
        # FMPy's last step is a whole one
        rows = min(len(found), len(expected)) - 1
        assert rows > 6000 and len(names) > 30
        np.testing.assert_allclose(found["time"][:rows], expected["time"][:rows], atol=1e-9)
        for name in names:
            wide = 1e-6 * max(1.0, np.abs(expected[name]).max())
            assert np.abs(found[name][:rows] - expected[name][:rows]).max() < wide, name


def test_the_verdict_is_inside(proven: list[Path], monkeypatch: pytest.MonkeyPatch,
                               capsys: pytest.CaptureFixture[str]) -> None:
    assert compared(monkeypatch, proven[1]) == 0
    printed = capsys.readouterr().out
    assert "verdict.json: planner and crane, judged: passed" in printed
    assert "58 of 58 signals are in their tubes" in printed


def test_another_crane_is_found_out(proven: list[Path], monkeypatch: pytest.MonkeyPatch,
                                    capsys: pytest.CaptureFixture[str]) -> None:
    with zipfile.ZipFile(proven[1]) as content:
        rows = content.read(f"{FOLDER}/results.csv").decode().splitlines()
    names = rows[0].replace('"', "").split(",")
    place, time = names.index("sway.x.angle"), names.index("time")
    cells = rows[2001].split(",")
    cells[place] = str(float(cells[place]) + 1e-5)
    rows[2001] = ",".join(cells)
    assert compared(monkeypatch, rewritten(proven[1], "results.csv", "\n".join(rows))) == 1
    printed = capsys.readouterr().out
    assert f"sway.x.angle leaves its tube at {float(cells[time]):.6g} s" in printed


def test_experiments_of_another_tool(pendulum: Path, tmp_path: Path) -> None:
    path = archive(pendulum, tmp_path / "old.fmu", foreign(TESTS, OLD))
    # small swings: the sine of an angle is the angle but for a sixth of its cube
    wide = (2.0 * PUSH / 9.81) ** 2
    references, (steady,) = repeat(path, tube_value=wide, relative=True)
    assert steady.alike and steady.signals == 1 and steady.left_out == ("String_output",)
    assert references.missing == (
        "slow.hdf5: is of type application/hdf5, text/csv can be read",
    )
    path = archive(pendulum, tmp_path / "new.fmu", foreign(TESTS, NEW))
    _, (moon,) = repeat(path, tube_value=(2.0 * PUSH / 1.62) ** 2, relative=True)
    assert moon.alike and moon.case.values == {"crane.gravity": 1.62}
    # the parameters count
    earthly = foreign(TESTS, NEW.replace('<Parameters source="../moon.ssv"/>', ""))
    _, (other,) = repeat(archive(pendulum, tmp_path / "earth.fmu", earthly), tube_value=1e-3)
    assert not other.alike and other.outside[0].signal == "sway.angle"
    # of the pendulum, which is none of ours
    assert str(other.outside[0]).endswith(" rad)")


def test_a_result_alone_is_of_the_default_experiment(pendulum: Path, tmp_path: Path) -> None:
    still = "time,sway.angle,crane.gravity\n0,0,false\n2.5,0,false\n5,0,true\n"
    files = {"fmi-ls-manifest.xml": EXAMPLE.format(related=RESULT), "out.csv": still}
    _, (one,) = repeat(archive(pendulum, tmp_path / "result.fmu", files))
    assert one.alike and (one.case.start, one.case.stop, one.case.step) == (0.0, 5.0, 0.01)
    assert one.left_out == ("crane.gravity",)


@pytest.mark.parametrize(("column", "told"), [
    ("time,sway.angel\n0,0\n5,0\n",
     "Pendulum has no variable sway.angel; did you mean sway.angle?"),
    ("time,sway.angle\n0,0\n5,x\n", "the references of sway.angle are no numbers"),
])
def test_references_that_cannot_be_compared_are_no_agreement(
    pendulum: Path, tmp_path: Path, column: str, told: str
) -> None:
    lines = (f"{line},{rest}" for line, rest in zip(
        column.splitlines(), ("sway.rate", "0", "0"), strict=True
    ))
    files = {"fmi-ls-manifest.xml": EXAMPLE.format(related=RESULT), "out.csv": "\n".join(lines)}
    _, (one,) = repeat(archive(pendulum, tmp_path / "result.fmu", files))
    assert not one.alike and one.error == told


def test_results_of_experiments_that_cannot_be_read_are_not_those_of_others(
    pendulum: Path, tmp_path: Path
) -> None:
    """They were repeated without their stimuli."""
    both = EXAMPLE.format(related=TESTS + RESULT.replace("out.csv", "tests/ref.csv"))
    for damaged, told in (
        (OLD[:-20], r"no XML: .*; tests/ref\.csv: may be of tests/smoke%20tests\.exp, which"),
        (OLD.replace("<Stimuli", "<Stimulus"), "steady: has an element Stimulus, which is not"),
        ("<Experiments/>", "has no experiment"),
    ):
        files = foreign(TESTS, damaged) | {"fmi-ls-manifest.xml": both}
        with pytest.raises(InputError, match=told):
            read_references(archive(pendulum, tmp_path / "damaged.fmu", files))


@pytest.mark.parametrize(("files", "told"), [
    ({}, "has no references"),
    ({"fmi-ls-manifest.xml": "<a"}, "no XML"),
    ({"fmi-ls-manifest.xml": "<Experiments/>"}, "its element is Experiments, not fmiReferences"),
    ({"fmi-ls-manifest.xml": EXAMPLE.format(related=RESULT)}, r"out\.csv: is not in the archive"),
    ({"fmi-ls-manifest.xml": EXAMPLE.format(related=RESULT), "out.csv": "a,b\n1,2\n"},
     r"out\.csv: no table with a column time"),
    ({"fmi-ls-manifest.xml": EXAMPLE.format(related=RESULT), "out.csv": "time,b\n1,2\n0,3\n"},
     r"out\.csv: its times do not increase"),
    ({"fmi-ls-manifest.xml": EXAMPLE.format(related=RESULT), "out.csv": "time,b\nx,2\n"},
     r"out\.csv: its times are no numbers"),
    ({"fmi-ls-manifest.xml": EXAMPLE.format(related=RESULT), "out.csv": "time,b\n1\n"},
     "rows with more or fewer values"),
    ({"fmi-ls-manifest.xml": EXAMPLE.format(related=TESTS), "tests/smoke tests.exp": OLD.replace(
        '"2.0"', '"two"')}, "could not convert string to float"),
])
def test_what_cannot_be_repeated_is_told(
    pendulum: Path, tmp_path: Path, files: dict[str, str], told: str
) -> None:
    with pytest.raises(InputError, match=told):
        read_references(archive(pendulum, tmp_path / "wrong.fmu", files))


def test_a_run_that_fails_is_told(pendulum: Path, tmp_path: Path) -> None:
    wrong = foreign(TESTS, NEW) | {"tests/in.csv": "time,wind\n0,1\n"}
    _, (one,) = repeat(archive(pendulum, tmp_path / "wrong.fmu", wrong))
    assert one.error == "Pendulum has no input wind" and not one.alike
    short = foreign(TESTS, NEW.replace('stopTime="2"', 'stopTime="1"'))
    _, (one,) = repeat(archive(pendulum, tmp_path / "short.fmu", short))
    assert one.error.startswith("the result is from 0 to 1 s, the reference from 0 to 2 s")


@needs_native
def test_an_fmu_that_ends_its_process_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    dies = MOON.replace(
        '<ssv:Parameter name="crane.gravity"><ssv:Real value="1.62" unit="m/s2"/></ssv:Parameter>',
        '<ssv:Parameter name="fail.time"><ssv:Real value="1"/></ssv:Parameter>'
        '<ssv:Parameter name="fail.status"><ssv:Integer value="99"/></ssv:Parameter>',
    )
    files = foreign(TESTS, NEW.replace('<Stimuli source="in.csv"/>', "")) | {
        "moon.ssv": dies, "tests/moon.csv": "time,y\n0,0\n2,2\n",
    }
    path = archive(build_probe(tmp_path, 2), tmp_path / "dies.fmu", files)
    assert compared(monkeypatch, path) == 1
    assert "an FMU ended its process: SIGABRT" in capsys.readouterr().out


def test_arguments_of_compare(tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
                              capsys: pytest.CaptureFixture[str]) -> None:
    assert compared(monkeypatch, tmp_path / "a.fmu", tmp_path / "b.csv") == 2
    assert compared(monkeypatch, tmp_path / "a.csv") == 2
    assert compared(monkeypatch, tmp_path / "a.fmu") == 2
    told = capsys.readouterr().err
    assert "leave out" in told and "name the table" in told
    assert "a.fmu: cannot be read: No such file" in told


def test_references_need_a_mission(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="name its file"):
        build(output=tmp_path, references=True)
