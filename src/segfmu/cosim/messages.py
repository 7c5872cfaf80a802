"""Messages of FMUs: records of the logger `segfmu.cosim`, each text once, and lines on stderr."""

from __future__ import annotations

import logging
import sys
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager

LOGGER = logging.getLogger("segfmu.cosim")

# fmi2Status, fmi3Status: level of each status; the last is "pending"
OK, WARNING, DISCARD, ERROR, FATAL = range(5)
LEVELS = (logging.INFO, logging.WARNING, logging.WARNING, logging.ERROR, logging.CRITICAL,
          logging.INFO)
CATEGORIES = {
    "logStatusWarning": logging.WARNING, "logStatusDiscard": logging.WARNING,
    "logStatusError": logging.ERROR, "logStatusFatal": logging.CRITICAL,
}
# limit of different texts per FMU, because texts with a time are all different
MOST_TEXTS = 100


class Messages:
    """The messages of one FMU.

    A text is logged when it first comes; its count is logged at the end. A record's text begins
    with the FMU's name, which is also its attribute `fmu`. Its level follows from status or
    category, whichever is worse.

    Parameters
    ----------
    name : str
        The FMU's.
    """

    def __init__(self, name: str) -> None:
        self._name = name
        self._counts: Counter[tuple[int, str]] = Counter()
        self._left_out = 0
        self._reasons: list[str] = []

    def hear(self, status: int, category: bytes | None, message: bytes | None) -> None:
        """Take a message from the FMU's callback; invalid UTF-8 is replaced."""
        text = (message or b"").decode("utf-8", "replace").strip()
        if not text:
            return
        if status >= DISCARD and len(self._reasons) < MOST_TEXTS:
            self._reasons.append(text)
        known = LEVELS[status] if 0 <= status < len(LEVELS) else logging.WARNING
        named = CATEGORIES.get((category or b"").decode("utf-8", "replace"), logging.NOTSET)
        key = (max(known, named), text)
        if key not in self._counts and len(self._counts) >= MOST_TEXTS:
            self._left_out += 1
            return
        self._counts[key] += 1
        if self._counts[key] == 1:
            self._log(*key)

    def reason(self) -> str | None:
        """The FMU's message for the error that ended the simulation, in one line."""
        return self._reasons[0].splitlines()[-1] if self._reasons else None

    def close(self) -> None:
        """Log the counts of repeated texts, and how many were omitted."""
        for (level, text), count in self._counts.items():
            if count > 1:
                self._log(level, f"said {count} times: {text}")
        if self._left_out:
            self._log(logging.WARNING, f"{self._left_out} further messages were omitted")
        self._counts.clear()
        self._reasons.clear()
        self._left_out = 0

    def _log(self, level: int, text: str) -> None:
        LOGGER.log(level, "%s: %s", self._name, text, extra={"fmu": self._name})


class _Lines(logging.Handler):
    """Collects records as lines `warning: GantryCrane: ...`, with their levels."""

    def __init__(self) -> None:
        super().__init__(logging.INFO)
        self.kept: list[tuple[int, str]] = []

    def emit(self, record: logging.LogRecord) -> None:
        words = " ".join(record.getMessage().split())
        # control characters are shown as escapes
        shown = "".join(c if c.isprintable() else ascii(c)[1:-1] for c in words)
        self.kept.append((record.levelno, f"{record.levelname.lower()}: {shown}"))


@contextmanager
def on_stderr() -> Iterator[None]:
    """Print the messages of FMUs at the end, one line each, on stderr.

    Errors are printed only if no exception ends the simulation, as it contains them.
    """
    lines = _Lines()
    before, propagates = LOGGER.level, LOGGER.propagate
    LOGGER.addHandler(lines)
    LOGGER.setLevel(logging.INFO)
    LOGGER.propagate = False
    most = logging.WARNING
    try:
        yield
        most = logging.CRITICAL
    finally:
        LOGGER.removeHandler(lines)
        LOGGER.setLevel(before)
        LOGGER.propagate = propagates
        for level, line in lines.kept:
            if level <= most:
                print(line, file=sys.stderr)
