"""An FMU whose output has a probability in closed form (rare_failures.py builds it).

Its parameters are even from -1 to 1. Their sum as standard normal numbers, over the root of their
number, is one itself; y is 10 more, so that it is positive.
"""

from math import sqrt
from statistics import NormalDist

from pythonfmu import Fmi2Causality, Fmi2Slave, Fmi2Variability, Real

NAMES, MEAN = "abcde", 10.0
# the numbers next to 0 and 1 for which the normal distribution has a value
LEAST = 1e-16


class SumOfNormals(Fmi2Slave):  # type: ignore[misc]
    """y = 10 + (z(a) + z(b) + z(c) + z(d) + z(e)) / sqrt(5)."""

    def __init__(self, **kwargs: object) -> None:
        super().__init__(**kwargs)
        self.y = MEAN
        for name in NAMES:
            setattr(self, name, 0.0)
            self.register_variable(Real(
                name, causality=Fmi2Causality.parameter, variability=Fmi2Variability.tunable,
                start=0.0,
            ))
        self.register_variable(Real("y", causality=Fmi2Causality.output))

    def exit_initialization_mode(self) -> None:
        """All parameters are set."""
        shares = [0.5 + 0.5 * getattr(self, name) for name in NAMES]
        normal = NormalDist()
        numbers = [normal.inv_cdf(min(max(s, LEAST), 1.0 - LEAST)) for s in shares]
        self.y = MEAN + sum(numbers) / sqrt(len(NAMES))

    def do_step(self, current_time: float, step_size: float) -> bool:
        """Nothing changes."""
        return True
