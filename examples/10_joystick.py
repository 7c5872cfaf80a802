"""A load under a joystick: pushed, released, held back by an end and a box, and sent home."""

import segfmu

crane = segfmu.Crane(2.2, 1.155, 1.0, rope_min=0.2, rope_max=0.9)
limits = segfmu.Limits(velocity=[0.4, 0.4, 0.3], acceleration=0.5, jerk=1.5, snap=10.0)
box = segfmu.Obstacle("box", [0.3, -0.2, -0.9], [0.5, 0.2, -0.55], margin=0.02)
space = segfmu.Clearance([box], minimum=[-1.0, -1.0, -0.9], maximum=[1.0, 1.0, -0.2])
bounds = segfmu.ActuatorBounds(velocity=0.6, acceleration=0.9)
operator = segfmu.Operator(crane, limits, [0.0, 0.0, -0.6], bounds=bounds, clearance=space)


def follow(what: str, duration: float) -> None:
    """Follow the command, with a step of 10 ms."""
    for _ in range(round(duration / 0.01)):
        operator.step(0.01)
    sway = operator.setpoints[6:8]
    print(f"{what:28s} {operator}, sway {max(abs(sway)):.1e} rad")


operator.command("velocity", velocity=[-0.3, 0.2, 0.0])
follow("pushed", 1.5)
operator.command("stop")
follow("released", 1.5)
operator.command("velocity", velocity=[0.0, 0.4, 0.0])
follow("against the end", 4.0)
operator.command("target", target=[0.0, 0.0, -0.6])
follow("back", 5.0)
operator.command("velocity", velocity=[0.4, 0.0, 0.0])
follow("against the box", 3.0)
operator.command("velocity", velocity=[0.4, 0.0, 0.2], scale=0.5)
follow("lifted over it, slowly", 8.0)
