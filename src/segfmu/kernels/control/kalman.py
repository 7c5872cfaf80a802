"""Design of the observer's table, at one rope length: sampled model and steady Kalman gain.

The states of an axis are those of control/observer.py: position, sway angle, their rates, an
acceleration of the carriage or rope, an acceleration of the load; the last two are random walks.
The inputs are a velocity command, which the second one makes a ramp, and the correction: a force on
the carriage, or for velocity drives and the hoist an acceleration.

`expected` (5): sensor steps of carriages and rope [m] and of angles [rad], whose errors are evenly
distributed; standard deviations of the walks after one second [m/s2].

The steady covariance X = A X (1 + G X)^-1 A^T + Q comes by doubling, which squares the error in
every turn: E. K.-W. Chu, H.-Y. Fan, W.-W. Lin, Int. J. Control 77 (2004). Matrices are blocks of
eight rows of a work space with 16 columns.
"""

from segfmu.kernels.numerics.matrices import (
    matrix_add,
    matrix_copy,
    matrix_product,
    matrix_product_transposed,
    matrix_set,
    matrix_solve,
    matrix_transpose,
)


def kalman_model(
    axis: int,
    driven: bool,
    mass: float,
    payload: float,
    gravity: float,
    length: float,
    lag: float,
    model: 'float[:,:]',
) -> None:
    """Derivatives (8, 8) of six states and two inputs by themselves."""
    matrix_set(8, 0.0, model)
    model[6, 7] = 1.0
    model[0, 2] = 1.0
    model[2, 4] = 1.0
    if driven and lag > 0.0:
        model[2, 2] = -1.0 / lag
        model[2, 6] = 1.0 / lag
    elif driven or axis == 2:
        model[2, 7] = 1.0
    else:
        model[2, 7] = 1.0 / mass
        model[2, 1] = payload * gravity / mass
    if axis < 2:
        # l angle'' = -g angle - carriage acceleration + acceleration of the load
        model[1, 3] = 1.0
        for j in range(8):
            model[3, j] = -model[2, j] / length
        model[3, 1] = model[3, 1] - gravity / length
        model[3, 5] = 1.0 / length


def kalman_sampled(
    sample_time: float,
    drift: float,
    wind: float,
    model: 'float[:,:]',
    transition: 'float[:,:]',
    covariance: 'float[:,:]',
    work: 'float[:,:]',
) -> None:
    """Transition (8, 8) over a sample, and what the walks add to the covariance (6, 6).

    Taylor series over a part of the sample that is short, then doubled; work (24, 16).
    """
    size = 0.0
    for i in range(8):
        total = 0.0
        for j in range(8):
            total = total + abs(model[i, j])
        size = max(size, total)
    part = sample_time
    doublings = 0
    while size * part > 0.5:
        part = 0.5 * part
        doublings = doublings + 1
    kalman_series(part, drift, wind, model, transition, covariance, work)
    for _ in range(doublings):
        matrix_product(6, transition, covariance, work[0:8, :])
        matrix_product_transposed(6, work[0:8, :], transition, work[8:16, :])
        matrix_add(6, 1.0, work[8:16, :], covariance)
        matrix_product(8, transition, transition, work[0:8, :])
        matrix_copy(8, work[0:8, :], transition)


def kalman_series(
    part: float,
    drift: float,
    wind: float,
    model: 'float[:,:]',
    transition: 'float[:,:]',
    covariance: 'float[:,:]',
    work: 'float[:,:]',
) -> None:
    """exp(M h) = 1 + M h + ..., and the integral W h + (M W + W M^T) h^2 / 2 + ... of the walks."""
    matrix_set(8, 1.0, transition)
    matrix_set(8, 1.0, work[0:8, :])
    for n in range(1, 17):
        matrix_product(8, model, work[0:8, :], work[8:16, :])
        matrix_set(8, 0.0, work[0:8, :])
        matrix_add(8, part / n, work[8:16, :], work[0:8, :])
        matrix_add(8, 1.0, work[0:8, :], transition)
    matrix_set(6, 0.0, covariance)
    matrix_set(6, 0.0, work[0:8, :])
    work[4, 4] = drift * drift * part
    work[5, 5] = wind * wind * part
    for n in range(2, 18):
        matrix_add(6, 1.0, work[0:8, :], covariance)
        matrix_product(6, model, work[0:8, :], work[8:16, :])
        matrix_product_transposed(6, work[0:8, :], model, work[16:24, :])
        matrix_add(6, 1.0, work[16:24, :], work[8:16, :])
        matrix_set(6, 0.0, work[0:8, :])
        matrix_add(6, part / n, work[8:16, :], work[0:8, :])


def kalman_turn(spread: 'float[:,:]', work: 'float[:,:]') -> float:
    """One doubling of X in `spread` with A^T and G in work[0:8] and work[8:16].

    Returns the largest relative change of a variance; work (56, 16).
    """
    # one solution for both: (1 + G X)^-1 A^T and (1 + G X)^-1 G
    matrix_set(6, 1.0, work[16:24, :])
    matrix_product(6, work[8:16, :], spread, work[24:32, :])
    matrix_add(6, 1.0, work[24:32, :], work[16:24, :])
    for i in range(6):
        for j in range(6):
            work[24 + i, j] = work[i, j]
            work[24 + i, 6 + j] = work[8 + i, j]
    matrix_solve(6, 12, work[16:24, :], work[24:32, :])
    for i in range(6):
        for j in range(6):
            work[32 + i, j] = work[24 + i, 6 + j]
    # G + A^T (1 + G X)^-1 G A
    matrix_product(6, work[0:8, :], work[32:40, :], work[16:24, :])
    matrix_product_transposed(6, work[16:24, :], work[0:8, :], work[32:40, :])
    matrix_add(6, 1.0, work[32:40, :], work[8:16, :])
    # X + A X (1 + G X)^-1 A^T
    matrix_product(6, spread, work[24:32, :], work[16:24, :])
    matrix_transpose(6, work[0:8, :], work[32:40, :])
    matrix_product(6, work[32:40, :], work[16:24, :], work[40:48, :])
    matrix_add(6, 1.0, work[40:48, :], spread)
    # A^T (1 + G X)^-1 A^T
    matrix_product(6, work[0:8, :], work[24:32, :], work[16:24, :])
    matrix_copy(6, work[16:24, :], work[0:8, :])
    change = 0.0
    for i in range(6):
        if spread[i, i] > 0.0:
            change = max(change, work[40 + i, i] / spread[i, i])
    return change


def kalman_gain(
    axis: int, first: float, second: float, spread: 'float[:,:]', table: 'float[:,:]'
) -> None:
    """Columns 8 and 9 of an axis' rows: X C^T (C X C^T + R)^-1, for variances R of the signals."""
    a = spread[0, 0] + first
    b = 0.5 * (spread[0, 1] + spread[1, 0])
    d = spread[1, 1] + second
    if axis == 2:
        b = 0.0
    determinant = a * d - b * b
    for i in range(6):
        k = 6 * axis + i
        table[k, 8] = (d * spread[i, 0] - b * spread[i, 1]) / determinant
        table[k, 9] = (a * spread[i, 1] - b * spread[i, 0]) / determinant


def kalman_axis(
    axis: int,
    sample_time: float,
    expected: 'float[:]',
    work: 'float[:,:]',
    table: 'float[:,:]',
) -> None:
    """An axis' rows of the table for the model (8, 8) in work[72:80]; work (80, 16)."""
    transition = work[56:64, :]
    spread = work[64:72, :]
    position = expected[0] * expected[0] / 12.0
    if axis == 2:
        position = expected[1] * expected[1] / 12.0
    angle = expected[2] * expected[2] / 12.0
    wind = expected[4]
    if axis == 2:
        wind = 0.0
    kalman_sampled(
        sample_time, expected[3], wind, work[72:80, :], transition, spread, work[0:24, :]
    )
    for i in range(6):
        for j in range(8):
            table[6 * axis + i, j] = transition[i, j]
    matrix_transpose(6, transition, work[0:8, :])
    matrix_set(6, 0.0, work[8:16, :])
    work[8, 0] = 1.0 / position
    if axis < 2:
        work[9, 1] = 1.0 / angle
    turns = 0
    while kalman_turn(spread, work[0:56, :]) > 1e-15 and turns < 60:
        turns = turns + 1
    kalman_gain(axis, position, angle, spread, table)
    if axis == 2:
        # the hoist has no angle and no load
        for i in range(1, 6, 2):
            for j in range(10):
                table[12 + i, j] = 0.0


def observer_design(
    driven: bool,
    sample_time: float,
    length: float,
    bridge_mass: float,
    trolley_mass: float,
    payload_mass: float,
    gravity: float,
    lag: 'float[:]',
    expected: 'float[:]',
    work: 'float[:,:]',
    table: 'float[:,:]',
) -> None:
    """One rope length's part (18, 10) of the table of kernels/control/observer.py.

    lag (3) of the velocity drives [s]; work (80, 16).
    """
    for axis in range(3):
        mass = trolley_mass
        if axis == 0:
            mass = bridge_mass + trolley_mass
        kalman_model(
            axis, driven, mass, payload_mass, gravity, length, lag[axis], work[72:80, :]
        )
        kalman_axis(axis, sample_time, expected, work, table)
