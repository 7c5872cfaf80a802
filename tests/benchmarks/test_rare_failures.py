"""The FMU with a closed form fails as often as that says."""

from __future__ import annotations

import pytest

pytest.importorskip("distributed", reason="campaigns need dask")

from benchmarks.rare_failures import told

from tests.validation.campaigns.files import threaded


def test_its_failures_are_as_probable_as_the_closed_form_says() -> None:
    # of workers that are processes tests/validation/campaigns tells
    with threaded():
        found = told(0.3, 100, 1, rare=False)
    assert found["runs"] == 100
    assert found["low"] < 0.3 < found["high"]
    assert 0.7 < found["over the true one"] < 1.4
