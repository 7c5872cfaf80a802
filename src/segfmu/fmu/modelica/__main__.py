"""Write the package of the usual start values again: `python -m segfmu.fmu.modelica FOLDER`."""

from __future__ import annotations

import sys
from pathlib import Path

from segfmu.fmu.modelica.package import write_package

if __name__ == "__main__":
    write_package(Path(sys.argv[1]))
