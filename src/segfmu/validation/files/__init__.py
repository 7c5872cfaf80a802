"""Crane, mission and scenario files: what they may hold, read, checked, described."""
