"""A recording of commands, replayed: an emergency stop, and the swing that is taken over."""

import csv
from pathlib import Path

import segfmu

recording = Path(__file__).parents[1] / "models" / "commands" / "lab" / "emergency.csv"
crane = segfmu.Crane(2.2, 1.155, 1.0, rope_min=0.2, rope_max=0.9)
limits = segfmu.Limits(velocity=[0.4, 0.4, 0.3], acceleration=0.5, jerk=1.5, snap=10.0)
bounds = segfmu.ActuatorBounds(velocity=0.6, acceleration=[0.9, 0.9, 0.7])
operator = segfmu.Operator(crane, limits, [0.0, 0.0, -0.45], bounds=bounds)

with recording.open(newline="", encoding="utf-8") as file:
    rows = list(csv.DictReader(file))
ends = [float(row["time"]) for row in rows[1:]]
for row, end in zip(rows, [*ends, ends[-1] + 5.0], strict=True):
    # a row is held until the next one
    operator.command(
        row["command.mode"],
        velocity=[float(row[f"command.velocity.{a}"]) for a in "xyz"],
        target=[float(row[f"command.target.{a}"]) for a in "xyz"],
        scale=float(row["limits.scale"]),
    )
    while operator.time < end - 1e-9:
        operator.step(0.002)
    sway = abs(operator.setpoints[6:8]).max()
    print(f"until {end:4.2f} s: {operator}, sway {sway:.1e} rad")
