"""Dormand and Prince's embedded 5(4) pair.

J. R. Dormand, P. J. Prince, A family of embedded Runge-Kutta formulae, J. Comput. Appl. Math. 6
(1980).
"""

from segfmu.kernels.numerics.records import Stages


def stage_node(stage: int) -> float:
    """Node c of a stage, as a share of the step."""
    if stage == Stages.K1:
        return 0.0
    if stage == Stages.K2:
        return 1.0 / 5.0
    if stage == Stages.K3:
        return 3.0 / 10.0
    if stage == Stages.K4:
        return 4.0 / 5.0
    if stage == Stages.K5:
        return 8.0 / 9.0
    return 1.0


def stage_state(
    stage: int, h: float, count: int, state: 'float[:]', k: 'float[:,:]', trial: 'float[:]'
) -> float:
    """First components of the state at a stage after the first: state + h sum a_ij k_j.

    k: one row per stage (`Stages`); trial: the result. Every sum is written out, so that its terms
    stay in registers. The last stage is the end of the step. Returns the sum of the magnitudes,
    which is not a number, or very large, if one of them is.
    """
    size = 0.0
    if stage == Stages.K2:
        a0 = h * (1.0 / 5.0)
        for i in range(count):
            part = state[i] + a0 * k[Stages.K1, i]
            trial[i] = part
            size = size + abs(part)
    elif stage == Stages.K3:
        a0 = h * (3.0 / 40.0)
        a1 = h * (9.0 / 40.0)
        for i in range(count):
            part = state[i] + a0 * k[Stages.K1, i] + a1 * k[Stages.K2, i]
            trial[i] = part
            size = size + abs(part)
    elif stage == Stages.K4:
        a0 = h * (44.0 / 45.0)
        a1 = h * (-56.0 / 15.0)
        a2 = h * (32.0 / 9.0)
        for i in range(count):
            part = state[i] + a0 * k[Stages.K1, i] + a1 * k[Stages.K2, i] + a2 * k[Stages.K3, i]
            trial[i] = part
            size = size + abs(part)
    elif stage == Stages.K5:
        a0 = h * (19372.0 / 6561.0)
        a1 = h * (-25360.0 / 2187.0)
        a2 = h * (64448.0 / 6561.0)
        a3 = h * (-212.0 / 729.0)
        for i in range(count):
            part = state[i] + a0 * k[Stages.K1, i] + a1 * k[Stages.K2, i] + a2 * k[Stages.K3, i]
            part = part + a3 * k[Stages.K4, i]
            trial[i] = part
            size = size + abs(part)
    elif stage == Stages.K6:
        a0 = h * (9017.0 / 3168.0)
        a1 = h * (-355.0 / 33.0)
        a2 = h * (46732.0 / 5247.0)
        a3 = h * (49.0 / 176.0)
        a4 = h * (-5103.0 / 18656.0)
        for i in range(count):
            part = state[i] + a0 * k[Stages.K1, i] + a1 * k[Stages.K2, i] + a2 * k[Stages.K3, i]
            part = part + a3 * k[Stages.K4, i] + a4 * k[Stages.K5, i]
            trial[i] = part
            size = size + abs(part)
    else:
        a0 = h * (35.0 / 384.0)
        a2 = h * (500.0 / 1113.0)
        a3 = h * (125.0 / 192.0)
        a4 = h * (-2187.0 / 6784.0)
        a5 = h * (11.0 / 84.0)
        for i in range(count):
            part = state[i] + a0 * k[Stages.K1, i] + a2 * k[Stages.K3, i] + a3 * k[Stages.K4, i]
            part = part + a4 * k[Stages.K5, i] + a5 * k[Stages.K6, i]
            trial[i] = part
            size = size + abs(part)
    return size


def step_error(
    h: float, count: int, start: 'float[:]', end: 'float[:]', k: 'float[:,:]'
) -> float:
    """Largest difference of the fifth- and fourth-order states, relative to values above 1.

    A difference that is not finite counts as 1e100.
    """
    e0 = h * (71.0 / 57600.0)
    e2 = h * (-71.0 / 16695.0)
    e3 = h * (71.0 / 1920.0)
    e4 = h * (-17253.0 / 339200.0)
    e5 = h * (22.0 / 525.0)
    e6 = h * (-1.0 / 40.0)
    error = 0.0
    for i in range(count):
        part = e0 * k[Stages.K1, i] + e2 * k[Stages.K3, i] + e3 * k[Stages.K4, i]
        difference = part + e4 * k[Stages.K5, i] + e5 * k[Stages.K6, i] + e6 * k[Stages.K7, i]
        size = 1.0 + max(abs(start[i]), abs(end[i]))
        error = max(error, abs(difference) / size)
    if not error < 1e100:
        return 1e100
    return error


def next_step(error: float, tolerance: float) -> float:
    """Ratio of the next step to this one, from this one's error."""
    # most steps are shortened by their interval's end, with errors far below the tolerance
    if 5300.0 * error > tolerance:
        return min(5.0, max(0.2, 0.9 * (tolerance / error) ** 0.2))
    return 5.0


def all_finite(values: 'float[:]', count: int) -> bool:
    """Whether the first values are finite and below 1e100."""
    for i in range(count):
        if not abs(values[i]) < 1e100:
            return False
    return True
