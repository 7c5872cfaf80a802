"""Whether a trajectory that was put together, or changed, is one."""

from __future__ import annotations

import numpy as np

from segfmu.arrays import as_index, shown
from segfmu.errors import InputError
from segfmu.kernels.trajectory.records import Timing
from segfmu.planning.limits import NAMES, Limits
from segfmu.planning.problem import SYNCHRONIZATIONS
from segfmu.planning.trajectory import Trajectory
from segfmu.planning.waypoint import Waypoint

# numbers of dimensions
ARRAYS = {
    "timing": 2, "coefficients": 2, "offsets": 1, "axis_waypoint_times": 2, "axis_durations": 1,
}
SEQUENCES = {"waypoints": Waypoint, "axis_names": str}


def require_whole(trajectory: Trajectory) -> None:
    """Check that the attributes of a trajectory have their types and belong together.

    Raises
    ------
    InputError
        For the first one that does not.
    """
    _require_types(trajectory)
    times, points = trajectory.axis_waypoint_times, trajectory.waypoints
    if times.shape != (len(points), trajectory.axes):
        raise InputError(
            f"trajectory has {len(points)} waypoints of {trajectory.axes} axes, but the times of "
            f"{' x '.join(map(str, times.shape))}"
        )
    if len(points) < 2:
        raise InputError(f"trajectory has {len(points)} waypoints, at least 2 are needed")
    for number, point in enumerate(points, 1):
        if point.axes != trajectory.axes:
            raise InputError(
                f"trajectory has {trajectory.axes} axes, but waypoint {number} has {point.axes}"
            )
    if len(trajectory.axis_names) != trajectory.axes:
        raise InputError(
            f"trajectory has {trajectory.axes} axes, but {len(trajectory.axis_names)} axis_names"
        )
    if trajectory.synchronize not in SYNCHRONIZATIONS:
        raise InputError(
            f"trajectory has synchronize {trajectory.synchronize!r}, not one of "
            f"{', '.join(SYNCHRONIZATIONS)}"
        )
    _require_pieces(trajectory)


def _require_pieces(trajectory: Trajectory) -> None:
    """Raise InputError unless every axis has pieces, and all arrays have as many rows."""
    offsets = trajectory.offsets
    if offsets[0] != 0 or (np.diff(offsets) <= 0).any():
        raise InputError(
            f"trajectory needs offsets that ascend from 0, got {shown(offsets.tolist())}"
        )
    pieces = int(offsets[-1])
    for name, array, shape in (
        ("timing", trajectory.timing, (pieces, Timing.SIZE)),
        ("coefficients", trajectory.coefficients, (pieces, trajectory.coefficients.shape[-1])),
        ("axis_durations", trajectory.axis_durations, (trajectory.axes,)),
    ):
        if array.shape != shape:
            raise InputError(
                f"trajectory has {pieces} pieces of {trajectory.axes} axes; its {name} must have "
                f"the shape {shape}, not {array.shape}"
            )


def _require_types(trajectory: Trajectory) -> None:
    """Raise InputError unless every attribute has its type."""
    for name, dimensions in ARRAYS.items():
        value = getattr(trajectory, name)
        kinds = "iu" if name == "offsets" else "iuf"
        if not isinstance(value, np.ndarray) or value.dtype.kind not in kinds:
            what = "an array of integers" if name == "offsets" else "an array of numbers"
            raise InputError(f"trajectory: {name} must be {what}, got {shown(value)}")
        if value.ndim != dimensions:
            raise InputError(
                f"trajectory: {name} must have {dimensions} dimensions, got shape {value.shape}"
            )
    for name, kind in SEQUENCES.items():
        value = getattr(trajectory, name)
        if not isinstance(value, tuple | list) or not all(isinstance(v, kind) for v in value):
            raise InputError(
                f"trajectory: {name} must be a tuple of {kind.__name__}, got {shown(value)}"
            )
    if not isinstance(trajectory.limits, Limits):
        raise InputError(f"trajectory: limits must be Limits, got {shown(trajectory.limits)}")
    as_index("trajectory: smoothness", trajectory.smoothness, len(NAMES), least=1)
