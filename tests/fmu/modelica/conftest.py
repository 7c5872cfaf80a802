"""OpenModelica's compiler, where there is one."""

from __future__ import annotations

import pytest

from tests.fmu.modelica.openmodelica import compiler


@pytest.fixture(scope="session")
def omc() -> None:
    """Skip where there is no omc."""
    if compiler() is None:
        pytest.skip("OpenModelica's import and our Modelica package need omc on the PATH")
