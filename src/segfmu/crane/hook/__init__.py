"""The crane with a hook: parameters, equations, inverse and feedback."""

from segfmu.crane.hook.feedback import HookController, HookFeedback, HookWeights, design_hook
from segfmu.crane.hook.parameters import HookCrane

__all__ = ["HookController", "HookCrane", "HookFeedback", "HookWeights", "design_hook"]
