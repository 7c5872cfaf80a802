"""The direction and the sense of time in which a boundary problem is solved.

A motion mirrored, run backwards, or both, is the same one to all limits. The searches try things in
an order, and stop: of the four ways to write a problem they always see the same one, so that all
have the same plan.
"""

from segfmu.kernels.numerics.numbers import NEARLY
from segfmu.kernels.planner.phases import mirror_phases, reverse_phases
from segfmu.kernels.planner.records import Axis, Passing, PlanStatus, Problem
from segfmu.kernels.planner.sides import mirror_axis, reverse_axis, top_acceleration


def beyond_rounding(value: float, scale: float) -> float:
    """A value, 0 where only rounding separates it from that."""
    return 0.0 if abs(value) <= NEARLY * scale else value


def mirror_search(problem: 'float[:]', axis: 'float[:]') -> None:
    """Mirror a boundary problem and its limits."""
    for i in range(Problem.DURATION):
        problem[i] = -problem[i]
    mirror_axis(axis)


def reverse_search(problem: 'float[:]', axis: 'float[:]') -> None:
    """Reverse the time of a boundary problem and its limits, velocities kept."""
    v, a = problem[Problem.V], problem[Problem.A]
    problem[Problem.V] = problem[Problem.W]
    problem[Problem.A] = -problem[Problem.B]
    problem[Problem.W] = v
    problem[Problem.B] = -a
    reverse_axis(axis)


def orient(problem: 'float[:]', axis: 'float[:]') -> 'tuple[int, int]':
    """Mirror and reverse a problem as it is solved; whether that is mirrored, and reversed.

    It goes forwards, and its velocity does not rise; where that does not tell, the accelerations
    decide, and then the limits in both directions.
    """
    speed = abs(problem[Problem.V]) + abs(problem[Problem.W])
    push = abs(problem[Problem.A]) + abs(problem[Problem.B])
    # neither sign is changed by a reversal
    way = beyond_rounding(problem[Problem.DISTANCE], speed * speed / top_acceleration(axis))
    if way == 0.0:
        way = beyond_rounding(problem[Problem.V] + problem[Problem.W], speed)
    if way == 0.0:
        way = beyond_rounding(problem[Problem.A] - problem[Problem.B], push)
    if way == 0.0:
        way = axis[Axis.VELOCITY] - axis[Axis.LOWER]
    mirrored = 0
    if way < 0.0:
        mirrored = 1
        mirror_search(problem, axis)
    way = beyond_rounding(problem[Problem.V] - problem[Problem.W], speed)
    if way == 0.0:
        way = beyond_rounding(problem[Problem.A] + problem[Problem.B], push)
    if way == 0.0:
        way = axis[Axis.ACCELERATION] - axis[Axis.LOWER + 1]
    turned = 0
    if way < 0.0:
        turned = 1
        reverse_search(problem, axis)
    return mirrored, turned


def turn_back(mirrored: int, turned: int, problem: 'float[:]', axis: 'float[:]') -> None:
    """Write a problem and its limits as they were asked for; mirrored, turned: as of `orient`."""
    if turned > 0:
        reverse_search(problem, axis)
    if mirrored > 0:
        mirror_search(problem, axis)


def turn_phases(mirrored: int, turned: int, count: int, phases: 'float[:,:]') -> None:
    """Write the first phases of a motion, `count`, as the problem was asked for."""
    if turned > 0:
        reverse_phases(phases, 0, count)
    if mirrored > 0:
        mirror_phases(phases, count)


def as_asked(
    mirrored: int, turned: int, count: int, phases: 'float[:,:]', problem: 'float[:]',
    axis: 'float[:]', passing: 'float[:]',
) -> int:
    """Write a problem, its limits and `count` phases as they were asked for; count or status.

    mirrored, turned: what `orient` returned.
    """
    if turned > 0:
        passing[Passing.REVERSED] = 1.0 - passing[Passing.REVERSED]
    turn_back(mirrored, turned, problem, axis)
    turn_phases(mirrored, turned, max(count, 0), phases)
    if turned > 0 and count == PlanStatus.START_BRAKING:
        return PlanStatus.END_BRAKING
    return PlanStatus.START_BRAKING if turned > 0 and count == PlanStatus.END_BRAKING else count
