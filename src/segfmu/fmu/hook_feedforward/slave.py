"""HookFeedforward on PythonFMU: the planner of the gantry crane, with hook and sling."""

from __future__ import annotations

import numpy as np

from segfmu.crane.hook import HookCrane
from segfmu.crane.kinds import AnyCrane
from segfmu.errors import InfeasibleError
from segfmu.fmu.gantry_feedforward.slave import FeedforwardSlave
from segfmu.fmu.hook_feedforward import interface as hook_feedforward
from segfmu.kernels.clearance.records import SpaceFault, SpaceStatus
from segfmu.kernels.hook.records import HookFeedforward
from segfmu.kernels.messages import SPACE
from segfmu.planning import Trajectory


class HookFeedforwardSlave(FeedforwardSlave):
    """The slave; it takes no commands."""

    spec = hook_feedforward.spec()
    results = HookFeedforward
    takes_commands = False

    def crane(self) -> HookCrane:
        """The crane that the parameters describe."""
        return HookCrane.of(self.value)

    def require_taut(self, crane: AnyCrane, trajectory: Trajectory) -> None:
        """The same, and refuse obstacles for the rope, whose path is not judged."""
        super().require_taut(crane, trajectory)
        for i in range(int(self.value("obstacle.count"))):
            if self.value(f"obstacle[{i + 1}].rope"):
                fault = np.zeros(SpaceFault.SIZE)
                fault[SpaceFault.BOX] = i
                raise InfeasibleError(SPACE.text(SpaceStatus.SLING, fault.tolist()))
