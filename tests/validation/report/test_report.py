"""What reports say, and that thinned curves are those of the run."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from io import StringIO
from pathlib import Path

import numpy as np
import pyarrow
import pytest
from rich.console import Console

import segfmu
from segfmu.crane.bounds import DRIVES
from segfmu.validation.campaigns.result import CampaignResult
from segfmu.validation.campaigns.tables import criteria_table
from segfmu.validation.drive_use import PLACES
from segfmu.validation.plots.plan import plot_plan
from segfmu.validation.report import campaign_page, run_page, suite_page
from segfmu.validation.report.curves import TOLERANCE, thinned
from segfmu.validation.report.motion import drive_section, load_section, owned
from segfmu.validation.report.page import render
from segfmu.validation.report.suite_page import percent
from segfmu.validation.tables import plan_table
from segfmu.validation.units import length, pretty
from tests.compiler import needs_native
from tests.validation.stopped import stopped

MODELS = Path(__file__).parents[3] / "models"


@pytest.fixture(scope="module")
def run() -> segfmu.Run:
    return segfmu.simulate(MODELS / "inteco.toml", step=0.005)


@pytest.mark.parametrize("noise", [0.0, 0.3])
def test_a_thinned_curve_is_the_curve_to_a_third_of_a_pixel(noise: float) -> None:
    x = np.linspace(0.0, 10.0, 700)
    y = np.sin(x) * np.exp(-0.2 * x) + noise * np.random.default_rng(1).normal(size=x.size)
    few = thinned(x, y, float(np.ptp(y)))
    assert np.abs(np.interp(x, *few) - y).max() <= TOLERANCE * np.ptp(y)
    assert noise or few[0].size < 80


def test_a_long_curve_keeps_its_peaks() -> None:
    x = np.arange(200_000.0)
    y = np.where(x == 123_457, 5.0, np.sin(1e-3 * x))
    few = thinned(x, y, 10.0)
    assert few[1].max() == 5.0 and 123_457 in few[0] and few[0].size < 1000


@pytest.mark.parametrize(
    ("value", "text"),
    [(0.0, "0"), (0.005, "0.005"), (471e3, "471000"), (1.23456, "1.235"), (-0.02, "-0.02"),
     (1e-9, "1e-09"), (3.2e9, "3.2e+09"), (999.96, "1000")],
)
def test_numbers_are_short(value: float, text: str) -> None:
    assert pretty(value) == text


@pytest.mark.parametrize(("largest", "unit"), [(2.0, "m"), (0.02, "mm"), (3e-6, "µm")])
def test_lengths_have_the_unit_that_suits_them(largest: float, unit: str) -> None:
    assert length(largest)[1] == unit


@needs_native
def test_every_measure_is_in_the_verdict(run: segfmu.Run) -> None:
    page = run_page(run)
    assert len(page.summary.rows) == len(run.criteria.rows)
    assert {row[4][0] for row in page.summary.rows} == {"passed"}
    text = render(page)
    assert re.search(r"<title>[^<]*passed</title>", text)
    # on a phone a row begins with its number, beside what it counts
    assert '<th scope="row" data-head="waypoint">2</th>' in text
    assert '<th scope="row">residual sway</th>' in text
    assert "segfmu simulate" in text and 'below <span class="number">1e-6</span> mm' in text


@needs_native
def test_a_failed_run_says_so(run: segfmu.Run) -> None:
    swinging = segfmu.load_mission(run.mission, {"simulation": {"initial_sway": [3.0, 0.0]}})
    page = run_page(segfmu.simulate(swinging, step=0.005))
    assert not page.passed and page.verdict == "failed"
    assert ("failed", "bad") in [row[4] for row in page.summary.rows]
    (error,) = [s for s in page.sections if s.title == "Tracking error"]
    assert error.charts[0].unit == "mm"


@needs_native
def test_charts_show_the_run(run: segfmu.Run) -> None:
    page = run_page(run)
    charts = {chart.title: chart for section in page.sections for chart in section.charts}
    for drive, name in (("bridge", "bridge"), ("trolley", "trolley"), ("hoist", "rope")):
        chart = charts[f"{drive}, velocity"]
        curve = chart.curves[0]
        there = np.interp(run.time, curve.x, curve.y)
        height = chart.limits[1] - chart.limits[0] if chart.limits[1] else np.ptp(curve.y)
        assert np.abs(there - run[f"{name}.velocity"]).max() < 3.0 * TOLERANCE * height
    # weight of the load: the rope pulls
    pull = charts["hoist, force"].curves[0].y[-1]
    assert pull == pytest.approx(9.81 * run.mission.crane.payload_mass, rel=1e-2)


def test_variables_of_both_fmus_are_found_beside_others_of_their_names() -> None:
    names = ["time", "GantryFeedforward.velocity.bridge", "Own.velocity.bridge", "GantryCrane.a",
             "a", "Own.b"]
    rows = np.zeros(3, dtype=[(name, float) for name in names])
    found = owned(rows).dtype.names
    assert found == ("time", "velocity.bridge", "Own.velocity.bridge", "GantryCrane.a", "a",
                     "Own.b")


def test_the_peak_of_a_short_ramp_shows() -> None:
    limits = segfmu.Limits(1.0, 1.0, 4.0, 40.0)
    far = [segfmu.Waypoint([0.0, 0.0, -1.0]), segfmu.Waypoint([2000.0, 0.0, -1.0])]
    charts = load_section(segfmu.plan(far, limits, axis_names="xyz")).charts
    for chart in charts[1:]:
        assert max(chart.curves[0].y) == pytest.approx(100.0, abs=0.5)


def test_a_load_that_rests_has_words_in_place_of_empty_charts() -> None:
    limits = segfmu.Limits(1.0, 1.0, 4.0, 40.0)
    there = [segfmu.Waypoint([0.0, 0.0, -1.0])] * 2
    section = load_section(segfmu.plan(there, limits, axis_names="xyz"))
    assert not section.charts and "rests in its place" in section.text


def test_a_motion_is_compared_with_the_limit_of_its_direction() -> None:
    limits = segfmu.Limits(1.0, 1.0, 4.0, 40.0, velocity_min=-0.25, acceleration_min=-0.5)
    points = [segfmu.Waypoint([x, 0.0, -1.0]) for x in (0.0, 20.0, 0.0)]
    trajectory = segfmu.plan(points, limits, axis_names="xyz")
    velocity, acceleration = load_section(trajectory).charts[1:3]
    for chart in (velocity, acceleration):
        assert max(chart.curves[0].y) == pytest.approx(100.0, abs=0.5)
        assert min(chart.curves[0].y) == pytest.approx(-100.0, abs=0.5)
    figure = plot_plan(trajectory, "there and back")
    low, high = figure.axes[1].lines[0].get_ydata().min(), figure.axes[1].lines[0].get_ydata().max()
    assert (low, high) == pytest.approx((-100.0, 100.0), abs=0.5)
    assert figure.axes[1].lines[0].get_label() == "x, of -0.25 to 1 m/s"


def test_a_drive_is_compared_with_the_bound_of_its_direction() -> None:
    names = [f"drive.{d}.force" for d in DRIVES] + [f"force.{d}" for d in DRIVES]
    for axis in ("bridge", "trolley", "rope"):
        names += [f"{axis}.velocity", f"reference.{axis}.velocity"]
    names += [f"velocity.{d}" for d in DRIVES] + ["sway.x.angle", "sway.y.angle", *PLACES]
    rows = np.zeros(101, dtype=[(n, float) for n in ("time", *names)])
    rows["time"] = np.linspace(0.0, 1.0, 101)
    rows["trolley.velocity"] = np.where(rows["time"] < 0.5, 0.4, -0.19)
    bounds = segfmu.ActuatorBounds(
        velocity=[None, 1.0, None], velocity_min=[None, -0.2, None], force=[None, None, 9.0],
    )
    charts = {c.title: c for c in drive_section(rows, bounds, ("velocity",)).charts}
    assert "peak 0.19 m/s, 95 % of 0.2 m/s" in charts["trolley, velocity"].caption
    assert charts["trolley, velocity"].limits == (-0.2, 1.0)


@pytest.mark.parametrize("given", [True, False])
def test_limits_that_the_mission_does_not_have_are_told(given: bool) -> None:
    limits = segfmu.Limits(1.0, 1.0, 4.0, 40.0)
    points = [segfmu.Waypoint([0.0, 0.0, -1.0]), segfmu.Waypoint([1.0, 0.0, -1.0])]
    trajectory = segfmu.plan(points, limits)
    text = str(load_section(trajectory, given).text)
    assert ("The mission has no limits: these were found" in text) == (not given)
    table = plan_table("m", trajectory, segfmu.verify(trajectory), given)
    assert (table.caption is None) == given
    # y rests: limits of 1 stand for none that were searched for
    assert next(iter(table.columns[2].cells)) == ("0 of 1" if given else "rests")
    assert ("y 0 of 1;" in load_section(trajectory, given).charts[1].caption) == given
    lines = plot_plan(trajectory, "m", given).axes[1].lines
    assert [lines[0].get_label(), lines[1].get_label()] == [
        "x, of 1 m/s", "y, of 1 m/s" if given else "y",
    ]


@needs_native
def test_large_cranes_have_large_units() -> None:
    run = segfmu.simulate(MODELS / "scenarios" / "_quay_mission.toml", step=0.02)
    page = run_page(run)
    charts = {chart.title: chart for section in page.sections for chart in section.charts}
    assert charts["hoist, force"].unit == "kN" and charts["hoist, power"].unit == "kW"
    texts = [str(section.text) for section in page.sections]
    assert any("Bridge: at rest" in text for text in texts)


@needs_native
def test_the_data_are_json_that_ends_no_element(run: segfmu.Run) -> None:
    text = render(run_page(run))
    (data,) = re.findall(r'<script id="data" type="application/json">(.*?)</script>', text)
    content = json.loads(data)
    assert len(content["scenes"]) == 1 and len(content["charts"]) > 15
    scene = content["scenes"][0]
    assert {len(row) for row in scene["frames"]} == {len(scene["times"])}


@needs_native
def test_a_suite_has_every_criterion_and_error(tmp_path: Path) -> None:
    suite = segfmu.validate([MODELS / "scenarios" / "wind.toml", stopped(tmp_path)])
    text = suite.report(tmp_path / "report.html").read_text(encoding="utf-8")
    for result in suite:
        assert f"segfmu validate {result.scenario.path}" in text
        assert all(finding.name in text for finding in result.findings)
    bounds = [row[3] for row in suite_page(suite).sections[0].tables[0].rows]
    # a number and its unit are on one line
    assert {style for _, style in bounds} == {"number"}
    assert [bound.split()[1:] for bound, _ in bounds] == [["m"], []]
    assert "end stop" in text and "as expected" in text


def campaign(runs: int = 500) -> CampaignResult:
    """A campaign whose margin falls with the gust, and in which one run has an error."""
    draw = np.random.default_rng(3)
    gust, payload = draw.uniform(0.0, 2.0, runs), draw.uniform(0.9, 1.1, runs)
    margins = [*(0.01 * (1.5 - gust) + 1e-3 * draw.normal(size=runs))[:-1], None]
    holds = [None if margin is None else margin >= 0.0 for margin in margins]
    table = pyarrow.table({
        "run": range(runs), "scenario": ["quay.toml"] * runs, "gust": gust, "payload": payload,
        "passed": [bool(held) for held in holds], "error": [None] * (runs - 1) + ["rope is slack"],
        "margin.near its plan": margins, "bound.near its plan": [0.02] * runs,
        "holds.near its plan": holds,
    })
    return CampaignResult("gusts", Path("out"), ("gust", "payload"), ("near its plan",), table)


def test_a_campaign_has_every_run_in_its_distribution() -> None:
    result = campaign()
    page = campaign_page(result)
    margins = np.array(result.column("margin.near its plan")[:-1])
    (chart,) = page.sections[0].charts
    counts = chart.curves[0].y
    assert sum(counts) == margins.size and chart.limits == (0.0, None)
    # bars below zero have the runs that fail, but for the bar at zero
    below = sum(n for n, x in zip(counts, chart.curves[0].x[1:], strict=False) if x <= 0.0)
    assert abs(below - (margins < 0.0).sum()) <= max(counts)
    assert page.verdict == f"{sum(result.column('passed'))} of 500 runs passed"


def test_a_campaign_names_causes_worst_case_and_errors(tmp_path: Path) -> None:
    result = campaign()
    text = result.report(tmp_path / "report.html").read_text(encoding="utf-8")
    worst = int(np.argmin(result.column("margin.near its plan")[:-1]))
    assert f"segfmu validate out/run_{worst}.toml" in text and "rope is slack" in text
    depends = campaign_page(result).summary.rows[0][-1]
    assert depends == "gust"
    points = next(s for s in campaign_page(result).sections if s.tables and s.charts).charts[0]
    # the effect is that of the draw: the margin falls by 0.01 for 1 of the gust
    slope = np.polyfit(points.curves[0].x, points.curves[0].y, 1)[0]
    assert points.across == "gust" and slope == pytest.approx(-0.01, rel=0.05)
    # the unit alone is in brackets, and there are none without
    assert points.unit == "" and "<b>near its plan</b> <span" in text


@pytest.mark.parametrize(("share", "told"), [
    (1e-4, "0.0 %"), (0.268, "+26.8 %"), (-9.9, "-990.0 %"), (-65.478, "-6,548 %"),
])
def test_shares_have_no_digits_that_tell_nothing(share: float, told: str) -> None:
    assert percent(share) == told


def test_the_table_of_a_campaign_is_whole_on_a_narrow_terminal() -> None:
    """Its last column was cut."""
    margins = [0.00771] * 999 + [-0.003468]
    table = pyarrow.table({
        "run": range(1000), "scenario": ["quay.toml"] * 1000, "gust": np.linspace(2.0, 0.0, 1000),
        "passed": [True] * 999 + [False], "error": pyarrow.array([None] * 1000, pyarrow.string()),
        "margin.no sway behind the arrival": np.linspace(1.0, 2.0, 1000) * margins,
        "holds.no sway behind the arrival": [True] * 999 + [False],
    })
    result = CampaignResult(
        "gusts", Path(), ("gust",), ("no sway behind the arrival",), table,
        units={"no sway behind the arrival": "rad"}, draws=1000,
    )
    shown = StringIO()
    Console(file=shown, width=80).print(criteria_table(result))
    lines = shown.getvalue().splitlines()[1:]
    assert {len(line) for line in lines} == {len(lines[0])} and len(lines[0]) <= 80
    assert lines[0][-1] == "┓" and all(
        word in shown.getvalue() for word in ("fails (95 %)", "depends", "gust")
    )


def test_a_campaign_has_no_empty_columns_and_names_no_chart_that_is_not_there() -> None:
    """Of runs that are no draws the probability of a failure is not known."""
    for draws, columns in ((0, ("share",)), (500, ("share", "fails (95 %)"))):
        page = campaign_page(replace(campaign(), draws=draws))
        assert page.summary.heads == (
            "criterion", "held", *columns, "least margin", "run", "depends most on"
        )
        assert all("" not in row[:-1] for row in page.summary.rows)
    table = campaign().table
    methods = pyarrow.array(["a" if gust < 1.0 else "b" for gust in table["gust"].to_pylist()])
    chosen = replace(
        campaign(), factors=("gust",),
        table=table.set_column(table.column_names.index("gust"), "gust", methods),
    )
    section = next(s for s in campaign_page(chosen).sections if s.title.startswith("What the"))
    assert not section.charts and "charts" not in section.text


def test_numbers_with_exponents_stay_on_one_line(tmp_path: Path) -> None:
    table = pyarrow.table({
        "run": [0], "scenario": ["<s>"], "<gust>": [1.55e-9], "passed": [False],
        "error": pyarrow.array([None], pyarrow.string()),
        "margin.c": [-1.55e-9], "bound.c": [0.1], "holds.c": [False],
    })
    result = CampaignResult("tiny", tmp_path, ("<gust>",), ("c",), table)
    text = result.report(tmp_path / "report.html").read_text(encoding="utf-8")
    whole = '<span class="number">{}</span>'
    assert f"<span>{whole.format('-1.55e-09')}</span></td>" in text
    assert f"<span>&lt;gust&gt; {whole.format('1.55e-09')}</span></td>" in text
    assert ".number { white-space: nowrap; }" in text


def test_a_search_shows_worst_cases_in_place_of_shares() -> None:
    result = replace(campaign(), searched=("near its plan",))
    summary = campaign_page(result).summary
    assert summary.heads == ("criterion", "held", "least margin", "run", "worst case")
    worst = int(np.argmin(result.column("margin.near its plan")[:-1]))
    gust = pretty(result.column("gust")[worst])
    assert str(summary.rows[0][-1]).startswith(f"gust {gust}, payload ")
    assert not result.sensitivities


def test_a_campaign_of_one_run_has_a_report(tmp_path: Path) -> None:
    assert campaign(2).report(tmp_path / "report.html").stat().st_size > 1e6
