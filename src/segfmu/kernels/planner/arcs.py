"""Profiles of two levels next to a single ramp (loop.py): a search along all their arcs."""

from segfmu.kernels.numerics.numbers import (
    FEW,
    FINE,
    GAINED,
    HALVINGS,
    ROUNDED,
    SAME,
    SAMPLES,
    SMALL,
)
from segfmu.kernels.numerics.roots import next_bracket, next_point
from segfmu.kernels.planner.levels import member_distance
from segfmu.kernels.planner.loop import loop_radius, set_loop, slow_middle
from segfmu.kernels.planner.merged import write_member
from segfmu.kernels.planner.phases import copy_phases, valid_duration
from segfmu.kernels.planner.records import Axis, Effort, Family, LoopArc, PlanWork, Problem
from segfmu.kernels.planner.sides import fastest_velocity, top_acceleration
from segfmu.kernels.planner.timed_cruise import is_enclosed, keep_nearest


def loop_excess(
    arc: int, place: float, accuracy: float, missing: float, largest: float, family: 'float[:]',
    axis: 'float[:]',
) -> 'tuple[float, float]':
    """Duration of the member at a place (-1: none), and what it goes too far [m] or lasts too long.

    On an arc with a slow ramp, places are 0 .. 4 from the largest downward to upward change.
    accuracy: of its velocity, see `loop_radius`.
    """
    family[Family.STRETCH] = 1.0
    family[Family.FLATNESS] = 0.0
    if arc == LoopArc.LOOP or arc == LoopArc.FOLD:
        if loop_radius(arc, place, accuracy, missing, largest, family, axis) < 0.0:
            return -1.0, 0.0
    elif arc == LoopArc.SINGLE:
        family[Family.FLATNESS] = 0.25 * place
        if not slow_middle(0.0, 0.0, family, axis):
            return -1.0, 0.0
    else:
        if arc == LoopArc.FLAT_FIRST or arc == LoopArc.FLAT_LAST:
            family[Family.FLATNESS] = 1.0
        part = 0.5 * place - 1.0
        side = 2.0 if part < 0.0 else 0.0
        if arc == LoopArc.LAST or arc == LoopArc.FLAT_LAST:
            side = side + 1.0
        if not slow_middle(side, largest * part * part, family, axis):
            return -1.0, 0.0
    duration, y = member_distance(family, axis)
    if family[Family.BY_TIME] != 0.0:
        error = duration - family[Family.TARGET]
        if abs(error) <= ROUNDED * duration:
            error = 0.0
        return duration, error
    error = y - family[Family.TARGET]
    speed = abs(family[Family.V]) + abs(family[Family.W]) + top_acceleration(axis) * duration
    # states on another plan bring its rounding, and an arc can end at the distance
    if abs(error) <= SAME * (abs(y) + min(fastest_velocity(axis), speed) * duration):
        error = 0.0
    return duration, error


def loop_root(
    arc: int, lower: float, upper: float, e_lower: float, e_upper: float, missing: float,
    largest: float, family: 'float[:]', axis: 'float[:]',
) -> float:
    """Duration of the member between two places that covers the distance; sets it. -1: none."""
    if e_lower == 0.0 or e_upper == 0.0:
        place = lower if e_lower == 0.0 else upper
        duration, error = loop_excess(arc, place, 0.0, missing, largest, family, axis)
        return duration
    newest, other, before = upper, lower, lower
    e_newest, e_other, e_before = e_upper, e_lower, e_lower
    duration = -1.0
    for i in range(HALVINGS):
        place = next_point(newest, other, before, e_newest, e_other, e_before)
        if place == newest or place == other:
            break
        duration, error = loop_excess(arc, place, 0.0, missing, largest, family, axis)
        if duration < 0.0:
            return -1.0
        newest, other, before, e_newest, e_other, e_before = next_bracket(
            error * e_newest < 0.0, place, error, newest, other, e_newest, e_other
        )
        if error == 0.0:
            break
    return duration


def scanned_excess(
    arc: int, place: float, missing: float, largest: float, family: 'float[:]', axis: 'float[:]'
) -> 'tuple[float, float]':
    """`loop_excess`, accurate where it is small beside what the velocities cover.

    Elsewhere its sign is enough.
    """
    duration, error = loop_excess(arc, place, FINE, missing, largest, family, axis)
    if duration < 0.0 or (arc != LoopArc.LOOP and arc != LoopArc.FOLD):
        return duration, error
    small = SMALL * duration
    if family[Family.BY_TIME] == 0.0:
        speed = abs(family[Family.V]) + abs(family[Family.W]) + missing
        small = small * speed
    if abs(error) <= small:
        return loop_excess(arc, place, 0.0, missing, largest, family, axis)
    return duration, error


def arc_root(
    arc: int, sample: int, missing: float, largest: float, family: 'float[:]', axis: 'float[:]'
) -> 'tuple[int, float]':
    """Set the next member of an arc that is searched for, after a sample of its places.

    Returns the sample after it, or -1 if there is none, and its duration [s]. Between the last
    place with a member and one without, members are searched by halving.
    """
    place = 4.0 * sample / SAMPLES
    duration, e_place = scanned_excess(arc, place, missing, largest, family, axis)
    known = duration >= 0.0
    for i in range(sample + 1, SAMPLES + 1):
        before = place
        e_before = e_place
        was_known = known
        place = 4.0 * i / SAMPLES
        duration, e_place = scanned_excess(arc, place, missing, largest, family, axis)
        known = duration >= 0.0
        if not known and not was_known:
            continue
        # the arc from `other`, to `inside`, perhaps on its way to a place without a member
        other = before
        e_other = e_before
        inside = place
        e_inside = e_place
        if known != was_known:
            outside = before
            other = place
            e_other = e_place
            if was_known:
                outside = place
                other = before
                e_other = e_before
            inside = other
            e_inside = e_other
            # halvings cost as much as samples, and of what is in between there is hardly ever the
            # distance
            for j in range(FEW):
                middle = 0.5 * (inside + outside)
                duration, error = scanned_excess(arc, middle, missing, largest, family, axis)
                if duration < 0.0:
                    outside = middle
                else:
                    inside = middle
                    e_inside = error
                    if error * e_other <= 0.0:
                        break
        if other != inside and e_other * e_inside <= 0.0:
            duration = loop_root(
                arc, other, inside, e_other, e_inside, missing, largest, family, axis
            )
            if duration >= 0.0:
                return i, duration
    return -1, -1.0


def loop_form(
    last: int, count: int, longest: float, phases: 'float[:,:]', problem: 'float[:]',
    axis: 'float[:]', work: 'float[:,:]',
) -> int:
    """Replace a profile by the shortest one of all arcs up to the last one, if that is shorter.

    last: of LoopArc; count: phases of the profile, 0 if there is none; longest: its duration, or
    the longest one that is looked for [s]. Returns the new number of phases.
    """
    if axis[Axis.EFFORT] == Effort.QUICK:
        return count
    family, trial = work[PlanWork.FAMILY, :], work[PlanWork.TRIAL:PlanWork.BEST, :]
    missing = set_loop(problem, axis, family)
    given = longest
    for arc in range(last + 1):
        if arc == LoopArc.FOLD and longest < given:
            break
        sample = 0
        while sample >= 0 and sample < SAMPLES:
            sample, duration = arc_root(arc, sample, missing, given, family, axis)
            if sample >= 0 and duration < longest:
                used = write_member(trial, family, axis)
                duration = valid_duration(trial, used, problem, axis)
                # a gain by rounding is none
                if duration >= 0.0 and duration < longest * (1.0 - GAINED):
                    copy_phases(trial, phases, used)
                    count = used
                    longest = duration
    return count


def timed_loop(
    problem: 'float[:]', axis: 'float[:]', cell: 'float[:,:]', work: 'float[:,:]'
) -> None:
    """Nearest profiles of the arcs that last the problem's duration, until they enclose it."""
    family = work[PlanWork.FAMILY, :]
    target = problem[Problem.DURATION]
    missing = set_loop(problem, axis, family)
    family[Family.BY_TIME] = 1.0
    family[Family.TARGET] = target
    for arc in range(LoopArc.SINGLE + 1):
        sample = 0
        while sample >= 0 and sample < SAMPLES:
            sample, duration = arc_root(arc, sample, missing, target, family, axis)
            if sample >= 0:
                used = write_member(work[PlanWork.TRIAL:PlanWork.BEST, :], family, axis)
                keep_nearest(used, problem, axis, cell, work)
        if is_enclosed(work):
            return
