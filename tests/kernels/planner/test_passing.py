"""Profiles that pass zero jerk with snap: against closed forms, at every kind of plateau."""

from __future__ import annotations

from math import factorial

import numpy as np
import pytest

from segfmu import Limits, Waypoint, plan, verify

LOOSE = 1e6


def bounds(n: int, **given: float) -> Limits:
    """Limits of a smoothness, loose where none is given."""
    names = ("velocity", "acceleration", "jerk", "snap", "crackle", "pop")[:n]
    return Limits(**(dict.fromkeys(names, LOOSE) | given))


@pytest.mark.parametrize(
    ("n", "name"), [(3, "jerk"), (4, "snap"), (5, "crackle"), (6, "pop")]
)
def test_rest_to_rest_with_the_highest_limit_alone(n: int, name: str) -> None:
    # the control of least time changes its sign where a Chebyshev polynomial does
    distance, bound = 0.7, 3.0
    optimum = (2.0 ** (2 * n - 2) * factorial(n - 1) * distance / bound) ** (1.0 / n)
    found = plan([Waypoint(0.0), Waypoint(distance)], bounds(n, **{name: bound}), smoothness=n)
    # a tenth of each rise is spent on the derivative above
    assert 1.0 < found.duration / optimum < (1.0 / 0.9) ** (1.0 / n)
    assert found.extrema(n)[1][0] == pytest.approx(bound, rel=1e-9)


TOUCHES = (
    # limits, state (v, a, w, b, distance), the optimum [s] by a linear program over 50 cells
    (
        (1.0311727883, 1.4445613520, 3.6490157204, 2.2758858534),
        (0.3577104275, -0.6536666450, -0.5838497037, 0.5972673386, 0.8519926062), 5.6635,
    ),
    (
        (1.3881915610, 1.7794294526, 4.7511211665, 1.4521238869),
        (1.1105532488, -1.4235435621, 0.0, 0.0, 3.7566359522), 6.7838,
    ),
)


@pytest.mark.parametrize(("limits", "state", "optimum"), TOUCHES)
def test_a_velocity_touches_its_limit(
    limits: tuple[float, ...], state: tuple[float, ...], optimum: float
) -> None:
    v, a, w, b, distance = state
    found = plan([Waypoint(0.0, v, a), Waypoint(distance, w, b)], Limits(*limits))
    assert found.extrema(1)[1][0] == pytest.approx(limits[0], rel=1e-9)
    assert verify(found).passed
    assert found.duration < 1.045 * optimum


@pytest.mark.parametrize("n", [5, 6])
@pytest.mark.parametrize(
    "given",
    [
        {"acceleration": 0.4}, {"velocity": 0.5}, {"velocity": 0.3, "acceleration": 0.4},
        {"jerk": 0.8}, {"jerk": 1.2, "velocity": 0.5}, {"snap": 6.0},
        {"velocity": 0.4, "acceleration": 0.4, "jerk": 1.0, "snap": 6.0},
    ],
    ids=str,
)
def test_plateaus_of_the_derivatives_below(n: int, given: dict[str, float]) -> None:
    highest = {"crackle": 60.0} if n == 5 else {"crackle": 60.0, "pop": 900.0}
    free = plan([Waypoint(0.0), Waypoint(1.0)], bounds(n, **highest), smoothness=n)
    held = plan([Waypoint(0.0), Waypoint(1.0)], bounds(n, **highest, **given), smoothness=n)
    assert held.duration > free.duration
    for order, name in enumerate(("velocity", "acceleration", "jerk", "snap"), 1):
        if name in given:
            assert np.abs(held.extrema(order)).max() <= given[name] * (1.0 + 1e-9)
    # symmetric in time, as the problem is
    times = np.linspace(0.0, held.duration, 101)
    assert held(times)[:, 0] + held(times[::-1])[:, 0] == pytest.approx(1.0, abs=1e-9)


def test_a_loose_limit_above_snap_costs_nothing() -> None:
    points = [Waypoint(0.0), Waypoint(1.0)]
    limited = plan(points, Limits(1, 1, 4, 20), smoothness=5).duration
    loose = plan(points, Limits(1, 1, 4, 20, crackle=1e9), smoothness=5).duration
    assert loose <= limited * (1.0 + 1e-9)


@pytest.mark.parametrize("n", [5, 6])
@pytest.mark.parametrize("factor", [1.001, 1.02, 1.1, 1.5])
def test_moving_states_with_a_given_duration(n: int, factor: float) -> None:
    limits = Limits(1.0, 1.0, 4.0, 20.0, 100.0, 900.0 if n == 6 else None)
    points = [Waypoint(0.0, 0.2, 0.1), Waypoint(1.0, -0.1, 0.2)]
    shortest = plan(points, limits, smoothness=n).duration
    found = plan(points, limits, smoothness=n, duration=factor * shortest)
    assert found.duration == pytest.approx(factor * shortest, rel=1e-9)


def test_reversed_in_time_it_takes_as_long() -> None:
    """A search that finds the profile from one end only would leave 9.9 s from the other."""
    limits = Limits(0.5, 0.25, pop=0.5)
    forth, back = (
        plan([Waypoint([0.0], [0.0], [a]), Waypoint([-1.0], [0.0], [b])], limits, smoothness=6)
        for a, b in ((-0.1875, 0.0), (0.0, 0.1875))
    )
    assert back.duration == pytest.approx(forth.duration, rel=1e-9)
    assert forth.duration < 6.5
