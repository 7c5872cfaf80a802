"""Reports: one HTML file for a run or a suite, which opens without a network."""

from segfmu.validation.report.page import write
from segfmu.validation.report.run_page import run_page
from segfmu.validation.report.suite_page import suite_page

__all__ = ["run_page", "suite_page", "write"]
