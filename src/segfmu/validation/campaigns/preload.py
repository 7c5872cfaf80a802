"""What Dask calls in each new worker of this machine."""

from __future__ import annotations

import signal
import tempfile
from typing import Any


def dask_setup(worker: Any) -> None:
    """Leave Ctrl-C to the command, and temporary files to the folder that it removes."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    tempfile.tempdir = worker.local_directory
