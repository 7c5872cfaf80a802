"""Loads Matplotlib, which reads the user's choices when it is imported."""

from __future__ import annotations

import os
import sys
from contextlib import suppress

from segfmu.errors import InputError, first_line

BACKEND = "MPLBACKEND"


def load_matplotlib() -> None:
    """Import it, also where the environment names a backend that it does not know: files need none.

    Raises
    ------
    InputError
        If it cannot read the user's matplotlibrc.
    """
    if "matplotlib" in sys.modules:
        return
    named = os.environ.pop(BACKEND, None)
    try:
        import matplotlib
    except ValueError as error:
        raise InputError(
            f"Matplotlib cannot read its file matplotlibrc: {first_line(error)}; mend it, or let "
            "the variable MATPLOTLIBRC name another one"
        ) from None
    finally:
        if named is not None:
            os.environ[BACKEND] = named
    if named:
        # as it does itself
        with suppress(ValueError):
            matplotlib.rcParams["backend"] = named
