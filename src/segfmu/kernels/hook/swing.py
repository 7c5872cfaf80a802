"""Natural frequencies of hook and load, and the motion of the load in a state of the crane."""

from math import cos, sin, sqrt

from segfmu.kernels.crane.records import Masses
from segfmu.kernels.hook.records import (
    HookFrequencies,
    HookLinks,
    HookMasses,
    HookMotion,
    HookState,
    HookTension,
)


def hook_frequencies(rope: float, masses: 'float[:]', found: 'float[:]') -> None:
    """Natural frequencies (HookFrequencies) of small swings below a carriage at rest.

    rope [m]: from trolley to hook; masses: HookMasses. With M = m_h + m_p they are the roots of

        m_h l L w^4 - M g (l + L) w^2 + M g^2 = 0

    written so that a hook without mass leaves the pendulum of length l + L, exactly.
    """
    gravity = masses[Masses.GRAVITY]
    sling = masses[HookMasses.SLING]
    hook = masses[HookMasses.HOOK_MASS]
    total = hook + masses[Masses.PAYLOAD_MASS]
    length = rope + sling
    # the mean of both roots' periods, squared, in units of 1 / g
    middle = 0.5 * (length + sqrt(length * length - 4.0 * hook * rope * sling / total))
    found[HookFrequencies.SLOW] = sqrt(gravity / middle)
    found[HookFrequencies.FAST] = sqrt(gravity * total * middle / (hook * rope * sling))


def hook_load_motion(
    state: 'float[:]',
    tension: 'float[:]',
    masses: 'float[:]',
    work: 'float[:,:]',
    load: 'float[:,:]',
) -> None:
    """Position of the load and three derivatives (HookMotion) in a state (HookState).

    tension: force of the hoist and its rate (HookTension); masses: HookMasses; work: HookLinks.
    The carriages' accelerations do not enter: rope and sling alone move hook and load. With the
    rope's pull S along d, the unit vector from hook to trolley, and the sling's pull T along s,
    that from load to hook, the length of the sling gives

        T = m_p (S (d s) + m_h L s'^2) / (m_h + m_p),   p'' = T s / m_p - g e_z
    """
    hook = masses[HookMasses.HOOK_MASS]
    payload = masses[Masses.PAYLOAD_MASS]
    sling = masses[HookMasses.SLING]
    length = state[HookState.POSITION + 2]
    write_direction(state, HookState.ANGLE, HookState.RATE, HookLinks.ROPE, work)
    write_direction(state, HookState.SLING_ANGLE, HookState.SLING_RATE, HookLinks.SLING, work)
    pull = -tension[HookTension.FORCE]
    change = -tension[HookTension.RATE]
    along = 0.0
    turning = 0.0
    for i in range(3):
        along = along + work[HookLinks.ROPE, i] * work[HookLinks.SLING, i]
        turning = turning + work[HookLinks.SLING_RATE, i] * work[HookLinks.SLING_RATE, i]
    share = payload / (hook + payload)
    sling_pull = share * (pull * along + hook * sling * turning)
    # L s'' = h'' - p''; gravity acts on both
    gain = 0.0
    for i in range(3):
        work[HookLinks.RELATIVE, i] = (
            (pull * work[HookLinks.ROPE, i] - sling_pull * work[HookLinks.SLING, i]) / hook
            - sling_pull * work[HookLinks.SLING, i] / payload
        ) / sling
        gain = gain + (
            change * work[HookLinks.ROPE, i] * work[HookLinks.SLING, i]
            + pull * work[HookLinks.ROPE_RATE, i] * work[HookLinks.SLING, i]
            + pull * work[HookLinks.ROPE, i] * work[HookLinks.SLING_RATE, i]
            + 2.0 * hook * sling * work[HookLinks.SLING_RATE, i] * work[HookLinks.RELATIVE, i]
        )
    gain = share * gain
    for i in range(3):
        load[HookMotion.POSITION, i] = (
            -length * work[HookLinks.ROPE, i] - sling * work[HookLinks.SLING, i]
        )
        load[HookMotion.VELOCITY, i] = (
            -state[HookState.VELOCITY + 2] * work[HookLinks.ROPE, i]
            - length * work[HookLinks.ROPE_RATE, i] - sling * work[HookLinks.SLING_RATE, i]
        )
        load[HookMotion.ACCELERATION, i] = sling_pull * work[HookLinks.SLING, i] / payload
        load[HookMotion.JERK, i] = (
            gain * work[HookLinks.SLING, i] + sling_pull * work[HookLinks.SLING_RATE, i]
        ) / payload
    for i in range(2):
        load[HookMotion.POSITION, i] = load[HookMotion.POSITION, i] + state[i]
        load[HookMotion.VELOCITY, i] = (
            load[HookMotion.VELOCITY, i] + state[HookState.VELOCITY + i]
        )
    load[HookMotion.ACCELERATION, 2] = load[HookMotion.ACCELERATION, 2] - masses[Masses.GRAVITY]


def write_direction(
    state: 'float[:]', angle: int, rate: int, row: int, work: 'float[:,:]'
) -> None:
    """Unit vector upwards along rope or sling, and in the next row its derivative by time."""
    sine = sin(state[angle])
    cosine = cos(state[angle])
    across = sin(state[angle + 1])
    upright = cos(state[angle + 1])
    first = state[rate]
    second = state[rate + 1]
    direction = work[row, :]
    turn = work[row + 1, :]
    direction[0] = -sine
    direction[1] = cosine * across
    direction[2] = cosine * upright
    turn[0] = -cosine * first
    turn[1] = -sine * across * first + cosine * upright * second
    turn[2] = -sine * upright * first - cosine * across * second
