"""Plots (PNG) of plans, drives and runs, in the units and ranges of the field."""

from segfmu.validation.plots.loading import load_matplotlib

load_matplotlib()

from segfmu.validation.plots.drives import plot_drives  # noqa: E402
from segfmu.validation.plots.path import plot_path  # noqa: E402
from segfmu.validation.plots.plan import plot_plan  # noqa: E402
from segfmu.validation.plots.run import plot_run  # noqa: E402
from segfmu.validation.plots.style import save  # noqa: E402

__all__ = ["plot_drives", "plot_path", "plot_plan", "plot_run", "save"]
