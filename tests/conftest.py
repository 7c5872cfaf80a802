"""Both FMUs and the planner in C, built once for all tests."""

from __future__ import annotations

import gc
from collections.abc import Iterator
from functools import partial
from pathlib import Path

import pytest
from hypothesis import settings

from segfmu.fmu import pairs
from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.gantry_feedforward import interface as gantry_feedforward
from segfmu.fmu.native import archive as native
from segfmu.fmu.python.archive import build_all
from tests.compiler import SANITIZERS, binary, kernels_object, require_cc, require_native
from tests.kernels.planner.c_planner import Planner
from tests.sharing import shared

# The same examples in every run of the whole suite; `--hypothesis-profile=search` looks for more.
settings.register_profile("repeatable", derandomize=True, deadline=None)
settings.register_profile("search", max_examples=2000, deadline=None)
settings.load_profile("repeatable")


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Iterator[None]:
    """Modules and thousands of tests stay: nothing looks for garbage among them, now or later.

    Nor does it look often among others: SymPy makes so much that lasts that this takes a quarter of
    its time.
    """
    gc.disable()
    try:
        return (yield)
    finally:
        gc.enable()
        gc.collect()
        gc.freeze()
        gc.set_threshold(100_000, 20, 100)


@pytest.fixture(scope="session", autouse=True)
def sooner_binaries() -> Iterator[None]:
    """Native archives that this process builds have the binaries of `tests.compiler`."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(native, "binary", binary)
        yield


@pytest.fixture(scope="session")
def fmus(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """Archives of GantryFeedforward and GantryCrane on the Python backend."""
    specs = (gantry_feedforward.spec(), gantry_crane.spec())
    return pair(shared(tmp_path_factory, "fmus", lambda folder: build_all(folder, specs=specs)))


@pytest.fixture(scope="session")
def native_fmus(tmp_path_factory: pytest.TempPathFactory) -> dict[int, tuple[Path, Path]]:
    """Native archives of GantryFeedforward and GantryCrane, by version of FMI."""
    require_native()
    specs = (gantry_feedforward.native_spec(), gantry_crane.native_spec())
    return {
        fmi: pair(shared(
            tmp_path_factory, f"native{fmi}", partial(native.build_all, specs, fmi=fmi)
        ))
        for fmi in (2, 3)
    }


@pytest.fixture(scope="session")
def hook_fmus(tmp_path_factory: pytest.TempPathFactory) -> dict[int, tuple[Path, Path]]:
    """Native archives of HookFeedforward and HookCrane, by version of FMI."""
    require_native()
    specs = pairs.native((pairs.HOOK.planner(16), pairs.HOOK.plant()))
    return {
        fmi: pair(shared(
            tmp_path_factory, f"hooks{fmi}", partial(native.build_all, specs, fmi=fmi)
        ), pairs.HOOK)
        for fmi in (2, 3)
    }


@pytest.fixture(scope="session")
def kernels_in_c(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The kernels as an object file."""
    require_cc()
    return shared(
        tmp_path_factory, "kernels", lambda folder: kernels_object(folder, "-Og", "-fPIC")
    ) / "kernels.o"


@pytest.fixture(scope="session")
def sanitized_kernels(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The kernels as an object file with sanitizers."""
    require_cc()
    return shared(
        tmp_path_factory, "sanitized",
        lambda folder: kernels_object(folder, "-O0", "-g", *SANITIZERS),
    ) / "kernels.o"


@pytest.fixture(scope="session")
def planner(tmp_path_factory: pytest.TempPathFactory, kernels_in_c: Path) -> Planner:
    """The C entry points of plans."""
    return Planner(shared(
        tmp_path_factory, "planner", lambda folder: Planner(folder, kernels_in_c)
    ))


def pair(folder: Path, models: pairs.ModelPair = pairs.GANTRY) -> tuple[Path, Path]:
    """The two archives of a folder."""
    return folder / f"{models.feedforward}.fmu", folder / f"{models.crane}.fmu"
