"""A browser for the tests of reports, and the one reason to skip where there is none."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, sync_playwright

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome")
PLACE = next(filter(None, map(shutil.which, NAMES)), "")
needs_browser = pytest.mark.skipif(
    not PLACE, reason=f"no browser found ({', '.join(NAMES)}): apt-get install chromium"
)
DESK, PHONE = (1280, 900), (390, 844)


@contextmanager
def chromium() -> Iterator[Browser]:
    """The browser that is installed, without a window."""
    with sync_playwright() as play:
        browser = play.chromium.launch(executable_path=PLACE, args=["--no-sandbox"])
        try:
            yield browser
        finally:
            browser.close()


def opened(
    browser: Browser, report: Path, size: tuple[int, int] = DESK, scheme: str = "light"
) -> tuple[Page, list[str]]:
    """A page with all charts drawn, and what it complains about or asks the network for."""
    page = browser.new_page(viewport={"width": size[0], "height": size[1]}, color_scheme=scheme)
    found: list[str] = []
    page.on("console", lambda m: found.append(m.text) if m.type in ("error", "warning") else None)
    page.on("pageerror", lambda error: found.append(str(error)))
    page.on("dialog", lambda dialog: (found.append(dialog.message), dialog.dismiss()))
    page.on("request", lambda r: None if r.url == report.as_uri() else found.append(r.url))
    page.goto(report.as_uri())
    page.wait_for_selector("body[data-drawn=yes]", timeout=120_000)
    return page, found
