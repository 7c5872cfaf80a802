"""A load with a spreader."""

from segfmu.crane.spreader.model import SpreaderCrane

__all__ = ["SpreaderCrane"]
