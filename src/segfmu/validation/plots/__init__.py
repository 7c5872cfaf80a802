"""Plots (PNG) of plans, drives and runs, in the units and ranges of the field."""

from segfmu.validation.plots.loading import load_matplotlib

# before a module of this package imports it
load_matplotlib()
