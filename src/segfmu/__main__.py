"""Entry point of the command `segfmu`: whatever stops it, at any time, ends it in one line.

Only the standard library is imported here. A signal during the imports of the rest ends the process
at once, as there is nothing to clean up yet; later it raises SystemExit, so that temporary folders
and processes go. A second signal kills.
"""

from __future__ import annotations

import os
import signal
import sys
from types import FrameType

TEXTS = {signal.SIGINT: b"segfmu: interrupted\n", signal.SIGTERM: b"segfmu: terminated\n"}


def main() -> None:
    """Run the command line and exit with its code; 130 for Ctrl-C, 143 for SIGTERM."""
    _handle(_end)
    from segfmu.cli import run

    _handle(_leave)
    try:
        code = run()
    finally:
        _handle(_end)
    sys.exit(code)


def _handle(action: signal.Handlers | object) -> None:
    for number in TEXTS:
        signal.signal(number, action)  # type: ignore[arg-type]


def _end(number: int, _: FrameType | None) -> None:
    os.write(2, TEXTS[signal.Signals(number)])
    os._exit(128 + number)


def _leave(number: int, _: FrameType | None) -> None:
    _handle(signal.SIG_DFL)
    os.write(2, TEXTS[signal.Signals(number)])
    sys.exit(128 + number)


if __name__ == "__main__":
    main()
