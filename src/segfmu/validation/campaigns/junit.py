"""The criteria of a campaign as JUnit XML: one test each, over all runs."""

from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree as xml

from segfmu.validation.campaigns.result import CampaignResult
from segfmu.validation.campaigns.summary import Summary
from segfmu.validation.campaigns.tables import case
from segfmu.validation.junit import add_requirements, add_test, plain, write_tests


def write_junit(path: Path, result: CampaignResult) -> None:
    """Write a test for every criterion, one for the runs without a verdict, and the requirements.

    Raises
    ------
    InputError
        When the file cannot be written.
    """
    root = xml.Element("testsuites", name="segfmu campaign")
    suite = xml.SubElement(root, "testsuite", name=plain(result.name))
    for row in result.summaries:
        add_test(suite, result.name, row.criterion, _outcome(row), _told(result, row))
    if result.errors:
        (run, error), *more = result.errors
        others = f", and {len(more)} more" if more else ""
        add_test(suite, result.name, "all runs end", "error", f"run {run}: {error}{others}")
    add_requirements(root, result.requirements)
    write_tests(path, root)


def _outcome(row: Summary) -> str:
    if row.judged == 0:
        return "error"
    return "" if row.held == row.judged else "failure"


def _told(result: CampaignResult, row: Summary) -> str:
    if row.run is None:
        return "no run came to a verdict"
    rate = "" if row.fails is None else f"; fails (95 %): {row.fails}"
    return (
        f"{row.held} of {row.judged} runs hold it{rate}; least margin {row.least} in run "
        f"{row.run}: {case(result.values(row.run))}; {result.command(row.run)}"
    )
