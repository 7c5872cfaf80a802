"""The crane with its drives, sensors and sampled controller, advanced by a communication step.

Times within are seconds since the start. The integration stops at the ticks of the controller and
of the sensors, where the payload changes and at the ends of a gust. Setpoints are linear in time
between those of the last step's end and those of this one's, or cubic where memory has what is not
linear in them. A correction is added to the force setpoints, or with velocity drives its integral
is added to the velocity setpoints; it acts from tick to tick.

`loop` (5): 0 who corrects, 0: the caller, 1: state feedback, 2: tracking controller; 1 period of
the controller [s], above 0; 2 whether corrections act, may be changed between steps; 3 tolerance of
the integration; 4 time constant [s] with which a change of 2 fades in, 0: it jumps. `changes`
(count, 2): time [s] and mass of the load [kg] from then on, in any order. `sensors` is told in
kernels/rig/sensing.py, parameters and components in kernels/crane/plant.py.

`setpoints` (19): forces (3) [N] and velocities (3) of bridge, trolley and hoist, the reference
state (10), and a force on the load (3), held over the step, beside the rig's wind.

`memory` (`rig_rows`, 40), C order, is all that a rig remembers, so a copy of it is its state:

    0  state (13), see kernels/crane/plant.py
    1  parameters of the plant (37), with the present mass of the load
    2  0 time of the start, 1 time reached since, 2 time done within the present step, 3 ticks of
       the controller, 4 time of the next change of payload or wind, 5 energy at the start, 6 energy
       that payload changes have brought, 7 time of the tick that is due or of a failure, from the
       same zero as the time of the start
    3  setpoints at the end of the last step (19)
    4  0:10 report of crane/plant.py, 10:13 whether the drives were at a bound in the last step
    5  signals of the sensors (5)                    6  reference at the tick (10)
    7  what the correction is added to (3): force setpoints, or slopes of the velocity setpoints
    8  correction (3), what remains of a switching step (3), whether corrections acted at the tick
       before: 0 there was none, 1 no, 2 yes, 3 with other gains; the correction of that tick (3)
    9  velocities that corrections have added (3)
    10 0:3 commands, 10:26 what setpoints 0:16 have of the square of the share of the step done
    11 0:9 rates of the commands, see kernels/crane/plant.py, 10:26 what they have of its cube
    12 force on the load (3)                         13 kinetic and potential energy
    14:30 work space of kernels/crane/plant.py             30: memory of kernels/rig/sensing.py

A tracking controller keeps what it remembers in its own array, see kernels/control/tracking.py.

Status: 0: done; -1: a tick of the caller's controller is due: its time, signals, reference and
what the correction is added to are in the rows 2, 5, 6 and 7, the correction goes to row 8, and
then `rig_step` is called again with the same arguments; above 0: as in crane/plant.py, the state is
the last one without, and the step may be tried again.
"""

from segfmu.kernels.crane._crane import crane_energy
from segfmu.kernels.numerics.integrate import all_finite
from segfmu.kernels.rig.events import (
    change_payload,
    mechanical_energy,
    meet_events,
    next_edge,
    next_event,
)
from segfmu.kernels.rig.loop import advance_plant, controller_due, correct_setpoints, prepare_tick
from segfmu.kernels.rig.sensing import sense_signals, sensing_rows, start_sensing


def rig_rows(sample_time: float, dead_time: float) -> int:
    """Rows of memory for sensors with these times [s]."""
    return 30 + sensing_rows(sample_time, dead_time)


def rig_start(
    loop: 'float[:]',
    sensors: 'float[:]',
    changes: 'float[:,:]',
    parameters: 'float[:]',
    state: 'float[:]',
    setpoints: 'float[:]',
    start: float,
    memory: 'float[:,:]',
) -> None:
    """Put a state (10) and the setpoints at the start into the memory and forget the past."""
    for row in range(memory.shape[0]):
        for i in range(memory.shape[1]):
            memory[row, i] = 0.0
    for i in range(10):
        memory[0, i] = state[i]
    for i in range(37):
        memory[1, i] = parameters[i]
    for i in range(19):
        memory[3, i] = setpoints[i]
    for i in range(3):
        memory[4, i] = setpoints[i]
    memory[4, 6] = setpoints[2]
    memory[2, 0] = start
    memory[2, 4] = next_edge(changes, 0.0, memory)
    change_payload(loop, changes, start, memory)
    memory[2, 5] = mechanical_energy(memory)
    start_sensing(sensors, memory[0, :], memory[30:memory.shape[0], :])
    sense_signals(sensors, 0.0, memory[0, :], memory[30:memory.shape[0], :], memory[5, :])


def rig_step(
    loop: 'float[:]',
    sensors: 'float[:]',
    components: 'float[:,:]',
    changes: 'float[:,:]',
    tracking: 'float[:]',
    lengths: 'float[:]',
    table: 'float[:,:,:]',
    gain_lengths: 'float[:]',
    gains: 'float[:,:,:]',
    tracker: 'float[:,:]',
    setpoints: 'float[:]',
    duration: float,
    memory: 'float[:,:]',
) -> int:
    """Advance by a duration [s] to the given setpoints; returns the status.

    gain_lengths and gains are those of the feedback; tracking, lengths, table and tracker are what
    kernels/control/tracking.py calls parameters, lengths, table and memory, and unused without it.
    """
    # before anything that remembers, such as an observer, has seen it
    if not abs(duration) < 1e100 or not all_finite(setpoints, 19):
        memory[2, 7] = memory[2, 0] + memory[2, 1]
        return 4
    status = 0
    if memory[2, 2] == 0.0:
        for i in range(3):
            memory[4, 10 + i] = 0.0
    while status == 0 and memory[2, 2] < duration:
        if controller_due(loop, memory):
            prepare_tick(sensors, setpoints, duration, memory)
            if loop[0] < 0.5:
                return -1
            correct_setpoints(
                loop, tracking, lengths, table, gain_lengths, gains, tracker, memory
            )
        until = next_event(loop, sensors, duration, memory)
        status = advance_plant(loop, components, setpoints, duration, until, memory)
        if status == 0:
            memory[2, 2] = until
            meet_events(loop, sensors, changes, memory)
    memory[2, 2] = 0.0
    if status == 0:
        memory[2, 1] = memory[2, 1] + duration
        for i in range(19):
            memory[3, i] = setpoints[i]
        for i in range(10, 26):
            memory[10, i] = 0.0
            memory[11, i] = 0.0
    sense_signals(
        sensors, memory[2, 1], memory[0, :], memory[30:memory.shape[0], :], memory[5, :]
    )
    return status


def rig_balance(memory: 'float[:,:]', balance: 'float[:]') -> None:
    """Energies [J] (7): kinetic, potential, their sum at the start, work of the drives and of the
    wind, energy that payload changes brought, energy dissipated."""
    crane_energy(
        memory[0, :], memory[1, 0], memory[1, 1], memory[1, 2], memory[1, 3], memory[13, :]
    )
    balance[0] = memory[13, 0]
    balance[1] = memory[13, 1]
    balance[2] = memory[2, 5]
    balance[3] = memory[0, 10]
    balance[4] = memory[0, 11]
    balance[5] = memory[2, 6]
    balance[6] = memory[0, 12]


def rig_imbalance(balance: 'float[:]') -> float:
    """What the balance (7) misses by integration and rounding [J]."""
    gained = balance[3] + balance[4] + balance[5] - balance[6]
    return balance[0] + balance[1] - balance[2] - gained
