"""Some random call sequences; `python -m tests.fmu.native.fuzz` makes a million."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from tests.campaign import SOAK, campaign
from tests.compiler import CC, SANITIZERS, require_cc
from tests.fmu.native import fuzz

COMMANDED = [
    pytest.param(fmi, fuzz.COMMANDED, marks=pytest.mark.soak) for fmi in (2, 3) if SOAK
]


@pytest.fixture(scope="module")
def kernels(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> Path | None:
    """The kernels for all programs, where the C compiler has sanitizers; None to optimise them."""
    require_cc()
    folder = tmp_path_factory.mktemp("fuzz")
    empty = folder / "empty.c"
    empty.write_text("int main(void) { return 0; }\n")
    done = subprocess.run(
        [CC, *SANITIZERS, empty, "-o", folder / "empty"], capture_output=True,
        check=False,
    )
    if done.returncode != 0:
        pytest.skip("the C compiler has no sanitizers")
    return None if SOAK else request.getfixturevalue("sanitized_kernels")


@campaign(100, 20_000)
# every source is in one of these; the command makes all, of both versions
@pytest.mark.parametrize(
    ("fmi", "spec"),
    [(3, fuzz.SPECS[0]), (2, fuzz.SPECS[1]), (2, fuzz.HOOKS[0]), (3, fuzz.HOOKS[1]), *COMMANDED],
)
def test_random_calls_end_with_a_status(
    kernels: Path | None, tmp_path: Path, spec, fmi: int, count: int
) -> None:
    # so few run sooner than an optimised program compiles
    target = fuzz.program(
        CC, spec, fmi, tmp_path, "-O1" if SOAK else "-O0", kernels=kernels
    )
    told = fuzz.run(target, count, 1, timeout=600.0)
    sequences, calls, errors, messages = (int(t.split()[0]) for t in told.split(", "))
    assert (sequences, calls) == (count, 40 * count)
    # a good part of the calls is in order, so that the models run
    assert errors < 0.8 * calls and messages > 0
    if spec is fuzz.SPECS[0]:
        # of both sizes, states free and given, boxes and none; a soak takes all combinations
        kinds = list(fuzz.missions(1))
        kinds = kinds if SOAK else [kinds[i] for i in (2, 5)]
        assert len(fuzz.searches(target, fmi, kinds, 30 if SOAK else 1, 1)) == len(kinds)
