"""The kernels of a crane with a hook that other layers and the FMUs call."""

from segfmu.kernels.crane.records import (
    Axes,
    Coordinates,
    Masses,
    Plant,
    RopeBounds,
    RopeFault,
    RopeWork,
    State,
    Vector,
)
from segfmu.kernels.entry_point import entry
from segfmu.kernels.hook.records import (
    HookAxis,
    HookDesign,
    HookFrequencies,
    HookInverse,
    HookLimits,
    HookLinks,
    HookMasses,
    HookMotion,
    HookOutputs,
    HookPath,
    HookState,
    HookTable,
    HookTension,
    HookWeighing,
    SlingSeries,
)
from segfmu.kernels.rig.records import Memory

ENTRY_POINTS = (
    entry(
        "hook.inverse", "hook_derivatives", flat=("order + 7", 3), masses=Masses.SIZE,
        work=(SlingSeries.SIZE, "order + 5"), found=HookInverse.SIZE,
    ),
    entry(
        "hook.rope", "check_hook", timing=("pieces", 2), coefficients=("pieces", "width"),
        offsets=4, ends=Vector.SIZE, masses=Masses.SIZE, bounds=RopeBounds.SIZE,
        polynomials=(RopeWork.SIZE, "4 * width - 5"), work=(HookPath.SIZE, HookPath.COLUMNS),
        report=RopeFault.SIZE,
    ),
    entry(
        "hook.swing", "hook_frequencies", masses=HookMasses.SIZE, found=HookFrequencies.SIZE
    ),
    entry(
        "hook.swing", "hook_load_motion", state=HookState.SIZE, tension=HookTension.SIZE,
        masses=HookMasses.SIZE, work=(HookLinks.SIZE, HookLinks.COLUMNS),
        load=(HookMotion.SIZE, HookMotion.COLUMNS),
    ),
    entry(
        "hook.design", "hook_design", plant=Plant.SIZE, weights=HookWeighing.SIZE,
        work=(HookDesign.SIZE, 2 * HookAxis.CORRECTION), table=(HookTable.SIZE, HookTable.COLUMNS),
    ),
    entry(
        "hook.feedback", "hook_correction", table=("lengths", HookTable.SIZE, HookTable.COLUMNS),
        limits=HookLimits.SIZE, measured=Coordinates.SIZE, reference=State.SIZE,
        feedforward=Axes.SIZE, estimates=(Axes.SIZE + 1, HookAxis.SIZE), correction=Axes.SIZE,
    ),
    entry(
        "hook.outputs", "hook_outputs", memory=(Memory.SIZE, Memory.COLUMNS),
        outputs=HookOutputs.SIZE,
    ),
)
