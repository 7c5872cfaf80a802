"""Feedback with a hook at one rope length: sampled model, LQR and steady Kalman gain of each axis.

States of an axis are those of `HookAxis`. Small angles decouple bridge, trolley and hoist: with
the masses m of the load, h of the hook and M of both, rope l, sling s and the carriage's
acceleration a,

    l phi'' = -M g phi / h + m g psi / h - a        s psi'' = M g (phi - psi) / h

All is weighted in units of L = l + s and sqrt(g / L). `plant` is a `Plant`, `weights` a
`HookWeighing`, `work` a `HookDesign` with 16 columns.
"""

from math import sqrt

from segfmu.kernels.control.kalman import kalman_turn
from segfmu.kernels.control.records import Doubling
from segfmu.kernels.crane.bounds import carriage_mass, hanging_mass
from segfmu.kernels.crane.records import Axes, DriveMode, Plant
from segfmu.kernels.hook.records import (
    HookAxis,
    HookAxisTable,
    HookDesign,
    HookTable,
    HookWeighing,
)
from segfmu.kernels.numerics.matrices import (
    halvings_below,
    matrix_copy,
    matrix_exponential,
    matrix_product,
    matrix_set,
    matrix_transpose,
)


def hook_unit(axis: int, plant: 'float[:]') -> float:
    """Correction over the acceleration that it gives without a load: a mass [kg], or 1."""
    if int(plant[Plant.MODE]) == DriveMode.VELOCITY:
        return 1.0
    if axis == Axes.ROPE:
        return hanging_mass(plant)
    return carriage_mass(plant, axis)


def hook_lag(axis: int, plant: 'float[:]') -> float:
    """Lag [s] of a velocity drive, else 0."""
    if int(plant[Plant.MODE]) == DriveMode.VELOCITY:
        return plant[Plant.LAG + axis]
    return 0.0


def hook_model(axis: int, plant: 'float[:]', length: float, model: 'float[:,:]') -> None:
    """System matrix (9, 9) of eight states and the correction at a rope length [m]."""
    gravity = plant[Plant.GRAVITY]
    hook = plant[Plant.TACKLE_MASS]
    total = hanging_mass(plant)
    lag = hook_lag(axis, plant)
    matrix_set(HookAxis.SIZE, 0.0, model)
    model[HookAxis.POSITION, HookAxis.VELOCITY] = 1.0
    change = model[HookAxis.VELOCITY, :]
    change[HookAxis.DRIFT] = 1.0
    if lag > 0.0:
        change[HookAxis.VELOCITY] = -1.0 / lag
        change[HookAxis.COMMAND] = 1.0 / lag
        model[HookAxis.COMMAND, HookAxis.CORRECTION] = 1.0
    else:
        change[HookAxis.CORRECTION] = 1.0 / hook_unit(axis, plant)
    if axis == Axes.ROPE:
        return
    if int(plant[Plant.MODE]) == DriveMode.FORCE:
        change[HookAxis.ANGLE] = total * gravity / carriage_mass(plant, axis)
    model[HookAxis.ANGLE, HookAxis.RATE] = 1.0
    model[HookAxis.SLING, HookAxis.SLING_RATE] = 1.0
    for j in range(HookAxis.SIZE):
        model[HookAxis.RATE, j] = -change[j] / length
    restoring = total * gravity / hook
    pulled = restoring - gravity
    rate = model[HookAxis.RATE, :]
    rate[HookAxis.ANGLE] = rate[HookAxis.ANGLE] - restoring / length
    rate[HookAxis.SLING] = pulled / length
    model[HookAxis.SLING_RATE, HookAxis.ANGLE] = restoring / plant[Plant.SLING]
    model[HookAxis.SLING_RATE, HookAxis.SLING] = -restoring / plant[Plant.SLING]


def hook_moved(sample_time: float, work: 'float[:,:]') -> None:
    """States and input after a sample [s]: a Taylor series over a part of it, then doubled."""
    model = work[HookDesign.MODEL:HookDesign.MOVED, :]
    moved = work[HookDesign.MOVED:HookDesign.TERM, :]
    term = work[HookDesign.TERM:HookDesign.RESULT, :]
    result = work[HookDesign.RESULT:HookDesign.SIZE, :]
    doublings = halvings_below(HookAxis.SIZE, sample_time, model)
    part = sample_time / 2**doublings
    matrix_exponential(HookAxis.SIZE, part, model, moved, term, result)
    for _ in range(doublings):
        matrix_product(HookAxis.SIZE, moved, moved, term)
        matrix_copy(HookAxis.SIZE, term, moved)


def hook_steady(work: 'float[:,:]') -> None:
    """Solve the Riccati equation whose matrices are in work; X starts as the costs."""
    spread = work[HookDesign.SPREAD:HookDesign.MODEL, :]
    turns = 0
    while kalman_turn(HookAxis.CORRECTION, spread, work[0:Doubling.SIZE, :]) > 1e-15 and turns < 60:
        turns = turns + 1


def hook_gains(
    axis: int, plant: 'float[:]', length: float, weights: 'float[:]', work: 'float[:,:]',
    gains: 'float[:]',
) -> None:
    """LQR of an axis; the unknown acceleration is not controlled but rejected."""
    moved = work[HookDesign.MOVED:HookDesign.TERM, :]
    spread = work[HookDesign.SPREAD:HookDesign.MODEL, :]
    kept = work[Doubling.TRANSPOSED:Doubling.INFORMATION, :]
    information = work[Doubling.INFORMATION:Doubling.FACTOR, :]
    whole = length + plant[Plant.SLING]
    per_rate = whole / plant[Plant.GRAVITY]
    n = HookAxis.CORRECTION
    unit = hook_unit(axis, plant)
    # of the weight, see crane/feedback.py
    largest = 3.0 * unit * plant[Plant.GRAVITY]
    effort = weights[HookWeighing.EFFORT] / (largest * largest)
    matrix_set(n, 0.0, spread)
    place = weights[HookWeighing.POSITION]
    if axis == Axes.ROPE:
        place = weights[HookWeighing.ROPE]
    else:
        spread[HookAxis.ANGLE, HookAxis.ANGLE] = weights[HookWeighing.ANGLE]
        spread[HookAxis.SLING, HookAxis.SLING] = weights[HookWeighing.ANGLE]
        spread[HookAxis.RATE, HookAxis.RATE] = weights[HookWeighing.RATE] * per_rate
        spread[HookAxis.SLING_RATE, HookAxis.SLING_RATE] = weights[HookWeighing.RATE] * per_rate
    spread[HookAxis.POSITION, HookAxis.POSITION] = place / (whole * whole)
    speed = weights[HookWeighing.VELOCITY] * per_rate / (whole * whole)
    spread[HookAxis.VELOCITY, HookAxis.VELOCITY] = speed
    matrix_copy(n, moved, kept)
    for i in range(n):
        kept[i, HookAxis.DRIFT] = 0.0
        kept[HookAxis.DRIFT, i] = 0.0
        for j in range(n):
            given = moved[i, HookAxis.CORRECTION] * moved[j, HookAxis.CORRECTION]
            information[i, j] = given / effort
    hook_steady(work)
    total = effort
    for j in range(n):
        gains[j] = 0.0
        for i in range(n):
            weight = moved[i, HookAxis.CORRECTION] * spread[i, j]
            gains[j] = gains[j] + weight
        total = total + gains[j] * moved[j, HookAxis.CORRECTION]
    # the row B^T X, then its product with the transition
    row = work[HookDesign.TERM, :]
    for j in range(n):
        row[j] = gains[j] / total
    for j in range(n):
        gains[j] = 0.0
        for i in range(n):
            gains[j] = gains[j] + row[i] * moved[i, j]
    gains[HookAxis.DRIFT] = 0.0
    gains[HookAxis.CORRECTION] = 0.0
    if hook_lag(axis, plant) == 0.0:
        gains[HookAxis.DRIFT] = unit


def hook_watch(
    axis: int, plant: 'float[:]', sample_time: float, length: float, weights: 'float[:]',
    work: 'float[:,:]', table: 'float[:,:]',
) -> None:
    """Steady Kalman gains of an axis, rows of a `HookAxisTable`; signals have white errors."""
    moved = work[HookDesign.MOVED:HookDesign.TERM, :]
    spread = work[HookDesign.SPREAD:HookDesign.MODEL, :]
    information = work[Doubling.INFORMATION:Doubling.FACTOR, :]
    gravity = plant[Plant.GRAVITY]
    whole = length + plant[Plant.SLING]
    time = sqrt(whole / gravity)
    n = HookAxis.CORRECTION
    matrix_set(n, 0.0, spread)
    push = weights[HookWeighing.PUSH] * gravity
    spread[HookAxis.VELOCITY, HookAxis.VELOCITY] = push * push
    if axis != Axes.ROPE:
        swing = weights[HookWeighing.SWING] * gravity / plant[Plant.SLING]
        spread[HookAxis.VELOCITY, HookAxis.RATE] = -push * push / length
        spread[HookAxis.RATE, HookAxis.VELOCITY] = -push * push / length
        spread[HookAxis.RATE, HookAxis.RATE] = push * push / (length * length)
        spread[HookAxis.SLING_RATE, HookAxis.SLING_RATE] = swing * swing
    walk = weights[HookWeighing.DRIFT] * gravity / time
    spread[HookAxis.DRIFT, HookAxis.DRIFT] = walk * walk
    for i in range(n):
        for j in range(n):
            spread[i, j] = spread[i, j] * sample_time * time
    angle = weights[HookWeighing.NOISE] * weights[HookWeighing.NOISE] * time / sample_time
    place = angle * whole * whole
    matrix_transpose(n, moved, work[Doubling.TRANSPOSED:Doubling.INFORMATION, :])
    matrix_set(n, 0.0, information)
    information[HookAxis.POSITION, HookAxis.POSITION] = 1.0 / place
    if axis != Axes.ROPE:
        information[HookAxis.ANGLE, HookAxis.ANGLE] = 1.0 / angle
    hook_steady(work)
    a = spread[HookAxis.POSITION, HookAxis.POSITION] + place
    b = spread[HookAxis.POSITION, HookAxis.ANGLE]
    d = spread[HookAxis.ANGLE, HookAxis.ANGLE] + angle
    determinant = a * d - b * b
    for i in range(n):
        first = spread[i, HookAxis.POSITION]
        second = spread[i, HookAxis.ANGLE]
        table[HookAxisTable.POSITION_GAIN, i] = (d * first - b * second) / determinant
        table[HookAxisTable.ANGLE_GAIN, i] = (a * second - b * first) / determinant
    table[HookAxisTable.POSITION_GAIN, HookAxis.CORRECTION] = 0.0
    table[HookAxisTable.ANGLE_GAIN, HookAxis.CORRECTION] = 0.0


def hook_design(
    plant: 'float[:]', sample_time: float, length: float, weights: 'float[:]',
    work: 'float[:,:]', table: 'float[:,:]',
) -> None:
    """Feedback at a rope length [m] and a period [s], a `HookTable`."""
    for j in range(HookAxis.SIZE):
        table[HookTable.LENGTH, j] = 0.0
    table[HookTable.LENGTH, 0] = length
    for axis in range(Axes.SIZE):
        first = HookTable.AXES + axis * HookAxisTable.SIZE
        rows = table[first:first + HookAxisTable.SIZE, :]
        hook_model(axis, plant, length, work[HookDesign.MODEL:HookDesign.MOVED, :])
        hook_moved(sample_time, work)
        for i in range(HookAxis.CORRECTION):
            for j in range(HookAxis.SIZE):
                rows[HookAxisTable.TRANSITION + i, j] = work[HookDesign.MOVED + i, j]
        hook_gains(axis, plant, length, weights, work, rows[HookAxisTable.GAINS, :])
        hook_watch(axis, plant, sample_time, length, weights, work, rows)
