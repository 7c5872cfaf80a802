"""Files with which other tools load both FMUs, connected and with a mission's values."""

from __future__ import annotations

import os
from collections.abc import Sequence
from importlib.metadata import version
from pathlib import Path

from segfmu.errors import BuildError
from segfmu.fmu.feedforward.interface import WAYPOINTS
from segfmu.fmu.gantry_crane.pair import GANTRY
from segfmu.fmu.native.archive import pack
from segfmu.fmu.pairs import native
from segfmu.fmu.standard import osp, ssp
from segfmu.fmu.standard.spec import Spec
from segfmu.fmu.standard.system import System, archive
from segfmu.folders import work_folder

PACKAGE = "mission.ssp"
STRUCTURE = "OspSystemStructure.xml"


def write_system(
    folder: Path, archives: Sequence[Path], specs: Sequence[Spec] | None = None,
    title: str = "", *, fmi: int = 2,
) -> list[Path]:
    """Write mission.ssp into the folder of the archives; for FMI 2.0 OspSystemStructure.xml too.

    libcosim, which reads the latter, has no FMI 3.0.

    Parameters
    ----------
    folder
        That of the archives.
    archives
        Native FMUs of a planner and the crane that follows it.
    specs
        Their interfaces; by default GantryFeedforward and GantryCrane with the usual start values.
    title
        The mission's name.
    fmi
        Version of FMI of the archives.

    Raises
    ------
    BuildError
        When the folder cannot be written.
    """
    source, sink = native(specs or (GANTRY.planner(WAYPOINTS), GANTRY.plant()))
    system = System(title or "planner and crane", source, sink, fmi)
    entries = ssp.files(system, version("segfmu"))
    names = (PACKAGE, STRUCTURE) if fmi == 2 else (PACKAGE,)
    try:
        for spec, path in zip(system.specs, archives, strict=True):
            entries[f"{ssp.RESOURCES}/{archive(spec)}"] = path.read_bytes()
        with work_folder(folder) as work:
            pack(entries, work / PACKAGE)
            (work / STRUCTURE).write_bytes(osp.system_structure(system))
            for name in names:
                os.replace(work / name, folder / name)
    except OSError as error:
        raise BuildError(f"{folder}: cannot be written: {error.strerror}") from error
    return [folder / name for name in names]
