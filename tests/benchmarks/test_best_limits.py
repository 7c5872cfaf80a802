"""The shortest plan over all limits is none that no motion can be, and about that of our search."""

from __future__ import annotations

from benchmarks.best_limits import shortest_over_limits
from benchmarks.drive_friction import CASES, _plan, _task
from benchmarks.friction_program import Transfer, shortest_time


def test_it_is_between_a_linear_program_and_the_search_of_limits() -> None:
    (case,) = [c for c in CASES if c.name == "lab, bridge, 0.3 m/s"]
    waypoints, bounds, friction = _task(case, case.coulomb, case.viscous)
    ours, _ = _plan(case, "plateau", case.coulomb, case.viscous)
    best = shortest_over_limits(
        case.crane, waypoints, case.axis, bounds, friction, "plateau", ours, generations=20
    )
    moved = case.crane.trolley_mass + case.crane.bridge_mass
    optimum = shortest_time(
        Transfer(
            moved, case.crane.payload_mass, case.rope, case.crane.gravity, case.distance,
            case.force, case.velocity, case.coulomb, case.viscous,
        ),
        40, 1e-3,
    )
    assert optimum < best < 1.03 * ours
    assert ours < 1.01 * best
