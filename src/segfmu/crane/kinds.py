"""What every crane has that there is a model of."""

from __future__ import annotations

from typing import Protocol

from segfmu.crane.parameters import Crane


class AnyCrane(Protocol):
    """Parameters of a model in `segfmu.crane.flat_models`."""

    @property
    def crane(self) -> Crane:
        """Carriages, load, gravity and rope range."""

    @property
    def masses(self) -> tuple[float, ...]:
        """The kernels' masses: bridge, trolley, load, gravity, then those of the model."""

    @property
    def suspension(self) -> int:
        """Code of the model in `kernels/crane/suspension.py`."""

    @property
    def tackle(self) -> tuple[float, float]:
        """Mass [kg] and length [m] of what is between rope and load."""

    @property
    def gravity(self) -> float:
        """[m/s2]"""

    @property
    def weight(self) -> float:
        """Of what hangs on the rope [N]."""

    def values(self) -> dict[str, float]:
        """As FMU variables; a rope bound of 0 means none."""
