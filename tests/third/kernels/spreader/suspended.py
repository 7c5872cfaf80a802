"""A load with a spreader: equations and inverse of a gantry crane with the mass of both."""

from segfmu.kernels.crane._crane import crane_driven, crane_flat_inverse, crane_rhs
from segfmu.kernels.crane.records import Resistance, Work


def spreader_code() -> int:
    """Its code as `Resistance.SUSPENSION`."""
    return 2


def add_spreader(share: float, masses: 'float[:]') -> None:
    """Add the spreader to the load, or with -1 take it off."""
    masses[Resistance.PAYLOAD_MASS] = (
        masses[Resistance.PAYLOAD_MASS] + share * masses[Resistance.TACKLE_MASS]
    )


def spreader_rhs(
    plant: 'float[:]', state: 'float[:]', work: 'float[:,:]', derivative: 'float[:]'
) -> None:
    """Derivative of the state under forces."""
    add_spreader(1.0, plant)
    crane_rhs(state, work[Work.GENERALISED, :], work[Work.WIND, :], plant, derivative)
    add_spreader(-1.0, plant)


def spreader_driven(
    plant: 'float[:]', state: 'float[:]', work: 'float[:,:]', derivative: 'float[:]'
) -> None:
    """The same under accelerations, with the forces for them."""
    add_spreader(1.0, plant)
    crane_driven(
        state, work[Work.DEMAND, :], work[Work.GENERALISED, :], work[Work.WIND, :], plant,
        derivative, work[Work.ACTION, :],
    )
    add_spreader(-1.0, plant)


def spreader_inverse(
    flat: 'float[:,:]', resistance: 'float[:]', force: 'float[:]', state: 'float[:]',
    acceleration: 'float[:]',
) -> None:
    """Forces, and motion of carriages and rope."""
    add_spreader(1.0, resistance)
    crane_flat_inverse(flat, resistance, force, state, acceleration)
    add_spreader(-1.0, resistance)
