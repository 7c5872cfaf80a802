"""JUnit XML, which servers show as tests: what suites and campaigns share."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from xml.etree import ElementTree as xml

from segfmu.cosim.result import replacing
from segfmu.validation.requirements import Requirement


def add_test(
    suite: xml.Element, where: str, name: str, outcome: str = "", message: str = ""
) -> None:
    """A test; `outcome` is "failure", "error" or "skipped", or empty for one that passed."""
    entry = xml.SubElement(suite, "testcase", classname=plain(where), name=plain(name))
    if outcome:
        xml.SubElement(entry, outcome, message=plain(message))
    elif message:
        xml.SubElement(entry, "system-out").text = plain(message)


def add_requirements(root: xml.Element, every: Sequence[Requirement]) -> None:
    """A test for every requirement; one without evidence is an error."""
    if not every:
        return
    suite = xml.SubElement(root, "testsuite", name="requirements")
    for one in every:
        told = "; ".join(f"{e.criterion}: {e.found}" for e in one.evidence)
        outcome = {True: "", False: "failure", None: "error"}[one.holds]
        message = f"{one.verdict}: {told or 'no criterion names it'}" if outcome else told
        add_test(suite, "requirements", one.name, outcome, message)


def write_tests(path: Path, root: xml.Element) -> None:
    """Write all test suites with their counts.

    Raises
    ------
    InputError
        When the file cannot be written.
    """
    kinds = (("failures", "failure"), ("errors", "error"), ("skipped", "skipped"))
    for suite in root.findall("testsuite"):
        for count, outcome in kinds:
            suite.set(count, str(len(suite.findall(f"testcase/{outcome}"))))
        suite.set("tests", str(len(suite)))
    with replacing(path) as temporary:
        xml.ElementTree(root).write(temporary, encoding="utf-8", xml_declaration=True)


def plain(text: str) -> str:
    """Without characters that XML does not have."""
    return "".join(c for c in text if c.isprintable())
