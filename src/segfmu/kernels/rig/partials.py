"""Partial derivatives of the rig between events, for kernels/rig/exchange.py's derivatives.

`partials` (12, 17): rows are `RigPartials`, columns `RigVariables`. `memory` is that of
kernels/rig/rig.py after `rig_rates` for the same time and setpoints; `rig` is the `Work` in it.
`work` (6, 18) has the partial derivatives of the crane's equations, columns `CranePartials`.
"""

from segfmu.kernels.control.records import Correction
from segfmu.kernels.crane._partials import (
    crane_driven_partials,
    crane_load_partials,
    crane_rhs_partials,
)
from segfmu.kernels.crane.bounds import (
    acceleration_bound,
    at_velocity_bound,
    exceeds,
    force_bound,
    limited,
    static_bound,
    velocity_bound,
)
from segfmu.kernels.crane.buffers import buffer_slopes
from segfmu.kernels.crane.friction import deflection_rate, friction_slopes
from segfmu.kernels.crane.records import (
    Action,
    Air,
    Axes,
    Coordinates,
    CranePartials,
    DrivenPartials,
    LoadPartials,
    Plant,
    PlantState,
    State,
    Vector,
    Work,
)
from segfmu.kernels.crane.slack import may_slacken
from segfmu.kernels.crane.wind import drag_slope, wind_rates
from segfmu.kernels.rig.records import Clock, Memory, RigPartials, RigVariables
from segfmu.kernels.rig.setpoints import is_driven


def axis_slopes(plant: 'float[:]', axis: int, state: 'float[:]') -> 'tuple[float, float, float]':
    """Derivatives of an axis' resistance by its position, its velocity and its deflection."""
    velocity = state[State.VELOCITY + axis]
    by_position, damping = buffer_slopes(plant, axis, state[State.POSITION + axis], velocity)
    by_velocity, by_deflection = friction_slopes(
        plant, axis, velocity, state[PlantState.DEFLECTION + axis]
    )
    return by_position, by_velocity + damping, by_deflection


def power_slope(
    plant: 'float[:]', axis: int, state: 'float[:]', action: 'float[:]'
) -> float:
    """Derivative of a drive's force by its velocity [N s/m], where its power bounds it."""
    velocity = state[State.VELOCITY + axis]
    force = action[Action.FORCE + axis]
    bound = force_bound(plant, axis, force, velocity)
    if action[Action.SATURATED + axis] < 0.5 or bound == static_bound(plant, axis, force):
        return 0.0
    return -force / velocity


def forced_partials(
    plant: 'float[:]', state: 'float[:]', rig: 'float[:,:]', work: 'float[:,:]',
    partials: 'float[:,:]',
) -> None:
    """Accelerations and forces under force commands."""
    crane_rhs_partials(state, rig[Work.GENERALISED, :], rig[Work.WIND, :], plant, work)
    saturated = rig[Work.ACTION, :]
    for i in range(Coordinates.SIZE):
        row = partials[RigPartials.ACCELERATION + i, :]
        for j in range(State.SIZE):
            row[j] = work[i, j]
        for j in range(3):
            by_force = work[i, CranePartials.DRIVE + j]
            by_position, slope, by_deflection = axis_slopes(plant, j, state)
            row[State.POSITION + j] = row[State.POSITION + j] - by_position * by_force
            row[State.VELOCITY + j] = row[State.VELOCITY + j] - slope * by_force
            row[RigVariables.DEFLECTION + j] = -by_deflection * by_force
            row[RigVariables.WIND + j] = work[i, CranePartials.WIND + j]
            if saturated[Action.SATURATED + j] < 0.5:
                row[RigVariables.COMMAND + j] = by_force
            by_velocity = by_force * power_slope(plant, j, state, saturated)
            row[State.VELOCITY + j] = row[State.VELOCITY + j] + by_velocity
        add_damping(plant, work[i, :], row)
    for j in range(3):
        if saturated[Action.SATURATED + j] < 0.5:
            partials[RigPartials.FORCE + j, RigVariables.COMMAND + j] = 1.0
        by_velocity = power_slope(plant, j, state, saturated)
        partials[RigPartials.FORCE + j, State.VELOCITY + j] = by_velocity
    rope = partials[RigPartials.ROPE_FORCE, :]
    hoist = RigVariables.COMMAND + Axes.ROPE
    velocity = State.VELOCITY + Axes.ROPE
    rope[hoist] = partials[RigPartials.FORCE + Axes.ROPE, hoist]
    by_power = partials[RigPartials.FORCE + Axes.ROPE, velocity]
    by_position, slope, by_deflection = axis_slopes(plant, Axes.ROPE, state)
    rope[State.POSITION + Axes.ROPE] = -by_position
    rope[velocity] = by_power - slope
    rope[RigVariables.DEFLECTION + Axes.ROPE] = -by_deflection


def add_damping(plant: 'float[:]', by: 'float[:]', row: 'float[:]') -> None:
    """Add the effect of the sway damping to a row of partial derivatives by the sway rates."""
    for j in range(2):
        damped = plant[Plant.SWAY_DAMPING] * by[CranePartials.TORQUE + j]
        row[State.RATE + j] = row[State.RATE + j] - damped


def demand_partials(
    plant: 'float[:]', state: 'float[:]', rig: 'float[:,:]', command: 'float[:]',
    partials: 'float[:,:]',
) -> bool:
    """Accelerations of the drives under velocity commands; false if one is at its force bound."""
    action = rig[Work.ACTION, :]
    for i in range(3):
        lag = plant[Plant.LAG + i]
        largest = force_bound(plant, i, action[Action.FORCE + i], state[State.VELOCITY + i])
        demand = command[i]
        fastest = velocity_bound(plant, i, demand)
        clipped = exceeds(demand, fastest)
        if clipped:
            demand = limited(demand, fastest)
        demand = (demand - state[State.VELOCITY + i]) / lag
        bounded = exceeds(demand, acceleration_bound(plant, i, demand))
        if action[Action.SATURATED + i] > 0.5 and not (bounded or clipped):
            return False
        if largest > 0.0 and abs(action[Action.FORCE + i]) >= largest * (1.0 - 1e-9):
            return False
        if not bounded:
            if not clipped:
                partials[i, RigVariables.COMMAND + i] = 1.0 / lag
            partials[i, State.VELOCITY + i] = -1.0 / lag
    return True


def driven_partials(
    plant: 'float[:]', state: 'float[:]', rig: 'float[:,:]', work: 'float[:,:]',
    partials: 'float[:,:]',
) -> bool:
    """The same under velocity commands; false if a drive is at its largest force."""
    if not demand_partials(plant, state, rig, rig[Work.COMMAND, :], partials):
        return False
    crane_driven_partials(
        state, rig[Work.DEMAND, :], rig[Work.GENERALISED, :], rig[Work.WIND, :], plant, work
    )
    # angles and forces are adjacent in both
    first = RigPartials.ACCELERATION + Coordinates.ANGLE
    for i in range(DrivenPartials.SIZE):
        row = partials[first + i, :]
        for j in range(State.SIZE):
            row[j] = work[i, j]
        for j in range(3):
            # through the accelerations of the drives
            by_drive = work[i, CranePartials.DRIVE + j]
            velocity = State.VELOCITY + j
            command = RigVariables.COMMAND + j
            row[velocity] = row[velocity] + by_drive * partials[j, velocity]
            row[command] = by_drive * partials[j, command]
            row[RigVariables.WIND + j] = work[i, CranePartials.WIND + j]
        add_damping(plant, work[i, :], row)
    for j in range(RigVariables.SIZE):
        hoist = partials[RigPartials.FORCE + Axes.ROPE, j]
        partials[RigPartials.ROPE_FORCE, j] = hoist
    for i in range(3):
        velocity = State.VELOCITY + i
        by_position, slope, by_deflection = axis_slopes(plant, i, state)
        force = partials[RigPartials.FORCE + i, :]
        force[State.POSITION + i] = force[State.POSITION + i] + by_position
        force[velocity] = force[velocity] + slope
        force[RigVariables.DEFLECTION + i] = by_deflection
    return True


def power_partials(
    plant: 'float[:]', state: 'float[:]', rig: 'float[:,:]', work: 'float[:,:]',
    partials: 'float[:,:]',
) -> None:
    """Powers of drives, wind and friction."""
    drive = partials[RigPartials.DRIVE_POWER, :]
    wind = partials[RigPartials.WIND_POWER, :]
    lost = partials[RigPartials.FRICTION_POWER, :]
    crane_load_partials(state, work)
    for j in range(State.SIZE):
        for i in range(3):
            wind[j] = wind[j] + rig[Work.WIND, i] * work[LoadPartials.VELOCITY + i, j]
    for i in range(3):
        rate = State.VELOCITY + i
        velocity = state[rate]
        for j in range(RigVariables.TIME):
            drive[j] = drive[j] + partials[RigPartials.FORCE + i, j] * velocity
        drive[rate] = drive[rate] + rig[Work.ACTION, Action.FORCE + i]
        # the load's velocity is linear in the rates
        by_wind = RigVariables.WIND + i
        for j in range(State.VELOCITY, State.SIZE):
            wind[by_wind] = wind[by_wind] + work[LoadPartials.VELOCITY + i, j] * state[j]
        by_position, slope, by_deflection = axis_slopes(plant, i, state)
        deflection = state[PlantState.DEFLECTION + i]
        lost[State.POSITION + i] = by_position * velocity
        lost[rate] = slope * velocity + rig[Work.FRICTION, i]
        lost[RigVariables.DEFLECTION + i] = by_deflection * velocity
        if deflection_rate(plant, i, velocity, deflection) != 0.0:
            partials[RigPartials.DEFLECTION + i, rate] = 1.0
    for i in range(State.RATE, State.SIZE):
        lost[i] = 2.0 * plant[Plant.SWAY_DAMPING] * state[i]


def drag_partials(
    plant: 'float[:]', air: 'float[:]', work: 'float[:,:]', partials: 'float[:,:]'
) -> None:
    """Add what all rows have by the load's velocity, as the drag of the air depends on it.

    work: rows `LoadPartials` by the state.
    """
    for j in range(State.SIZE):
        for i in range(Vector.SIZE):
            slope = 0.0
            for k in range(Vector.SIZE):
                along = work[LoadPartials.VELOCITY + k, j]
                slope = slope - drag_slope(plant, air, i, k) * along
            for row in range(RigPartials.SIZE):
                added = partials[row, RigVariables.WIND + i] * slope
                partials[row, j] = partials[row, j] + added


def rig_partials(
    components: 'float[:,:]', time: float, memory: 'float[:,:]', work: 'float[:,:]',
    partials: 'float[:,:]',
) -> bool:
    """All partial derivatives at a time [s] since the start.

    False if a velocity drive is at its largest force, or a force drive at its largest velocity:
    there they jump. Also where the rope bears nothing.
    """
    plant = memory[Memory.PLANT, :]
    state = memory[Memory.STATE, :]
    rig = memory[Memory.WORK:Memory.WORK + Work.SIZE, :]
    if may_slacken(plant) and rig[Work.ACTION, Action.ROPE_FORCE] >= 0.0:
        return False
    for i in range(RigPartials.SIZE):
        for j in range(RigVariables.SIZE):
            partials[i, j] = 0.0
    for i in range(LoadPartials.SIZE):
        for j in range(CranePartials.SIZE):
            work[i, j] = 0.0
    driven = is_driven(memory)
    if driven:
        if not driven_partials(plant, state, rig, work, partials):
            return False
    else:
        for i in range(Axes.SIZE):
            if at_velocity_bound(plant, i, state):
                return False
        forced_partials(plant, state, rig, work, partials)
    power_partials(plant, state, rig, work, partials)
    wind_rates(plant, components, memory[Memory.CLOCK, Clock.START] + time, rig[Work.AIR, :])
    if plant[Plant.DRAG_AREA] > 0.0:
        drag_partials(plant, rig[Work.AIR, :], work, partials)
    for i in range(RigPartials.SIZE):
        row = partials[i, :]
        for j in range(3):
            slope = rig[Work.AIR, Air.FORCE_RATE + j]
            added = row[RigVariables.TIME] + row[RigVariables.WIND + j] * slope
            if driven:
                # corrections are integrated into the velocities
                correction = memory[Memory.CORRECTION, Correction.VALUE + j]
                added = added + row[RigVariables.COMMAND + j] * correction
            row[RigVariables.TIME] = added
    return True
