"""Disturbances: each is what its name says, and nothing else."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu import Crane
from segfmu.crane import Friction, Sensors, Wind
from segfmu.validation.disturbances import (
    DISTURBANCES,
    INTECO,
    LAG,
    Case,
    Disturbance,
    meet,
)

CRANE = Crane(2.2, 1.155, 2.0, rope_min=0.2, rope_max=1.0)


def met(disturbance: Disturbance, driven: bool = True) -> Case:
    return meet(disturbance, CRANE, 0.8, 5.0, driven)


@pytest.mark.parametrize("driven", [True, False])
def test_nothing_is_disturbed_by_default(driven: bool) -> None:
    found = met(Disturbance("none"), driven)
    lag = LAG if driven else 0.0
    assert found.crane == CRANE
    assert found.rig.friction == Friction()
    assert found.rig.sensors == Sensors()
    assert found.rig.wind == Wind()
    assert found.rig.travel.rope == (0.2, 1.0)
    assert found.rig.bridge.lag == found.compensation.lag[0] == lag
    assert found.compensation.viscous == (0.0, 0.0, 0.0)
    assert not found.deviation.any()


def test_sway_and_payload() -> None:
    found = met(Disturbance("both", sway=5.0, payload=1.5))
    assert found.crane.payload_mass == 3.0
    assert np.degrees(found.deviation) == pytest.approx([0.0] * 3 + [5.0] + [0.0] * 6)


def test_a_rope_error_is_seen_or_not() -> None:
    seen = met(Disturbance("seen", rope=0.05, rope_measured=True))
    unseen = met(Disturbance("unseen", rope=0.05))
    assert seen.deviation[2] == unseen.deviation[2] == pytest.approx(0.04)
    assert seen.rig.sensors.offset == (0.0,) * 5
    # what the encoder shows at the start is the nominal length
    assert unseen.deviation[2] + unseen.rig.sensors.offset[2] == pytest.approx(0.0)


def test_half_of_the_friction_is_known() -> None:
    found = met(Disturbance("friction", friction=True))
    assert found.rig.friction == INTECO
    assert found.compensation.viscous == (50.0, 41.0, 37.5)
    assert found.compensation.coulomb == (2.5, 3.75, 5.0)


def test_gust_is_a_tenth_of_the_weight_and_ends_before_the_plan() -> None:
    gust = met(Disturbance("gust", gust=True)).rig.wind.gust
    assert gust is not None
    assert gust.force == pytest.approx((1.962, 1.962, 0.0))
    assert 0.0 < gust.start < gust.start + gust.duration < 5.0


def test_all_at_once_has_every_kind() -> None:
    (found,) = (d for d in DISTURBANCES if d.name == "all at once")
    assert found.sway and found.gust and found.friction and found.encoder and found.dead_time
    assert found.payload != 1.0 and found.blind
    assert len({d.name for d in DISTURBANCES}) == len(DISTURBANCES)
