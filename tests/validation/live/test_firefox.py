"""Pages on which a crane is driven, in Firefox: drawn, driven by keys, swing-free or swinging."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

import segfmu
from tests.campaign import soaked_rows
from tests.validation.live.compiler import needs_wasm
from tests.validation.live.firefox import Firefox, firefox, needs_firefox

pytestmark = [needs_firefox, needs_wasm]
MODELS = Path(__file__).parents[3] / "models"
RIGHT = "\ue014"
SWAY = """Math.max(...["x", "y"].map(
    (axis) => Math.abs(page.driver.system.state[`sway.${axis}.angle`])))"""
# s of the crane, without a hand on anything
PASS = """(() => {
    const end = page.driver.time + %r;
    let sway = 0;
    while (page.driver.time < end) {
        page.driver.step();
        if (page.driver.time > end - %r) sway = Math.max(sway, SWAY);
    }
    return sway;
})()""".replace("SWAY", SWAY)


@pytest.fixture(scope="module")
def browser() -> Iterator[Firefox]:
    with firefox() as found:
        yield found


@pytest.mark.parametrize(
    ("mission", "rest"), [("inteco.toml", 4.0), *soaked_rows(("container.toml", 60.0))]
)
def test_keys_drive_it_swing_free_and_a_plain_joystick_lets_it_swing(
    browser: Firefox, tmp_path: Path, mission: str, rest: float
) -> None:
    path = segfmu.live(MODELS / mission, tmp_path / "live.html")
    browser.ask("WebDriver:Navigate", url=path.as_uri())
    browser.wait("document.body.dataset.drawn === 'yes'")
    browser.wait("/frames a second/.test(document.getElementById('rate').textContent)")
    # the long rope of a ship-to-shore crane is slow
    browser.value("void (document.getElementById('pace').value = '5')")
    left = []
    for plain in ("false", "true"):
        browser.value(f"void page.driver.choose({plain})")
        start = browser.value("page.driver.load[1]")
        way = browser.value("0.1 * (data.room[1][1] - data.room[1][0])")
        browser.key("keyDown", RIGHT)
        browser.wait(f"page.driver.load[1] > {start + way}")
        browser.key("keyUp", RIGHT)
        browser.wait("page.driver.command.kind === 'stop'")
        left.append(browser.value(PASS % (rest, 0.5 * rest)))
        assert browser.value("page.driver.message") == ""
    free, swinging = left
    assert free < 1e-6 and swinging > 0.01
