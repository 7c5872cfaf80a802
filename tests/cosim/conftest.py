"""Probes and the pendulum, built once for the tests of the system."""

from __future__ import annotations

from pathlib import Path

import pytest

from segfmu.fmu import models
from segfmu.fmu.build import build_all
from segfmu.fmu.choice import Choice
from tests.compiler import require_native
from tests.cosim.probe.build import build
from tests.fmu.pendulum.model import PENDULUM


@pytest.fixture(scope="session")
def probes(tmp_path_factory: pytest.TempPathFactory) -> dict[int, Path]:
    """FMUs that do what they are told, by version of FMI."""
    require_native()
    folder = tmp_path_factory.mktemp("probes")
    return {fmi: build(folder, fmi) for fmi in (2, 3)}


@pytest.fixture(scope="session")
def pendulums(tmp_path_factory: pytest.TempPathFactory) -> dict[int, Path]:
    """The pendulum, native, by version of FMI."""
    require_native()
    # the registration ends here: other tests have the models of the package
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(models, "_registered", dict(models._registered))
        models.register(PENDULUM)
        return {
            fmi: build_all(
                tmp_path_factory.mktemp(f"pendulum{fmi}"), Choice(True, fmi), [PENDULUM.spec()]
            )[0]
            for fmi in (2, 3)
        }
