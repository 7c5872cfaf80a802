"""Reports: one HTML file for a run, a suite or a campaign, which opens without a network."""

from segfmu.validation.report.campaign_page import campaign_page
from segfmu.validation.report.page import write
from segfmu.validation.report.run_page import run_page
from segfmu.validation.report.suite_page import suite_page

__all__ = ["campaign_page", "run_page", "suite_page", "write"]
