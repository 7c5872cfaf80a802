"""The crane with a hook, linearised about hook and load hanging at rest, and sampled.

It decouples into bridge with phi_x and psi_x, trolley with phi_y and psi_y, and hoist. In the
equations of one axis the signs of the angles are such that the load is at position + l * rope angle
+ sling * sling angle. Derivatives are central differences of the generated equations, with errors
below 1e-8 of the largest.
"""

from __future__ import annotations

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.crane.hook.parameters import HookCrane
from segfmu.crane.linear import SIGNS
from segfmu.kernels.crane.records import Axes, GeneralisedForce, Vector
from segfmu.kernels.hook._hook import hook_driven, hook_rhs
from segfmu.kernels.hook.records import HookState

# position, both angles, and their rates, of bridge and trolley; length and its rate of the rope
PLACES = (
    *(
        np.array([
            axis, HookState.ANGLE + axis, HookState.SLING_ANGLE + axis, HookState.VELOCITY + axis,
            HookState.RATE + axis, HookState.SLING_RATE + axis,
        ])
        for axis in range(2)
    ),
    np.array([Axes.ROPE, HookState.VELOCITY + Axes.ROPE]),
)
VELOCITY = (3, 3, 1)
STEP = 1e-5


def axis_model(
    crane: HookCrane, length: float, axis: int, driven: bool
) -> tuple[FloatArray, FloatArray]:
    """A (6, 6) and B (6, 1) of bridge or trolley, (2, 2) and (2, 1) of the hoist.

    The input is the drive's force [N], or if `driven` the acceleration [m/s2].
    """
    places = PLACES[axis]
    signs = np.ones(places.size)
    if axis != Axes.ROPE:
        signs[[1, 2, 4, 5]] = SIGNS[axis]

    def rate(state: FloatArray, effort: float) -> FloatArray:
        full = np.zeros(HookState.SIZE)
        full[Axes.ROPE] = length
        full[places] += signs * state
        found: FloatArray = signs * _derivative(crane, full, axis, effort, driven)[places]
        return found

    rest = np.zeros(places.size)
    size = STEP if driven else STEP * crane.masses[2] * crane.masses[3]
    columns = [
        (rate(STEP * e, 0.0) - rate(-STEP * e, 0.0)) / (2.0 * STEP) for e in np.eye(rest.size)
    ]
    given = (rate(rest, size) - rate(rest, -size)) / (2.0 * size)
    return np.array(columns).T, given[:, None]


def _derivative(
    crane: HookCrane, state: FloatArray, axis: int, effort: float, driven: bool
) -> FloatArray:
    """Derivative of a state under an effort of one drive beside that of the rest."""
    masses, calm = np.array(crane.masses), np.zeros(Vector.SIZE)
    derivative, tension = np.zeros(HookState.SIZE), np.zeros(1)
    force, inputs = np.zeros(GeneralisedForce.SIZE), np.zeros(Axes.SIZE)
    inputs[axis] = effort
    if driven:
        hook_driven(state, inputs, force, calm, masses, derivative, np.zeros(3), tension)
        return derivative
    force[: Axes.SIZE] = inputs
    force[Axes.ROPE] -= (crane.hook_mass + crane.crane.payload_mass) * crane.crane.gravity
    hook_rhs(state, force, calm, masses, derivative, tension)
    return derivative
