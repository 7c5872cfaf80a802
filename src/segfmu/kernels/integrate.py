"""Dormand and Prince's embedded 5(4) pair.

J. R. Dormand, P. J. Prince, A family of embedded Runge-Kutta formulae, J. Comput. Appl. Math. 6
(1980).
"""


def stage_row(stage: int, row: 'float[:]') -> float:
    """Coefficients a_ij of a stage (0 .. 6); returns its node c_i."""
    for i in range(7):
        row[i] = 0.0
    if stage == 0:
        return 0.0
    if stage == 1:
        row[0] = 1.0 / 5.0
        return 1.0 / 5.0
    if stage == 2:
        row[0] = 3.0 / 40.0
        row[1] = 9.0 / 40.0
        return 3.0 / 10.0
    if stage == 3:
        row[0] = 44.0 / 45.0
        row[1] = -56.0 / 15.0
        row[2] = 32.0 / 9.0
        return 4.0 / 5.0
    if stage == 4:
        row[0] = 19372.0 / 6561.0
        row[1] = -25360.0 / 2187.0
        row[2] = 64448.0 / 6561.0
        row[3] = -212.0 / 729.0
        return 8.0 / 9.0
    if stage == 5:
        row[0] = 9017.0 / 3168.0
        row[1] = -355.0 / 33.0
        row[2] = 46732.0 / 5247.0
        row[3] = 49.0 / 176.0
        row[4] = -5103.0 / 18656.0
        return 1.0
    row[0] = 35.0 / 384.0
    row[2] = 500.0 / 1113.0
    row[3] = 125.0 / 192.0
    row[4] = -2187.0 / 6784.0
    row[5] = 11.0 / 84.0
    return 1.0


def error_weights(row: 'float[:]') -> None:
    """Difference of the fifth- and the fourth-order weights."""
    row[0] = 71.0 / 57600.0
    row[1] = 0.0
    row[2] = -71.0 / 16695.0
    row[3] = 71.0 / 1920.0
    row[4] = -17253.0 / 339200.0
    row[5] = 22.0 / 525.0
    row[6] = -1.0 / 40.0


def next_step(error: float, tolerance: float) -> float:
    """Factor from a step, whose error was found, to the next one."""
    if error > 0.0:
        return min(5.0, max(0.2, 0.9 * (tolerance / error) ** 0.2))
    return 5.0


def all_finite(values: 'float[:]', count: int) -> bool:
    """Whether the first values are numbers that can be computed with."""
    for i in range(count):
        if not abs(values[i]) < 1e100:
            return False
    return True
