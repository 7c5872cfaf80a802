"""Short motions between moving states: no longer than motions that exist within 95 % of the limits.

Each was built of random ramps and holds; its duration bounds that of the shortest one.
"""

from __future__ import annotations

import pytest

from segfmu import Limits, Waypoint, plan, verify

pytestmark = pytest.mark.interpreted

# limits; v, a -> w, b over a distance; duration of the motion that was built
BUILT = [
    # accelerations of unlike sign, one of them small: the levels lie between them
    ((1.3147, 1.1719, 0.6278, 4.8301), (-0.83414, 1.11333, 0.284, -0.01608, -0.14375), 2.0381),
    ((7.0086, 2.29, 0.3889, 1.2317), (-2.4153, 1.44123, 0.63665, -0.04962, -1.33335), 4.3862),
    ((9.9509, 2.9021, 1.8485, 3.6652), (2.62667, -2.75704, -0.3018, 0.0288, 1.21264), 2.1468),
    # the velocity limit forbids the optimal form, and the one that touches it takes much longer
    ((0.7647, 0.8764, 5.3297, 8.4719), (0.4393, 0.83261, 0.3403, -0.83261, 0.78923), 1.3317),
    ((8.4214, 2.7162, 8.7858, 1.4729), (-3.24781, -2.58042, -5.50203, 1.95576, -34.9816), 5.3422),
    ((0.4639, 0.7901, 6.1712, 8.5617), (-0.11205, -0.75058, -0.21265, 0.71146, -0.4101), 1.2489),
    ((0.7526, 1.1778, 3.7329, 2.3939), (-0.36169, 1.11887, -0.16817, -1.11887, 0.95846), 2.9359),
    # steeper rises touch the limit, the usual ones brake
    ((0.4467, 0.5409, 1.7539, 6.0218), (0.29863, 0.37736, 0.22284, -0.51381, 0.4166), 1.1766),
    # much shorter than the profile that brakes
    (
        (9.8884, 0.5776, 1.182, 1.3013, 1.7048),
        (-6.84475, 0.23427, -6.49863, 0.14971, -14.24399), 2.1413,
    ),
]


@pytest.mark.parametrize("shape", ["plateau", "smoothstep"])
@pytest.mark.parametrize("n", range(2, 7))
def test_nothing_but_a_cruise_at_the_velocity_limit(n: int, shape: str) -> None:
    points = [Waypoint(0.0, -0.5), Waypoint(-1.0, -0.5)]
    limits = Limits(*[0.5] * max(n, 3))
    assert plan(points, limits, smoothness=n, shape=shape).duration == pytest.approx(2.0, rel=1e-12)


@pytest.mark.parametrize(("limits", "state", "built"), BUILT)
@pytest.mark.parametrize("mirrored", [False, True])
@pytest.mark.parametrize("reversed_in_time", [False, True])
def test_a_motion_takes_no_longer_than_one_that_was_built(
    limits, state, built, mirrored, reversed_in_time
) -> None:
    v, a, w, b, distance = state
    if reversed_in_time:
        v, a, w, b = w, -b, v, -a
    sign = -1.0 if mirrored else 1.0
    points = [
        Waypoint([0.0], [sign * v], [sign * a]), Waypoint([sign * distance], [sign * w], [sign * b])
    ]
    trajectory = plan(points, Limits(*limits), smoothness=len(limits))
    assert verify(trajectory).passed
    assert trajectory.duration <= built * 1.001
