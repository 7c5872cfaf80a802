"""A crane with hook and sling: its parameters and the errors for bad ones."""

from __future__ import annotations

import pytest

from segfmu import Crane, InputError
from segfmu.crane import HookCrane

CRANE = Crane(2.2, 1.155, 1.0, rope_min=0.2)


@pytest.mark.parametrize("name", ["hook_mass", "sling"])
@pytest.mark.parametrize("value", [0.0, -1.0, float("nan"), 1e10, "1", None, True])
def test_bad_values_are_named(name: str, value: object) -> None:
    with pytest.raises(InputError, match=name):
        HookCrane(**{"crane": CRANE, "hook_mass": 0.2, "sling": 0.3, name: value})


def test_it_hangs_on_a_crane() -> None:
    with pytest.raises(InputError, match=r"crane must be a segfmu\.Crane, got int"):
        HookCrane(1, 0.2, 0.3)  # type: ignore[arg-type]


def test_variables_give_it_back() -> None:
    hook = HookCrane(CRANE, 0.2, 0.3)
    assert hook.values()["hook.mass"] == 0.2
    assert HookCrane.of(hook.values().__getitem__) == hook
