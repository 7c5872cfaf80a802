"""The crane with its drives, sensors and sampled controller, advanced by a communication step.

Times inside are seconds since the start. The integration stops at the ticks of the controller and
of the sensors, at payload changes and at the ends of a gust. Setpoints are linear in time from
those at the end of the last step to those at the end of this one; with SQUARE and CUBE of the
memory they are cubic. A correction is added to the force setpoints; with velocity drives its
integral is added to the velocity setpoints. It is held from tick to tick.
Drives with a dead time get their commands late, see rig/delay.py.

Arrays, in C order; their records are in rig/records.py:

settings             `Settings` rows, as many columns
components (., 8)    wind's noise, a `Sinusoid` a row
changes (., 2)       payload, a `PayloadChange` a row, in any order
table (., 19, 10)    the observer's, see control/observer.py; unused without a tracking controller
gains (., 4, 10)     of the feedback, see control/feedback.py
tracker (25, 10)     memory of a tracking controller, a `Tracker`
setpoints (19)       `Setpoints`
memory               `Memory`, of `rig_rows` rows; a copy of it is the state of the rig
"""

from segfmu.kernels.crane.friction import first_deflection
from segfmu.kernels.crane.records import Axes, Plant, PlantState, PlantStatus, Report, State
from segfmu.kernels.numerics.integrate import all_finite
from segfmu.kernels.numerics.times import begin_time
from segfmu.kernels.rig.acting import act_first
from segfmu.kernels.rig.delay import (
    delay_rows,
    is_late,
    longest_delay,
    next_command,
    send_commands,
    start_delay,
)
from segfmu.kernels.rig.events import (
    change_payload,
    handle_events,
    mechanical_energy,
    next_change,
    next_event,
    update_signals,
)
from segfmu.kernels.rig.loop import advance_plant, controller_due, correct_setpoints, prepare_tick
from segfmu.kernels.rig.planned import start_planned
from segfmu.kernels.rig.records import (
    Balance,
    Clock,
    Corrector,
    EnergyMemory,
    Loop,
    Memory,
    RigStatus,
    Setpoints,
    Settings,
)
from segfmu.kernels.rig.sensing import sensing_end, start_sensing


def rig_rows(settings: 'float[:,:]') -> int:
    """Rows of memory for the settings: samples and commands may be on their way."""
    longest = longest_delay(settings[Settings.PLANT, :])
    late = delay_rows(longest, settings[Settings.LOOP, Loop.PERIOD])
    return sensing_end(settings) + late


def rig_start(
    settings: 'float[:,:]',
    components: 'float[:,:]',
    changes: 'float[:,:]',
    state: 'float[:]',
    setpoints: 'float[:]',
    start: float,
    memory: 'float[:,:]',
) -> None:
    """Reset the memory to a state and the setpoints at the start [s].

    state: a `PlantState`, of which only the crane and the sling count.
    """
    for row in range(memory.shape[0]):
        for i in range(memory.shape[1]):
            memory[row, i] = 0.0
    for i in range(State.SIZE):
        memory[Memory.STATE, i] = state[i]
    for i in range(PlantState.SLING_ANGLE, PlantState.SLACK):
        memory[Memory.STATE, i] = state[i]
    for i in range(Plant.SIZE):
        memory[Memory.PLANT, i] = settings[Settings.PLANT, i]
    memory[Memory.PLANT, Plant.GUST_START] = begin_time(
        settings[Settings.PLANT, Plant.GUST_START], start
    )
    for i in range(Axes.SIZE):
        memory[Memory.STATE, PlantState.DEFLECTION + i] = first_deflection(
            memory[Memory.PLANT, :], i, state[State.VELOCITY + i]
        )
    for i in range(Setpoints.SIZE):
        memory[Memory.LAST, i] = setpoints[i]
    start_planned(setpoints, memory)
    memory[Memory.CLOCK, Clock.START] = start
    memory[Memory.CLOCK, Clock.NEXT_CHANGE] = next_change(changes, 0.0, memory)
    change_payload(settings, changes, start, memory)
    memory[Memory.ENERGY, EnergyMemory.INITIAL] = mechanical_energy(memory)
    start_sensing(
        settings[Settings.SENSORS, :], memory[Memory.STATE, :],
        memory[Memory.SENSING:sensing_end(settings), :],
    )
    update_signals(settings, 0.0, memory)
    if is_late(memory):
        start_delay(setpoints, memory[sensing_end(settings):memory.shape[0], :], memory)
    act_first(components, setpoints, memory)


def rig_step(
    settings: 'float[:,:]',
    components: 'float[:,:]',
    changes: 'float[:,:]',
    table: 'float[:,:,:]',
    gains: 'float[:,:,:]',
    tracker: 'float[:,:]',
    setpoints: 'float[:]',
    duration: float,
    memory: 'float[:,:]',
) -> int:
    """Advance by a duration [s] to the given setpoints; returns the status.

    The status is a `PlantStatus`: after a failure the state is the last valid one, and the step may
    be tried again. Or it is `RigStatus.TICK`, if the caller has the controller: the first rows of
    memory are a `Tick` without correction; the caller writes the correction there, calls
    `switch_correction`, and then `rig_step` again with the same arguments.
    """
    clock = memory[Memory.CLOCK, :]
    # checked before it changes any memory, such as the observer's
    if not abs(duration) < 1e100 or not all_finite(setpoints, Setpoints.SIZE):
        clock[Clock.EVENT] = clock[Clock.START] + clock[Clock.REACHED]
        return PlantStatus.NOT_FINITE
    status = PlantStatus.DONE
    if clock[Clock.DONE] == 0.0:
        for i in range(3):
            memory[Memory.REPORT, Report.STEP_SATURATED + i] = 0.0
    while status == PlantStatus.DONE and clock[Clock.DONE] < duration:
        if controller_due(settings, memory):
            prepare_tick(settings, setpoints, duration, memory)
            if int(settings[Settings.LOOP, Loop.CORRECTOR]) == Corrector.CALLER:
                return RigStatus.TICK
            correct_setpoints(settings, table, gains, tracker, memory)
        until = next_event(settings, duration, memory)
        if is_late(memory):
            delayed = memory[sensing_end(settings):memory.shape[0], :]
            send_commands(setpoints, duration, memory, delayed)
            until = next_command(settings, until, memory, delayed)
        status = advance_plant(settings, components, setpoints, duration, until, memory)
        if status == PlantStatus.DONE:
            clock[Clock.DONE] = until
            handle_events(settings, changes, memory)
    clock[Clock.DONE] = 0.0
    if status == PlantStatus.DONE:
        clock[Clock.REACHED] = clock[Clock.REACHED] + duration
        for i in range(Setpoints.SIZE):
            memory[Memory.LAST, i] = setpoints[i]
            memory[Memory.SQUARE, i] = 0.0
            memory[Memory.CUBE, i] = 0.0
    update_signals(settings, clock[Clock.REACHED], memory)
    return status


def rig_balance(memory: 'float[:,:]', balance: 'float[:]') -> None:
    """Energies [J], a `Balance` (7)."""
    state = memory[Memory.STATE, :]
    energy = memory[Memory.ENERGY, :]
    mechanical_energy(memory)
    balance[Balance.KINETIC] = energy[EnergyMemory.KINETIC]
    balance[Balance.POTENTIAL] = energy[EnergyMemory.POTENTIAL]
    balance[Balance.INITIAL] = energy[EnergyMemory.INITIAL]
    balance[Balance.DRIVES] = state[PlantState.DRIVE_WORK]
    balance[Balance.WIND] = state[PlantState.WIND_WORK]
    balance[Balance.PAYLOAD] = energy[EnergyMemory.PAYLOAD]
    balance[Balance.DISSIPATED] = state[PlantState.DISSIPATED]


def rig_imbalance(balance: 'float[:]') -> float:
    """Error of the balance by integration and rounding [J]."""
    gained = balance[Balance.DRIVES] + balance[Balance.WIND] + balance[Balance.PAYLOAD]
    gained = gained - balance[Balance.DISSIPATED]
    kept = balance[Balance.KINETIC] + balance[Balance.POTENTIAL] - balance[Balance.INITIAL]
    return kept - gained
