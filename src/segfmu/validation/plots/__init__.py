"""Plots (PNG) of plans, drives and runs, in the units and ranges of the field."""

from segfmu.validation.plots.drives import plot_drives
from segfmu.validation.plots.path import plot_path
from segfmu.validation.plots.plan import plot_plan
from segfmu.validation.plots.run import plot_run
from segfmu.validation.plots.style import save

__all__ = ["plot_drives", "plot_path", "plot_plan", "plot_run", "save"]
