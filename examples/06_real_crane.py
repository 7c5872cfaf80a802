"""The same move on an ideal crane and on a real one: drives, friction, sensors, wind."""

import numpy as np

import segfmu
from segfmu.crane import Drive, Friction, Gust, Plant, Rig, Sensors, Setpoints, Wind
from segfmu.crane.feedback import design
from segfmu.crane.sensors import resolution

crane = segfmu.Crane(bridge_mass=2.2, trolley_mass=1.155, payload_mass=1.0)
limits = segfmu.Limits(0.3, 0.5, 2.0, 20.0)
waypoints = [segfmu.Waypoint([0.0, 0.0, -0.7]), segfmu.Waypoint([0.5, 0.3, -0.5])]
trajectory = segfmu.plan(waypoints, limits)
feedforward = segfmu.FlatInverse(crane, trajectory)
feedback = design(crane, sample_time=0.01, shortest=0.3, longest=1.0, driven=True)

drive = Drive(lag=0.025, force_max=60.0, acceleration_max=1.0)
angle = resolution(4096)
real = Rig(
    drive, drive, drive,
    friction=Friction(viscous=(100.0, 82.0, 75.0), coulomb=(5.0, 7.5, 10.0), sway=0.005),
    sensors=Sensors(sample_time=0.01, dead_time=0.01, resolution=(1e-4, 1e-4, 1e-4, angle, angle)),
    wind=Wind(gust=Gust(start=1.0, duration=0.5, force=(0.3, 0.0, 0.0)), seed=1),
)


def setpoints(time: float) -> Setpoints:
    return Setpoints(feedforward.force(time), feedforward.velocity(time), feedforward.state(time))


print("velocity drives, 1 ms      largest error  sway left    work    dissipated  imbalance")
for name, rig, enabled in (
    ("ideal, feedforward", Rig(), False),
    ("real, feedforward", real, False),
    ("real, with feedback", real, True),
):
    start = feedforward.state(0.0)
    plant = Plant(crane, start, setpoints(0.0), feedback, driven=True, enabled=enabled, rig=rig)
    error = sway = 0.0
    for time in np.arange(1, 1000 * (trajectory.duration + 2.0)) * 1e-3:
        plant.step(1e-3, setpoints(time))
        error = max(error, float(np.linalg.norm(plant.load[0] - trajectory(time))))
        if time >= trajectory.duration + 1.0:
            sway = max(sway, float(np.abs(plant.state[3:5]).max()))
    found = plant.balance
    print(
        f"{name:26s} {1e3 * error:8.3f} mm {np.degrees(sway):8.4f} deg {found.drives:8.3f} J "
        f"{found.dissipated:8.3f} J {found.imbalance:10.1e} J"
    )
