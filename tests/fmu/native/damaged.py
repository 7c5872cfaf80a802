"""Restore changed states with a sum that fits: `python -m tests.fmu.native.damaged`.

A process of its own, as what is tested is that an importer survives. Prints how many states were
refused and how many went on.
"""

from __future__ import annotations

import sys
from contextlib import suppress
from pathlib import Path

import numpy as np

from tests.fmu.native.importer import Importer
from tests.fmu.native.test_state import restore, run, serialised, start

WORD = 8
MASK = 2**64 - 1
# of the header: format, model, build, interface, token, size and sum
HEADER = 7


def mixed(words: np.ndarray, size: int) -> int:
    """The sum that state.c writes into a header."""
    found = size
    for word in words.tolist():
        found = ((found ^ word) * 0x9E3779B97F4A7C15) & MASK
        found ^= found >> 29
    return found


def changed(state: bytes, random: np.random.Generator) -> bytes:
    """The state with some words of its block changed, and the sum that belongs to them."""
    words = np.frombuffer(state, dtype=np.uint64).copy()
    block = words[HEADER:]
    # small integers and sizes stand at the beginning and where most words are zero
    chosen = random.integers(0, block.size, random.integers(1, 5))
    if random.random() < 0.5:
        chosen = random.integers(0, min(block.size, 64), 1)
    for place in chosen:
        block[place] = random.choice([
            0, 1, 2, 255, 2**31, 2**63, MASK, 0x7FF8000000000000, 0x7FF0000000000000,
            int(random.integers(0, 2**63)), np.float64(random.choice([-1.0, 0.5, 3.0, 1e9])).view(
                np.uint64),
        ])
    words[HEADER - 1] = mixed(block, block.size * WORD)
    return words.tobytes()


def main(path: str, index: int, count: int, seed: int) -> None:
    """Try `count` damaged states, each in the same instance."""
    random = np.random.default_rng(seed)
    refused = gone_on = 0
    with Importer(Path(path)) as fmu:
        start(fmu, index)
        run(fmu, 0, 10)
        good = serialised(fmu)
        for _ in range(count):
            try:
                restore(fmu, changed(good, random))
            except Exception:
                refused += 1
                continue
            # whether the steps succeed does not matter, that they return does
            with suppress(Exception):
                run(fmu, 10, 14)
            gone_on += 1
            restore(fmu, good)
        expected = run(fmu, 10, 14)
        restore(fmu, good)
        assert run(fmu, 10, 14).tobytes() == expected.tobytes()
    print(refused, gone_on)


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]), int(sys.argv[3]), int(sys.argv[4]))
