"""Changes during a run: times, values, and a crane in the wind."""

from __future__ import annotations

from ctypes import string_at
from functools import partial

import numpy as np
import pytest

from segfmu.cosim import Change, System, native, profile
from segfmu.cosim.load import load
from segfmu.errors import InputError

SINK = "GantryCrane"
ENGINES = ("c", "python") if native.COMPILED else ("python",)


@pytest.fixture(params=[(fmi, engine) for fmi in (2, 3) for engine in ENGINES])
def one(request, probes):
    """A probe, whose output is gain x + time."""
    fmi, engine = request.param
    with System({"one": probes[fmi]}, step=0.1, engine=engine) as system:
        yield system


def test_rows_have_what_follows_from_the_values(one) -> None:
    changes = [
        Change(0.7, "one", {"x": 9.0}), Change(0.0, "one", {"x": 1.0}),
        Change(0.25, "one", {"gain": 10.0, "n": 4}), Change(0.7, "one", {"x": 3.0, "flag": True}),
        Change(1.0, "one", {"x": -1.0}),
    ]
    rows = one.run(stop_time=1.0, changes=changes)
    times = np.round(np.arange(11) * 0.1, 12)
    gain = np.where(times < 0.25, 1.0, 10.0)
    x = np.select([times < 0.65, times < 0.95], [1.0, 3.0], -1.0)
    assert rows["y"] == pytest.approx(gain * x + times)
    assert rows["n.out"].tolist() == [0] * 3 + [12] * 8
    assert rows["flag.out"].tolist() == [True] * 7 + [False] * 4
    # the next run knows nothing of them
    assert one.run(stop_time=1.0)["y"] == pytest.approx(times)


def test_a_profile_holds_its_samples(one) -> None:
    times = np.linspace(0.0, 1.0, 301)
    rows = one.run(stop_time=1.0, changes=profile("one", "x", times, np.sin(times)))
    held = np.sin(times[np.searchsorted(times, rows["time"] + 1e-9, side="right") - 1])
    assert rows["y"] == pytest.approx(held + rows["time"])


@pytest.mark.parametrize("fmi", [2, 3])
def test_equal_texts_stay_until_their_times(probes, fmi: int) -> None:
    with load(probes[fmi]) as unit:
        first, again, other = (unit.assignments({"text": t})[0] for t in ("same", "same", "other"))
        places = [int(values[0]) for _, values in (first, again, other)]
        assert [string_at(p) for p in places] == [b"same", b"same", b"other"]
        # a second buffer would free the first one, which may look unchanged for a while
        assert places[0] == places[1] != places[2]


def test_texts_change_nothing_that_runs(one) -> None:
    with pytest.raises(InputError, match="text cannot change during a run, only inputs and"):
        one.run(stop_time=1.0, changes=[Change(0.5, "one", {"text": "x"})])


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (Change(0.5, "two", {}), "no FMU two"), (Change(0.5, "one", {"q": 1.0}), "no variable q"),
        (Change(0.5, "one", {"y": 1.0}), "y cannot change during a run"),
        (Change(0.5, "one", {"fail.time": 1.0}), "give it as a start value"),
        (Change(-0.1, "one", {"x": 1.0}), "outside of the run from 0 s to 1 s"),
        (Change(1.1, "one", {"x": 1.0}), "outside of the run"),
        (Change(float("nan"), "one", {"x": 1.0}), "time of a change must be finite"),
        (Change("1", "one", {"x": 1.0}), "one: the time of a change must be one number, got '1'"),
        (Change(0.5, "one", None), "one: values of a change must be a mapping from names"),
        (Change(0.5, "one", {"n": 0.5}), "n takes an integer"),
    ],
)
def test_bad_changes_are_named(one, change: Change, words: str) -> None:
    with pytest.raises(InputError, match=words):
        one.run(stop_time=1.0, changes=[change])


@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize(("values", "words"), [
    ({"limits.scale": 2.0}, "limits.scale must be at most 1, got 2.0"),
    ({"limits.scale": -0.5}, "limits.scale must be at least 0, got -0.5"),
    ({"command.mode": 9}, "command.mode must be at most 6, got 9"),
    ({"limits.scale": float("nan")}, "limits.scale must be at most 1, got nan"),
])
def test_values_outside_of_their_ranges_are_named_with_their_line(
    native_fmus, fmi: int, values: dict[str, float], words: str
) -> None:
    """The FMU refused them in the run: an error without the line of the file."""
    change = Change(0.5, "GantryFeedforward", values, "rec.csv, line 3")
    with System(native_fmus[fmi], step=0.1) as system:
        for call in (system.run, partial(system.check, {})):
            with pytest.raises(InputError, match=f"^rec.csv, line 3: .*{words}$"):
                call(stop_time=1.0, changes=[change])
        kept = Change(0.5, "GantryFeedforward", {"limits.scale": 1.0, "command.mode": 6})
        system.check({}, stop_time=1.0, changes=[kept])


def test_connected_inputs_cannot_change(probes) -> None:
    with (
        System({"a": probes[2], "b": probes[3]}, step=0.1,
               connections=[("a", "y", "b", "x")]) as system,
        pytest.raises(InputError, match="b: x is connected, so a change of it would not last"),
    ):
        system.run(stop_time=1.0, changes=[Change(0.5, "b", {"x": 1.0})])


@pytest.mark.parametrize("coupling", ["sequential", "parallel"])
def test_a_change_of_a_source_reaches_its_sink(probes, coupling: str) -> None:
    """Parallel: at once; sequential: with the next step, whose end it has."""
    with System({"a": probes[2], "b": probes[3]}, step=0.1, connections=[("a", "y", "b", "x")],
                coupling=coupling) as system:
        rows = system.run(stop_time=1.0, changes=[Change(0.5, "a", {"x": 100.0})])
    late = rows["time"] > (0.45 if coupling == "parallel" else 0.55)
    assert rows["b.y"] == pytest.approx(2.0 * rows["time"] + 100.0 * late)


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("fmi", [2, 3])
def test_wind_by_changes_pushes_the_load(native_fmus, fmi: int, engine: str) -> None:
    """From its time on, not before; farther where a further change turned the feedback off."""
    start, duration, force = 0.1234, 0.4, 0.5
    with System(native_fmus[fmi], step=2e-3, engine=engine) as system:
        calm = system.run(stop_time=1.0)
        steps = system.run(
            stop_time=1.0,
            changes=[Change(start, SINK, {"wind.x": force}),
                     Change(start + duration, SINK, {"wind.x": 0.0})],
        )
        tuned = system.run(
            stop_time=1.0, changes=[Change(0.3, SINK, {"feedback.enabled": False}),
                                    Change(start, SINK, {"wind.x": force})],
        )
    before = calm["time"] < start
    for rows in (steps, tuned):
        assert rows["load.position.x"][before] == pytest.approx(
            calm["load.position.x"][before], abs=1e-9
        )
    pushed = np.abs(steps["load.position.x"] - calm["load.position.x"]).max()
    assert pushed > 0.005
    # without feedback it goes farther
    assert np.abs(tuned["load.position.x"] - calm["load.position.x"]).max() > pushed
