"""Ranges of demands contain them, and proofs of bounds agree with the exact peaks."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

from segfmu import ActuatorBounds, Crane, Limits, Trajectory, Waypoint, plan
from segfmu.crane import Friction
from segfmu.crane.contacts import IDEAL, NONE, resistance
from segfmu.crane.demand import demands, peaks
from segfmu.kernels import backend
from segfmu.kernels.crane.records import Demand
from segfmu.kernels.operation.drives import judge_reach
from segfmu.kernels.operation.reach import write_reach
from segfmu.kernels.operation.records import Known, OperationWork, Range, Reach
from tests.campaign import campaign

LAB = Crane(bridge_mass=2.2, trolley_mass=1.155, payload_mass=1.0)
PORT = Crane(bridge_mass=800e3, trolley_mass=30e3, payload_mass=40e3)
# of the velocity loops [s]; ideal drives, and slow ones
LAGS = np.array([IDEAL, [0.1, 0.2, 0.3]])
SIZES = {"lab": (LAB, 0.5, 0.4), "port": (PORT, 20.0, 3.0)}


def moved(rng: np.random.Generator, rope: float, fast: float, smoothness: int = 4) -> Trajectory:
    way = rng.uniform(-1.0, 1.0, (3, 3)) * rope * np.array([2.0, 2.0, 0.3])
    way[:, 2] -= rope
    limits = Limits(fast, 0.5 * fast, fast, 5.0 * fast)
    return plan([Waypoint(p) for p in way], limits, smoothness=smoothness)


def known_of(crane: Crane, friction: Friction = NONE, lag: np.ndarray = IDEAL) -> np.ndarray:
    known = np.zeros((Known.SIZE, Known.COLUMNS))
    given = resistance(crane, friction, lag)
    known[Known.CRANE, : given.size] = given
    return known


@pytest.mark.parametrize("lag", LAGS, ids=["ideal", "slow"])
@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("smoothness", [4, 6])
def test_ranges_contain_all_demands(size: str, smoothness: int, lag: np.ndarray) -> None:
    crane, rope, fast = SIZES[size]
    rng = np.random.default_rng(1)
    found = moved(rng, rope, fast, smoothness)
    work = np.zeros((OperationWork.SIZE, OperationWork.COLUMNS))
    joints = np.unique(found.timing[:, 0])
    widths = []
    for begin, end in zip(joints[:-1:5], joints[1::5], strict=False):
        for parts in (1, 16):
            last = begin + (end - begin) / parts
            assert write_reach(
                begin, last, found.timing, found.coefficients, found.offsets,
                known_of(crane, lag=lag)[Known.CRANE], work,
            )
            ranges = work[OperationWork.REACH + Reach.DEMAND :][: Demand.SIZE]
            centre, radius = ranges[:, Range.CENTRE], ranges[:, Range.RADIUS]
            told = demands(crane, found, np.linspace(begin, last, 23), lag=lag)
            rounding = 1e-9 * (np.abs(centre) + radius) + 1e-12
            assert (np.abs(told - centre) <= radius + rounding).all()
            widths.append(radius.copy())
    # they are no wider than they have to be: in a sixteenth of the time, about a sixteenth
    wide, narrow = np.array(widths[::2]), np.array(widths[1::2])
    assert (narrow.max(axis=0) < 0.25 * wide.max(axis=0)).all()


@campaign(12, 400)
@pytest.mark.parametrize("size", SIZES)
def test_proofs_agree_with_exact_peaks(size: str, count: int) -> None:
    crane, rope, fast = SIZES[size]
    rng = np.random.default_rng(2)
    work = np.zeros((OperationWork.SIZE, OperationWork.COLUMNS))
    for i in range(count):
        found, lag = moved(rng, rope, fast), LAGS[i % 2]
        most = peaks(crane, found, lag=lag)[0]
        drive = int(rng.integers(3))
        name = str(rng.choice(["force", "velocity", "acceleration", "power"]))
        first = getattr(Demand, name.upper())
        for share, keeps in ((1.005, True), (0.999, False)):
            bound = np.full(3, np.inf)
            bound[drive] = share * most[:, first + drive].max()
            known = known_of(crane, lag=lag)
            record = ActuatorBounds(**{name: bound}).record
            known[Known.BOUNDS, : record.size] = record
            assert backend.keeps_drives(
                found.timing, found.coefficients, found.offsets, known, work
            ) is keeps


def test_sway_is_proved() -> None:
    found = moved(np.random.default_rng(3), 0.5, 0.4)
    sway = peaks(LAB, found)[0][:, Demand.SWAY :].max(axis=0)
    work = np.zeros((OperationWork.SIZE, OperationWork.COLUMNS))
    for share, keeps in ((1.005, True), (0.999, False)):
        known = known_of(LAB)
        record = ActuatorBounds(sway_angle=share * sway).record
        known[Known.BOUNDS, : record.size] = record
        assert backend.keeps_drives(
            found.timing, found.coefficients, found.offsets, known, work
        ) is keeps


@pytest.mark.parametrize("size", SIZES)
def test_travel_is_proved(size: str) -> None:
    crane, rope, fast = SIZES[size]
    found = moved(np.random.default_rng(7), rope, fast)
    most = peaks(crane, found)[0][:, Demand.PLACE : Demand.SWAY]
    work = np.zeros((OperationWork.SIZE, OperationWork.COLUMNS))
    greatest, least = most[0], -most[1]
    room = 0.002 * (greatest - least)
    for axis in range(3):
        for side, (wider, keeps) in product(range(2), ((1.0, True), (-0.1, False))):
            stops = [greatest + room, least - room]
            stops[side][axis] += (1.0 - 2.0 * side) * (wider - 1.0) * room[axis]
            known = known_of(crane)
            record = ActuatorBounds(travel=stops[0], travel_min=stops[1]).record
            known[Known.BOUNDS, : record.size] = record
            assert backend.keeps_drives(
                found.timing, found.coefficients, found.offsets, known, work
            ) is keeps


def test_friction_needs_room() -> None:
    found = moved(np.random.default_rng(4), 0.5, 0.4)
    rubbing = Friction(viscous=(1.0, 1.0, 1.0), coulomb=(0.5, 0.5, 0.5))
    most = peaks(LAB, found, rubbing)[0][:, Demand.FORCE].max()
    work = np.zeros((OperationWork.SIZE, OperationWork.COLUMNS))
    known = known_of(LAB, rubbing)
    for share, keeps in ((0.95, False), (1.6, True)):
        record = ActuatorBounds(force=[share * most, np.inf, np.inf]).record
        known[Known.BOUNDS, : record.size] = record
        assert backend.keeps_drives(
            found.timing, found.coefficients, found.offsets, known, work
        ) is keeps


@pytest.mark.parametrize(("centre", "radius", "verdict"), [
    (0.5, 0.1, 1), (0.95, 0.1, 0), (1.1, 0.1, -1), (-0.95, 0.1, 0), (-1.1, 0.0, -1),
    (np.nan, 0.0, -1),
])
def test_a_range_is_inside_outside_or_open(centre: float, radius: float, verdict: int) -> None:
    work = np.zeros((OperationWork.SIZE, OperationWork.COLUMNS))
    work[OperationWork.REACH + Reach.DEMAND + Demand.VELOCITY, :2] = centre, radius
    bounds = ActuatorBounds(velocity=[1.0, np.inf, np.inf]).record
    assert judge_reach(0, Demand.SIZE, bounds, work) == verdict


def test_a_rope_that_falls_freely_is_not_proved() -> None:
    fall = plan([Waypoint([0.0, 0.0, -0.5]), Waypoint([0.0, 0.0, -40.0])], Limits(20.0, 12.0, 90.0))
    work = np.zeros((OperationWork.SIZE, OperationWork.COLUMNS))
    known = known_of(LAB)
    record = ActuatorBounds(velocity=1e3).record
    known[Known.BOUNDS, : record.size] = record
    assert not backend.keeps_drives(fall.timing, fall.coefficients, fall.offsets, known, work)
