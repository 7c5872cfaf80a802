"""Outputs of hook and sling from a rig."""

from segfmu.kernels.crane._crane import crane_load
from segfmu.kernels.crane.records import Axes, Load, Plant, PlantState, Report, State, Vector, Work
from segfmu.kernels.hook.records import HookFrequencies, HookOutputs
from segfmu.kernels.hook.suspended import gather_hook
from segfmu.kernels.hook.swing import hook_frequencies
from segfmu.kernels.rig.records import Memory


def hook_outputs(memory: 'float[:,:]', outputs: 'float[:]') -> None:
    """Write HookOutputs; without a hook its place is that of the load."""
    state = memory[Memory.STATE, :]
    work = memory[Memory.WORK : Memory.WORK + Work.SIZE, :]
    for i in range(2):
        outputs[HookOutputs.ANGLE + i] = state[PlantState.SLING_ANGLE + i]
        outputs[HookOutputs.RATE + i] = state[PlantState.SLING_RATE + i]
    # the hook is where the rope ends
    place = work[Work.LOAD : Work.LOAD + Load.SIZE, :]
    crane_load(state, place)
    for i in range(Vector.SIZE):
        outputs[HookOutputs.POSITION + i] = place[Load.POSITION, i]
        outputs[HookOutputs.VELOCITY + i] = place[Load.VELOCITY, i]
    outputs[HookOutputs.TENSION] = memory[Memory.REPORT, Report.SLING_TENSION]
    outputs[HookOutputs.FREQUENCY] = 0.0
    outputs[HookOutputs.FREQUENCY + 1] = 0.0
    if memory[Memory.PLANT, Plant.SLING] > 0.0:
        gather_hook(memory[Memory.PLANT, :], state, work)
        hook_frequencies(
            state[State.POSITION + Axes.ROPE], work[Work.OWN_MASSES, :],
            outputs[HookOutputs.FREQUENCY : HookOutputs.FREQUENCY + HookFrequencies.SIZE],
        )
