"""Plans in slots: their offsets, copies, and the time that they take.

timing and coefficients have a plan a slot (`Slot`, rows, columns), offsets Slot.OFFSETS entries a
slot.
"""

from segfmu.kernels.operation.records import Operation, OperationRows, Slot
from segfmu.kernels.trajectory.cut import copy_piece, cut_plan
from segfmu.kernels.trajectory.evaluate import evaluate_piece
from segfmu.kernels.trajectory.records import Timing


def plan_pieces(slot: int, offsets: 'int[:]') -> int:
    """Number of the pieces of a plan."""
    return offsets[slot * Slot.OFFSETS + Slot.AXES] - offsets[slot * Slot.OFFSETS]


def plan_end(slot: int, axis: int, timing: 'float[:,:,:]', offsets: 'int[:]') -> float:
    """Time [s] at which an axis of a plan comes to rest."""
    last = offsets[slot * Slot.OFFSETS + axis + 1] - 1
    return timing[slot, last, Timing.START] + timing[slot, last, Timing.LENGTH]


def rest_time(slot: int, timing: 'float[:,:,:]', offsets: 'int[:]') -> float:
    """Time [s] at which a plan comes to rest."""
    rests = plan_end(slot, 0, timing, offsets)
    for axis in range(1, 3):
        rests = max(rests, plan_end(slot, axis, timing, offsets))
    return rests


def copy_plan(
    source: int, target: int, timing: 'float[:,:,:]', coefficients: 'float[:,:,:]',
    offsets: 'int[:]',
) -> None:
    """Copy a plan from one slot to another."""
    for i in range(Slot.OFFSETS):
        offsets[target * Slot.OFFSETS + i] = offsets[source * Slot.OFFSETS + i]
    for row in range(plan_pieces(source, offsets)):
        copy_piece(
            timing[source, :, :], coefficients[source, :, :], row, timing[target, :, :],
            coefficients[target, :, :], row,
        )


def has_room(slot: int, offsets: 'int[:]') -> bool:
    """Whether a plan has few enough pieces to be taken."""
    return plan_pieces(slot, offsets) <= OperationRows.KEPT


def clear_plan(slot: int, offsets: 'int[:]') -> None:
    """Leave a plan no pieces."""
    for i in range(Slot.OFFSETS):
        offsets[slot * Slot.OFFSETS + i] = 0


def note_present(
    elapsed: float, operation: 'float[:,:]', timing: 'float[:,:,:]',
    coefficients: 'float[:,:,:]', offsets: 'int[:]',
) -> None:
    """Cut what is left of the present plan, in the slot REST, and note the state."""
    present = Slot.PRESENT * Slot.OFFSETS
    rest = Slot.REST * Slot.OFFSETS
    cut_plan(
        max(elapsed, 0.0), timing[Slot.PRESENT, :, :], coefficients[Slot.PRESENT, :, :],
        offsets[present:present + Slot.OFFSETS], timing[Slot.REST, :, :],
        coefficients[Slot.REST, :, :], offsets[rest:rest + Slot.OFFSETS],
    )
    width = coefficients.shape[2]
    for axis in range(3):
        row = offsets[rest + axis]
        for order in range(width // 2 + 1):
            operation[Operation.NOW + axis, order] = evaluate_piece(
                coefficients[Slot.REST, :, :], row, width, 0.0, order
            )
