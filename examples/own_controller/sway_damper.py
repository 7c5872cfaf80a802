"""A controller of one's own as an FMU: it leans the trolley's velocity on the measured sway.

Build it with: pythonfmu build -f sway_damper.py
"""

from pythonfmu import Fmi2Causality, Fmi2Slave, Fmi2Variability, Real


class SwayDamper(Fmi2Slave):
    """command = velocity - gain * sway angle; the trolley follows the load."""

    def __init__(self, **kwargs):
        super().__init__(**kwargs)
        self.velocity = 0.0
        self.angle = 0.0
        self.command = 0.0
        self.gain = 1.0
        self.register_variable(Real("velocity", causality=Fmi2Causality.input, start=0.0))
        self.register_variable(Real("angle", causality=Fmi2Causality.input, start=0.0))
        self.register_variable(Real("command", causality=Fmi2Causality.output))
        self.register_variable(Real(
            "gain", causality=Fmi2Causality.parameter, variability=Fmi2Variability.tunable,
            start=1.0,
        ))

    def do_step(self, current_time, step_size):
        self.command = self.velocity - self.gain * self.angle
        return True
