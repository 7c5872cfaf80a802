"""Plans in slots: their offsets, copies, and the time that they take.

timing and coefficients have a plan a slot (`Slot`, rows, columns), offsets Slot.OFFSETS entries a
slot.
"""

from segfmu.kernels.operation.records import OperationRows, Slot
from segfmu.kernels.trajectory.cut import copy_piece
from segfmu.kernels.trajectory.records import Timing


def plan_pieces(slot: int, offsets: 'int[:]') -> int:
    """Number of the pieces of a plan."""
    return offsets[slot * Slot.OFFSETS + Slot.AXES] - offsets[slot * Slot.OFFSETS]


def plan_end(slot: int, axis: int, timing: 'float[:,:,:]', offsets: 'int[:]') -> float:
    """Time [s] at which an axis of a plan comes to rest."""
    last = offsets[slot * Slot.OFFSETS + axis + 1] - 1
    return timing[slot, last, Timing.START] + timing[slot, last, Timing.LENGTH]


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
