"""Flat inverse of a crane whose load hangs by a sling on a hook.

The load obeys Newton's law with gravity and the sling's force, so its path p gives the direction of
the sling, that of w = p'' + g e_z, and thereby the path of the hook:

    h = p + L w / |w|

The rope carries hook and load. Per mass of the load its force is

    w + (m_h / m_p) (h'' + g e_z)

From here on all is as for a load that hangs on the rope: the path of what hangs on it, and its
force, give trolley, length, angles and forces (crane/_series.py). The accelerations of the
carriages follow from the sixth derivative of p, their velocities from the fifth.
"""

from segfmu.kernels.crane._series import suspension_derivatives
from segfmu.kernels.crane.records import (
    Coordinates,
    FlatInverse,
    FlatSeries,
    Masses,
    State,
)
from segfmu.kernels.hook.records import HookCoordinates, HookInverse, HookState, SlingSeries
from segfmu.kernels.numerics.series import (
    series_angle,
    series_derivative,
    series_of_derivatives,
    series_product,
    series_quotient,
    series_root,
    series_sum,
)


def hook_derivatives(
    flat: 'float[:,:]',
    order: int,
    masses: 'float[:]',
    hook_mass: float,
    sling: float,
    work: 'float[:,:]',
    found: 'float[:]',
) -> None:
    """Derivatives, of an order, of the flat inverse; of order 0 the inverse itself.

    flat (order + 7, 3) holds the derivatives 0 .. order + 6 of the load's position; masses
    (Masses.SIZE), mass of the hook [kg] and length of the sling [m], work (SlingSeries.SIZE,
    order + 5 or more), found (HookInverse.SIZE).
    """
    write_sling(flat, order + 5, masses, hook_mass, sling, work)
    suspension_derivatives(
        order, masses, work, found[FlatInverse.FORCE:FlatInverse.STATE],
        found[FlatInverse.STATE:FlatInverse.ACCELERATION],
        found[FlatInverse.ACCELERATION:FlatInverse.SIZE],
    )
    # these results move apart, from the end, to make room for those of the sling
    for i in range(Coordinates.SIZE):
        k = Coordinates.SIZE - 1 - i
        found[HookInverse.ACCELERATION + k] = found[FlatInverse.ACCELERATION + k]
    for i in range(Coordinates.SIZE):
        k = Coordinates.SIZE - 1 - i
        found[HookInverse.STATE + HookState.VELOCITY + k] = found[
            FlatInverse.STATE + State.VELOCITY + k
        ]
    for i in range(2):
        angle = work[SlingSeries.SLING + i, :]
        found[HookInverse.STATE + HookState.SLING_ANGLE + i] = series_derivative(angle, order)
        found[HookInverse.STATE + HookState.SLING_RATE + i] = series_derivative(angle, order + 1)
        found[HookInverse.ACCELERATION + HookCoordinates.SLING_ANGLE + i] = series_derivative(
            angle, order + 2
        )


def write_sling(
    flat: 'float[:,:]',
    count: int,
    masses: 'float[:]',
    hook_mass: float,
    sling: float,
    work: 'float[:,:]',
) -> None:
    """Series of what hangs on the rope: count terms of its path, two less of the rope's force."""
    gravity = masses[Masses.GRAVITY]
    write_links(flat, count, gravity, work)
    climb_sling(count, hook_mass / masses[Masses.PAYLOAD_MASS], sling, gravity, work)


def write_links(
    flat: 'float[:,:]', count: int, gravity: float, work: 'float[:,:]'
) -> None:
    """Series of the load's path, of w, and of the sling's direction and angles."""
    for i in range(3):
        series_of_derivatives(flat, 0, i, count, work[FlatSeries.LOAD + i, :])
        series_of_derivatives(flat, 2, i, count, work[FlatSeries.PULL + i, :])
    w_x = work[FlatSeries.PULL, :]
    w_y = work[FlatSeries.PULL + 1, :]
    w_z = work[FlatSeries.PULL + 2, :]
    w_z[0] = w_z[0] + gravity
    across = work[FlatSeries.INTERMEDIATE, :]
    size = work[FlatSeries.INTERMEDIATE + 1, :]
    square = work[FlatSeries.INTERMEDIATE + 2, :]
    part = work[FlatSeries.COORDINATES, :]
    scratch = work[FlatSeries.COORDINATES + 1, :]
    # w_y^2 + w_z^2, then |w|^2
    series_product(w_y, w_y, count, part)
    series_product(w_z, w_z, count, scratch)
    series_sum(part, scratch, count, across)
    series_product(w_x, w_x, count, part)
    series_sum(across, part, count, square)
    series_angle(w_y, w_z, across, count, scratch, work[SlingSeries.SLING + 1, :])
    # atan2(-w_x, sqrt(across))
    series_root(across, count, part)
    for k in range(count):
        size[k] = -w_x[k]
    series_angle(size, part, square, count, scratch, work[SlingSeries.SLING, :])
    series_root(square, count, size)
    for i in range(3):
        series_quotient(
            work[FlatSeries.PULL + i, :], size, count, work[SlingSeries.DIRECTION + i, :]
        )


def climb_sling(
    count: int, share: float, sling: float, gravity: float, work: 'float[:,:]'
) -> None:
    """From the load's path and w to the hook's path and the rope's force per mass of the load.

    share: mass of the hook per mass of the load. The force has two terms less than the path.
    """
    for i in range(3):
        path = work[FlatSeries.LOAD + i, :]
        direction = work[SlingSeries.DIRECTION + i, :]
        pull = work[FlatSeries.PULL + i, :]
        for k in range(count):
            path[k] = path[k] + sling * direction[k]
        for k in range(count - 2):
            pull[k] = pull[k] + share * (k + 1.0) * (k + 2.0) * path[k + 2]
    upwards = work[FlatSeries.PULL + 2, :]
    upwards[0] = upwards[0] + share * gravity
