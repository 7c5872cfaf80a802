"""A clean end of processes that have loaded an FMU of the Python backend.

PythonFMU 0.7 keeps the interpreter's state in a global shared pointer of its library. When a
process ends, the C++ runtime destroys the pointer, and after it the library's own destructor
assigns to it: it counts references in freed memory, and now and then the process aborts. That
destructor is an exported function, `finalizePythonInterpreter`. Called while the pointer lives, as
here when Python ends, it empties the pointer, and nothing is left for both destructors. Windows
destroys in the right order.
"""

from __future__ import annotations

import atexit
import ctypes
import os
import sys
from pathlib import Path

_held: dict[Path, ctypes.CDLL] = {}


def release_at_exit(library: Path) -> None:
    """Let a loaded library of PythonFMU release the interpreter before the process ends.

    Parameters
    ----------
    library
        Path from which the importer has loaded it; where it has not, nothing happens.
    """
    if sys.platform != "linux" or library in _held:
        return
    try:
        # the reference keeps the library in memory until the function has been called
        found = ctypes.CDLL(str(library), mode=os.RTLD_NOW | os.RTLD_NOLOAD)
        function = found.finalizePythonInterpreter
    except (OSError, AttributeError):
        return
    function.restype, function.argtypes = None, ()
    _held[library] = found
    atexit.register(function)
