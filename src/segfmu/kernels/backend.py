"""The entry points of the kernels that other layers call: compiled, or else interpreted.

Both give the same numbers. The compiled ones exist where a C compiler was found when the package
was installed; SEGFMU_INTERPRETED=1 in the environment turns them off.
"""

import os
from importlib.util import find_spec

COMPILED = (
    os.environ.get("SEGFMU_INTERPRETED", "0") in ("", "0")
    and find_spec("segfmu.kernels._compiled") is not None
)

if COMPILED:
    from segfmu.kernels._compiled import (
        check_plan,
        check_rope,
        compensate_setpoints,
        count_pieces,
        crane_energy,
        crane_flat_inverse,
        crane_load,
        crane_rhs,
        evaluate,
        expand_plan,
        feedback_bandwidth,
        feedback_correction,
        feedback_gains,
        flat_derivatives,
        next_plan_event,
        noise_components,
        observer_correct,
        observer_design,
        observer_predict,
        plan_phases,
        plant_advance,
        rig_balance,
        rig_imbalance,
        rig_rows,
        rig_start,
        rig_step,
        seed_numbers,
        switch_correction,
        track_setpoint,
    )
else:
    from segfmu.kernels.control.feedback import (
        feedback_bandwidth,
        feedback_correction,
        feedback_gains,
    )
    from segfmu.kernels.control.kalman import observer_design
    from segfmu.kernels.control.observer import observer_correct, observer_predict
    from segfmu.kernels.control.tracking import track_setpoint
    from segfmu.kernels.crane._crane import crane_energy, crane_flat_inverse, crane_load, crane_rhs
    from segfmu.kernels.crane.compensation import compensate_setpoints
    from segfmu.kernels.crane.plant import plant_advance
    from segfmu.kernels.crane.rope import check_rope
    from segfmu.kernels.crane.series import flat_derivatives
    from segfmu.kernels.numerics.noise import noise_components, seed_numbers
    from segfmu.kernels.planner.plan import plan_phases
    from segfmu.kernels.rig.loop import switch_correction
    from segfmu.kernels.rig.rig import rig_balance, rig_imbalance, rig_rows, rig_start, rig_step
    from segfmu.kernels.trajectory.breaks import next_plan_event
    from segfmu.kernels.trajectory.check import check_plan
    from segfmu.kernels.trajectory.evaluate import evaluate
    from segfmu.kernels.trajectory.expand import count_pieces, expand_plan

__all__ = [
    "COMPILED",
    "check_plan",
    "check_rope",
    "compensate_setpoints",
    "count_pieces",
    "crane_energy",
    "crane_flat_inverse",
    "crane_load",
    "crane_rhs",
    "evaluate",
    "expand_plan",
    "feedback_bandwidth",
    "feedback_correction",
    "feedback_gains",
    "flat_derivatives",
    "next_plan_event",
    "noise_components",
    "observer_correct",
    "observer_design",
    "observer_predict",
    "plan_phases",
    "plant_advance",
    "rig_balance",
    "rig_imbalance",
    "rig_rows",
    "rig_start",
    "rig_step",
    "seed_numbers",
    "switch_correction",
    "track_setpoint",
]
