"""Identified parameters against the truth: closed forms, SciPy's integration, random cranes."""

from __future__ import annotations

from collections import Counter
from typing import Any

import numpy as np
import pytest
from benchmarks.identification import identified
from benchmarks.synthetic_logs import SIZES, synthetic, tables
from scipy.integrate import solve_ivp

import segfmu
from segfmu.errors import InputError
from segfmu.validation.files.crane_file import CraneFile
from segfmu.validation.files.reading import merged
from segfmu.validation.identification.fit import Problem
from segfmu.validation.identification.log import OUTPUTS, read_log
from segfmu.validation.identification.model import Model
from tests.campaign import SOAK, campaign, soaked, soaked_rows

GRAVITY = 9.81


def crane(size: str, drive: str = "velocity", **more: Any) -> dict[str, Any]:
    bridge, trolley, load, _ = SIZES[size]
    return {"bridge_mass": bridge, "trolley_mass": trolley, "payload_mass": load, "drive": drive,
            **more}


@pytest.mark.parametrize("size", ["lab", *soaked("quay")])
def test_lag_and_dead_time_of_a_ramp_that_has_a_closed_form(size: str) -> None:
    *_, length = SIZES[size]
    time = np.sqrt(length / GRAVITY)
    times = np.linspace(0.0, 3.0 * time, 300)
    lag, late, slope = 0.31 * time, 0.17 * time, 0.02 * GRAVITY
    s = np.maximum(times - late, 0.0)
    # of lag v' = slope s - v
    position = slope * (s**2 / 2.0 - lag * s + lag**2 * (1.0 - np.exp(-s / lag)))
    found = segfmu.identify(
        {"time": times, "velocity.bridge": slope * times, "measured.bridge.position": position,
         "measured.rope.length": np.full_like(times, length)},
        crane(size), fit=["bridge.lag", "bridge.dead_time"],
    )
    assert found["bridge.lag"].value == pytest.approx(lag, rel=2e-3)
    assert found["bridge.dead_time"].value == pytest.approx(late, rel=4e-3)
    (part,) = found.predicted
    assert part.load is None and part.signals[0].index > 0.999


@pytest.mark.parametrize("size", ["quay", *soaked("lab")])
def test_rope_sway_zeros_and_damping_of_a_pendulum(size: str) -> None:
    *_, load, length = SIZES[size]
    time = np.sqrt(length / GRAVITY)
    damping = 0.02 * load * length**2 / time
    times = np.linspace(0.0, 25.0 * time, 400)

    def swings(_: float, state: np.ndarray) -> list[float]:
        angle, rate = state
        inertia = load * length**2
        return [rate, -(load * GRAVITY * length * np.sin(angle) + damping * rate) / inertia]

    angle = solve_ivp(swings, (0.0, times[-1]), [0.2, 0.0], t_eval=times, rtol=1e-9, atol=1e-9).y[0]
    draw = np.random.default_rng(4)
    keys = ["friction.sway.viscous", "sensors.rope.zero", "sensors.sway_x.zero"]
    found = segfmu.identify(
        {"time": times, "velocity.bridge": 0.0 * times,
         "measured.rope.length": 1.05 * length + draw.normal(0.0, 1e-4 * length, 400),
         "measured.sway.x.angle": angle + 0.01 + draw.normal(0.0, 1e-3, 400)},
        crane(size), fit=keys,
    )
    truth = [damping, 0.05 * length, np.degrees(0.01)]
    for key, value in zip(keys, truth, strict=True):
        one = found[key]
        assert one.low < value < one.high
        assert one.high - one.low < 0.1 * value


def test_a_rope_that_stands_still_leaves_room_for_its_zero() -> None:
    *_, length = SIZES["lab"]
    log = synthetic("lab", "velocity", 2, rows=300)
    known = log.crane_without("sensors.rope.zero", "sensors.sway_x.zero")
    still = {**log.columns, "velocity.hoist": 0.0 * log.columns["time"]}
    model = Model(CraneFile.model_validate(merged(log.crane, tables(log.truth))))
    start = np.zeros(10)
    start[2], start[3] = length, 0.1
    shown = model.run(read_log(still, "velocity", {}), {}, start)
    for i, name in enumerate(OUTPUTS):
        noise = 0.0 if i == 2 else [1e-3 * length, 2e-3][i > 2]
        still[name] = shown[:, i] + np.random.default_rng(i).normal(0.0, noise, len(shown))
    found = segfmu.identify(still, known, fit=["sensors.rope.zero", "sensors.sway_x.zero"])
    zero = found["sensors.rope.zero"]
    assert zero.low < log.truth["sensors.rope.zero"] < zero.high
    assert 0.0 < zero.high - zero.low < 0.01 * length


def test_noise_of_the_integration_tells_no_dead_time() -> None:
    """Short differences took it for a slope: an interval eight times its half from the truth."""
    log = synthetic("lab", "force", 38, rows=150)
    keys = ["hoist.dead_time", "friction.hoist.coulomb", "friction.hoist.viscous"]
    found = segfmu.identify(log.columns, log.crane_without(*keys), fit=keys, held_out=0.0)
    for key in keys:
        assert found[key].low <= log.truth[key] <= found[key].high, key


@pytest.mark.soak
@pytest.mark.skipif(not SOAK, reason="takes a minute or two; make soak fits the whole crane")
def test_noise_of_the_integration_tells_no_dead_time_of_a_whole_crane() -> None:
    """Short differences took it for a slope: an interval of 3.5 ms, 20 ms from the truth."""
    found, truth = identified(("lab", "force"), 18)
    told = {e.key: e.low <= truth[e.key] <= e.high for e in found.estimates}
    assert told.get("hoist.dead_time", True)
    assert sum(told.values()) >= len(told) - 2


@pytest.mark.soak
@pytest.mark.skipif(not SOAK, reason="takes half a minute; make soak fits the whole crane")
def test_the_deeper_of_two_valleys_is_found() -> None:
    """From parts of whole pieces alone, four of 16 intervals were wrong."""
    log = synthetic("lab", "force", 124, rows=400)
    found = segfmu.identify(log.columns, log.crane, held_out=0.0)
    assert sum(e.low <= log.truth[e.key] <= e.high for e in found.estimates) >= 14
    assert max(signal.dependence for part in found.fitted for signal in part.signals) < 1.5


# of force drives fewer intervals are right, see docs/identification.md
KINDS = [("lab", "velocity"), *soaked(("quay", "velocity"))]


@campaign(1, 100)
@pytest.mark.parametrize("kind", KINDS)
def test_intervals_cover_the_truth_and_another_log_is_followed(
    kind: tuple[str, str], count: int
) -> None:
    covered: Counter[str] = Counter()
    for seed in range(count):
        found, truth = identified(kind, seed)
        (unseen,) = found.predicted
        assert unseen.load is not None and unseen.load > 0.95
        for one in found.estimates:
            covered[one.key] += one.low <= truth[one.key] <= one.high
    least = 0.9 if SOAK else 0.0
    assert all(times >= least * count for times in covered.values())
    assert sum(covered.values()) >= 0.8 * count * len(covered)


def test_force_drives_tell_masses_and_friction() -> None:
    log = synthetic("lab", "force", 2, rows=200)
    keys = ["payload_mass", "trolley_mass", "bridge_mass", "friction.trolley.coulomb"]
    found = segfmu.identify(log.columns, log.crane_without(*keys), fit=keys)
    for key in keys:
        one = found[key]
        assert one.low < log.truth[key] < one.high
        assert one.high - one.low < 0.2 * one.value


def test_what_a_log_does_not_tell_is_named_and_kept() -> None:
    log = synthetic("quay", "velocity", 1, rows=200)
    keys = ["payload_mass", "friction.sway.viscous", "sensors.bridge.zero", "trolley.lag"]
    crane = log.crane_without(*keys)
    found = segfmu.identify(log.columns, crane, fit=keys)
    told = {one.key: one for one in found.untold}
    assert {one.key for one in found.estimates} == set(keys) - set(told)
    # with velocity drives, the damping's share of the mass is all that acts on the sway
    (pair,) = told.keys() & set(keys[:2])
    assert {name for name, _ in told[pair].parts} == set(keys[:2])
    # zero and place of the bridge are one
    zero = told["sensors.bridge.zero"]
    assert {name for name, _ in zero.parts} == {zero.key, "bridge.position at the start"}
    assert str(zero).endswith("apart from bridge.position at the start; kept at 0 m")
    assert found.converged and set(found.crane) == {*crane, "friction"}
    assert set(found.crane["trolley"]) == {"dead_time", "lag"}


@pytest.mark.parametrize("size", ["quay", *soaked("lab")])
def test_a_value_that_the_log_contradicts_is_not_held(size: str) -> None:
    """A hoist that sticks: any friction above the missing force explains it, none does not."""
    *_, load, length = SIZES[size]
    times = np.linspace(0.0, 10.0 * np.sqrt(length / GRAVITY), 200)
    draw, missing = np.random.default_rng(7), 0.02 * load * GRAVITY
    still = {name: draw.normal(0.0, 1e-3 * length, 200) for name in OUTPUTS[:3]}
    still |= {name: draw.normal(0.0, 1e-3, 200) for name in OUTPUTS[3:]}
    still[OUTPUTS[2]] += length
    forces = {"force.bridge": 0.0, "force.trolley": 0.0, "force.hoist": missing - load * GRAVITY}
    found = segfmu.identify(
        {"time": times, **{n: np.full(200, f) for n, f in forces.items()}, **still},
        crane(size, "force"), fit=["friction.hoist.coulomb"],
    )
    (one,) = found.estimates
    assert not found.untold and one.value > missing
    assert one.low == 0.0 and one.high > 5.0 * missing
    (rope,) = (s for s in found.predicted[0].signals if s.signal == OUTPUTS[2])
    assert rope.deviation < 1.2e-3 * length


def test_a_crane_that_cannot_do_what_the_log_has() -> None:
    log = synthetic("lab", "velocity", 0, rows=200)
    stops = log.crane | {"travel": {"rope": [0.6, 0.9]}}
    with pytest.raises(InputError, match=r"cannot do what the log has: .* rope"):
        segfmu.identify(log.columns, stops)


def test_a_search_that_a_short_part_leads_astray_begins_anew(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """It said that the rope went slack, of logs without noise that the crane had made itself."""
    log = synthetic("lab", "velocity", 0, rows=200)
    keys = ["bridge.lag", "friction.sway.viscous"]
    solved, astray = Problem._solved, [True]

    def once(self: Problem, point: np.ndarray, *rest: Any) -> np.ndarray:
        if astray.pop() if astray else False:
            # no rope at the start
            return np.where(np.arange(point.size) == len(keys) + 2, -1e3, point)
        return solved(self, point, *rest)

    expected = segfmu.identify(log.columns, log.crane_without(*keys), fit=keys)
    monkeypatch.setattr(Problem, "_solved", once)
    found = segfmu.identify(log.columns, log.crane_without(*keys), fit=keys)
    assert not astray
    for key in keys:
        half = 0.5 * (expected[key].high - expected[key].low)
        assert found[key].value == pytest.approx(expected[key].value, abs=0.05 * half), key


def bad(**changes: Any) -> dict[str, Any]:
    times = np.linspace(0.0, 1.0, 30)
    columns = {"time": times, "velocity.bridge": times, "measured.rope.length": 0.5 + 0.0 * times}
    return {n: v for n, v in (columns | changes).items() if v is not None}


@pytest.mark.parametrize(("columns", "options", "text"), [
    (bad(**{"velocity.bridge": None}), {}, r"no column velocity\.bridge, a setpoint of drive"),
    (bad(**{"measured.rope.length": None}), {},
     r"the sway's period follows.*: --column measured\.rope\.length=COLUMN"),
    (bad(**{"measured.sway.x.angle": np.full(30, 4.0)}), {}, "reaches 4; angles are in rad"),
    (bad(**{"measured.rope.length": np.full(30, np.nan)}), {}, "no number for measured"),
    (bad(**{"measured.rope.length": np.full(30, -1.0)}), {}, "mean length is -1 m"),
    (bad(time=np.zeros(30)), {}, "time does not increase"),
    (bad(time=np.arange(29.0)), {}, "as many numbers as time"),
    (bad(time=None), {}, "no column time among .*: --column time=COLUMN"),
    ({n: v[:9] for n, v in bad().items()}, {}, "9 rows, at least 20"),
    (bad(), {"fit": ["gravity"]}, "gravity cannot be fitted; what can is bridge_mass"),
    (bad(), {"fit": []}, "name keys of the crane file, each once"),
    (bad(), {"fit": ["bridge.lag"] * 2}, "each once"),
    (bad(), {"held_out": 0.99}, r"held_out must be from 0 to 0\.9"),
    (bad(), {"piece": 0.0}, "piece must be positive"),
    (bad(), {"columns": {"rope": "l"}}, "column rope: no signal that is used"),
    (bad(), {"columns": {"measured.rope.length": "l"}}, "no column l, which is to be"),
    ({n: v[:1] for n, v in bad().items()}, {}, "log 1: 1 row, at least 20"),
    ([], {}, "no logs; name at least one"),
])
def test_wrong_input_is_told(columns: Any, options: Any, text: str) -> None:
    with pytest.raises(InputError, match=text):
        segfmu.identify(columns, crane("lab"), **options)


def test_force_drives_have_no_lag() -> None:
    columns = bad() | {f"force.{axis}": np.zeros(30) for axis in ("bridge", "trolley", "hoist")}
    with pytest.raises(InputError, match="drives that follow forces have no lag"):
        segfmu.identify(columns, crane("lab", "force"), fit=["hoist.lag"])
    with pytest.raises(InputError, match=r"no column force\.bridge"):
        segfmu.identify(bad(), crane("lab", "force"))


def test_columns_with_other_names_and_two_logs() -> None:
    log = synthetic("lab", "velocity", 3, rows=100)
    keys = ["trolley.lag", "sensors.sway_x.zero"]
    crane = log.crane_without(*keys)
    other = {("phi" if n == "measured.sway.x.angle" else n): v for n, v in log.columns.items()}
    options: dict[str, Any] = {"fit": keys, "held_out": 0.0}
    plain = segfmu.identify(log.columns, crane, **options)
    named = segfmu.identify(other, crane, columns={"measured.sway.x.angle": "phi"}, **options)
    assert named.estimates == plain.estimates and not named.predicted
    both = segfmu.identify([log.columns, log.columns], crane, **options)
    width = [one["trolley.lag"].high - one["trolley.lag"].low for one in (both, plain)]
    assert width[0] == pytest.approx(width[1] / np.sqrt(2.0), rel=0.1)
    assert len(both.fitted) == 2


def test_a_log_with_a_gap_begins_anew_behind_it() -> None:
    log = synthetic("lab", "velocity", 3, rows=200)
    columns = {name: values.copy() for name, values in log.columns.items()}
    # nobody knows what was there for a quarter of an hour
    columns["time"][95:] += 1000.0
    keys = ["bridge.lag", "trolley.dead_time", "friction.sway.viscous"]
    found = segfmu.identify(columns, log.crane_without(*keys), fit=keys, validation=columns)
    for key in keys:
        assert found[key].low < log.truth[key] < found[key].high
    behind = f"log 1 from {columns['time'][95]:.6g} s"
    assert [part.log for part in found.fitted] == ["log 1 from 0 s", behind]
    assert len(found.predicted) == 4
    # held-out parts are short: noise is a tenth of what moves there
    assert all(p.load is not None and p.load > 0.98 for p in found.predicted[2:])


def test_a_few_rows_between_gaps_are_refused_by_their_times() -> None:
    log = synthetic("quay", "velocity", 3)
    columns = {name: values.copy() for name, values in log.columns.items()}
    columns["time"][590:] += 100.0
    begin, end = columns["time"][[590, -1]]
    told = f"log 1: 10 rows from {begin:.6g} to {end:.6g} s, with gaps of more than the pendulum's"
    with pytest.raises(InputError, match=told):
        segfmu.identify(columns, log.crane)


def test_a_log_beyond_what_was_fitted_is_told() -> None:
    """The hoist of the fitted log stands still: it tells nothing of other lengths of the rope."""
    log, other = (synthetic("lab", "velocity", 3, unseen=u, rows=200) for u in (False, True))
    still = log.columns["measured.rope.length"]
    moved = int(np.argmax(np.abs(still / still[0] - 1.0) > 0.02))
    first = {name: values[:moved] for name, values in log.columns.items()}
    near = segfmu.identify(log.columns, log.crane_without(), fit=["trolley.lag"], held_out=0.0,
                    validation=other.columns)
    far = segfmu.identify(first, log.crane_without(), fit=["trolley.lag"], held_out=0.0,
                   validation=other.columns)
    assert not [b for b in near.beyond if b.signal == "measured.rope.length"]
    (rope,) = [b for b in far.beyond if b.signal == "measured.rope.length"]
    assert rope.log == "validation" and rope.range[1] > 1.05 * rope.fitted[1]
    assert str(rope).startswith("validation: measured.rope.length is 0.")


def test_a_log_that_is_not_followed_is_told() -> None:
    log = synthetic("lab", "velocity", 3, rows=100)
    crane, keys = log.crane_without("trolley.lag"), ["trolley.lag"]
    swapped = dict(log.columns)
    pair = "measured.sway.x.angle", "measured.sway.y.angle"
    swapped |= {one: log.columns[other] for one, other in (pair, pair[::-1])}
    (found,) = segfmu.identify(swapped, crane, fit=keys).poor
    assert [s.signal for s in found.signals] == list(pair)
    assert str(found).startswith(
        "log 1: the fitted crane does not follow measured.sway.x.angle (fit index "
    )
    # an axis that rests shows noise, of which nothing is to be followed
    still = log.columns | {"velocity.trolley": 0.0 * log.columns["time"]}
    for name in ("measured.trolley.position", pair[1]):
        still[name] = np.random.default_rng(1).normal(0.0, 1e-3, 100)
    followed = segfmu.identify(still, crane, fit=["bridge.lag", "sensors.sway_y.zero"])
    assert followed.fitted[0].signals[1].index < 0.1 and not followed.poor


@pytest.mark.parametrize(("late", "fit", "told"), [
    (-0.2, ["bridge.dead_time"], ", which no lag or dead time explains: "),
    (0.2, ["sensors.sway_x.zero"], "fit lag and dead time of its drive"), (0.2, ["bridge.lag"], ""),
    # both search five times as long
    *soaked_rows(
        (-0.2, ["bridge.lag", "bridge.dead_time"], ", which no lag or dead time explains: ")
    ),
])
def test_a_drive_that_moves_at_another_time_is_told(
    late: float, fit: list[str], told: str
) -> None:
    times = np.linspace(0.0, 6.0, 100)
    rate = 2.0 * np.pi / 6.0
    found = segfmu.identify(
        {"time": times, "velocity.bridge": 0.2 * np.sin(rate * times),
         "measured.bridge.position": -0.2 / rate * np.cos(rate * (times - late)),
         "measured.rope.length": np.full_like(times, 0.7)},
        crane("lab"), fit=fit,
    )
    assert bool(told) == bool(found.shifted)
    for one in found.shifted:
        assert one.signal == "measured.bridge.position"
        assert one.time == pytest.approx(late, rel=0.05)
        assert str(one).startswith(f"log 1: {one.signal} is 0.") and told in str(one)


@pytest.mark.parametrize(("length", "text"), [
    (500.0, r"mean length is 500 m, rope_max of the crane file is 0\.9 m"),
    (5e-4, r"mean length is 0\.0005 m, rope_min of the crane file is 0\.2 m"),
])
def test_a_rope_far_beyond_its_bounds_is_told(length: float, text: str) -> None:
    columns = bad(**{"measured.rope.length": np.full(30, length)})
    with pytest.raises(InputError, match=text):
        segfmu.identify(columns, crane("lab", rope_min=0.2, rope_max=0.9))


@pytest.fixture(scope="module")
def moving() -> Any:
    return synthetic("lab", "velocity", 3, rows=100)


@pytest.mark.parametrize(("name", "factor", "text"), [
    ("measured.bridge.position", 1000.0, r"measured\.bridge\.position moves through 480\.9 m, "
     r"velocity\.bridge tells 0\.4987 m: one of them, or time, is in another unit than m, m/s"),
    ("measured.trolley.position", 1e-3, r"measured\.trolley\.position moves through 0\.000\d+ m"),
    ("measured.rope.length", 1000.0, r"measured\.rope\.length moves through 1\d\d\.\d m"),
    ("velocity.trolley", 1000.0, r"velocity\.trolley tells 4\d\d\.\d m"),
    ("time", 1000.0, r"or time, is in another unit"),
    ("measured.bridge.position", -1.0, r"measured\.bridge\.position moves against velocity\.b"),
    ("velocity.hoist", -1.0, r"measured\.rope\.length moves against velocity\.hoist; turn the s"),
])
def test_other_units_and_signs_are_told(moving: Any, name: str, factor: float, text: str) -> None:
    columns = moving.columns | {name: factor * moving.columns[name]}
    with pytest.raises(InputError, match=text):
        segfmu.identify(columns, moving.crane)


def test_a_drive_that_rests_is_not_taken_for_another_unit(moving: Any) -> None:
    """Noise of a setpoint and of a position have no unit in common; a gap has any way within."""
    random = np.random.default_rng(1)
    columns = {name: values.copy() for name, values in moving.columns.items()}
    columns["time"][40:] += 1000.0
    columns["velocity.bridge"] = 1e-7 * random.normal(size=100)
    columns["measured.bridge.position"] = 0.1 + 1e-3 * random.normal(size=100)
    assert read_log(columns, "velocity", {}).times.size == 100
