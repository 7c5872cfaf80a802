"""A Firefox to drive pages in, and the one reason to skip where there is none.

Playwright drives a Firefox of its own build alone, so this speaks Marionette, the protocol of every
Firefox.
"""

from __future__ import annotations

import json
import os
import shutil
import socket
import subprocess
import tempfile
import time
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path
from typing import Any

import pytest

NAMES = ("firefox", "firefox-esr")
PLACE = next(filter(None, map(shutil.which, NAMES)), "")
needs_firefox = pytest.mark.skipif(
    not PLACE, reason=f"no Firefox found ({', '.join(NAMES)}): apt-get install firefox-esr"
)
# s until it listens
PATIENCE = 60.0


class Firefox:
    """A session: messages are lists of a kind, a number, and what is asked or answered."""

    def __init__(self, port: int) -> None:
        self._link = socket.create_connection(("127.0.0.1", port))
        self._left, self._number = b"", 0
        self._receive()
        self.ask("WebDriver:NewSession", capabilities={})

    def close(self) -> None:
        """End the session; the browser goes on."""
        self._link.close()

    def _more(self) -> bytes:
        found = self._link.recv(65536)
        assert found, "Firefox has ended"
        return found

    def _receive(self) -> Any:
        while b":" not in self._left:
            self._left += self._more()
        size, _, rest = self._left.partition(b":")
        while len(rest) < int(size):
            rest += self._more()
        self._left = rest[int(size) :]
        return json.loads(rest[: int(size)])

    def ask(self, name: str, **words: Any) -> Any:
        """The result of a command."""
        self._number += 1
        told = json.dumps([0, self._number, name, words]).encode()
        self._link.sendall(b"%d:%s" % (len(told), told))
        _, _, error, result = self._receive()
        assert not error, f"{name}: {error['message']}"
        return result

    def value(self, script: str) -> Any:
        """What an expression has as its value in the page."""
        # evaluated among the page's own names
        script = f"return window.eval({json.dumps(script)})"
        return self.ask("WebDriver:ExecuteScript", script=script, args=[])["value"]

    def wait(self, condition: str, patience: float = PATIENCE) -> None:
        """Until an expression is true in the page."""
        end = time.monotonic() + patience
        while not self.value(condition):
            assert time.monotonic() < end, f"not within {patience} s: {condition}"
            time.sleep(0.05)

    def key(self, kind: str, value: str) -> None:
        """Press a key (keyDown) or let it go (keyUp)."""
        actions = [{"type": "key", "id": "keys", "actions": [{"type": kind, "value": value}]}]
        self.ask("WebDriver:PerformActions", actions=actions)


def _port(profile: Path) -> int:
    """Where a Firefox listens: it writes this once it does."""
    told = profile / "MarionetteActivePort"
    end = time.monotonic() + PATIENCE
    while not (told.exists() and told.read_text().strip()):
        assert time.monotonic() < end, "Firefox does not answer"
        time.sleep(0.1)
    return int(told.read_text())


@contextmanager
def firefox() -> Iterator[Firefox]:
    """A Firefox without a window, with an empty profile, on a port of its own."""
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        profile = Path(folder)
        (profile / "user.js").write_text('user_pref("marionette.port", 0);\n')
        process = subprocess.Popen(
            [PLACE, "--headless", "--marionette", "--no-remote", "--profile", folder],
            env=os.environ | {"HOME": folder}, stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        try:
            with closing(Firefox(_port(profile))) as found:
                yield found
        finally:
            process.terminate()
            process.wait()
