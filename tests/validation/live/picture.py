"""The moving picture of the README: `python -m tests.validation.live.picture FOLDER`.

A container goes over a stack to the same target, swing-free and by a plain joystick, in Chromium.
"""

from __future__ import annotations

import sys
import tempfile
from io import BytesIO
from pathlib import Path

from PIL import Image, ImageDraw, ImageFont
from playwright.sync_api import Browser

import segfmu
from tests.validation.report.browser import chromium, opened

MISSION = Path(__file__).parents[3] / "models" / "container.toml"
# m; above the stack
FIRST, LAST = [0.0, -5.0, -17.0], [0.0, 50.0, -17.0]
# frames, from one to the next in the picture [s] and on the crane [s]
FRAMES, SHOWN, PASSED = 80, 0.08, 0.65
# px
SIZE, TITLE, COLOURS = (380, 250), 26, 20
BEGIN = """([plain, first, last]) => {
    page.frame = () => {};
    page.driver.choose(plain);
    page.driver.rest(first);
    page.driver.goTo(last);
    page.forget();
    Object.assign(page.view, {azimuth: 80, elevation: 12});
    page.view.changed();
    const stage = document.getElementById("stage");
    Object.assign(stage.style, {width: "%dpx", height: "%dpx"});
}"""
PASS = """(seconds) => {
    const end = page.driver.time + seconds;
    while (page.driver.time < end) {
        page.driver.step();
        page.sample();
    }
    page.draw();
}"""


def run(browser: Browser, page: Path, plain: bool) -> list[Image.Image]:
    """Pictures of a crossing."""
    tab, _ = opened(browser, page)
    tab.evaluate(BEGIN % SIZE, [plain, FIRST, LAST])
    tab.wait_for_timeout(300)
    found = []
    for _ in range(FRAMES):
        tab.evaluate(PASS, PASSED)
        picture = tab.locator("#stage").screenshot()
        found.append(Image.open(BytesIO(picture)).convert("RGB"))
    tab.close()
    return found


def beside(pictures: list[tuple[str, Image.Image]]) -> Image.Image:
    """Pictures beside each other, with their titles above."""
    whole = Image.new("RGB", (SIZE[0] * len(pictures), SIZE[1] + TITLE), "white")
    draw = ImageDraw.Draw(whole)
    for i, (title, picture) in enumerate(pictures):
        whole.paste(picture, (i * SIZE[0], TITLE))
        draw.text((i * SIZE[0] + 12, 6), title, "black", ImageFont.load_default(15))
    return whole


def main() -> None:
    """Write live.gif."""
    target = Path(sys.argv[1]) / "live.gif"
    with tempfile.TemporaryDirectory() as place, chromium() as browser:
        page = segfmu.live(MISSION, Path(place) / "live.html")
        free, plain = (run(browser, page, kind) for kind in (False, True))
    pictures = [
        beside([("swing-free", one), ("plain joystick", other)])
        for one, other in zip(free, plain, strict=True)
    ]
    # one palette for all, so that what rests takes no room
    palette = pictures[FRAMES // 2].quantize(COLOURS, dither=Image.Dither.NONE)
    frames = [p.quantize(palette=palette, dither=Image.Dither.NONE) for p in pictures]
    frames[0].save(
        target, save_all=True, append_images=frames[1:], duration=round(1e3 * SHOWN), loop=0,
        optimize=True,
    )
    print(target, target.stat().st_size)


if __name__ == "__main__":
    main()
