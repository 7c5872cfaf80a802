"""The crane with drives, friction and wind, integrated adaptively over an interval.

State (13): x_t, y_t, l, phi_x, phi_y, their rates; then work of the drives, work of the wind and
energy dissipated by friction [J].

Parameters (37), triples in the order bridge, trolley, rope; 0 where a bound or an effect is absent:

    0      mass of the bridge        1   of the trolley      2   of the load [kg]
    3      gravity [m/s2]            4   1: velocity commands, 0: force commands
    5:8    lag [s]                   8:11   largest force [N]   11:14  largest acceleration [m/s2]
    14:17  viscous friction [N s/m]  17:20  Coulomb friction [N]
    20     velocity at which Coulomb friction comes to tanh(1) of its value [m/s]
    21     viscous damping of both sway angles [N m s]
    22:25  least positions [m]       25:28  greatest positions [m]
    28:31  constant wind [N]         31  start of the gust [s]  32  its duration [s]
    33     its shape, 0: 1 - cosine, 1: half a sine             34:37  its force [N]

Work space (16, 13): 0:7 derivatives of the stages, 7 trial state; in 8, 7 the step to try first (0:
the whole interval), kept for the next call; 9 generalised forces, 10 results as in
`driven_derivative` and, from 9 on, its flags at the step's start, 11 wind, 12:14 position and
velocity of the load, 14 commands and accelerations, 15 friction and scratch.
"""

from segfmu.kernels.crane._crane import crane_load
from segfmu.kernels.crane.drives import (
    driven_derivative,
    forced_derivative,
    friction_force,
    wind_force,
)
from segfmu.kernels.numerics.integrate import (
    all_finite,
    next_step,
    stage_node,
    stage_state,
    step_error,
)


def plant_derivative(
    parameters: 'float[:]',
    components: 'float[:,:]',
    time: float,
    elapsed: float,
    state: 'float[:]',
    command: 'float[:]',
    rate: 'float[:]',
    load_force: 'float[:]',
    work: 'float[:,:]',
    derivative: 'float[:]',
) -> None:
    """Derivative of the state at a time that has elapsed since the interval's start."""
    wind_force(parameters, components, time + elapsed, load_force, work[11, :])
    for i in range(3):
        bend = rate[3 + i] + elapsed * rate[6 + i]
        work[14, i] = command[i] + elapsed * (rate[i] + elapsed * bend)
        work[15, i] = friction_force(parameters, i, state[5 + i])
        work[10, 3 + i] = 0.0
    work[9, 3] = -parameters[21] * state[8]
    work[9, 4] = -parameters[21] * state[9]
    if parameters[4] > 0.5:
        driven_derivative(parameters, state, work, derivative)
    else:
        forced_derivative(parameters, state, work, derivative)
    # without wind, it does no work, whatever the load's velocity is
    calm = work[11, 0] == 0.0 and work[11, 1] == 0.0 and work[11, 2] == 0.0
    if not calm:
        crane_load(state, work[12:14, :])
    derivative[10] = 0.0
    derivative[11] = 0.0
    derivative[12] = parameters[21] * (state[8] * state[8] + state[9] * state[9])
    for i in range(3):
        derivative[10] = derivative[10] + work[10, i] * state[5 + i]
        if not calm:
            derivative[11] = derivative[11] + work[11, i] * work[13, i]
        derivative[12] = derivative[12] + work[15, i] * state[5 + i]


def first_stage(work: 'float[:,:]') -> None:
    """Take the last stage of a step, at its end, as the first one of the next step."""
    for i in range(13):
        work[0, i] = work[6, i]
    for i in range(3):
        work[10, 9 + i] = work[10, 3 + i]


def plant_attempt(
    parameters: 'float[:]',
    components: 'float[:,:]',
    time: float,
    elapsed: float,
    state: 'float[:]',
    command: 'float[:]',
    rate: 'float[:]',
    load_force: 'float[:]',
    h: float,
    work: 'float[:,:]',
) -> float:
    """Try a step of length h: the new state goes to work[7, :]; returns the error.

    work[0, :] is the derivative at its start.
    """
    for stage in range(1, 7):
        # the energies have no part in the derivatives
        count = 10
        if stage == 6:
            count = 13
        stage_state(stage, h, count, state, work, work[7, :])
        # a stage out of all bounds is a step that was much too long
        if not all_finite(work[7, :], count):
            return 1e100
        plant_derivative(
            parameters, components, time, elapsed + stage_node(stage) * h, work[7, :], command,
            rate, load_force, work, work[stage, :],
        )
    return step_error(h, 13, state, work[7, :], work)


def plant_advance(
    parameters: 'float[:]',
    components: 'float[:,:]',
    time: float,
    state: 'float[:]',
    command: 'float[:]',
    rate: 'float[:]',
    load_force: 'float[:]',
    duration: float,
    tolerance: float,
    work: 'float[:,:]',
    report: 'float[:]',
) -> int:
    """Advance the state (13), in place, by a duration from a time on.

    components (count, 7): sines of the wind's noise. command (3): forces [N] of bridge, trolley and
    hoist at the start; or velocities [m/s], or where a drive has no lag accelerations [m/s2]. rate
    (9): coefficients of the time elapsed in them, of its square and of its cube. load_force (3): on
    the load, held [N]. tolerance: relative and absolute error of a step. report (10): forces of the
    drives (3), whether they were at a bound (3), force on the rope, power of the wind and of
    friction [W], time advanced.

    Returns `plant_status`, or 3: the steps became too small (for stiff friction, too many), 4: a
    value is not finite. What has a status is approached until within 0.1 us of it; the state is
    the last one without.
    """
    for i in range(10):
        report[i] = 0.0
    if not all_finite(state, 13) or not all_finite(command, 3) or not all_finite(load_force, 3):
        return 4
    plant_derivative(
        parameters, components, time, 0.0, state, command, rate, load_force, work, work[6, :]
    )
    first_stage(work)
    t = 0.0
    # what a step was before is a better guess than an interval that may hold many
    planned = work[8, 7]
    if planned <= 0.0:
        planned = duration
    h = planned
    for _ in range(200000):
        last = h >= duration - t
        if last:
            planned = h
            h = duration - t
        error = plant_attempt(
            parameters, components, time, t, state, command, rate, load_force, h, work
        )
        if error > tolerance:
            h = h * next_step(error, tolerance)
            if h < 1e-12 * duration:
                return 3
            continue
        status = plant_status(parameters, work[7, :], work[10, 6])
        if status != 0:
            if h < 1e-7:
                return status
            h = 0.5 * h
            continue
        t = t + h
        h = h * next_step(error, tolerance)
        accept(state, work, t, report)
        if last:
            # cut short by the interval's end, it tells less than the step planned before
            work[8, 7] = max(h, planned)
            return 0
        first_stage(work)
    return 3


def accept(state: 'float[:]', work: 'float[:,:]', elapsed: float, report: 'float[:]') -> None:
    """Take over the state that was tried, and report what acts in it."""
    for i in range(13):
        state[i] = work[7, i]
    for i in range(3):
        report[i] = work[10, i]
        report[3 + i] = max(report[3 + i], max(work[10, 3 + i], work[10, 9 + i]))
    report[6] = work[10, 6]
    report[7] = work[6, 11]
    report[8] = work[6, 12]
    report[9] = elapsed


def plant_status(parameters: 'float[:]', state: 'float[:]', rope_force: float) -> int:
    """Whether the crane is within the range of its equations.

    Returns 0, or 1: an angle came to +-90 degrees, 2: the rope's length came to zero, 5: the rope
    went slack, 6 + axis: below the least position, 9 + axis: above the greatest.
    """
    if abs(state[3]) >= 1.57 or abs(state[4]) >= 1.57:
        return 1
    if state[2] <= 0.0:
        return 2
    for i in range(3):
        # resting at the very limit is allowed
        if state[i] < parameters[22 + i] - 1e-9:
            return 6 + i
        if state[i] > parameters[25 + i] + 1e-9:
            return 9 + i
    if rope_force > 1e-9 * parameters[2] * parameters[3]:
        return 5
    return 0
