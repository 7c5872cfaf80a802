"""The proof about the rope on polynomials whose verdict is known in closed form."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu.kernels.crane.records import RopeWork
from segfmu.kernels.crane.rope import check_rope

GRAVITY = 9.81


def judge(
    x: list[list[float]], y: list[list[float]], z: list[list[float]], *,
    shortest: float = 0.0, longest: float = 0.0, lengths=((1.0,), (1.0,), (1.0,)),
):
    """Status and report for ascending coefficients, one list a piece, and the pieces' lengths."""
    width = max(4, *(len(piece) for axis in (x, y, z) for piece in axis))
    timing, coefficients = [], []
    for axis, durations in zip((x, y, z), lengths, strict=True):
        starts = np.cumsum([0.0, *durations])[:-1]
        timing += list(zip(starts, durations, strict=True))
        coefficients += [piece + [0.0] * (width - len(piece)) for piece in axis]
    offsets = np.cumsum([0, len(x), len(y), len(z)])
    report = np.zeros(3)
    status = check_rope(
        np.array(timing), np.array(coefficients), offsets,
        np.array([GRAVITY, shortest, longest]), np.zeros((RopeWork.SIZE, 4 * width - 5)), report,
    )
    return status, *report.tolist()


def test_a_hanging_load_passes() -> None:
    assert judge([[0.0]], [[0.0]], [[-1.0]], shortest=0.5, longest=2.0) == (0, 0.0, 0.0, 0.0)


def test_a_load_that_rises_to_the_trolley() -> None:
    status, time, worst, bound = judge([[0.0]], [[0.0]], [[-0.25, 0.5]])
    assert (status, bound) == (1, -1e-6)
    # 1e-6 m below the trolley, at a velocity of 0.5 m/s
    assert time == pytest.approx(0.5 - 1e-6 / 0.5, abs=1e-8)
    assert worst == pytest.approx(0.25)


def test_a_load_that_falls_faster_than_gravity() -> None:
    # z'' = -12 t passes -9.81 at t = 0.8175
    status, time, worst, bound = judge([[0.0]], [[0.0]], [[-1.0, 0.0, 0.0, -2.0]])
    assert (status, bound) == (2, GRAVITY)
    assert time == pytest.approx(GRAVITY / 12.0, abs=1e-8)
    assert worst == pytest.approx(12.0)


@pytest.mark.parametrize(
    ("bounds", "status", "time", "worst"),
    [({"longest": 1.5}, 3, 0.5, 2.0), ({"shortest": 1.25}, 4, 0.0, 1.0)],
)
def test_a_load_lowered_steadily(bounds, status: int, time: float, worst: float) -> None:
    found = judge([[0.0]], [[0.0]], [[-1.0, -1.0]], **bounds)
    assert found[0] == status
    assert found[1:3] == pytest.approx((time, worst), abs=1e-8)
    assert found[3] == next(iter(bounds.values()))


def test_swaying_lengthens_the_rope() -> None:
    # a constant acceleration of 3 and 4 m/s2 in x and y: l = |z| sqrt(1 + (5 / g)^2)
    length = np.sqrt(1.0 + (5.0 / GRAVITY) ** 2)
    x, y, z = [[0.0, 0.0, 1.5]], [[0.0, 0.0, 2.0]], [[-1.0]]
    assert judge(x, y, z, longest=length * (1.0 + 1e-8), shortest=length * (1.0 - 1e-8))[0] == 0
    status, time, worst, _ = judge(x, y, z, longest=length * (1.0 - 1e-8))
    assert (status, time) == (3, 0.0)
    assert worst == pytest.approx(length, rel=1e-12)
    assert judge(x, y, z, shortest=length * (1.0 + 1e-8))[0] == 4


def test_axes_end_at_different_times_and_then_stay() -> None:
    # x stops accelerating when its only piece ends at 1 s, while z goes on to 3 s
    lengths = ((1.0,), (1.0,), (0.7, 2.3))
    z = [[-1.0], [-1.0, 0.0, -0.1]]
    bent = np.sqrt(1.0 + (3.0 / GRAVITY) ** 2)
    status, time, worst, _ = judge(
        [[0.0, 0.0, 1.5]], [[0.0]], z, longest=1.2, lengths=lengths
    )
    assert status == 3
    # 1 + 0.1 s^2 = 1.2 at s = sqrt(2) after 0.7 s; z'' leaves a hanging rope as long as |z|
    assert time == pytest.approx(0.7 + np.sqrt(2.0), abs=1e-6)
    assert worst == pytest.approx(1.0 + 0.1 * 2.3**2)
    assert judge([[0.0, 0.0, 1.5]], [[0.0]], z, longest=1.6, lengths=lengths)[0] == 0
    assert judge([[0.0, 0.0, 1.5]], [[0.0]], z, longest=0.999 * bent, lengths=lengths)[1] == 0.0


def test_an_earlier_demand_is_told_first_even_if_it_fails_later() -> None:
    # too long from the start, at the trolley's height in the end
    status, time, _, _ = judge([[0.0]], [[0.0]], [[-1.0, 1.5]], longest=0.9)
    assert status == 1
    assert time == pytest.approx((1.0 - 1e-6) / 1.5, abs=1e-8)


def test_a_touch_between_two_samples_is_found() -> None:
    # a peak at 0.503 s that passes by 1e-6 m for 2 ms
    excess, peak = 1e-6, 0.503
    z = [-1.0 - excess + peak**2, -2.0 * peak, 1.0]
    status, time, worst, _ = judge([[0.0]], [[0.0]], [z], longest=1.0)
    assert status == 3
    assert time == pytest.approx(peak - np.sqrt(excess), abs=1e-6)
    assert 1.0 < worst <= 1.0 + excess


@pytest.mark.parametrize("seed", range(40))
def test_the_extremes_of_the_rope_decide(seed: int) -> None:
    """Of motions that sway little or much, against samples of load and rope by Newton's laws."""
    random = np.random.default_rng(seed)
    size = 10.0 ** random.uniform(-2.0, -0.9)
    x, y, z = size * random.normal(size=(3, 6))
    z[0] = -3.0 - 4.0 * size
    t = np.linspace(0.0, 1.0, 20001)
    place = [np.polynomial.Polynomial(p) for p in (x, y, z)]
    force = [p.deriv(2)(t) + (GRAVITY if i == 2 else 0.0) for i, p in enumerate(place)]
    assert force[2].min() > 0.1 and place[2](t).max() < -0.1
    rope = -place[2](t) * np.sqrt(1.0 + (force[0] ** 2 + force[1] ** 2) / force[2] ** 2)
    motion = [[p.tolist()] for p in (x, y, z)]
    for share, refused in ((1.0 + 1e-6, False), (1.0 - 1e-6, True)):
        assert judge(*motion, longest=share * rope.max())[0] == (3 if refused else 0)
        assert judge(*motion, shortest=rope.min() / share)[0] == (4 if refused else 0)
