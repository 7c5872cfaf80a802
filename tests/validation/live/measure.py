"""Frames and steps of pages in Chromium: `python -m tests.validation.live.measure`."""

from __future__ import annotations

import tempfile
import time
from pathlib import Path

from playwright.sync_api import Page

import segfmu
from segfmu.cosim.change import Change
from segfmu.cosim.system import System
from segfmu.fmu.native.archive import build_all
from segfmu.validation.live.space import limits, space, speeds
from segfmu.validation.live.system import interfaces
from segfmu.validation.planned import planned
from tests.validation.live.test_live import FEEDFORWARD, MISSIONS, resting
from tests.validation.report.browser import DESK, PHONE, chromium, opened

# s of model time; the joystick is held in the first half
SPAN = 20.0
FRAMES = """async () => {
    const times = [], work = [], frame = page.frame.bind(page);
    page.frame = (now) => {
        const start = performance.now();
        frame(now);
        work.push(performance.now() - start);
        times.push(now);
    };
    await new Promise((next) => setTimeout(next, 10000));
    work.sort((a, b) => a - b);
    const share = (part) => work[Math.floor(part * (work.length - 1))];
    const rate = 1000 * (times.length - 1) / (times[times.length - 1] - times[0]);
    return [rate, share(0.5), share(0.99), share(1)];
}"""
# ms of a run of `end` s, whose first half has the commands of a joystick
STEPS = """async ([settings, command, end]) => {
    const system = await CraneSystem.load(data, Driver.STATE);
    const run = () => {
        system.begin(0, settings, {});
        system.change(system.feedforward, command);
        const start = performance.now(), count = Math.round(end / data.step);
        for (let i = 1; i <= count; i += 1) {
            if (i === Math.round(count / 2)) system.change(system.feedforward, {"command.mode": 4});
            system.advance(i * data.step);
        }
        return performance.now() - start;
    };
    run();
    return run();
}"""


def main() -> None:
    """Measure both sizes of cranes."""
    with tempfile.TemporaryDirectory() as place, chromium() as browser:
        for name, path in MISSIONS.items():
            page = segfmu.live(path, Path(place) / f"{name}.html")
            print(f"{name}: {page.stat().st_size / 1024:.0f} KiB")
            for size in (DESK, PHONE):
                tab, _ = opened(browser, page, size)
                tab.keyboard.down("PageUp")
                rate, median, late, worst = tab.evaluate(FRAMES)
                print(f"  {size[0]} px: {rate:.1f} frames a second; work in one {median:.1f} ms "
                      f"(median), {late:.1f} ms (99 %), {worst:.1f} ms (largest)")
                tab.close()
            tab, _ = opened(browser, page)
            tab.evaluate("page.frame = () => {}")
            steps(name, path, Path(place), tab)
            tab.close()


def steps(name: str, path: Path, place: Path, tab: Page) -> None:
    """Time of a step, in the page and of the native FMUs by the loop in C."""
    mission = segfmu.load_mission(path)
    plan = planned(mission)
    room = space(mission, plan)
    own = limits(mission, plan, room)
    start, speed = mission.waypoints[0].position, speeds(mission, plan, own)[0]
    values = {"command.velocity.z": float(0.5 * speed[2])}
    count = SPAN / mission.simulation.step
    command = {"command.mode": 3, **values}
    spent = tab.evaluate(STEPS, [resting(start), command, SPAN])
    page = 1e3 * spent / count
    paths = build_all(interfaces(mission, plan, room, own), place / name)
    with System(paths, step=mission.simulation.step) as system:
        begin = time.perf_counter()
        system.run(
            {FEEDFORWARD: resting(start)}, stop_time=SPAN, changes=[
                Change(0.0, FEEDFORWARD, {"command.mode": "velocity", **values}),
                Change(0.5 * SPAN, FEEDFORWARD, {"command.mode": "stop"}),
            ],
        )
        native = 1e6 * (time.perf_counter() - begin) / count
    print(f"  a step of both FMUs: {page:.1f} us in the page, {native:.1f} us native")


if __name__ == "__main__":
    main()
