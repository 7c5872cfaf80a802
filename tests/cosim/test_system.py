"""Systems: connections, many runs of the same instances, bad requests and bad archives."""

from __future__ import annotations

import gc
import os
import shutil
import tempfile
import zipfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from segfmu.cosim import Change, System, native, simulate
from segfmu.errors import InputError, SimulationError
from tests.cosim.probe.build import build

SOURCE, SINK = "GantryFeedforward", "GantryCrane"
ENGINES = ("c", "python") if native.COMPILED else ("python",)
CHAIN = [("a", "y", "b", "x")]


@pytest.fixture(params=ENGINES)
def engine(request) -> str:
    return str(request.param)


@pytest.fixture
def pair(probes, engine: str):
    """Two probes, the first before the second."""
    with System(
        {"a": probes[2], "b": probes[3]}, step=0.1, connections=CHAIN, engine=engine
    ) as system:
        yield system


def test_a_chain_is_its_formula(pair) -> None:
    """y_b = gain_b (gain_a x_a + t) + t: sequential coupling passes on values at once."""
    rows = pair.run({"a": {"x": 2.0, "gain": 3.0}, "b": {"gain": -0.5}}, stop_time=1.0)
    times = np.arange(11) * 0.1
    assert rows["a.y"] == pytest.approx(6.0 + times)
    assert rows["b.y"] == pytest.approx(-0.5 * (6.0 + times) + times)


def test_parallel_passes_on_at_the_end_of_a_step(probes, engine: str) -> None:
    ring = [*CHAIN, ("b", "y", "a", "x")]
    with System({"a": probes[2], "b": probes[3]}, step=0.1, connections=ring,
                coupling="parallel", engine=engine) as system:
        rows = system.run({"a": {"gain": 0.5}, "b": {"gain": 0.25}}, stop_time=0.5)
    # inputs of both at a point are the outputs before they were exchanged there
    x_a, x_b = 0.0, 0.0
    for i, row in enumerate(rows):
        time = 0.1 * i
        x_a, x_b = 0.25 * x_b + time, 0.5 * x_a + time
        assert (row["a.y"], row["b.y"]) == pytest.approx((0.5 * x_a + time, 0.25 * x_b + time))


@pytest.mark.parametrize("kept", [[], ["b.y"], ["a.y", "b.y"]])
def test_rows_have_the_columns_that_are_kept(probes, engine: str, kept: list[str]) -> None:
    """What is connected is read all the same, and columns keep the names of the whole record."""
    values = {"a": {"x": 2.0, "gain": 3.0}, "b": {"gain": -0.5}}
    fmus = {"a": probes[2], "b": probes[3]}
    with System(fmus, step=0.1, connections=CHAIN, engine=engine) as system:
        whole = system.run(values, stop_time=1.0)
    with System(fmus, step=0.1, connections=CHAIN, engine=engine, kept=kept) as system:
        rows = system.run(values, stop_time=1.0)
    assert rows.dtype.names == ("time", *kept)
    assert all(rows[name].tolist() == whole[name].tolist() for name in rows.dtype.names)


@pytest.mark.parametrize("coupling", ["sequential", "parallel"])
def test_an_fmu_with_longer_steps_holds_its_outputs(probes, engine: str, coupling: str) -> None:
    """y = gain x + t at the end of each step of three; the first FMU steps with every one."""
    with System(
        {"a": probes[2], "b": probes[3], "c": probes[2]}, step=0.1, steps={"b": 0.3},
        connections=[*CHAIN, ("b", "y", "c", "x")], coupling=coupling, engine=engine,
    ) as system:
        values = {"a": {"x": 2.0, "gain": 3.0}, "b": {"gain": 0.5}, "c": {"gain": 2.0}}
        rows = system.run(values, stop_time=1.0)
        again = system.run(values, stop_time=1.0)
    assert all(np.array_equal(rows[n], again[n]) for n in ("a.y", "b.y", "c.y"))
    times = 0.1 * np.arange(11)
    assert rows["a.y"] == pytest.approx(6.0 + times)
    own = 0.3 * (np.arange(11) // 3)
    b = 0.5 * (6.0 + own) + own
    assert rows["b.y"][3:] == pytest.approx(b[3:])
    passed_on = b.copy()
    if coupling == "parallel":
        # as in any parallel step, what it hands on at its end has the inputs of its beginning
        passed_on[::3] -= 0.5 * 0.3
    assert rows["c.y"][3:] == pytest.approx((2.0 * passed_on + times)[3:])


def test_a_change_between_long_steps_counts_from_the_beginning_of_one(probes, engine: str) -> None:
    with System({"a": probes[2], "b": probes[3]}, step=0.1, steps={"b": 0.2}, connections=CHAIN,
                engine=engine) as system:
        rows = system.run(
            {"a": {"gain": 0.0}, "b": {"gain": 1.0}}, stop_time=0.8,
            changes=[Change(0.25, "a", {"x": 1.0}), Change(0.25, "a", {"gain": 1.0})],
        )
    times = 0.1 * np.arange(9)
    y = np.where(times > 0.25, 1.0, 0.0) + times
    assert rows["a.y"] == pytest.approx(y)
    # the change cuts the step of the first FMU, not that of the second
    assert rows["b.y"][::2] == pytest.approx((y + times)[::2])
    assert rows["b.y"][1::2] == pytest.approx(rows["b.y"][:-1:2])


@pytest.mark.parametrize(("steps", "options", "text"), [
    ({"b": 0.25}, {}, r"step 0\.25 s of b is no multiple of the communication step 0\.1 s"),
    ({"b": 0.05}, {}, "of b is no multiple"),
    ({"a": 0.2}, {}, "a steps first"),
    ({"c": 0.2}, {}, "no FMU c in the system"),
    ({"b": -0.1}, {}, "step must be a time > 0 s"),
    ({"b": 0.2}, {"coupling": "derivatives"}, "needs one step for all FMUs"),
])
def test_steps_that_do_not_fit_are_refused(
    probes, steps: dict[str, float], options: dict[str, Any], text: str
) -> None:
    with pytest.raises(InputError, match=text):
        System({"a": probes[2], "b": probes[3]}, step=0.1, steps=steps, connections=CHAIN,
               **options)


def test_runs_leave_nothing_behind(native_fmus, engine: str) -> None:
    values: dict[str, dict[str, Any]] = {
        SOURCE: {"limits.x.velocity": 0.6, "planner.shape": "smoothstep"},
        SINK: {"sway.x.angle": 0.05, "feedback.enabled": False, "payload.count": 1,
               "payload[1].time": 0.2, "payload[1].mass": 1.3},
    }
    for fmi in (2, 3):
        rows = []
        if fmi == 3:
            values[SINK] = {n: v for n, v in values[SINK].items() if not n.startswith("payload[")}
        with System(native_fmus[fmi], step=5e-3, engine=engine) as system:
            for given in ({}, values, {}, values):
                rows.append(system.run(given, stop_time=0.5))
        assert rows[0].tobytes() == rows[2].tobytes() != rows[1].tobytes()
        assert rows[1].tobytes() == rows[3].tobytes()
        fresh = simulate(*native_fmus[fmi], step=5e-3, stop_time=0.5, engine=engine,
                         source_values=values[SOURCE], sink_values=values[SINK])
        assert fresh.tobytes() == rows[1].tobytes()


def test_a_lead_may_come_and_go(native_fmus, engine: str) -> None:
    """Steps end at events without a lead only; in FMI 3.0 an instance of its own is made for it."""
    step = 5e-3
    for fmi in (2, 3):
        with System(native_fmus[fmi], step=step, coupling="parallel", engine=engine) as system:
            for lead in (0.0, step, 0.0, step):
                found = system.run({SOURCE: {"setpoint.lead": lead}}, stop_time=0.5)
                alone = simulate(*native_fmus[fmi], step=step, stop_time=0.5, coupling="parallel",
                                 source_values={"setpoint.lead": lead}, engine=engine)
                assert found.tobytes() == alone.tobytes()


def test_instances_are_kept(pair) -> None:
    for run in range(4):
        rows = pair.run(stop_time=0.3)
        assert set(rows["a.runs"]) == set(rows["b.runs"]) == {run}


@pytest.mark.parametrize("fmi", [2, 3])
def test_an_instance_that_cannot_be_reset_is_made_again(probes, engine: str, fmi: int) -> None:
    with System({"one": probes[fmi]}, step=0.1, engine=engine) as system:
        for _ in range(3):
            rows = system.run({"one": {"reset.status": 3, "x": 1.0}}, stop_time=0.3)
            assert set(rows["runs"]) == {0} and rows["y"][-1] == pytest.approx(1.3)


def test_memory_stays(probes, engine: str) -> None:
    """Thousands of runs, some of which fail: no more memory than after the first hundreds."""
    resource = pytest.importorskip("resource", reason="no figure of memory on this system")
    with System({"a": probes[2], "b": probes[3]}, step=0.1, connections=CHAIN,
                engine=engine) as system:
        for i in range(3000):
            if i == 500:
                gc.collect()
                before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
            values = {"a": {"text": f"hello {i}", "x": i}, "b": {"fail.time": 0.5}}
            if i % 10 == 0:
                with pytest.raises(SimulationError):
                    system.run({**values, "b": {"fail.time": 0.5, "fail.status": 3}}, stop_time=1.0)
            else:
                system.run(values, stop_time=1.0)
        grown = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before
    assert grown < 3000, f"{grown} kB more"


def test_values_of_all_kinds(pair, caplog) -> None:
    values = {"x": np.float64(0.5), "n": np.int64(-7), "flag": np.bool_(True), "text": "Grüße %s"}
    rows = pair.run({"a": values, "b": values | {"x": [0.25]}}, stop_time=0.1)
    assert rows["a.n.out"][0] == rows["b.n.out"][0] == -21
    assert not rows["a.flag.out"].any() and not rows["b.flag.out"].any()
    assert [r.getMessage() for r in caplog.records] == ["a: Grüße %s", "b: Grüße %s"]
    rows = pair.run(stop_time=0.1)
    assert rows["a.n.out"][0] == 0 and rows["a.flag.out"].all()


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"c": {}}, r"no FMU c in the system; it has a, b"),
        ({"a": None}, "values of a must be a mapping from names, got None"),
        (["a"], "values must be a mapping from names"),
        ({"a": {"z": 1}}, "a has no variable z"),
        ({"a": {"gian": 1}}, r"a has no variable gian; did you mean gain\?"),
        ({"a": {"n": 0.5}}, "n takes an integer"), ({"a": {"n": float("nan")}}, "takes an integer"),
        ({"a": {"n": float("inf")}}, "takes an integer"), ({"a": {"n": 2**40}}, "of 32 bits"),
        ({"a": {"x": True}}, "x takes a number, got True"),
        ({"a": {"n": True}}, "n takes a number, got True"),
        ({"a": {"flag": "yes"}}, "flag takes true or false, got 'yes'"),
        ({"a": {"flag": 2}}, "flag takes true or false, got 2"),
        ({"a": {"flag": 0.5}}, "flag takes true or false, got 0.5"),
        ({"a": {"x": "much"}}, "x takes a number"), ({"a": {"x": None}}, "x takes a number"),
        ({"a": {"x": [1.0, 2.0]}}, "x takes one value, got 2"), ({"b": {"tiny": 200}}, "of 8 bits"),
        ({"a": {"text": 5}}, "text takes a text"), ({"a": {"text": "a\0b"}}, "zero byte"),
    ],
)
def test_bad_values_are_named(pair, values, words: str) -> None:
    with pytest.raises(InputError, match=words):
        pair.run(values, stop_time=1.0)
    assert pair.run(stop_time=1.0).size == 11


def test_the_shortest_run_has_its_start_and_its_end(pair) -> None:
    rows = pair.run(stop_time=1e-12)
    assert rows["time"].tolist() == [0.0, 1e-12]


def test_not_a_number_goes_to_the_fmu(pair) -> None:
    """One that looks at its parameters refuses it, one that does not gives it back."""
    with pytest.raises(SimulationError, match="b could not be initialised"):
        pair.run({"b": {"gain": float("nan")}}, stop_time=1.0)
    assert np.isnan(pair.run({"a": {"x": float("nan")}}, stop_time=1.0)["b.y"]).all()
    assert not np.isnan(pair.run(stop_time=1.0)["b.y"]).any()


@pytest.mark.parametrize(
    ("connections", "words"),
    [
        ([("a", "y", "b", "x"), ("b", "y", "b", "x")], "input of its own"),
        ([("a", "y", "b", "x"), ("b", "y", "a", "x"), ("a", "y", "b", "x")], "b: input x is conn"),
        ([("a", "y", "b", "x")] * 1000, "connected twice"), ([("a", "q", "b", "x")], "no output q"),
        ([("a", "y", "b", "gain")], "b has no input gain"), ([("a", "x", "b", "x")], "no output x"),
        ([("c", "y", "b", "x")], "no FMU c"), ([("a", "y", "b", "n")], "types of output and input"),
        ([("a", "y", "b")], "a connection has source, output, sink and input"),
    ],
)
def test_bad_connections_are_named(probes, connections, words: str) -> None:
    with pytest.raises(InputError, match=words):
        System({"a": probes[2], "b": probes[3]}, step=0.1, connections=connections)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"step": 0.0}, "step must be"), ({"coupling": "both"}, "coupling must be"),
        ({"engine": "fortran"}, "engine must be auto or c or python"),
        ({"record": ["a"]}, "record must be a mapping from names"),
        ({"record": {"c": []}}, "no FMU c"), ({"record": {"a": ["q"]}}, "a has no variable q"),
        ({"record": {"a": ["n.oot"]}}, r"a has no variable n\.oot; did you mean n\.out\?"),
        ({"connections": [("a", "n.oot", "b", "n")]}, r"no output n\.oot; did you mean n\.out\?"),
        ({"record": {"a": ["text"]}}, "text is no number"),
        ({"kept": "a.y"}, "kept must be a sequence of names"),
        ({"kept": ["a.z"]}, "no variable a.z in the run; did you mean a.y?"),
        ({"kept": ["b.y"], "record": {"a": ["y"]}}, "no variable b.y in the run"),
        ({"coupling": "derivatives"}, "a tells no output derivatives"),
    ],
)
def test_bad_systems_are_named(probes, options, words: str) -> None:
    with pytest.raises(InputError, match=words):
        System({"a": probes[2], "b": probes[3]},
               **{"step": 0.1, "connections": CHAIN, **options})


def test_systems_need_fmus_with_names(probes) -> None:
    with pytest.raises(InputError, match="at least one FMU"):
        System([], step=0.1)
    with pytest.raises(InputError, match="two FMUs are called Probe2; give a mapping"):
        System([probes[2]] * 2, step=0.1)
    with pytest.raises(InputError, match="takes a mapping or a sequence of files"):
        System(str(probes[2]), step=0.1)  # type: ignore[arg-type]
    with System([probes[2]], step=0.1) as system:
        system.close()
        with pytest.raises(InputError, match="the system is closed"):
            system.run(stop_time=1.0)


def test_the_engine_in_c_needs_the_extension(probes, monkeypatch) -> None:
    monkeypatch.setattr(native, "COMPILED", False)
    with System([probes[2]], step=0.1) as system:
        assert system.engine == "python"
    with pytest.raises(InputError, match="was not compiled when segfmu was installed"):
        System([probes[2]], step=0.1, engine="c")


def test_one_run_at_a_time(probes, engine: str) -> None:
    with System([probes[2]], step=1e-3, engine=engine) as system:
        def again(_share: float) -> None:
            with pytest.raises(InputError, match="is running; make one for each thread"):
                system.run(stop_time=1.0)

        assert system.run(stop_time=1.0, progress=again).size == 1001


def test_an_interrupted_run_is_no_harm(probes, engine: str) -> None:
    def stop(_share: float) -> None:
        raise KeyboardInterrupt

    with System([probes[2]], step=1e-3, engine=engine) as system:
        with pytest.raises(KeyboardInterrupt):
            system.run(stop_time=1.0, progress=stop)
        assert system.run(stop_time=1.0).size == 1001


@pytest.mark.parametrize("fmi", [2, 3])
def test_wrong_binaries_are_named(probes, tmp_path: Path, monkeypatch, fmi: int) -> None:
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "work"))
    (tmp_path / "work").mkdir()
    here = os.getcwd()
    for content, words in ((b"", "Failed to load"), (b"\x7fELF" + bytes(99), "Failed to load"),
                           (None, "Cannot find shared library")):
        bad = tmp_path / "bad.fmu"
        with zipfile.ZipFile(probes[fmi]) as source, zipfile.ZipFile(bad, "w") as target:
            for name in source.namelist():
                if not name.startswith("binaries/"):
                    target.writestr(name, source.read(name))
                elif content is not None:
                    target.writestr(name, content)
        with pytest.raises(InputError, match=f"Probe{fmi} cannot be loaded: .*({words})"):
            System([bad], step=0.1)
    incomplete = build(tmp_path / "incomplete", fmi, complete=False)
    with pytest.raises(InputError, match=rf"Probe{fmi} cannot be loaded: .*fmi{fmi}\w+"):
        System([incomplete], step=0.1)
    assert os.getcwd() == here
    assert not list((tmp_path / "work").iterdir())


def test_a_lost_archive_is_named_and_the_system_recovers(probes, tmp_path: Path) -> None:
    own = Path(shutil.copy(probes[2], tmp_path / "own.fmu"))
    with System([own], step=0.1) as system:
        system.run({"Probe2": {"reset.status": 3}}, stop_time=0.2)
        own.rename(tmp_path / "away.fmu")
        with pytest.raises(InputError, match=r"own\.fmu: cannot be read: No such file"):
            system.run(stop_time=0.2)
        (tmp_path / "away.fmu").rename(own)
        assert system.run(stop_time=0.2).size == 3


def test_the_first_row_of_a_planner_without_connections(native_fmus) -> None:
    """It is read before the first step, which ends at its events too."""
    source, sink = native_fmus[2]
    fmus = {"crane": sink, "plan": source}
    with System(fmus, step=2e-3, connections=[]) as system:
        first, again = (system.run(stop_time=0.1) for _ in range(2))
    with System({"plan": source}, step=2e-3) as system:
        alone = system.run(stop_time=0.1)
    for name in alone.dtype.names:
        assert first[name].tobytes() == again[name].tobytes() == alone[name].tobytes(), name
