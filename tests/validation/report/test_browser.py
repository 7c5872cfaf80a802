"""Reports in a browser: what is drawn, the animation, the keyboard, readers with disabilities."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pyarrow
import pytest
from axe_playwright_python.sync_playwright import Axe
from playwright.sync_api import Browser, Page

import segfmu
from tests.campaign import soaked
from tests.compiler import needs_native
from tests.validation.report.browser import DESK, PHONE, chromium, needs_browser, opened
from tests.validation.report.test_report import campaign

pytestmark = [needs_browser, needs_native]
MODELS = Path(__file__).parents[3] / "models"
MISSIONS = {"lab": MODELS / "inteco.toml", "40 t": MODELS / "scenarios" / "_quay_mission.toml"}
NAMES = ("ship_to_shore_gust", "large_sway", "noise")
SCENARIOS = [MODELS / "scenarios" / f"{name}.toml" for name in NAMES]
# of a report, and of the time until something is painted [ms]
LARGEST, LATEST = 6_000_000, 2000.0
FIRST_PAINT = "performance.getEntriesByName('first-contentful-paint')[0].startTime"
SCREENS = {"desk": DESK, "phone": PHONE}
CONTROLS = "button, select, input, summary, a[href]"


@pytest.fixture(scope="module")
def runs() -> dict[str, segfmu.Run]:
    return {name: segfmu.simulate(path, step=0.01) for name, path in MISSIONS.items()}


@pytest.fixture(scope="module")
def reports(runs, tmp_path_factory) -> dict[str, Path]:
    """Reports of two sizes of cranes and of a suite."""
    folder = tmp_path_factory.mktemp("reports")
    made = {name: run.report(folder / f"{name}.html") for name, run in runs.items()}
    suite = segfmu.validate(SCENARIOS)
    return made | {
        "suite": suite.report(folder / "suite.html"),
        "campaign": campaign().report(folder / "campaign.html", suite),
    }


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with chromium() as found:
        yield found


# every page on one of two screens; tests below open those that are missing here
@pytest.mark.parametrize("shown_on", [
    ("lab", "desk"), ("40 t", "phone"), ("suite", "phone"), ("campaign", "desk"),
    *soaked(("lab", "phone"), ("40 t", "desk"), ("suite", "desk"), ("campaign", "phone")),
], ids="-".join)
def test_it_draws_without_a_complaint_and_a_network(
    browser: Browser, reports: dict[str, Path], shown_on: tuple[str, str]
) -> None:
    name, size = shown_on[0], SCREENS[shown_on[1]]
    assert reports[name].stat().st_size < LARGEST
    page, complaints = opened(browser, reports[name], size)
    assert not complaints
    assert page.evaluate("document.documentElement.scrollWidth") <= size[0]
    page.evaluate("document.querySelectorAll('details').forEach(d => { d.open = true; })")
    page.wait_for_function(
        "[...document.querySelectorAll('.chart')].every(c => c.querySelector('.js-line, .point'))"
    )
    assert page.evaluate("document.documentElement.scrollWidth") <= size[0] and not complaints
    page.close()


@pytest.mark.parametrize("name", ["suite", *soaked("40 t")])
def test_something_shows_at_once(browser: Browser, reports: dict[str, Path], name: str) -> None:
    # one of some is quick enough, as other tests run beside it
    times = []
    while len(times) < 3 and not (times and min(times) < LATEST):
        page, _ = opened(browser, reports[name])
        times.append(page.evaluate(FIRST_PAINT))
        page.close()
    assert 0.0 < min(times) < LATEST


def shown(page: Page) -> np.ndarray:
    """Time [s] and load position [m] that the view tells."""
    text = page.inner_text("#state")
    found = re.fullmatch(r"([\d.]+) s: load at x (\S+), y (\S+), z (\S+) m; sway .*", text)
    assert found, text
    return np.array([float(number) for number in found.groups()])


@pytest.mark.parametrize("name", ["40 t", *soaked("lab")])
def test_the_animation_plays_to_its_end(
    browser: Browser, runs: dict[str, segfmu.Run], reports: dict[str, Path], name: str
) -> None:
    page, complaints = opened(browser, reports[name])
    assert shown(page)[0] == 0.0
    first = page.get_attribute("#load", "cx"), page.get_attribute("#load", "cy")
    page.select_option("#speed", "20")
    page.click("#play")
    assert page.inner_text("#play") == "Pause"
    page.wait_for_function("document.getElementById('play').textContent === 'Play'")
    end = shown(page)
    assert end[0] == pytest.approx(runs[name].time[-1], abs=0.01)
    assert end[1:] == pytest.approx(runs[name].mission.waypoints[-1].position, abs=2e-3)
    assert (page.get_attribute("#load", "cx"), page.get_attribute("#load", "cy")) != first
    assert not complaints
    page.close()


def test_pause_holds_the_animation(browser: Browser, reports: dict[str, Path]) -> None:
    page, _ = opened(browser, reports["lab"])
    page.click("#play")
    page.wait_for_function("Number(document.getElementById('time').value) > 0.2")
    page.click("#play")
    at = page.input_value("#time")
    page.wait_for_timeout(200)
    assert page.input_value("#time") == at and 0.2 < float(at) < 5.0
    page.close()


@pytest.mark.parametrize("name", ["lab", *soaked("40 t")])
def test_the_slider_shows_the_load_where_it_was(
    browser: Browser, runs: dict[str, segfmu.Run], reports: dict[str, Path], name: str
) -> None:
    page, _ = opened(browser, reports[name])
    run = runs[name]
    page.focus("#time")
    for _ in range(17):
        page.keyboard.press("ArrowRight")
    time, *place = shown(page)
    assert time == pytest.approx(17 / 50 * run.time[-1], abs=0.01)
    there = [np.interp(time, run.time, run[f"load.position.{axis}"]) for axis in "xyz"]
    assert place == pytest.approx(there, abs=2e-3 * max(1.0, np.abs(there).max()))
    # a line in the charts is at the same time
    left = page.evaluate("""() => {
        const chart = document.querySelector('.chart'), axis = chart._fullLayout.xaxis;
        return axis.p2l(parseFloat(chart.querySelector('.cursor').style.left) - axis._offset);
    }""")
    assert left == pytest.approx(float(page.input_value("#time")), abs=1e-3 * run.time[-1])
    page.close()


def test_a_small_motion_is_told_with_its_digits(browser: Browser, tmp_path: Path) -> None:
    mission = segfmu.load_mission({
        "crane": segfmu.Crane(0.8, 0.3, 0.05), "limits": segfmu.Limits(0.05, 0.1, 0.5, 5.0),
        "waypoints": [segfmu.Waypoint([x, 0.0, -0.3]) for x in (0.0, -0.002)],
    })
    run = segfmu.simulate(mission)
    page, _ = opened(browser, run.report(tmp_path / "report.html"))
    assert page.inner_text("#state").startswith("0.00 s: load at x 0.00000, y 0.00000, z -0.30000")
    page.focus("#time")
    for _ in range(4):
        page.keyboard.press("ArrowRight")
    expected = np.interp(float(page.input_value("#time")), run.time, run["load.position.x"])
    assert shown(page)[1] == pytest.approx(expected, abs=1e-5)
    assert -0.0015 < expected < -0.0005
    page.close()


# texts of the view that lie on one before them, and all of them
CROSSINGS = """[...document.querySelectorAll('#stage text')]
    .map((text) => text.getBoundingClientRect())
    .filter((a, i, all) => all.slice(0, i).some((b) => a.left < b.right && b.left < a.right
        && a.top < b.bottom && b.top < a.bottom)).length"""
NUMBERS = "[...document.querySelectorAll('#stage text')].map((text) => text.textContent)"


def test_names_in_the_view_are_apart(browser: Browser, tmp_path: Path) -> None:
    places = [[0.0, 0.1 * i, -3.0 + 0.3 * (i % 2)] for i in range(12)]
    boxes = [segfmu.Obstacle(f"row of containers {i}", [-1.0, i, -9.0], [1.0, i + 0.8, -5.0])
             for i in range(8)]
    mission = segfmu.load_mission({
        "crane": segfmu.Crane(2.0, 1.0, 1.0), "limits": segfmu.Limits(1.0, 1.0, 5.0, 50.0),
        "waypoints": [segfmu.Waypoint(place) for place in places], "obstacles": boxes,
    })
    report = segfmu.simulate(mission, step=0.01).report(tmp_path / "report.html")
    page, complaints = opened(browser, report)
    for view in ("from above", "along x", "along y", "oblique"):
        page.click(f"text={view}")
        numbers = page.evaluate(NUMBERS)
        assert "1" in numbers and any(name.startswith("row") for name in numbers)
        assert page.evaluate(CROSSINGS) == 0, view
    assert not complaints
    page.close()


def test_the_view_turns_and_shows_every_scenario(
    browser: Browser, reports: dict[str, Path]
) -> None:
    page, complaints = opened(browser, reports["suite"])
    drawings = set()
    for view in ("oblique", "from above", "along x", "along y"):
        page.get_by_role("button", name=view).click()
        drawings.add(page.inner_html("#stage"))
    page.focus("#stage")
    page.keyboard.press("ArrowLeft")
    drawings.add(page.inner_html("#stage"))
    page.select_option("#which", index=1)
    drawings.add(page.inner_html("#stage"))
    assert len(drawings) == 6 and not complaints
    page.close()


@pytest.mark.parametrize("name", ["suite", *soaked("lab")])
def test_the_keyboard_reaches_every_control(
    browser: Browser, reports: dict[str, Path], name: str
) -> None:
    page, _ = opened(browser, reports[name])
    count = page.evaluate(f"""() => {{
        const all = [...document.querySelectorAll('{CONTROLS}')].filter(e => e.checkVisibility());
        all.forEach((e, i) => {{ e.dataset.place = i; }});
        return all.length;
    }}""")
    reached = set()
    for _ in range(3 * count + 100):
        page.keyboard.press("Tab")
        reached.add(page.evaluate("document.activeElement.dataset.place"))
    assert reached - {None} == {str(i) for i in range(count)} and count > 12
    # what has a pointer's action alone would be missed
    assert page.locator(".modebar-btn, [onclick]").count() == 0
    page.close()


# every page in one of two ways
@pytest.mark.parametrize("shown_as", [
    ("lab", "phone"), ("suite", "desk"), ("campaign", "phone"),
    *soaked(("lab", "desk"), ("suite", "phone"), ("campaign", "desk")),
], ids="-".join)
def test_axe_finds_nothing_serious(
    browser: Browser, reports: dict[str, Path], shown_as: tuple[str, str]
) -> None:
    name, way = shown_as
    page, complaints = opened(
        browser, reports[name], SCREENS[way], {"desk": "light", "phone": "dark"}[way]
    )
    page.evaluate("document.querySelectorAll('details').forEach(d => { d.open = true; })")
    assert not complaints
    found = Axe().run(page).response["violations"]
    assert not [f"{v['id']}: {v['help']}" for v in found if v["impact"] in ("serious", "critical")]
    page.close()


def test_axe_would_find_something(browser: Browser, reports: dict[str, Path]) -> None:
    page, _ = opened(browser, reports["lab"])
    page.evaluate("document.querySelector('label.time').replaceWith(document.querySelector('#time'))")
    assert "label" in {v["id"] for v in Axe().run(page).response["violations"]}
    page.close()


def test_charts_fit_the_paper(browser: Browser, reports: dict[str, Path]) -> None:
    page, _ = opened(browser, reports["lab"], (760, 1000))
    page.emulate_media(media="print")
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    page.wait_for_timeout(300)
    widths = page.evaluate("""[...document.querySelectorAll('.chart')].map(
        c => [c.querySelector('svg').getBoundingClientRect().width, c.clientWidth])""")
    assert widths and all(drawn <= room + 1.0 for drawn, room in widths)
    assert not page.is_visible("#play")
    assert len(page.pdf()) > 20_000
    page.close()


def test_names_are_no_markup(browser: Browser, tmp_path: Path) -> None:
    name = "</script><script>alert('a')</script><b>&amp;"
    run = segfmu.simulate(segfmu.load_mission(MISSIONS["lab"], {"name": name}), step=0.02)
    page, complaints = opened(browser, run.report(tmp_path / "report.html"))
    assert page.inner_text("h1") == name and not complaints
    page.close()


@pytest.mark.parametrize("size", [PHONE, *soaked(DESK)], ids=str)
def test_charts_of_a_campaign_have_names_and_numbers_that_can_be_read(
    browser: Browser, tmp_path: Path, size: tuple[int, int]
) -> None:
    """Names that look like markup, and margins that differ in the sixth digit."""
    name = '<i>load</i> &amp; <a href="x">'
    found = campaign()
    margins = pyarrow.array(4.998e-3 - 1e-6 * np.array(found.column("gust")))
    names = [name if n == "gust" else n for n in found.table.column_names]
    table = found.table.rename_columns(names)
    place = names.index("margin.near its plan")
    found = replace(
        found, factors=(name, "payload"),
        table=table.set_column(place, "margin.near its plan", margins),
    )
    page, complaints = opened(browser, found.report(tmp_path / "report.html"), size)
    titles = page.evaluate("[...document.querySelectorAll('.xtitle')].map(t => t.textContent)")
    assert titles[1] == name and not complaints
    shown = page.evaluate("""[...document.querySelectorAll('.chart')].map(chart =>
        [...chart.querySelectorAll('.xtick text, .xtitle')].map(text => {
            const box = text.getBoundingClientRect();
            return [box.left, box.right, box.top, box.bottom];
        }))""")
    for boxes in shown:
        for i, (left, right, top, bottom) in enumerate(boxes):
            for other in boxes[:i]:
                assert left >= other[1] or right <= other[0] or top >= other[3] - 1.0 \
                    or bottom <= other[2] + 1.0
    page.close()
