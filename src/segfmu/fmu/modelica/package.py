"""The Modelica package Segfmu: classes made from the specifications, others written by hand."""

from __future__ import annotations

import os
import shutil
import zipfile
from collections.abc import Sequence
from importlib.resources import files
from importlib.resources.abc import Traversable
from pathlib import Path

from segfmu.errors import BuildError
from segfmu.fmu.feedforward.interface import WAYPOINTS
from segfmu.fmu.modelica.declarations import UNUSED
from segfmu.fmu.modelica.drawing import HALF_WIDTH, extent, half_height
from segfmu.fmu.modelica.names import identifier, quoted, title
from segfmu.fmu.modelica.wrapper import wrapper
from segfmu.fmu.models import named
from segfmu.fmu.pairs import PAIRS
from segfmu.fmu.standard.spec import Spec
from segfmu.folders import make_folders, work_folder

LIBRARY = files("segfmu.fmu.modelica").joinpath("library")
CLASSES = ("Examples", *(pair.coupled[0] for pair in PAIRS), "PlainCrane", "Interfaces",
           "Types", "FMI")
NAME = "Segfmu"
# in the package, unpacked
FMUS = Path("Resources", "FMUs")


def write_package(
    folder: Path, specs: Sequence[Spec] | None = None, archives: Sequence[Path] = ()
) -> Path:
    """Write the package into a folder, with the archives unpacked in it where some are given.

    Parameters
    ----------
    folder
        In which the package becomes a folder.
    specs
        Interfaces with other than the usual start values.
    archives
        Native FMUs of FMI 2.0 of these interfaces.

    Returns
    -------
    Path
        Its package.mo.

    Raises
    ------
    BuildError
        When the folder cannot be written.
    """
    target = folder / NAME
    given = {own.name: own for own in specs or ()}
    usual = (own for models in PAIRS for own in (models.planner(WAYPOINTS), models.plant()))
    every = [given.get(own.name, own) for own in usual]
    try:
        make_folders(folder)
        with work_folder(folder) as work:
            for name, text in package([named(own.name).native_spec(own) for own in every]).items():
                path = work / name
                make_folders(path.parent)
                path.write_bytes(text)
            for archive in archives:
                _unpack(archive, work / FMUS / archive.stem)
            for archive in archives:
                shutil.rmtree(target / FMUS / archive.stem, ignore_errors=True)
            _place(work, target)
    except OSError as error:
        raise BuildError(f"{target}: cannot be written: {error.strerror}") from error
    return target / "package.mo"


def package(specs: Sequence[Spec]) -> dict[str, bytes]:
    """All files of the package but the FMUs, by their paths in it; specs: all native interfaces."""
    found, named_specs = _library(LIBRARY, ""), {spec.name: spec for spec in specs}
    texts = {
        "Types.mo": _types(specs),
        "package.order": "\n".join((*named_specs, *CLASSES, "")),
    }
    described = " ".join(models.described for models in PAIRS)
    texts["package.mo"] = found["package.mo"].decode().replace("{MODELS}", described)
    for models in PAIRS:
        name, crane = models.coupled
        feedforward, plant = (named_specs[own] for own in models.names)
        texts[f"{name}.mo"] = coupled(name, feedforward, crane, plant)
    for spec in specs:
        texts[f"{spec.name}.mo"] = wrapper(spec)
    return found | {name: text.encode() for name, text in texts.items()}


def _library(folder: Traversable, prefix: str) -> dict[str, bytes]:
    found: dict[str, bytes] = {}
    for entry in folder.iterdir():
        if entry.is_dir():
            found |= _library(entry, f"{prefix}{entry.name}/")
        else:
            found[prefix + entry.name] = entry.read_bytes()
    return found


def _place(work: Path, target: Path) -> None:
    """Move all files of a folder into another one, which may have others; all are complete."""
    for path in work.rglob("*"):
        if path.is_file():
            place = target / path.relative_to(work)
            make_folders(place.parent)
            os.replace(path, place)


def _unpack(archive: Path, target: Path) -> None:
    """What running an FMU needs: its description, binaries and resources."""
    with zipfile.ZipFile(archive) as entries:
        for name in entries.namelist():
            if name.startswith(("modelDescription.xml", "binaries/", "resources/")):
                entries.extract(name, target)


def _types(specs: Sequence[Spec]) -> str:
    lines = ["within Segfmu;", 'package Types "Enumerations of the parameters"']
    for one in dict.fromkeys(e for spec in specs for e in spec.enumerations):
        lines.append(
            f"  type {one.name} = enumeration({', '.join(one.items)}) {quoted(one.description)};"
        )
    return "\n".join((*lines, "end Types;", ""))


def coupled(label: str, feedforward: Spec, own: str, crane: Spec) -> str:
    """The text of a class in which both FMUs are connected by name; own: the crane's name in it."""
    sources = {v.name for v in feedforward.where("output")}
    shared = [v.name for v in crane.where("input") if v.name in sources]
    high = max(half_height(feedforward), half_height(crane))
    middle = HALF_WIDTH + 100
    lines = [
        "within Segfmu;",
        f'partial model {label} "{feedforward.name} and {crane.name}, connected by name"',
        *(
            f"  {spec.name} {name} annotation(Placement(transformation(origin = {{{x}, 0}}, "
            f"{extent(0, 0, HALF_WIDTH, half_height(spec))})));"
            for spec, name, x in (
                (feedforward, "feedforward", -middle), (crane, own, middle)
            )
        ),
        "equation",
        *(
            f"  connect(feedforward.{identifier(n)}, {own}.{identifier(n)}) "
            "annotation(Line(color = {0, 0, 127}));"
            for n in shared
        ),
        f"  annotation(Diagram(coordinateSystem({extent(0, 0, 2 * middle, high + 60)})));",
        f"end {label};", "",
    ]
    left = {title(v.name) for v in crane.where("input") if v.name not in sources}
    if not left <= set(UNUSED):
        raise AssertionError(f"inputs without a source: {left}")
    return "\n".join(lines)
