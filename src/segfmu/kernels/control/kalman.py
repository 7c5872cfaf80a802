"""Design of the observer's table, at one rope length: sampled model and steady Kalman gain.

The states of an axis are an `Estimate`: position, sway angle, their rates, an acceleration of the
carriage or rope, an acceleration of the load; the last two are random walks. The inputs are a
velocity command, whose rate is the correction, and the correction: a force on the carriage, or an
acceleration for velocity drives and for the hoist.

`expected` (5) is an `Expected`; sensor errors are uniformly distributed over the quantisation
steps.

The steady covariance X = A X (1 + G X)^-1 A^T + Q is found by doubling, which squares the error in
every iteration: E. K.-W. Chu, H.-Y. Fan, W.-W. Lin, Int. J. Control 77 (2004). Matrices are blocks
of eight rows of a work space with 16 columns.
"""

from segfmu.kernels.control.records import (
    AxisModel,
    AxisTable,
    Doubling,
    Estimate,
    Expected,
    Kalman,
    ModelWork,
    Observer,
)
from segfmu.kernels.crane.bounds import carriage_mass
from segfmu.kernels.crane.records import Axes, DriveMode, Plant
from segfmu.kernels.numerics.matrices import (
    halvings_below,
    matrix_add,
    matrix_copy,
    matrix_exponential,
    matrix_product,
    matrix_product_transposed,
    matrix_set,
    matrix_solve,
    matrix_transpose,
)


def kalman_model(axis: int, plant: 'float[:]', length: float, model: 'float[:,:]') -> None:
    """System matrix (8, 8) of six states and two inputs at a rope length [m]."""
    mass = carriage_mass(plant, axis)
    gravity = plant[Plant.GRAVITY]
    lag = plant[Plant.LAG + axis]
    driven = int(plant[Plant.MODE]) == DriveMode.VELOCITY
    matrix_set(AxisModel.SIZE, 0.0, model)
    model[AxisModel.COMMAND, AxisModel.CORRECTION] = 1.0
    model[AxisModel.POSITION, AxisModel.VELOCITY] = 1.0
    model[AxisModel.VELOCITY, AxisModel.DRIFT] = 1.0
    if driven and lag > 0.0:
        model[AxisModel.VELOCITY, AxisModel.VELOCITY] = -1.0 / lag
        model[AxisModel.VELOCITY, AxisModel.COMMAND] = 1.0 / lag
    elif driven or axis == Axes.ROPE:
        model[AxisModel.VELOCITY, AxisModel.CORRECTION] = 1.0
    else:
        model[AxisModel.VELOCITY, AxisModel.CORRECTION] = 1.0 / mass
        model[AxisModel.VELOCITY, AxisModel.ANGLE] = plant[Plant.PAYLOAD_MASS] * gravity / mass
    if axis != Axes.ROPE:
        rate = model[AxisModel.RATE, :]
        # l angle'' = -g angle - carriage acceleration + acceleration of the load
        model[AxisModel.ANGLE, AxisModel.RATE] = 1.0
        for j in range(AxisModel.SIZE):
            rate[j] = -model[AxisModel.VELOCITY, j] / length
        rate[AxisModel.ANGLE] = rate[AxisModel.ANGLE] - gravity / length
        rate[AxisModel.WIND] = 1.0 / length


def kalman_sampled(
    sample_time: float,
    drift: float,
    wind: float,
    model: 'float[:,:]',
    transition: 'float[:,:]',
    covariance: 'float[:,:]',
    work: 'float[:,:]',
) -> None:
    """Transition (8, 8) over a sample, and the covariance (6, 6) added by the walks.

    Taylor series over a short fraction of the sample, then doubled; work: a `ModelWork`.
    """
    doublings = halvings_below(AxisModel.SIZE, sample_time, model)
    part = sample_time / 2**doublings
    kalman_series(part, drift, wind, model, transition, covariance, work)
    term = work[ModelWork.TERM:ModelWork.PRODUCT, :]
    product = work[ModelWork.PRODUCT:ModelWork.TRANSPOSED, :]
    for _ in range(doublings):
        matrix_product(Estimate.SIZE, transition, covariance, term)
        matrix_product_transposed(Estimate.SIZE, term, transition, product)
        matrix_add(Estimate.SIZE, 1.0, product, covariance)
        matrix_product(AxisModel.SIZE, transition, transition, term)
        matrix_copy(AxisModel.SIZE, term, transition)


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
    term = work[ModelWork.TERM:ModelWork.PRODUCT, :]
    product = work[ModelWork.PRODUCT:ModelWork.TRANSPOSED, :]
    transposed = work[ModelWork.TRANSPOSED:ModelWork.SIZE, :]
    matrix_exponential(AxisModel.SIZE, part, model, transition, term, product)
    matrix_set(Estimate.SIZE, 0.0, covariance)
    matrix_set(Estimate.SIZE, 0.0, term)
    term[Estimate.DRIFT, Estimate.DRIFT] = drift * drift * part
    term[Estimate.WIND, Estimate.WIND] = wind * wind * part
    for n in range(2, 18):
        matrix_add(Estimate.SIZE, 1.0, term, covariance)
        matrix_product(Estimate.SIZE, model, term, product)
        matrix_product_transposed(Estimate.SIZE, term, model, transposed)
        matrix_add(Estimate.SIZE, 1.0, transposed, product)
        matrix_set(Estimate.SIZE, 0.0, term)
        matrix_add(Estimate.SIZE, part / n, product, term)


def kalman_turn(n: int, spread: 'float[:,:]', work: 'float[:,:]') -> float:
    """One doubling of X (n, n) in `spread` with the A^T and G of work, a `Doubling`.

    Returns the largest relative change of a variance.
    """
    transposed = work[Doubling.TRANSPOSED:Doubling.INFORMATION, :]
    information = work[Doubling.INFORMATION:Doubling.FACTOR, :]
    factor = work[Doubling.FACTOR:Doubling.SOLUTION, :]
    solution = work[Doubling.SOLUTION:Doubling.PRODUCT, :]
    product = work[Doubling.PRODUCT:Doubling.CHANGE, :]
    change = work[Doubling.CHANGE:Doubling.SIZE, :]
    # one solution for both: (1 + G X)^-1 A^T and (1 + G X)^-1 G
    matrix_set(n, 1.0, factor)
    matrix_product(n, information, spread, solution)
    matrix_add(n, 1.0, solution, factor)
    for i in range(n):
        for j in range(n):
            solution[i, j] = transposed[i, j]
            solution[i, n + j] = information[i, j]
    matrix_solve(n, 2 * n, factor, solution)
    for i in range(n):
        for j in range(n):
            product[i, j] = solution[i, n + j]
    # G + A^T (1 + G X)^-1 G A
    matrix_product(n, transposed, product, factor)
    matrix_product_transposed(n, factor, transposed, product)
    matrix_add(n, 1.0, product, information)
    # X + A X (1 + G X)^-1 A^T
    matrix_product(n, spread, solution, factor)
    matrix_transpose(n, transposed, product)
    matrix_product(n, product, factor, change)
    matrix_add(n, 1.0, change, spread)
    # A^T (1 + G X)^-1 A^T
    matrix_product(n, transposed, solution, factor)
    matrix_copy(n, factor, transposed)
    largest = 0.0
    for i in range(n):
        if spread[i, i] > 0.0:
            largest = max(largest, change[i, i] / spread[i, i])
    return largest


def kalman_gain(
    axis: int, first: float, second: float, spread: 'float[:,:]', table: 'float[:,:]'
) -> None:
    """Gains of an axis: X C^T (C X C^T + R)^-1, for variances R of position and angle."""
    a = spread[0, 0] + first
    b = 0.5 * (spread[0, 1] + spread[1, 0])
    d = spread[1, 1] + second
    if axis == Axes.ROPE:
        b = 0.0
    determinant = a * d - b * b
    for i in range(Estimate.SIZE):
        row = table[Observer.BRIDGE + Estimate.SIZE * axis + i, :]
        row[AxisTable.POSITION_GAIN] = (d * spread[i, 0] - b * spread[i, 1]) / determinant
        row[AxisTable.ANGLE_GAIN] = (a * spread[i, 1] - b * spread[i, 0]) / determinant


def kalman_axis(
    axis: int,
    sample_time: float,
    expected: 'float[:]',
    work: 'float[:,:]',
    table: 'float[:,:]',
) -> None:
    """The rows of an axis in the table, for the model in work, a `Kalman`."""
    transition = work[Kalman.TRANSITION:Kalman.SPREAD, :]
    spread = work[Kalman.SPREAD:Kalman.MODEL, :]
    transposed = work[Kalman.TRANSPOSED:Kalman.INFORMATION, :]
    information = work[Kalman.INFORMATION:Kalman.FACTOR, :]
    step = expected[Expected.POSITION]
    wind = expected[Expected.WIND]
    if axis == Axes.ROPE:
        step = expected[Expected.LENGTH]
        wind = 0.0
    position = step * step / 12.0
    angle = expected[Expected.ANGLE] * expected[Expected.ANGLE] / 12.0
    kalman_sampled(
        sample_time, expected[Expected.DRIFT], wind, work[Kalman.MODEL:Kalman.SIZE, :],
        transition, spread, work[0:ModelWork.SIZE, :],
    )
    first = Observer.BRIDGE + Estimate.SIZE * axis
    for i in range(Estimate.SIZE):
        for j in range(AxisModel.SIZE):
            table[first + i, j] = transition[i, j]
    matrix_transpose(Estimate.SIZE, transition, transposed)
    matrix_set(Estimate.SIZE, 0.0, information)
    information[Estimate.POSITION, Estimate.POSITION] = 1.0 / position
    if axis != Axes.ROPE:
        information[Estimate.ANGLE, Estimate.ANGLE] = 1.0 / angle
    turns = 0
    while kalman_turn(Estimate.SIZE, spread, work[0:Doubling.SIZE, :]) > 1e-15 and turns < 60:
        turns = turns + 1
    kalman_gain(axis, position, angle, spread, table)
    if axis == Axes.ROPE:
        # the hoist has no angle and no load
        for i in range(Estimate.ANGLE, Estimate.SIZE, 2):
            for j in range(AxisTable.SIZE):
                table[first + i, j] = 0.0


def observer_design(
    plant: 'float[:]',
    sample_time: float,
    length: float,
    expected: 'float[:]',
    work: 'float[:,:]',
    table: 'float[:,:]',
) -> None:
    """One rope length's part (19, 10) of the observer's table, an `Observer`.

    plant: masses, drive mode and lags of the nominal crane, a `Plant`; sample_time [s]; length [m];
    work (72, 16): a `Kalman`.
    """
    for j in range(AxisTable.SIZE):
        table[Observer.LENGTH, j] = 0.0
    table[Observer.LENGTH, 0] = length
    for axis in range(3):
        kalman_model(axis, plant, length, work[Kalman.MODEL:Kalman.SIZE, :])
        kalman_axis(axis, sample_time, expected, work, table)
