"""A real crane kept at its plan from measured signals: two designs, their stability, a table."""

import numpy as np

import segfmu
from segfmu.crane import (
    Compensation,
    Drive,
    Feedforward,
    Gust,
    Plant,
    Rig,
    Sensors,
    Setpoints,
    TrackingController,
    Wind,
    design_flat,
    design_lqr,
    design_observer,
    stability_map,
)
from segfmu.crane.sensors import resolution

crane = segfmu.Crane(bridge_mass=2.2, trolley_mass=1.155, payload_mass=1.0)
limits = segfmu.Limits(0.22, 0.3, 0.8, 6.0)
waypoints = [segfmu.Waypoint([-0.25, -0.3, -0.8]), segfmu.Waypoint([0.25, 0.3, -0.7])]
inverse = segfmu.FlatInverse(crane, segfmu.plan(waypoints, limits))

lag = (0.025, 0.025, 0.025)
drive, angle = Drive(lag[0]), resolution(4096)
sensors = Sensors(sample_time=0.01, dead_time=0.01, resolution=(1e-4, 1e-4, 1e-4, angle, angle))
gust = Wind(gust=Gust(start=0.5, duration=0.8, force=(1.0, 0.7, 0.0)))
real = Rig(drive, drive, drive, sensors=sensors, wind=gust)

ranges = {"sample_time": 0.01, "shortest": 0.16, "longest": 0.98, "driven": True}
observer = design_observer(crane, lag=lag, delayed=True, **ranges)
feedforward = Feedforward(inverse, Compensation(lag))
times = np.arange(0.0, inverse.trajectory.duration + 3.0, 1e-3)
states, planned = inverse.state(times), inverse.trajectory(times)
rows = zip(feedforward.force(times), feedforward.velocity(times), states, strict=True)
setpoints = [Setpoints(*row) for row in rows]

print("gust, late encoders       RMS error   largest   sway left     eigenvalue")
for name, gains, enabled in (
    ("feedforward", design_lqr(crane, **ranges), False),
    ("with LQR", design_lqr(crane, **ranges), True),
    ("with flatness feedback", design_flat(crane, lag=max(lag), **ranges), True),
):
    controller = TrackingController(observer, gains, enabled=enabled)
    plant = Plant(crane, states[0], setpoints[0], controller, driven=True, rig=real)
    errors, sways = [0.0], [0.0]
    for given, position in zip(setpoints[1:], planned[1:], strict=True):
        plant.step(1e-3, given)
        errors.append(float(np.linalg.norm(plant.load[0] - position)))
        sways.append(float(np.abs(plant.state[3:5]).max()))
    grid = stability_map(controller, np.geomspace(0.16, 0.98, 5), [0.0, 1.0, 2.0], lag)
    print(
        f"{name:24s} {1e3 * np.sqrt(np.mean(np.square(errors))):7.2f} mm "
        f"{1e3 * max(errors):7.2f} mm "
        f"{np.degrees(max(sways[-1000:])):7.3f} deg   {grid.max():.4f}"
    )
