"""The gantry crane: parameters, equations of motion, flat inverse, sway feedback."""

from segfmu.crane.feedback import SwayFeedback
from segfmu.crane.inverse import FlatInverse
from segfmu.crane.parameters import Crane

__all__ = ["Crane", "FlatInverse", "SwayFeedback"]
