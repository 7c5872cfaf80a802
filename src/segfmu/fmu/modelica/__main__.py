"""Write the package of the default mission again: `python -m segfmu.fmu.modelica FOLDER`."""

from __future__ import annotations

import sys
from pathlib import Path

from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.gantry_feedforward import interface as gantry_feedforward
from segfmu.fmu.modelica.package import write_package

if __name__ == "__main__":
    write_package(
        gantry_feedforward.native_spec(), gantry_crane.native_spec(), Path(sys.argv[1])
    )
