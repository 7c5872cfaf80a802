"""Entry point of the command `segfmu`: whatever stops it, at any time, ends it in one line.

Only the standard library is imported here. A signal during the imports of the rest ends the process
at once, as there is nothing to clean up yet; later it raises SystemExit, so that temporary folders
and processes go. It is raised again every second, because it may come where it is swallowed: in
callbacks, and in imports by other packages. A second signal kills.
"""

from __future__ import annotations

import os
import signal
import sys
from types import FrameType

TEXTS = {signal.SIGINT: b"segfmu: interrupted\n", signal.SIGTERM: b"segfmu: terminated\n"}
AGAIN = 1.0  # s


def main() -> None:
    """Run the command line and exit with its code; 130 for Ctrl-C, 143 for SIGTERM."""
    _handle(_end)
    from segfmu.cli import run

    stop = _Stop()
    _handle(stop)
    try:
        code = run()
    except BaseException:
        # a stop within an import, or a callback, can come out as another exception
        if not stop.code:
            raise
        code = stop.code
    finally:
        # what was asked is done; a signal while the interpreter ends would be a traceback
        stop.finish()
        _handle(signal.SIG_IGN)
    sys.exit(stop.code or code)


class _Stop:
    """The handler of signals while the command runs."""

    def __init__(self) -> None:
        self.code = 0

    def __call__(self, number: int, _: FrameType | None) -> None:
        self.code = 128 + number
        _handle(signal.SIG_DFL)
        os.write(2, TEXTS[signal.Signals(number)])
        # nothing that follows from the stop is news
        sys.stderr = open(os.devnull, "w", encoding="utf-8")  # noqa: SIM115
        if hasattr(signal, "setitimer"):
            signal.signal(signal.SIGALRM, self._again)
            signal.setitimer(signal.ITIMER_REAL, AGAIN, AGAIN)
        sys.exit(self.code)

    def _again(self, number: int, _: FrameType | None) -> None:
        sys.exit(self.code)

    def finish(self) -> None:
        if self.code and hasattr(signal, "setitimer"):
            signal.setitimer(signal.ITIMER_REAL, 0.0)


def _handle(action: object) -> None:
    for number in TEXTS:
        signal.signal(number, action)  # type: ignore[arg-type]


def _end(number: int, _: FrameType | None) -> None:
    os.write(2, TEXTS[signal.Signals(number)])
    os._exit(128 + number)


if __name__ == "__main__":
    main()
