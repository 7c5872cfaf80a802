"""The step loop in C and the one in Python: every value of every row, bit for bit."""

from __future__ import annotations

import ctypes
import os
import subprocess
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from fmpy.fmi2 import FMU2Slave
from fmpy.fmi3 import FMU3Slave

from segfmu.cosim import Change, Connection, System, native
from segfmu.cosim.layout import TYPES, CCopy, CSimulation
from segfmu.cosim.messages import ERROR, FATAL
from segfmu.errors import SimulationError
from tests.campaign import SOAK
from tests.compiler import CC, needs_cc, needs_loop, require_cc

pytestmark = needs_loop

SOURCE, SINK = "GantryFeedforward", "GantryCrane"
STEP, STOP = 2e-3, 1.0
UNKIND: dict[str, Any] = {
    "drive.mode": "velocity", "feedback.design": "flatness", "sensor.sample_time": 0.01,
    "sensor.seed": 3, "sensor.trolley.position.deviation": 1e-4, "wind.noise.deviation.y": 0.1,
    "wind.noise.bandwidth": 3.0,
}
CHANGES = [
    Change(0.0, SINK, {"wind.x": 0.2}), Change(0.31234, SINK, {"wind.x": 0.0, "wind.y": -0.4}),
    Change(0.5, SINK, {"feedback.enabled": False}), Change(0.5, SINK, {"wind.y": 0.1}),
    Change(0.7000000001, SINK, {"feedback.enabled": True, "feedback.fade": 0.2}),
]
# each version, coupling, kind of event and lead meets each of the others; in a soak all do
CASES = [
    (fmi, coupling, events, lead)
    for fmi in (2, 3) for coupling in ("sequential", "parallel", "derivatives")
    for events in (True, False) for lead in (0.0, STEP)
    if not (fmi == 3 and coupling == "derivatives")
    and (SOAK or (fmi + events + (lead > 0.0)) % 2 == (coupling == "parallel"))
]


def both(
    fmus: Any, values: Any = None, *, stop_time: float = STOP, changes: Any = (), **options: Any
) -> np.ndarray:
    """Rows of the engine in C, after a check that those in Python are the same."""
    rows = []
    for engine in ("c", "python"):
        with System(fmus, engine=engine, **{"step": STEP, **options}) as system:
            assert system.engine == engine
            rows.append(system.run(values, stop_time=stop_time, changes=changes))
    assert rows[0].dtype == rows[1].dtype
    for name in rows[0].dtype.names:
        assert rows[0][name].tobytes() == rows[1][name].tobytes(), name
    return rows[0]


@pytest.mark.soak
@pytest.mark.parametrize(("fmi", "coupling", "events", "lead"), CASES)
@pytest.mark.parametrize("changes", [(), CHANGES], ids=["plain", "changes"])
def test_couplings_and_events(native_fmus, fmi, coupling, events, lead, changes) -> None:
    values = {SOURCE: {"setpoint.lead": lead}, SINK: UNKIND}
    rows = both(native_fmus[fmi], values, coupling=coupling, events=events, changes=changes)
    assert rows.size == 501
    assert np.ptp(rows["load.position.x"]) > 0.01


@pytest.mark.parametrize("versions", [(2, 3), (3, 2)])
@pytest.mark.parametrize("coupling", ["sequential", "parallel"])
def test_both_versions_in_one_system(native_fmus, versions, coupling: str) -> None:
    pair = [native_fmus[fmi][i] for i, fmi in enumerate(versions)]
    rows = both(pair, {SINK: UNKIND}, coupling=coupling, changes=CHANGES)
    same = both(native_fmus[2], {SINK: UNKIND}, coupling=coupling, changes=CHANGES)
    assert rows["load.position.x"] == pytest.approx(same["load.position.x"], abs=1e-9)


@pytest.mark.parametrize("coupling", ["sequential", "parallel"])
@pytest.mark.parametrize("fmi", [2, 3])
def test_three_fmus_in_a_ring(native_fmus, pendulums, fmi: int, coupling: str) -> None:
    """The pendulum hangs below the real trolley, and blows at the load of the crane."""
    source, sink = native_fmus[fmi]
    fmus = {"plan": source, "crane": sink, "pendulum": pendulums[5 - fmi]}
    with System(fmus, step=STEP) as system:
        given = system.connections
    ring = [c for c in given if c.sink == "crane"] + [
        Connection("plan", "reference.rope.length", "pendulum", "reference.rope.length"),
        Connection("crane", "sway.x.rate", "pendulum", "reference.bridge.acceleration"),
        Connection("pendulum", "sway.rate", "crane", "wind.y"),
    ]
    assert len(given) > 20
    values = {"pendulum": {"sway.angle": 0.2}, "crane": UNKIND}
    for connections in (None, ring):
        rows = both(fmus, values, connections=connections, coupling=coupling)
        assert np.ptp(rows["sway.angle"]) > 0.1
    # the pendulum with a step of its own, while steps of the plan end at events and changes
    both(fmus, values, connections=ring, coupling=coupling, steps={"pendulum": 5 * STEP},
         changes=[Change(0.31934, "crane", {"wind.x": 0.3})])
    # what blows moves the load aside
    alone = both(fmus, {"crane": UNKIND}, connections=ring, coupling=coupling)
    assert np.abs(rows["load.position.y"] - alone["load.position.y"]).max() > 1e-4


@pytest.mark.parametrize("fmi", [2, 3])
def test_a_swing_does_not_depend_on_its_own_steps(native_fmus, pendulums, fmi: int) -> None:
    fmus = {"plan": native_fmus[fmi][0], "pendulum": pendulums[fmi]}
    values = {"pendulum": {"sway.angle": 0.2}}
    short = both(fmus, values, connections=[], record={"pendulum": None})
    long = both(fmus, values, connections=[], record={"pendulum": None}, steps={"pendulum": 0.02})
    assert np.ptp(short["sway.angle"]) > 0.1
    assert long["sway.angle"][::10] == pytest.approx(short["sway.angle"][::10], abs=1e-5)
    assert np.all(np.diff(long["sway.angle"])[1:9] == 0.0)


def test_fmus_in_python(fmus: tuple[Path, Path]) -> None:
    both(fmus, {SINK: {"sway.x.angle": 0.1}}, step=0.01, stop_time=0.2,
         changes=[Change(0.1, SINK, {"wind.x": 0.3})])


def test_numbers_of_all_types(probes) -> None:
    connections = [
        ("a", "y", "b", "x"), ("b", "narrow", "a", "x"), ("b", "wide", "a", "n"),
        ("a", "n.out", "b", "tiny"), ("b", "flag.out", "a", "flag"), ("a", "flag.out", "b", "flag"),
    ]
    rows = both(
        {"a": probes[2], "b": probes[3]}, {"b": {"gain": 0.7}, "a": {"flag": True}},
        connections=connections, step=0.1, changes=[Change(0.33, "b", {"gain": -1.3})],
    )
    assert rows["wide"].dtype == np.int64 and rows["a.flag.out"].dtype == np.bool_
    assert np.all(rows["narrow"] == rows["b.y"].astype(np.float32))
    assert set(rows["wide"] + 1000000000000 - rows["a.n.out"].astype(np.int8)) == {0}


def test_chosen_signals_are_those_of_all(native_fmus) -> None:
    wanted = {SINK: ["load.position.x", "drive.mode", "wind.x", "drive.hoist.saturated"],
              SOURCE: ["plan.done"]}
    whole = both(native_fmus[2])
    part = both(native_fmus[2], record=wanted)
    assert part.dtype.names == ("time", "plan.done", "load.position.x", "wind.x",
                                "drive.hoist.saturated", "drive.mode")
    for name in set(part.dtype.names) & set(whole.dtype.names):
        assert part[name].tobytes() == whole[name].tobytes()


@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize("status", [2, 3, 4, 5])
def test_failures_have_the_same_words(probes, caplog, fmi: int, status: int) -> None:
    told = []
    for engine in ("c", "python"):
        caplog.clear()
        with System({"one": probes[fmi]}, step=0.1, engine=engine) as system:
            values = {"fail.time": 0.45, "fail.status": status, "talk": True}
            with pytest.raises(Exception, match=r"one could not step at 0\.4 s: told to fail") as e:
                system.run({"one": values}, stop_time=1.0)
            told.append((str(e.value), [(r.levelname, r.getMessage()) for r in caplog.records]))
            # the next run is one of its own
            rows = system.run({"one": {"x": 2.0}}, stop_time=1.0)
            assert rows["y"] == pytest.approx(2.0 + rows["time"])
            # an instance that had a fatal error is no longer used, another one is made
            assert set(rows["runs"]) == ({0} if status >= FATAL else {1})
    assert told[0] == told[1]
    assert any("said 5 times" in text for _, text in told[0][1])


@pytest.mark.parametrize("engine", ["c", "python"])
@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize("status", [ERROR, FATAL])
def test_nothing_is_called_after_a_fatal_error(
    probes, monkeypatch, fmi: int, status: int, engine: str
) -> None:
    kind = {2: FMU2Slave, 3: FMU3Slave}[fmi]
    called: list[str] = []

    def watch(name: str) -> None:
        own = getattr(kind, name)

        def noting(*arguments: Any) -> Any:
            called.append(name)
            return own(*arguments)

        monkeypatch.setattr(kind, name, noting)

    for name in ("terminate", "reset", "freeInstance"):
        watch(name)
    told = {"fail.time": 0.45, "fail.status": status}
    with (
        pytest.raises(SimulationError, match="told to fail"),
        System({"one": probes[fmi]}, step=0.1, engine=engine) as system,
    ):
        system.run({"one": told}, stop_time=1.0)
    assert called == ([] if status == FATAL else ["freeInstance"])


@pytest.mark.parametrize(
    ("status", "words"),
    [(-1, r"more than 100 steps in a row at 0\.4 s"), (-2, "to end the simulation at an event"),
     (-3, r"asked to end the simulation at 0\.5 s"), (-4, "more than 100 rounds of an event")],
)
def test_ends_that_fmi3_asks_for(probes, status: int, words: str) -> None:
    for engine in ("c", "python"):
        with System({"one": probes[3]}, step=0.1, engine=engine) as system:
            with pytest.raises(Exception, match=words):
                system.run({"one": {"fail.time": 0.45, "fail.status": status}}, stop_time=1.0)
            assert system.run(stop_time=1.0).size == 11


@pytest.mark.parametrize("way", [-1, -5])
def test_the_first_fmu_alone_ends_steps_early(probes, way: int) -> None:
    """Others may not, and those that do it all the same end no step of all."""
    values = {"b": {"fail.time": 0.45, "fail.status": way}}
    rows = both({"a": probes[2], "b": probes[3]}, values, step=0.1, connections=[])
    assert rows["time"] == pytest.approx(np.arange(11) * 0.1)


def test_other_threads_run_meanwhile(native_fmus) -> None:
    """The loop holds no lock of Python: a thread counts while it runs."""
    counts, done = [0], threading.Event()

    def count() -> None:
        while not done.is_set():
            counts[0] += 1
            time.sleep(1e-4)

    with System(native_fmus[2], step=1e-4, engine="c", record={}) as system:
        system.run(stop_time=0.1)
        thread = threading.Thread(target=count)
        thread.start()
        before = counts[0]
        system.run(stop_time=2.0)
        after = counts[0]
        done.set()
        thread.join()
    assert after - before > 10


def test_systems_run_side_by_side(native_fmus) -> None:
    """Each thread loads, runs, and frees systems of its own."""
    def work(sway: float) -> list[bytes]:
        found = []
        for _ in range(3):
            with System(native_fmus[2], step=STEP, engine="c") as system:
                for _ in range(3):
                    rows = system.run({SINK: {"sway.x.angle": sway}}, stop_time=STOP)
                    found.append(rows.tobytes())
        return found

    sways = [0.02 * i for i in range(4)]
    here = os.getcwd()
    with ThreadPoolExecutor(4) as pool:
        together = list(pool.map(work, sways))
    assert os.getcwd() == here
    for sway, found in zip(sways, together, strict=True):
        alone = both(native_fmus[2], {SINK: {"sway.x.angle": sway}})
        assert set(found) == {alone.tobytes()}


def test_layout_is_that_of_the_c_code() -> None:
    from segfmu.cosim import _loop

    assert ctypes.sizeof(CSimulation) == _loop.SIZE


@needs_cc
def test_c_compiles_without_a_warning(tmp_path: Path) -> None:
    folder = Path(native.__file__).parent / "c"
    for name in ("loop", "copy"):
        subprocess.run(
            [CC, "-std=c99", "-Wall", "-Wextra", "-Werror", "-O2", "-c", folder / f"{name}.c",
             "-o", tmp_path / f"{name}.o"], check=True,
        )


@pytest.fixture(scope="module")
def copy_values(tmp_path_factory) -> Any:
    """The function of copy.c."""
    require_cc()
    library = tmp_path_factory.mktemp("copy") / "copy.so"
    source = Path(native.__file__).parent / "c" / "copy.c"
    subprocess.run([CC, "-std=c99", "-shared", "-fPIC", source, "-o", library], check=True)
    return ctypes.CDLL(str(library)).copy_values


# real and other numbers are never connected
PAIRS = [(g, t) for g in TYPES for t in TYPES if (g.kind == "f") == (t.kind == "f")]


@pytest.mark.parametrize(("given", "taken"), PAIRS)
@pytest.mark.parametrize("indexed", [False, True])
def test_conversions_are_those_of_numpy(copy_values, given, taken, indexed: bool) -> None:
    """Between types of one kind; integers that do not fit wrap around."""
    raw = np.random.default_rng(1).integers(0, 2**63, 7, np.int64)
    source = (raw / 3.0).astype(given) if given.kind == "f" else raw.astype(given)
    source[3] = 0
    index = np.array([5, 3, 0, 6], np.int64)
    expected = (source[index] if indexed else source[:4]).astype(taken)
    target = np.zeros(4, taken)
    made = CCopy(TYPES[given], TYPES[taken], 4, source.ctypes.data,
                 index.ctypes.data if indexed else None, target.ctypes.data, 0)
    copy_values(ctypes.byref(made), ctypes.c_void_p(target.ctypes.data))
    assert target.tobytes() == expected.tobytes()
