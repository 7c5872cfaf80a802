"""The numbers of many random plans, to compare two versions bit for bit.

`python -m tests.property.plan_numbers --plans 8000 --against OTHER` runs this file with the package
of this checkout and with that of OTHER, another checkout with its environment in .venv, and counts
the requests whose plans differ. It calls the public face of segfmu alone, so that older versions
run it as well. The wording of refusals may differ; whether a request is refused may not.
"""

from __future__ import annotations

import argparse
import hashlib
import subprocess
import sys
from pathlib import Path

import numpy as np

import segfmu

Request = tuple[list[segfmu.Waypoint], segfmu.Limits, int, str]


def share(random: np.random.Generator) -> float:
    """A number in [-1, 1], often zero, an end or a half."""
    return float(random.choice([0.0, 0.0, 1.0, -1.0, 0.5, -0.5, *random.uniform(-1.0, 1.0, 4)]))


def request(random: np.random.Generator) -> Request:
    """One to three axes, two to four waypoints, cranes from millimetres to hundreds of metres."""
    axes, points = int(random.integers(1, 4)), int(random.integers(2, 5))
    smoothness = int(random.integers(2, 7))
    shape = str(random.choice(["smoothstep", "plateau"]))
    size = 10.0 ** random.integers(-3, 3)
    table = [size * 10.0 ** random.uniform(-1.0, 1.0, axes) for _ in range(max(smoothness, 3))]
    limits = segfmu.Limits(*(row.tolist() for row in table))
    waypoints = []
    for i in range(points):
        moving = 0 < i < points - 1 or random.random() < 0.2
        state = [
            [0.6 * share(random) * moving * bound for bound in table[order]] for order in range(2)
        ]
        place = [size * 3.0 * share(random) + i * size for _ in range(axes)]
        waypoints.append(segfmu.Waypoint(place, *state))
    return waypoints, limits, smoothness, shape


def line(number: int, asked: Request) -> str:
    """Number, then a checksum of all polynomials of the plan, or "refused"."""
    waypoints, limits, smoothness, shape = asked
    try:
        trajectory = segfmu.plan(waypoints, limits, smoothness=smoothness, shape=shape)
    except segfmu.InfeasibleError:
        return f"{number} refused"
    digest = hashlib.sha256()
    for axis in range(len(waypoints[0].position)):
        for values in trajectory.pieces(axis):
            digest.update(np.ascontiguousarray(values).tobytes())
    return f"{number} {digest.hexdigest()}"


def show(plans: int, seed: int) -> None:
    """Print a line for each request."""
    random = np.random.default_rng(seed)
    for number in range(plans):
        print(line(number, request(random)))


def compare(other: Path, plans: int, seed: int) -> int:
    """Print how many plans differ; the number."""
    found = []
    for root in (Path(__file__).parents[2], other.resolve()):
        command = [str(root / ".venv" / "bin" / "python"), __file__, "--plans", str(plans)]
        done = subprocess.run(
            [*command, "--seed", str(seed)], cwd=root, stdout=subprocess.PIPE, text=True, check=True
        )
        found.append(done.stdout.splitlines())
    differ = sum(a != b for a, b in zip(*found, strict=True))
    refused = sum(a.endswith("refused") for a in found[0])
    print(f"{plans} requests: {plans - refused} planned, {refused} refused, {differ} differ")
    return differ


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description="Numbers of random plans, of two versions.")
    parser.add_argument("--plans", type=int, default=8000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--against", type=Path)
    given = parser.parse_args()
    if given.against is None:
        show(given.plans, given.seed)
    else:
        sys.exit(compare(given.against, given.plans, given.seed) > 0)
