# SPDX-License-Identifier: BSD-3-Clause
"""Pictures: what they show, their labels and units. People looked at them; this keeps them as they were."""

import numpy as np
import pytest
from conftest import example

import trivet


def labels(figure) -> list[str]:
    return [text for axes in figure.axes for text in (axes.get_xlabel(), axes.get_ylabel()) if text]


def test_response(machine, tmp_path):
    figure = machine.response(band=("0 Hz", "20 Hz"), of=["coordinates"]).plot()
    assert labels(figure) == [
        "amplitude [m]", "frequency [Hz]", "phase [°]", "amplitude [rad]", "frequency [Hz]", "phase [°]",
    ]  # fmt: skip
    colours = [[line.get_color() for line in axes.get_lines()] for axes in figure.axes]
    assert colours[0] == colours[1]
    for line in figure.axes[1].get_lines():  # no vertical line where the phase passes ±180°
        steps = abs(np.diff(line.get_ydata()))
        assert np.all(steps[np.isfinite(steps)] <= 180)
    assert [line.get_label() for line in figure.axes[0].get_lines()] == ["machine.x", "machine.y", "machine.z"]
    assert figure.axes[0].get_yscale() == "log"
    figure.savefig(tmp_path / "response.png")
    assert (tmp_path / "response.png").stat().st_size > 10_000


def test_labels_tell_the_units(machine):
    shown = machine.response(band=("1 Hz", "20 Hz")).to(frequency="rpm", length="mil", level="peak_to_peak")
    assert labels(shown.plot("machine.z")) == ["peak to peak [mil]", "frequency [rpm]", "phase [°]"]


def test_results_of_peaks_by_name(machine):
    peaks = machine.peaks()
    name = peaks.array("name")[0]
    lines = [
        line for axes in peaks.plot(str(name)).axes for line in axes.get_lines() if not line.get_label().startswith("_")
    ]
    assert [line.get_label() for line in lines] == [name]
    with pytest.raises(trivet.InputError, match="no such result"):
        peaks.plot("machine.zz")


def test_a_continuous_phase_is_complete(machine):
    from trivet._plots import Line, Panel, _angles

    turns = Panel("x", "phase [°]", [Line("a", np.arange(3.0), np.array([0.0, -400.0, np.nan]))], phase=True)
    low, high, ticks = _angles(turns)
    assert low < -400 and high >= 180 and ticks[0] == -540 and 0 in ticks
    within = Panel("x", "phase [°]", [Line("a", np.arange(2.0), np.array([-180.0, 180.0]))], phase=True)
    assert _angles(within) == (-190, 190, [-180, -90, 0, 90, 180])


@pytest.mark.filterwarnings("ignore::trivet.ModelWarning")
@pytest.mark.parametrize("backend", ["matplotlib", "plotly"])
@pytest.mark.parametrize(
    ("path", "analysis"),
    [
        ("paper/corrected.toml", "modes"),
        ("paper/corrected.toml", "peaks"),
        ("track/bogie.toml", "random"),
        ("transport_shock/device.toml", "transient"),
        ("genset/genset.toml", "orders"),
        ("genset/genset.toml", "power"),
        ("measured_response/machine.toml", "measurements"),
        ("optical_table/table.toml", "transmissibility"),
    ],
)
def test_every_result_with_curves_has_a_picture(path, analysis, backend, tmp_path):
    figure = getattr(trivet.open(example(path)), analysis)().plot(backend=backend)
    if backend == "matplotlib":
        figure.savefig(tmp_path / "picture.png")
        assert all(label for label in labels(figure))
    else:
        assert len(figure.data) > 0
        figure.to_json()


def test_what_cannot_be_drawn(machine):
    with pytest.raises(trivet.InputError, match="no curves"):
        machine.suspension().plot()
    with pytest.raises(trivet.InputError, match="matplotlib"):
        machine.response().plot(backend="paper")
    with pytest.raises(trivet.InputError, match="no such result"):
        machine.response().plot("machine.q")


@pytest.mark.filterwarnings("ignore::trivet.ModelWarning")
def test_maps_and_fronts_are_those_of_the_report():
    assert trivet.open(example("paper/map.toml")).map(points=30).svg().startswith("<svg")
