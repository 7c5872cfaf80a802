"""Reports in a browser: what is drawn, the animation, the keyboard, readers with disabilities."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pyarrow
import pytest
from axe_playwright_python.sync_playwright import Axe
from playwright.sync_api import Browser, Page

import segfmu
from segfmu.validation.campaigns.result import CampaignResult
from tests.campaign import SOAK, soaked
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
SCREENS = {"desk": (DESK, "light"), "phone": (PHONE, "dark"), "paper": ((760, 1000), "light")}
MARKUP = "</script><script>alert('a')</script><b>&amp;"
FACTOR = '<i>load</i> &amp; <a href="x">'
CONTROLS = "button, select, input, summary, a[href]"
Opened = tuple[Page, list[str]]


@pytest.fixture(scope="module")
def runs() -> Callable[[str], segfmu.Run]:
    """Runs by the names of their reports."""

    @cache
    def run(name: str) -> segfmu.Run:
        return small() if name == "small" else segfmu.simulate(MISSIONS[name], step=0.01)

    return run


@pytest.fixture(scope="module")
def reports(runs, tmp_path_factory) -> Callable[[str], Path]:
    """Reports of two sizes of cranes, of a suite, of a campaign, and of what is small."""
    folder = tmp_path_factory.mktemp("reports")
    suite = cache(lambda: segfmu.validate(SCENARIOS))

    @cache
    def report(name: str) -> Path:
        path = folder / f"{name}.html"
        if name == "suite":
            return suite().report(path)
        if name == "campaign":
            return marked_up_campaign().report(path, suite())
        return runs(name).report(path)

    return report


def small() -> segfmu.Run:
    """A run of 2 mm, whose name would be markup."""
    return segfmu.simulate(segfmu.load_mission({
        "crane": segfmu.Crane(0.8, 0.3, 0.05), "limits": segfmu.Limits(0.05, 0.1, 0.5, 5.0),
        "waypoints": [segfmu.Waypoint([x, 0.0, -0.3]) for x in (0.0, -0.002)], "name": MARKUP,
    }))


def marked_up_campaign() -> CampaignResult:
    """Names that look like markup, and margins that differ in the sixth digit."""
    found = campaign()
    margins = pyarrow.array(4.998e-3 - 1e-6 * np.array(found.column("gust")))
    names = [FACTOR if n == "gust" else n for n in found.table.column_names]
    table = found.table.rename_columns(names)
    place = names.index("margin.near its plan")
    return replace(
        found, factors=(FACTOR, "payload"),
        table=table.set_column(place, "margin.near its plan", margins),
    )


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with chromium() as found:
        yield found


@pytest.fixture(scope="module")
def pages(browser: Browser, reports: Callable[[str], Path]) -> Callable[..., Opened]:
    """Pages that stay open for all tests, which leave them on the same screen.

    Only what a test sets itself is known of the view, the time and what is folded.
    """

    @cache
    def page(name: str, screen: str) -> Opened:
        return opened(browser, reports(name), *SCREENS[screen])

    return page


def unfold(page: Page) -> None:
    """Open all that is folded, with its charts drawn."""
    page.evaluate("document.querySelectorAll('details').forEach(d => { d.open = true; })")
    page.wait_for_function(
        "[...document.querySelectorAll('.chart')].every(c => c.querySelector('.js-line, .point'))"
    )


# every page on one of two screens, and every test on the screen that others have open
@pytest.mark.parametrize("shown_on", [
    ("lab", "phone"), ("40 t", "desk"), ("suite", "desk"), ("campaign", "phone"),
    *soaked(("lab", "desk"), ("40 t", "phone"), ("suite", "phone"), ("campaign", "desk")),
], ids="-".join)
def test_it_draws_without_a_complaint_and_a_network(
    pages: Callable[..., Opened], reports: Callable[[str], Path], shown_on: tuple[str, str]
) -> None:
    assert reports(shown_on[0]).stat().st_size < LARGEST
    page, complaints = pages(*shown_on)
    width = SCREENS[shown_on[1]][0][0]
    assert page.evaluate("document.documentElement.scrollWidth") <= width and not complaints
    unfold(page)
    assert page.evaluate("document.documentElement.scrollWidth") <= width and not complaints


@pytest.mark.parametrize("name", ["suite", *soaked("40 t")])
def test_something_shows_at_once(
    browser: Browser, pages: Callable[..., Opened], reports: Callable[[str], Path], name: str
) -> None:
    # one of some is quick enough, as other tests run beside it
    times = [pages(name, "desk")[0].evaluate(FIRST_PAINT)]
    while len(times) < 3 and min(times) >= LATEST:
        page, _ = opened(browser, reports(name))
        times.append(page.evaluate(FIRST_PAINT))
        page.close()
    assert 0.0 < min(times) < LATEST


def shown(page: Page) -> np.ndarray:
    """Time [s] and load position [m] that the view tells."""
    text = page.inner_text("#state")
    found = re.fullmatch(r"([\d.]+) s: load at x (\S+), y (\S+), z (\S+) m; sway .*", text)
    assert found, text
    return np.array([float(number) for number in found.groups()])


# in a soak from the start, elsewhere its last tenth
@pytest.mark.parametrize("name", ["40 t", *soaked("lab")])
def test_the_animation_plays_to_its_end(
    pages: Callable[..., Opened], runs: Callable[[str], segfmu.Run], name: str
) -> None:
    page, complaints = pages(name, "desk")
    page.focus("#time")
    page.keyboard.press("Home")
    assert shown(page)[0] == 0.0
    first = page.get_attribute("#load", "cx"), page.get_attribute("#load", "cy")
    page.select_option("#speed", "20")
    if not SOAK:
        page.keyboard.press("End")
        for _ in range(5):
            page.keyboard.press("ArrowLeft")
        assert shown(page)[0] == pytest.approx(0.9 * runs(name).time[-1], abs=0.01)
    # at once: a busy machine may ask when it has ended
    assert page.evaluate("""() => {
        document.getElementById("play").click();
        return document.getElementById("play").textContent;
    }""") == "Pause"
    page.wait_for_function("document.getElementById('play').textContent === 'Play'")
    end = shown(page)
    assert end[0] == pytest.approx(runs(name).time[-1], abs=0.01)
    assert end[1:] == pytest.approx(runs(name).mission.waypoints[-1].position, abs=2e-3)
    assert (page.get_attribute("#load", "cx"), page.get_attribute("#load", "cy")) != first
    assert not complaints


def test_pause_holds_the_animation(pages: Callable[..., Opened]) -> None:
    page, _ = pages("lab", "phone")
    page.focus("#time")
    page.keyboard.press("Home")
    page.click("#play")
    page.wait_for_function("Number(document.getElementById('time').value) > 0.2")
    page.click("#play")
    at = page.input_value("#time")
    page.wait_for_timeout(200)
    assert page.input_value("#time") == at and 0.2 < float(at) < 5.0


@pytest.mark.parametrize("name", ["lab", *soaked("40 t")])
def test_the_slider_shows_the_load_where_it_was(
    pages: Callable[..., Opened], runs: Callable[[str], segfmu.Run], name: str
) -> None:
    page, _ = pages(name, "phone")
    run = runs(name)
    page.focus("#time")
    page.keyboard.press("Home")
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


def test_a_small_motion_is_told_with_its_digits(
    pages: Callable[..., Opened], runs: Callable[[str], segfmu.Run]
) -> None:
    page, _ = pages("small", "paper")
    assert page.inner_text("#state").startswith("0.00 s: load at x 0.00000, y 0.00000, z -0.30000")
    page.focus("#time")
    for _ in range(4):
        page.keyboard.press("ArrowRight")
    run = runs("small")
    expected = np.interp(float(page.input_value("#time")), run.time, run["load.position.x"])
    assert shown(page)[1] == pytest.approx(expected, abs=1e-5)
    assert -0.0015 < expected < -0.0005


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


def test_the_view_turns_and_shows_every_scenario(pages: Callable[..., Opened]) -> None:
    page, complaints = pages("suite", "desk")
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


@pytest.mark.parametrize("name", ["suite", *soaked("lab")])
def test_the_keyboard_reaches_every_control(pages: Callable[..., Opened], name: str) -> None:
    page, _ = pages(name, "desk")
    unfold(page)
    count = page.evaluate(f"""() => {{
        const all = [...document.querySelectorAll('{CONTROLS}')].filter(e => e.checkVisibility());
        all.forEach((e, i) => {{ e.dataset.place = i; }});
        return all.length;
    }}""")
    assert count > 12
    missing = {str(i) for i in range(count)}
    for _ in range(3 * count + 100):
        page.keyboard.press("Tab")
        missing.discard(page.evaluate("document.activeElement.dataset.place"))
        if not missing:
            break
    assert not missing
    # what has a pointer's action alone would be missed
    assert page.locator(".modebar-btn, [onclick]").count() == 0


# every page in one of two ways
@pytest.mark.parametrize("shown_on", [
    ("lab", "phone"), ("suite", "desk"), ("campaign", "phone"),
    *soaked(("lab", "desk"), ("suite", "phone"), ("campaign", "desk")),
], ids="-".join)
def test_axe_finds_nothing_serious(
    pages: Callable[..., Opened], shown_on: tuple[str, str]
) -> None:
    page, complaints = pages(*shown_on)
    unfold(page)
    assert not complaints
    found = Axe().run(page).response["violations"]
    assert not [f"{v['id']}: {v['help']}" for v in found if v["impact"] in ("serious", "critical")]


def test_axe_would_find_something(pages: Callable[..., Opened]) -> None:
    page, _ = pages("lab", "phone")
    page.evaluate("""
        window.label = document.querySelector('label.time');
        label.replaceWith(document.querySelector('#time'));
    """)
    # of that name alone: what else there is has been looked for above
    found = Axe().run(page, options={"runOnly": ["label"], "resultTypes": ["violations"]})
    page.evaluate("""
        const slider = document.querySelector('#time');
        slider.replaceWith(label);
        label.append(slider);
    """)
    assert "label" in {v["id"] for v in found.response["violations"]}


def test_charts_fit_the_paper(pages: Callable[..., Opened]) -> None:
    page, _ = pages("small", "paper")
    page.emulate_media(media="print")
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    page.wait_for_timeout(300)
    widths = page.evaluate("""[...document.querySelectorAll('.chart')].map(
        c => [c.querySelector('svg').getBoundingClientRect().width, c.clientWidth])""")
    assert widths and all(drawn <= room + 1.0 for drawn, room in widths)
    assert not page.is_visible("#play")
    assert len(page.pdf()) > 20_000
    page.evaluate("dispatchEvent(new Event('afterprint'))")
    page.emulate_media(media="screen")


def test_names_are_no_markup(pages: Callable[..., Opened]) -> None:
    page, complaints = pages("small", "paper")
    assert page.inner_text("h1") == MARKUP and not complaints


@pytest.mark.parametrize("screen", ["phone", *soaked("desk")])
def test_charts_of_a_campaign_have_names_and_numbers_that_can_be_read(
    pages: Callable[..., Opened], screen: str
) -> None:
    page, complaints = pages("campaign", screen)
    titles = page.evaluate("[...document.querySelectorAll('.xtitle')].map(t => t.textContent)")
    assert titles[1] == FACTOR and not complaints
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


def test_every_number_along_an_axis_has_its_exponent(browser: Browser, tmp_path: Path) -> None:
    """Only the last one had it: 3.5, 4, 4.5, 5e-4."""
    result = campaign()
    name = "margin.near its plan"
    place = result.table.column_names.index(name)
    small = [None if m is None else 4e-4 + 1e-2 * m for m in result.column(name)]
    table = result.table.set_column(place, name, pyarrow.array(small, pyarrow.float64()))
    page, _ = opened(browser, replace(result, table=table).report(tmp_path / "report.html"))
    shown = page.evaluate("""[...document.querySelector('.chart').querySelectorAll('.xtick text')]
        .map(text => text.textContent)""")
    assert len(shown) > 2 and all("e" in text for text in shown if float_of(text) != 0.0), shown


def float_of(text: str) -> float:
    return float(text.replace("\u2212", "-"))
