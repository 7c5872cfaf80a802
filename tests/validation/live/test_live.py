"""Pages on which a crane is driven, in Chromium: equal to the native FMUs, swing-free, at hand."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from axe_playwright_python.sync_playwright import Axe
from playwright.sync_api import Browser, Page

import segfmu
from segfmu.cosim.change import Change
from segfmu.cosim.system import System
from segfmu.fmu.gantry_feedforward.interface import MODES
from segfmu.fmu.native.archive import build_all
from segfmu.validation.live.space import limits, space, speeds
from segfmu.validation.live.system import interfaces
from segfmu.validation.planned import planned
from tests.campaign import campaign, soaked, soaked_rows
from tests.compiler import needs_native
from tests.sharing import shared
from tests.validation.live.compiler import needs_wasm
from tests.validation.report.browser import DESK, PHONE, chromium, needs_browser, opened

pytestmark = [needs_browser, needs_native, needs_wasm]
MODELS = Path(__file__).parents[3] / "models"
MISSIONS = {"lab": MODELS / "inteco.toml", "40 t": MODELS / "container.toml"}
FEEDFORWARD, CRANE = "GantryFeedforward", "GantryCrane"
# m; what the coupling of the FMUs adds to the plan, which is in its room exactly
EDGE = 1e-5
# bytes of a page
LARGEST = 2_000_000
SIGNALS = [
    *(f"load.{name}.{axis}" for name in ("position", "velocity") for axis in "xyz"),
    *(f"sway.{axis}.{name}" for axis in "xy" for name in ("angle", "rate")),
    "bridge.position", "trolley.position", "rope.length", "rope.force",
]
# of a run in the page: changes are (time, FMU, values)
RUN = """async ([names, changes, settings, end]) => {
    const system = await CraneSystem.load(data, names);
    const apply = (time) => {
        while (changes.length && changes[0][0] <= time + CraneSystem.INSTANT) {
            const [, fmu, values] = changes.shift();
            system.change(fmu === "GantryCrane" ? system.crane : system.feedforward, values);
        }
    };
    system.begin(0, settings, {});
    apply(0);
    const rows = [];
    for (let i = 1; i <= Math.round(end / data.step); i += 1) {
        system.advance(i * data.step);
        rows.push(names.map((name) => system.state[name]));
        apply(i * data.step);
    }
    // in one piece: numbers one by one would take longer than the run
    return JSON.stringify(rows);
}"""


@pytest.fixture(scope="module")
def pages(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    def make(folder: Path) -> None:
        for name, path in MISSIONS.items():
            segfmu.live(path, folder / f"{name}.html")

    folder = shared(tmp_path_factory, "live", make)
    return {name: folder / f"{name}.html" for name in MISSIONS}


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with chromium() as found:
        yield found


@pytest.fixture
def shown(browser: Browser, pages: dict[str, Path]) -> Iterator[Callable[[str], Page]]:
    """Opens pages, which must not have complained at the end."""
    found = []

    def show(name: str) -> Page:
        found.append(opened(browser, pages[name]))
        return found[-1][0]

    yield show
    for page, complaints in found:
        assert not complaints
        page.close()


def resting(place: Any) -> dict[str, float]:
    """Settings of a plan that stays where it is."""
    values: dict[str, float] = {"waypoint.count": 2}
    for i in (1, 2):
        for k, axis in enumerate("xyz"):
            values[f"waypoint[{i}].position.{axis}"] = float(place[k])
            values[f"waypoint[{i}].velocity.{axis}"] = 0.0
            values[f"waypoint[{i}].acceleration.{axis}"] = 0.0
    return values


@pytest.mark.parametrize(("name", "unit"), [("lab", 0.5), *soaked_rows(("40 t", 2.0))])
def test_signals_are_those_of_the_native_fmus(
    shown: Callable[[str], Page], tmp_path: Path, name: str, unit: float
) -> None:
    mission = segfmu.load_mission(MISSIONS[name])
    plan = planned(mission)
    room = space(mission, plan)
    own = limits(mission, plan, room)
    speed = speeds(mission, plan, own)[0]
    start = mission.waypoints[0].position
    wind = 0.02 * mission.crane.payload_mass * mission.crane.gravity
    changes: list[tuple[float, str, dict[str, float]]] = [
        (0.0, FEEDFORWARD, {"command.mode": 3, "command.velocity.z": 0.5 * speed[2]}),
        (2.0 * unit, FEEDFORWARD, {"command.velocity.x": speed[0], "command.velocity.y": speed[1]}),
        (3.0 * unit, CRANE, {"wind.y": wind}),
        (5.0 * unit, FEEDFORWARD, {"command.velocity.x": -speed[0], "limits.scale": 0.6}),
        (8.0 * unit, FEEDFORWARD, {"command.mode": 4}),
        (9.5 * unit, FEEDFORWARD,
         {"command.mode": 2, **{f"command.target.{a}": start[k] for k, a in enumerate("xyz")}}),
        (10.0 * unit, CRANE, {"wind.y": 0.0}),
    ]
    end = 14.0 * unit
    page = shown(name)
    found = np.array(json.loads(page.evaluate(RUN, [SIGNALS, changes, resting(start), end])))
    paths = build_all(interfaces(mission, plan, room, own), tmp_path)
    named = [
        Change(time, fmu, {
            n: MODES.items[int(v) - 1] if n == "command.mode" else v for n, v in values.items()
        })
        for time, fmu, values in changes
    ]
    with System(paths, step=mission.simulation.step) as system:
        rows = system.run({FEEDFORWARD: resting(start)}, stop_time=end, changes=named)
    native = np.column_stack([rows[signal] for signal in SIGNALS])[1:]
    assert found.shape == native.shape
    # the crane has moved, and was blown at
    assert np.ptp(native[:, 1]) > 0.02 * np.ptp(room[1])
    assert np.ptp(native[:, SIGNALS.index("sway.y.angle")]) > 0.01
    np.testing.assert_allclose(found, native, rtol=1e-12, atol=1e-12)


@pytest.mark.parametrize(
    ("name", "size", "scheme"), [("lab", DESK, "light"), ("40 t", PHONE, "dark")],
    ids=["desk", "phone"],
)
def test_the_page_is_small_and_for_everybody(
    browser: Browser, pages: dict[str, Path], name: str, size: tuple[int, int], scheme: str
) -> None:
    assert pages[name].stat().st_size < LARGEST
    page, complaints = opened(browser, pages[name], size, scheme)
    page.evaluate("document.querySelectorAll('details').forEach(d => { d.open = true; })")
    assert page.evaluate("document.documentElement.scrollWidth") <= size[0]
    found = Axe().run(page).response["violations"]
    assert not [f"{v['id']}: {v['help']}" for v in found if v["impact"] in ("serious", "critical")]
    assert not complaints
    page.close()


# records every tenth step of the page's own crane
RECORD = """() => {
    window.rows = [];
    const step = page.driver.step;
    page.driver.step = function () {
        step.call(this);
        if (this.points % 10) return;
        const {state} = this.system;
        window.rows.push([this.time, ...this.load, ...Driver.SPEED.map((n) => state[n]),
                          state["sway.x.angle"], state["sway.y.angle"],
                          ...["bridge", "trolley", "rope"].map((n) => state[`${n}.velocity`])]);
    };
}"""


def recorded(page: Page, seconds: float) -> np.ndarray:
    """Rows so far, and of so many seconds [s] more without a hand on anything."""
    return np.array(json.loads(page.evaluate("""(seconds) => {
        const end = page.driver.time + seconds;
        while (page.driver.time < end) page.driver.step();
        return JSON.stringify(window.rows);
    }""", seconds)))


def drive(page: Page, key: str, until: str) -> None:
    """Hold a key until something holds in the page."""
    page.keyboard.down(key)
    page.wait_for_function(until)
    page.keyboard.up(key)
    page.wait_for_function("page.driver.command.kind === 'stop'")


def aim(page: Page, place: list[float]) -> None:
    """Click on the floor below a place."""
    left, top = page.evaluate("""(place) => {
        const box = page.view.stage.getBoundingClientRect();
        const [u, v] = page.view.place([...place, page.view.bounds.low[2]]);
        return [box.left + u, box.top + v];
    }""", place)
    page.mouse.click(left, top)


# how far the load is lifted before it goes across [m], and how long it may take to rest [s]
LIFTS = {"lab": 0.25, "40 t": 13.0}
RESTS = {"lab": 4.0, "40 t": 60.0}


@pytest.mark.parametrize("name", ["lab", *soaked("40 t")])
def test_keys_and_a_click_bring_the_load_to_rest_without_sway(
    shown: Callable[[str], Page], name: str
) -> None:
    page, up, rest = shown(name), LIFTS[name], RESTS[name]
    page.evaluate(RECORD)
    page.select_option("#pace", "5")
    low, high = np.array(page.evaluate("data.room")).T
    speed = np.array(page.evaluate("data.speeds"))
    start = page.evaluate("data.start")
    drive(page, "PageUp", f"page.driver.load[2] > {start[2] + up}")
    # x is into the screen, or out of it: the room is longer in y
    drive(page, "ArrowRight", f"page.driver.load[1] > {start[1] + 0.2 * (high[1] - low[1])}")
    rows = recorded(page, rest)
    assert rows[-1, 1] == pytest.approx(start[0], abs=1e-9) and rows[-1, 2] > start[1]
    assert abs(rows[-1, 4:9]).max() < 1e-6
    goal = [float(start[0]) + 0.1 * (high[0] - low[0]), float(start[1])]
    aim(page, goal)
    page.wait_for_function("page.driver.command.kind === 'target'")
    target = page.evaluate("page.driver.command.target")
    assert target[:2] == pytest.approx(goal, abs=0.01 * (high[1] - low[1]))
    rows = recorded(page, 2.0 * rest)
    assert rows[-1, 1:4] == pytest.approx(target, abs=1e-6)
    behind = rows[rows[:, 0] > rows[-1, 0] - 0.2 * rest]
    assert abs(behind[:, 7:9]).max() < 1e-6
    # on the way it swings, and stays in its room; load and drives stay within their speed
    assert abs(rows[:, 7:9]).max() > 1e-3
    places = rows[:, 1:4]
    assert (places > low - EDGE).all() and (places < high + EDGE).all()
    bounds = segfmu.load_mission(MISSIONS[name]).build_bounds()
    assert bounds is not None
    assert (abs(rows[:, 4:7]).max(axis=0) < 1.05 * speed).all()
    assert (abs(rows[:, 9:]).max(axis=0) < bounds.velocity).all()


@pytest.mark.parametrize("name", ["lab", *soaked("40 t")])
def test_a_plain_joystick_lets_it_swing(shown: Callable[[str], Page], name: str) -> None:
    page = shown(name)
    page.evaluate(RECORD)
    page.keyboard.press("p")
    assert page.is_checked("#plain")
    page.keyboard.down("ArrowRight")
    page.wait_for_function("page.driver.command.kind === 'velocity'")
    # while the key is held: what is left after it depends on when it is released
    rows = recorded(page, RESTS[name])
    page.keyboard.up("ArrowRight")
    page.wait_for_function("page.driver.command.kind === 'stop'")
    late = rows[rows[:, 0] > rows[-1, 0] - 0.5 * RESTS[name]]
    assert np.ptp(late[:, 8]) > np.deg2rad(1.0)
    # back again: at rest where the trolley is
    page.check("#free")
    assert abs(recorded(page, 1.0)[-1, 4:9]).max() < 1e-12


def test_wind_and_load_act_while_it_runs(shown: Callable[[str], Page]) -> None:
    page = shown("lab")
    page.keyboard.press("p")
    page.evaluate(RECORD)
    mass, gravity = 1.0, 9.81
    wind = page.evaluate("data.wind")
    length = -page.evaluate("data.start")[2]
    swing = 2.0 * np.pi * np.sqrt(length / gravity)

    def tilt() -> float:
        """Mean of four swings [rad], which nothing damps."""
        rows = recorded(page, 4.0 * swing)
        return float(rows[rows[:, 0] > rows[-1, 0] - 4.0 * swing, 8].mean())

    page.evaluate("find('windy').value = 1; find('windy').dispatchEvent(new Event('input'))")
    full = tilt()
    before, after = page.evaluate("""() => {
        const {load} = page.driver, slider = find("mass");
        slider.value = 0.5;
        for (const name of ["input", "change"]) slider.dispatchEvent(new Event(name));
        return [load, page.driver.load];
    }""")
    assert after == pytest.approx(before, abs=1e-12)
    assert page.inner_text("#mass-value") == "0.5 kg"
    half = tilt()
    assert abs(full) == pytest.approx(np.arctan(wind / (mass * gravity)), rel=0.02)
    assert abs(half) == pytest.approx(np.arctan(wind / (0.5 * mass * gravity)), rel=0.02)


def test_wind_at_an_end_stop_ends_nothing(shown: Callable[[str], Page]) -> None:
    page = shown("lab")
    page.evaluate("page.driver.goTo([data.start[0], data.room[1][1], data.start[2]])")
    page.evaluate(RECORD)
    assert recorded(page, 6.0)[-1, 2] == pytest.approx(page.evaluate("data.room[1][1]"), abs=EDGE)
    page.evaluate("page.driver.blow([data.wind, data.wind])")
    rows = recorded(page, 12.0)
    assert page.evaluate("page.driver.message") == ""
    # the load still leans on the wind: nothing began anew at rest
    assert abs(rows[-100:, 7:9]).min() > 0.01


# commands at random; whether all was kept in a room, what was refused, and the sway behind it
RANDOM = """([count, seed, edge]) => {
    page.frame = () => {};
    const {driver} = page, told = new Set();
    const random = () => {
        seed = (1103515245 * seed + 12345) % 2147483648;
        return seed / 2147483648;
    };
    const within = () => driver.load.every((value, k) =>
        value > data.room[k][0] - edge && value < data.room[k][1] + edge);
    let inside = true;
    const pass = (seconds) => {
        const end = driver.time + seconds;
        while (driver.time < end) {
            driver.step();
            inside &&= within();
            if (driver.message) told.add(driver.message);
        }
    };
    for (let i = 0; i < count; i += 1) {
        const kind = random();
        if (kind < 0.5) driver.steer([0, 1, 2].map(() => Math.round(20 * random() - 10) / 10));
        else if (kind < 0.75) driver.goTo(data.room.map(([a, b]) => a + random() * (b - a)));
        else if (kind < 0.85) driver.stop();
        else driver.take(data.mass * (0.1 + random()));
        pass(0.3 * random() * data.window);
    }
    driver.stop();
    pass(5 * data.window);
    const {state} = driver.system;
    const sway = Math.max(Math.abs(state["sway.x.angle"]), Math.abs(state["sway.y.angle"]));
    return [inside, [...told], sway];
}"""


@pytest.mark.parametrize("name", ["lab", *soaked("40 t")])
@campaign(12, 200)
def test_random_commands_stay_in_the_room_and_leave_no_sway(
    shown: Callable[[str], Page], name: str, count: int
) -> None:
    inside, told, sway = shown(name).evaluate(RANDOM, [count, 1, EDGE])
    assert inside and told == [] and sway < 1e-6


def test_another_load_on_the_way_is_no_jerk(shown: Callable[[str], Page]) -> None:
    page = shown("lab")
    page.evaluate(RECORD)
    drive(page, "ArrowRight", "page.driver.load[1] > data.start[1] + 0.05")
    page.evaluate("page.driver.take(0.5)")
    rows = recorded(page, 4.0)
    assert page.evaluate("page.driver.system.crane.read(page.driver.system.crane.channel("
                         "['payload.mass']))[0]") == 0.5
    assert abs(rows[-1, 4:9]).max() < 1e-6
    # of velocity and sway from one row to the next, 10 ms later: no more than the plan's own
    assert abs(np.diff(rows[:, 4:9], axis=0)).max() < 0.01


def test_the_mission_flies_to_its_end(shown: Callable[[str], Page]) -> None:
    page = shown("40 t")
    page.evaluate(RECORD)
    page.keyboard.press("m")
    mission = segfmu.load_mission(MISSIONS["40 t"])
    page.select_option("#pace", "5")
    rows = recorded(page, planned(mission).duration + 1.0)
    assert rows[-1, 1:4] == pytest.approx(mission.waypoints[-1].position, abs=1e-6)
    # the axis that rests in the mission moves behind it
    drive(page, "ArrowUp", "Math.abs(page.driver.load[0]) > 0.01")


def test_pad_and_gamepad_are_joysticks(shown: Callable[[str], Page]) -> None:
    page = shown("lab")
    box = page.locator("#pad").bounding_box()
    assert box is not None
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.down()
    page.mouse.move(box["x"] + box["width"], box["y"] + box["height"] / 2)
    page.wait_for_function("page.driver.command.kind === 'velocity'")
    assert page.evaluate("page.driver.command.velocity[1]") == page.evaluate("data.speeds[1]")
    page.mouse.up()
    page.wait_for_function("page.driver.command.kind === 'stop'")
    page.evaluate("""navigator.getGamepads = () => [
        {axes: [0.02, 0, 0, -0.52], buttons: [{pressed: false}, {pressed: false}]}]""")
    page.wait_for_function("page.driver.command.kind === 'velocity'")
    speed = page.evaluate("data.speeds[2]")
    assert page.evaluate("page.driver.command.velocity") == pytest.approx([0.0, 0.0, 0.5 * speed])
    page.evaluate("navigator.getGamepads = () => []")


def test_the_page_tells_why_a_command_is_not_taken(shown: Callable[[str], Page]) -> None:
    page = shown("40 t")
    page.select_option("#pace", "5")
    page.keyboard.down("ArrowRight")
    page.wait_for_function("/obstacle is in the way/.test(find('told').textContent)")
    page.keyboard.up("ArrowRight")
    # words of the FMU itself, from C
    message = page.evaluate("""() => {
        try {
            page.driver.system.feedforward.set({"limits.scale": 2.0});
        } catch (error) {
            return error.message;
        }
    }""")
    assert message.startswith("GantryFeedforward: ") and "limits.scale" in message


def test_numbers_have_the_digits_of_the_crane(browser: Browser, tmp_path: Path) -> None:
    mission = {
        "crane": segfmu.Crane(0.8, 0.3, 0.05), "limits": segfmu.Limits(0.05, 0.1, 0.5, 5.0),
        "waypoints": [segfmu.Waypoint([x, 0.0, -0.3]) for x in (-0.01, 0.01)],
    }
    page, _ = opened(browser, segfmu.live(mission, tmp_path / "live.html"))
    page.wait_for_function("find('place').textContent !== ''")
    assert page.inner_text("#place").split(", ") == ["-0.010", "0.000", "-0.300"]
    assert page.inner_text("#pace-now") == "0.0000 m/s"
    page.close()
