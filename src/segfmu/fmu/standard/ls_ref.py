"""FMI-LS-REF: related files of an FMU with their roles, and experiments that can be repeated.

The layered standard (modelica/fmi-ls-ref, draft 1.0.0-alpha.1) is a manifest in the archive's
folder `extra`. Experiments are written in the format that it names, MA-HS-Experiments
(modelica/ma-hs-experiments), a draft as well: the times of an experiment are attributes of its
element `TransientSimulation`, in texts before that of `Experiment` itself. Both are read.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from xml.etree import ElementTree as ET

from segfmu.fmu.standard.fmi2 import document

FOLDER = "extra/org.fmi-standard.fmi-ls-ref"
MANIFEST = f"{FOLDER}/fmi-ls-manifest.xml"
NOTES = "documentation/fmi-ls-ref.txt"
NAMESPACE = "http://fmi-standard.org/fmi-ls-manifest"
ABOUT = {
    "xmlns:fmi-ls": NAMESPACE,
    "fmi-ls:fmi-ls-name": "org.fmi-standard.fmi-ls-ref",
    "fmi-ls:fmi-ls-version": "1.0.0-alpha.1",
    "fmi-ls:fmi-ls-description":
        "Layered Standard providing information on related files included in an FMU.",
}
# types of files
EXPERIMENTS, PARAMETERS = "application/x-ma-hs-experiments", "application/x-ssp-parameter-set"
TABLE, JSON, ANY = "text/csv", "application/json", "application/octet-stream"
TIMES = ("startTime", "stopTime", "stepSize")
# elements of an experiment that can be repeated
PARTS = ("Parameters", "Stimuli", "References", "Annotations", "TransientSimulation")


@dataclass(frozen=True)
class Related:
    """A file of an archive, or elsewhere.

    Attributes
    ----------
    source : str
        Its URI, relative to the manifest.
    role : str
        As "result", or with a part, "experiment/smoke-test".
    type : str
        MIME type.
    description : str
    """

    source: str
    role: str
    type: str = ANY
    description: str = ""


@dataclass(frozen=True)
class File:
    """A file of an experiment: its URI, relative to that of the experiments, and MIME type."""

    source: str
    type: str


@dataclass(frozen=True)
class Experiment:
    """A simulation of the FMU alone.

    Attributes
    ----------
    name : str
    start, stop, step : float or None
        Times of the experiment and communication step [s]; None: those of the model description.
    parameters, stimuli, references : File or None
        Start values, inputs over time, and results that are expected.
    other : str
        An element that it has and that is not known here; empty without.
    """

    name: str
    start: float | None = None
    stop: float | None = None
    step: float | None = None
    parameters: File | None = None
    stimuli: File | None = None
    references: File | None = None
    other: str = ""


def manifest(files: Sequence[Related]) -> bytes:
    """The text of a manifest."""
    root = ET.Element("fmiReferences", ABOUT)
    for file in files:
        ET.SubElement(root, "Related", {
            "type": file.type, "source": file.source, "role": file.role,
            "description": file.description,
        })
    return document(root)


def experiments(name: str, listed: Sequence[Experiment]) -> bytes:
    """The text of a file of experiments."""
    root = ET.Element("Experiments", {"name": name})
    for one in listed:
        element = ET.SubElement(root, "Experiment", {"name": one.name})
        given = zip(TIMES, (one.start, one.stop, one.step), strict=True)
        times = {key: repr(value) for key, value in given if value is not None}
        ET.SubElement(element, "TransientSimulation", times)
        for key, file in (
            ("Parameters", one.parameters), ("Stimuli", one.stimuli),
            ("References", one.references),
        ):
            if file is not None:
                ET.SubElement(element, key, {"source": file.source, "type": file.type})
    return document(root)


def read_manifest(text: bytes) -> list[Related]:
    """What a manifest lists.

    Raises
    ------
    ValueError
        For a text that is none.
    """
    root = _root(text, "fmiReferences")
    return [
        Related(
            e.get("source", ""), e.get("role", ""), e.get("type", ANY), e.get("description", "")
        )
        for e in root if _name(e) == "Related"
    ]


def read_experiments(text: bytes) -> list[Experiment]:
    """Experiments of a file; those that do not simulate over time have another element.

    Raises
    ------
    ValueError
        For a text that is none of experiments, and times that are no numbers.
    """
    found = []
    for element in _root(text, "Experiments"):
        parts = {_name(e): e for e in element}
        timed = parts.get("TransientSimulation", element)
        if _name(element) != "Experiment":
            continue
        parameters, stimuli, references = (
            _file(parts.get(name), usual) for name, usual in
            (("Parameters", PARAMETERS), ("Stimuli", TABLE), ("References", TABLE))
        )
        start, stop, step = (_number(timed.get(name)) for name in TIMES)
        other = next((name for name in parts if name not in PARTS), "")
        name = element.get("name", "")
        found.append(
            Experiment(name, start, stop, step, parameters, stimuli, references, other)
        )
    if not found:
        raise ValueError("has no experiment")
    return found


def _root(text: bytes, name: str) -> ET.Element:
    try:
        root = ET.fromstring(text)
    except ET.ParseError as error:
        raise ValueError(f"no XML: {error}") from None
    if _name(root) != name:
        raise ValueError(f"its element is {_name(root)}, not {name}")
    return root


def _name(element: ET.Element) -> str:
    """Its name without a namespace."""
    return element.tag.rpartition("}")[2]


def _file(element: ET.Element | None, usual: str) -> File | None:
    return None if element is None else File(element.get("source", ""), element.get("type", usual))


def _number(text: str | None) -> float | None:
    return None if text is None else float(text)
