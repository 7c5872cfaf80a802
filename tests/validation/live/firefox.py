"""Pages to drive in Firefox: `python -m tests.validation.live.firefox`; it must be installed.

Playwright has no Firefox of its own here, so this speaks Marionette, the protocol of every Firefox.
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
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import segfmu

MODELS = Path(__file__).parents[3] / "models"
MISSIONS = ("inteco.toml", "container.toml")
PORT, RIGHT = 2828, "\ue014"


class Firefox:
    """A session: messages are lists of a kind, a number, and what is asked or answered."""

    def __init__(self) -> None:
        self._link = self._connected()
        self._left, self._number = b"", 0
        self._receive()
        capabilities = self.ask("WebDriver:NewSession", capabilities={})["capabilities"]
        self.version = capabilities["browserVersion"]

    @staticmethod
    def _connected() -> socket.socket:
        for _ in range(60):
            try:
                return socket.create_connection(("127.0.0.1", PORT))
            except OSError:
                time.sleep(0.5)
        raise SystemExit("Firefox does not answer")

    def _receive(self) -> Any:
        while b":" not in self._left:
            self._left += self._link.recv(65536)
        size, _, rest = self._left.partition(b":")
        while len(rest) < int(size):
            rest += self._link.recv(65536)
        self._left = rest[int(size) :]
        return json.loads(rest[: int(size)])

    def ask(self, name: str, **words: Any) -> Any:
        """The result of a command."""
        self._number += 1
        told = json.dumps([0, self._number, name, words]).encode()
        self._link.sendall(b"%d:%s" % (len(told), told))
        _, _, error, result = self._receive()
        if error:
            raise SystemExit(f"{name}: {error['message']}")
        return result

    def value(self, script: str) -> Any:
        """What a script returns in the page."""
        return self.ask("WebDriver:ExecuteScript", script=f"return {script}", args=[])["value"]


@contextmanager
def firefox() -> Iterator[Firefox]:
    """A Firefox without a window and with an empty profile."""
    place = shutil.which("firefox") or shutil.which("firefox-esr")
    if place is None:
        raise SystemExit("no Firefox found (firefox, firefox-esr)")
    with tempfile.TemporaryDirectory() as profile:
        process = subprocess.Popen(
            [place, "--headless", "--marionette", "--no-remote", "--profile", profile],
            env=os.environ | {"HOME": profile}, stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        try:
            yield Firefox()
        finally:
            process.terminate()
            process.wait()


def drive(browser: Firefox, page: Path) -> None:
    """Hold a key for three seconds; the load moves, and rests behind it."""
    browser.ask("WebDriver:Navigate", url=page.as_uri())
    while browser.value("document.body.dataset.drawn") != "yes":
        time.sleep(0.1)
    first = browser.value("document.getElementById('place').textContent")
    # the long rope of a ship-to-shore crane is slow
    browser.value("document.getElementById('pace').value = '5'")
    keys = [{"type": "keyDown", "value": RIGHT}, {"type": "pause", "duration": 3000},
            {"type": "keyUp", "value": RIGHT}]
    browser.ask("WebDriver:PerformActions", actions=[{"type": "key", "id": "k", "actions": keys}])
    time.sleep(8.0)
    rate, place, sway = (
        browser.value(f"document.getElementById('{name}').textContent")
        for name in ("rate", "place", "now")
    )
    print(f"{page.name}: from {first} to {place} m, sway {sway}; {rate}")
    assert place != first and sway == "0.000°", (place, sway)


def main() -> None:
    """Drive cranes of both sizes."""
    with tempfile.TemporaryDirectory() as folder, firefox() as browser:
        print("Firefox", browser.version)
        for name in MISSIONS:
            drive(browser, segfmu.live(MODELS / name, Path(folder) / f"{name}.html"))


if __name__ == "__main__":
    main()
