"""Adaptive integration of the crane over one step: Dormand and Prince's 5(4) pair.

J. R. Dormand, P. J. Prince, A family of embedded Runge-Kutta formulae, J. Comput. Appl. Math. 6
(1980). Two modes: given forces (linear in time over the step), or given accelerations of bridge,
trolley and rope. The integrated state has an 11th component, the work of all forces.
"""

from segfmu.kernels._crane import crane_driven, crane_load, crane_rhs


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


def state_derivative(
    driven: bool,
    t: float,
    state: 'float[:]',
    drive: 'float[:]',
    drive_rate: 'float[:]',
    torque: 'float[:]',
    load_force: 'float[:]',
    bridge_mass: float,
    trolley_mass: float,
    payload_mass: float,
    gravity: float,
    work: 'float[:,:]',
    derivative: 'float[:]',
) -> None:
    """Derivative of state and work at time t of the step; work[10, :3] gets the drive forces."""
    load = work[11:13, :]
    for i in range(3):
        work[9, i] = drive[i] + t * drive_rate[i]
        work[10, i] = work[9, i]
    work[9, 3] = torque[0]
    work[9, 4] = torque[1]
    if driven:
        for i in range(3):
            work[13, i] = work[9, i]
        crane_driven(
            state, work[13, :], work[9, :], load_force, bridge_mass, trolley_mass,
            payload_mass, gravity, derivative, work[10, :],
        )
    else:
        crane_rhs(
            state, work[9, :], load_force, bridge_mass, trolley_mass, payload_mass, gravity,
            derivative,
        )
    crane_load(state, load)
    power = torque[0] * state[8] + torque[1] * state[9]
    for i in range(3):
        power = power + work[10, i] * state[5 + i] + load_force[i] * load[1, i]
    derivative[10] = power


def crane_advance(
    driven: bool,
    state: 'float[:]',
    drive: 'float[:]',
    drive_rate: 'float[:]',
    torque: 'float[:]',
    load_force: 'float[:]',
    bridge_mass: float,
    trolley_mass: float,
    payload_mass: float,
    gravity: float,
    duration: float,
    tolerance: float,
    work: 'float[:,:]',
) -> int:
    """Advance `state` (11 numbers: the crane's ten and the work done) by a duration, in place.

    drive and drive_rate: forces F_x, F_y, F_l [N] at the start and their rates, or, if driven,
    accelerations of bridge, trolley and rope [m/s2] and their rates; torque: on the two sway
    angles; tolerance: relative and absolute error a step. work (16, 11) is work space;
    work[10, :3] ends as the drive forces at the end.

    Returns 0, or 1: an angle came to +-90 degrees, 2: the rope's length came to zero, 3: the
    step size underflowed, 4: a value is not finite.
    """
    if not all_finite(state, 11) or not all_finite(drive, 3) or not all_finite(load_force, 3):
        return 4
    t = 0.0
    h = duration
    while t < duration:
        last = h >= duration - t
        if last:
            h = duration - t
        bounded = True
        for stage in range(7):
            if not bounded:
                break
            node = stage_row(stage, work[14, :])
            for i in range(11):
                value = state[i]
                for j in range(stage):
                    value = value + h * work[14, j] * work[j, i]
                work[7, i] = value
            bounded = all_finite(work[7, :], 11)
            if bounded:
                state_derivative(
                    driven, t + node * h, work[7, :], drive, drive_rate, torque, load_force,
                    bridge_mass, trolley_mass, payload_mass, gravity, work, work[stage, :],
                )
        error_weights(work[14, :])
        error = 0.0
        for i in range(11):
            value = 0.0
            for j in range(7):
                value = value + h * work[14, j] * work[j, i]
            error = max(error, abs(value) / (1.0 + max(abs(state[i]), abs(work[7, i]))))
        # a stage out of all bounds is a step that was much too long
        if not bounded or not error < 1e100:
            error = 1e100
        if error <= tolerance:
            for i in range(11):
                state[i] = work[7, i]
            status = state_status(state)
            if status != 0:
                return status
            t = t + h
            if last:
                return 0
        factor = 5.0
        if error > 0.0:
            factor = min(5.0, max(0.2, 0.9 * (tolerance / error) ** 0.2))
        h = h * factor
        if h < 1e-12 * duration:
            return 3
    return 0


def all_finite(values: 'float[:]', count: int) -> bool:
    """Whether the first values are numbers that can be computed with."""
    for i in range(count):
        if not abs(values[i]) < 1e100:
            return False
    return True


def state_status(state: 'float[:]') -> int:
    """Status of `crane_advance` that a state has."""
    if abs(state[3]) >= 1.57 or abs(state[4]) >= 1.57:
        return 1
    if state[2] <= 0.0:
        return 2
    return 0
