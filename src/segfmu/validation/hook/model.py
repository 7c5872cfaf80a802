"""What files, views and baselines know of the crane with a hook."""

from __future__ import annotations

from segfmu.crane.hook.parameters import HookCrane
from segfmu.fmu.hook_crane.pair import HOOK as PAIR
from segfmu.validation.files.crane_model import CraneModel
from segfmu.validation.hook.checks import check_crane, check_mission

HOOK = CraneModel(
    key="hook",
    pair=PAIR,
    parameters=HookCrane,
    build=lambda crane, table: HookCrane(crane, table.mass, table.sling),
    table=lambda crane: {"mass": crane.hook_mass, "sling": crane.sling},
    source="measured",
    # forces follow the sixth derivative of the load's position, which is large in the short parts
    # of a plateau's ramps
    defaults={"smoothness": 6, "shape": "smoothstep"},
    notes={"smoothness": "with a hook 6, or 5 for velocity drives without known bounds"},
    without_key={
        "feedback.sling": "the sling of the crane that the mission is planned for",
        "feedback.hook": "dimensionless weights of HookCrane's feedback, so that one set suits all",
    },
    designed=lambda table: {"feedback.sling": table.sling},
    check_crane=check_crane,
    check_mission=check_mission,
    bodies=("hook",),
    links=("sling",),
    parts=(("hook", "mass", "kg"), ("sling", "sling", "m")),
)
