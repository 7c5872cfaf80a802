"""The figure of an identification: names apart, fits that tell something, no empty panels."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from segfmu.validation.identification.log import OUTPUTS
from segfmu.validation.identification.prediction import LOAD, Prediction, SignalFit
from segfmu.validation.plots.identification import plot_identification


def part(name: str, signals: tuple[str, ...], index: float) -> Prediction:
    times = np.linspace(0.0, 5.0, 50)
    columns = {"time": times}
    for signal in signals:
        columns |= {signal: np.sin(times), f"simulated.{signal}": np.cos(times)}
    return Prediction(
        name, columns, tuple(SignalFit(s, index, 0.1, 0.2, 1.0) for s in signals), None, ()
    )


def test_what_changes_little_far_from_zero_is_no_flat_line() -> None:
    """A rope of 30 m with 1 mm of noise was two lines, and its difference a third."""
    name, times = "measured.rope.length", np.linspace(0.0, 5.0, 50)
    noise = 1e-3 * np.sin(40.0 * times)
    one = Prediction(
        "log", {"time": times, name: 30.0 + noise, f"simulated.{name}": np.full(50, 30.0)},
        (SignalFit(name, 0.0, 1e-3, 1e-3, 1.0),), None, (),
    )
    (panel,) = plot_identification([one], "fitted").axes
    assert panel.get_ylabel() == "measured\nrope.length\nless 30 m\n[mm]"
    measured, simulated, difference = (line.get_ydata() for line in panel.lines)
    assert np.allclose(measured, 1e3 * noise) and np.allclose(simulated, 0.0)
    assert np.allclose(difference, 1e3 * noise)


def test_names_are_apart_and_fits_have_few_digits(tmp_path: Path) -> None:
    shown = [part("a log", (*OUTPUTS, *LOAD), -2.74e7), part("with $1", OUTPUTS[:2], np.nan)]
    figure = plot_identification(shown, "only predicted")
    assert figure.get_suptitle() == "Measured and simulated signals, only predicted"
    figure.savefig(tmp_path / "figure.png")
    drawn = [panel for panel in figure.axes if panel.axison]
    assert len(figure.axes) == 16 and len(drawn) == 10
    # panels of the log with all signals, below each other
    boxes = [panel.yaxis.label.get_window_extent() for panel in figure.axes[0::2]]
    assert not any(box.count_overlaps(boxes[:i]) for i, box in enumerate(boxes))
    legends = [panel.get_legend().get_texts()[1].get_text() for panel in figure.axes[:2]]
    assert legends == ["simulated, fit below -10", "simulated, fit rests"]
    assert sum(panel.get_xlabel() == "time [s]" for panel in drawn) == 2
