"""Motions of one axis as splines: within limits and a range of positions, for a given duration."""
