"""A small version of `python -m tests.processors`, and what it finds differences by."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tests.campaign import soaked
from tests.compiler import needs_kernels
from tests.processors.agreement import TOLERANCE, Difference, durations
from tests.processors.problems import Problem, problems, rewritten
from tests.processors.variants import CORES, FUSED, LIBM, SIMD, Variant, build, processors

# the kinds of n = 5 and 6 are for the command: their searches take seconds
SMOOTHNESS = (2, 3, 4)
# without what takes long to compile
LESS = ("-fno-inline", *(
    f"-fno-tree-{name}" for name in ("dominator-opts", "fre", "loop-optimize", "pta")
))


@pytest.fixture(scope="module")
def given() -> list[Problem]:
    found = [p for p in problems(100) if p["n"] in SMOOTHNESS]
    assert {p["kind"] for p in found} >= {"rest", "moving", "ties", "free states", "drives"}
    # the search within the first one's drives takes as long as all others
    slow = next(p for p in found if p["kind"] == "drives")
    return [p for p in found if p is not slow]


@pytest.fixture(scope="module")
def expected(given: list[Problem], tmp_path_factory: pytest.TempPathFactory) -> np.ndarray:
    found = durations(given, tmp_path_factory.mktemp("expected"))
    assert (found > 0.0).mean() > 0.7
    return found


def agrees(difference: Difference) -> None:
    assert difference.wrong.size == 0, str(difference)


@pytest.fixture(scope="module")
def variants() -> dict[str, Variant]:
    return {variant.name: variant for variant in processors()}


@pytest.mark.parametrize("name", [*(f"OPENBLAS_CORETYPE={core}" for core in CORES), SIMD, LIBM])
def test_durations_are_those_of_other_processors(
    name: str, variants: dict[str, Variant], given: list[Problem], expected: np.ndarray,
    tmp_path: Path,
) -> None:
    variant = variants[name]
    if variant.skipped:
        pytest.skip(variant.skipped)
    agrees(Difference(variant.name, durations(given, tmp_path, variant), expected))


@needs_kernels
@pytest.mark.parametrize("options", [
    ("-O1", *LESS, "-fexpensive-optimizations", *FUSED),
    *soaked(("-O0", "-ffp-contract=off")),
])
def test_durations_are_those_of_kernels_compiled_otherwise(
    options: tuple[str, ...], given: list[Problem], expected: np.ndarray, tmp_path: Path
) -> None:
    """With FMA, in a soak also without optimisation; the command has them all.

    GCC takes FMA by an optimisation of -O2, whose others would take half as long again, as do some
    of -O1.
    """
    variant = build(tmp_path, "gcc", *options)
    if variant.skipped:
        pytest.skip(variant.skipped)
    found = durations(given, tmp_path, variant)
    agrees(Difference(variant.name, found, expected))
    # one rounding in place of two is seen, or no FMA was taken
    assert FUSED[0] not in options or (found != expected).any()


def test_durations_follow_from_the_motion_not_from_how_it_is_written(
    given: list[Problem], expected: np.ndarray, tmp_path: Path
) -> None:
    names, written, factors = zip(*rewritten(given), strict=True)
    together = durations([problem for changed in written for problem in changed], tmp_path)
    for name, found, factor in zip(names, np.split(together, len(names)), factors, strict=True):
        agrees(Difference(name, np.where(found > 0.0, found / factor, found), expected))


def test_differences_and_refusals_are_found() -> None:
    expected = np.array([1.0, 2.0, -1.0, 3.0, -1.0])
    found = np.array([1.0 + 2e-9, 2.0 + 1e-12, -1.0, -1.0, 4.0])
    difference = Difference("other", found, expected)
    assert difference.wrong.tolist() == [0, 3, 4]
    assert difference.shares[0] == pytest.approx(2.0 * TOLERANCE, rel=1e-6)
    assert "3 above" in str(difference) and "2 refused" in str(difference)
