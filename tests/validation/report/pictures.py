"""Pictures of reports in docs: `python -m tests.validation.report.pictures FOLDER`."""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import segfmu
from tests.validation.report.browser import DESK, PHONE, chromium, opened

MISSION = Path(__file__).parents[3] / "models" / "container.toml"
# in the picture: this share of the run, with the container over the stack
MOMENT = 0.4


def main() -> None:
    """Write report_1280.png and report_390.png."""
    folder = Path(sys.argv[1])
    with tempfile.TemporaryDirectory() as place, chromium() as browser:
        report = segfmu.simulate(MISSION).report(Path(place) / "report.html")
        for size in (DESK, PHONE):
            page, complaints = opened(browser, report, size)
            assert not complaints, complaints
            page.evaluate(
                """share => {
                    const slider = document.getElementById("time");
                    slider.value = share * slider.max;
                    slider.dispatchEvent(new Event("input"));
                }""",
                MOMENT,
            )
            page.evaluate("document.getElementById('view').scrollIntoView()")
            target = folder / f"report_{size[0]}.png"
            page.screenshot(path=target)
            print(target)


if __name__ == "__main__":
    main()
