"""Build both FMUs, couple them, start with a swinging load, and watch the feedback work."""

import tempfile
from math import radians
from pathlib import Path

import numpy as np

from segfmu.cosim import simulate
from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.gantry_feedforward import interface as gantry_feedforward
from segfmu.fmu.python.archive import build_all

SPECS = gantry_feedforward.spec(), gantry_crane.spec()

with tempfile.TemporaryDirectory() as folder:
    feedforward, crane = build_all(Path(folder), specs=SPECS)
    for enabled in (False, True):
        rows = simulate(
            feedforward,
            crane,
            stop_time=7.0,
            step=0.005,
            sink_values={"sway.x.angle": radians(5.0), "feedback.enabled": enabled},
        )
        late = rows["time"] > 5.5
        sway = np.degrees(np.abs(rows["sway.x.angle"][late]).max())
        print(f"feedback {'on ' if enabled else 'off'}: sway after the move {sway:.4f} deg")
