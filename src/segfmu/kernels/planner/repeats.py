"""Searches for shortest profiles that were made before.

Axes that meet try many durations for the same problems, and each of them may be that of the
shortest profile, slowed down: to find it takes longer than to slow it down. A search depends on the
problem, the axis and `Passing.PLAIN` alone, by which it is found again.
"""

from segfmu.kernels.planner.orientation import orient, turn_back
from segfmu.kernels.planner.records import Axis, Passing, PlanWork, Problem, Repeat


def is_search(
    place: int, plain: float, problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]'
) -> bool:
    """Whether the search that is kept at a place is that for a problem as it is solved."""
    search, searched = work[PlanWork.SEARCHES + place, :], work[PlanWork.SEARCHED_AXES + place, :]
    if search[Repeat.USED] == 0.0 or search[Repeat.PLAIN] != plain:
        return False
    for i in range(Problem.DURATION):
        if search[Repeat.PROBLEM + i] != problem[i]:
            return False
    for i in range(Axis.SIZE):
        if searched[i] != axis[i]:
            return False
    return True


def copy_search(source: int, target: int, work: 'float[:,:]') -> None:
    """Copy a sequence between rows of `work` (PlanWork), as it is in FOUND."""
    for j in range(int(work[source, Passing.COUNT]) + 3):
        work[target + j, :] = work[source + j, :]


def use_search(place: int, work: 'float[:,:]') -> None:
    """Note that the search at a place is the last one that was used."""
    turn = 0.0
    for i in range(PlanWork.SEARCHED_AXES - PlanWork.SEARCHES):
        turn = max(turn, work[PlanWork.SEARCHES + i, Repeat.USED])
    work[PlanWork.SEARCHES + place, Repeat.USED] = turn + 1.0


def keep_search(
    plain: float, passing: bool, problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]'
) -> None:
    """Keep what a search for a problem, as it is solved, has found, in place of the oldest one."""
    place = 0
    for i in range(PlanWork.SEARCHED_AXES - PlanWork.SEARCHES):
        if work[PlanWork.SEARCHES + i, Repeat.USED] < work[PlanWork.SEARCHES + place, Repeat.USED]:
            place = i
    row = PlanWork.SEARCHES + place
    for i in range(Problem.DURATION):
        work[row, Repeat.PROBLEM + i] = problem[i]
    for i in range(Axis.SIZE):
        work[PlanWork.SEARCHED_AXES + place, i] = axis[i]
    work[row, Repeat.PLAIN] = plain
    work[row, Repeat.REVERSED] = work[PlanWork.PASSING, Passing.REVERSED]
    work[row, Repeat.PASSING] = passing
    if passing:
        rows = PlanWork.SOLVED - PlanWork.FOUND
        copy_search(PlanWork.FOUND, PlanWork.SEARCHED + place * rows, work)
    use_search(place, work)


def search_again(
    plain: float, problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]'
) -> int:
    """Bring back what the search for a problem found: the sequence FOUND, and its direction.

    1: the profile passes zero jerk with snap, 0: it does not, -1: this search is not kept.
    """
    mirrored, turned = orient(problem, axis)
    again = -1
    for place in range(PlanWork.SEARCHED_AXES - PlanWork.SEARCHES):
        if again < 0 and is_search(place, plain, problem, axis, work):
            search = work[PlanWork.SEARCHES + place, :]
            again = int(search[Repeat.PASSING])
            work[PlanWork.PASSING, Passing.REVERSED] = abs(turned - search[Repeat.REVERSED])
            if again > 0:
                rows = PlanWork.SOLVED - PlanWork.FOUND
                copy_search(PlanWork.SEARCHED + place * rows, PlanWork.FOUND, work)
            use_search(place, work)
    turn_back(mirrored, turned, problem, axis)
    return again
