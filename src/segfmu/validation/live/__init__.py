"""A page on which a mission's crane is driven, with both FMUs in it."""

from segfmu.validation.live.page import live

__all__ = ["live"]
