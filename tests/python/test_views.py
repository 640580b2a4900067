# SPDX-License-Identifier: BSD-3-Clause
"""The read-only view of a project, curves and rows by name, and pictures in given axes."""

import copy
import pickle

import numpy as np
import pytest
from conftest import MACHINE

import trivet


def test_values_are_those_of_the_file_with_the_changes(machine):
    assert machine["bodies.machine.mass"] == 120.0
    heavier = machine.changed({"bodies.machine.mass": "0.2 t"})
    assert heavier["bodies.machine.mass"] == 200  # the file has SI there, and a change keeps the form
    assert heavier.bodies["machine"].mass == pytest.approx(200.0, rel=1e-15)
    assert machine["bodies.machine"]["points"] == {"seat": [0.1, 0.2, 0.3]}
    path = "elements.a.translation"
    assert machine.changed({path: machine[path]}) == machine
    machine["bodies.machine"]["mass"] = 3  # a copy
    assert machine["bodies.machine.mass"] == 120.0
    starter = trivet.Project.from_toml(trivet.starter())
    assert starter['elements."mount front left".on'] == "machine"
    assert starter["bodies.machine.mass"] == "250 kg"


def test_bodies_and_mounts_are_tables(machine):
    assert machine.bodies == ["machine"]
    body = machine.bodies["machine"]
    assert body.principal_moments == pytest.approx((4.0, 5.0, 6.0))
    assert machine.mounts == machine.elements == ["a", "b", "c", "d"]
    mount = machine.changed({"elements.b.scale": 1.5}).mounts["b"]
    assert (mount.type, mount.body, mount.base, mount.scale) == ("bushing", "machine", "ground", 1.5)
    assert mount.place == (0.3, -0.2, -0.2)
    assert mount.stiffness == pytest.approx((6e4, 7.5e4, 13.5e4), rel=1e-15)
    frame = machine.mounts.to_dataframe()
    assert list(frame["stiffness z [N/m]"]) == [9e4] * 4
    assert "stiffness z [N/m]" in machine.mounts._repr_html_()
    assert list(machine.bodies.to_dataframe()["mass [kg]"]) == [120.0]
    again = pickle.loads(pickle.dumps(machine.mounts))
    assert again["c"] == machine.mounts["c"] == copy.deepcopy(machine.mounts)["c"]


def test_places_of_a_turned_body_are_on_the_ground():
    body = {"position": [1.0, 2.0, 3.0], "orientation": {"axis": [0, 0, 1], "angle": "90 deg"}}
    project = trivet.Project(**MACHINE | {"bodies": {"machine": MACHINE["bodies"]["machine"] | body}})
    # a quarter turn about z takes x to y
    assert project.bodies["machine"].in_ground((1.0, 0.0, 0.0)) == pytest.approx((1.0, 3.0, 3.0))
    assert project.mounts["b"].place == pytest.approx((1.0 + 0.2, 2.0 + 0.3, 3.0 - 0.2))


def test_a_curve_has_the_units_of_both_axes(machine):
    response = machine.response(band=("0 Hz", "40 Hz"))
    curve = response.curve("machine.z")
    assert np.array_equal(curve.values, response["machine.z"].values)
    assert np.array_equal(curve.amplitude, np.abs(curve.values))
    assert curve.unit == "m"
    for chosen, factor in (("Hz", 2 * np.pi), ("rpm", 2 * np.pi / 60), ("rad/s", 1.0)):
        one = response.to(frequency=chosen).curve("machine.z")
        assert one.frequency_unit == chosen
        assert np.allclose(one.frequency * factor, one.angular_frequency, rtol=1e-14, atol=0)
        shown = machine.changed({"display.frequency": chosen}).response(band=("0 Hz", "40 Hz")).curve("machine.z")
        assert shown.frequency_unit == chosen
    assert curve.frequency_unit in ("Hz", "rad/s")


def test_rows_have_names(machine):
    peaks = machine.peaks()
    table = peaks.table("peaks")
    rows = table["machine.z"]
    assert set(rows.names) == {"machine.z"}
    frame = peaks.to_dataframe()
    assert np.array_equal(rows.column("amplitude"), frame[frame["name"] == "machine.z"]["amplitude"])
    assert len(peaks["machine.z"]) == len(rows) > 0
    assert peaks["machine.z"].rows[0]["amplitude"] == rows.column("amplitude")[0]
    assert list(table.to_dataframe().columns) == list(frame.columns)
    assert len(table) == len(frame)


def test_pictures_draw_into_given_axes(machine):
    from matplotlib.figure import Figure

    response = machine.response(band=("0 Hz", "40 Hz"))
    figure = Figure()
    one, two = figure.subplots(2, 1)
    assert response.plot("machine.z", ax=[one, two]) is figure
    heights = one.get_lines()[0].get_ydata()
    assert np.array_equal(heights, response.curve("machine.z").amplitude)
    assert two.get_lines() and "phase" in two.get_ylabel()
    alone = Figure().subplots()
    response.curve("machine.z").plot(ax=alone)
    assert np.array_equal(alone.get_lines()[0].get_ydata(), heights)
    assert "frequency" in alone.get_xlabel() and "[m]" in alone.get_ylabel()
    for result in (machine.modes(), machine.peaks()):
        axes = Figure().subplots()
        result.plot(ax=axes)
        assert axes.get_lines()
    with pytest.raises(trivet.InputError, match="Plotly"):
        response.plot(backend="plotly", ax=alone)


def test_sweeps_are_drawn(machine):
    from matplotlib.figure import Figure

    scales, masses = np.array([0.5, 1.0, 2.0]), np.array([100.0, 150.0])
    sweep = machine.sweep({"elements.a.scale": scales, "bodies.machine.mass": masses}, of=["machine.z", "machine.rx"])
    axes = Figure().subplots()
    sweep.plot("machine.z", ax=axes)
    lines = axes.get_lines()
    assert len(lines) == 2
    assert np.array_equal(lines[0].get_xdata(), scales)
    assert np.array_equal(lines[1].get_ydata(), sweep["machine.z"][:, 1])
    assert "150" in lines[1].get_label()
    assert len(sweep.plot().axes) == 2  # m and rad
    with pytest.raises(KeyError):
        sweep.plot("machine.q")


@pytest.mark.parametrize(("view", "right", "up"), [("front", 0, 2), ("side", 1, 2), ("top", 0, 1)])
def test_a_project_is_drawn(machine, view, right, up):
    figure = machine.plot(view=view)
    (axes,) = figure.axes
    drawn = {tuple(point) for line in axes.get_lines() if line.get_label() == "mounts" for point in line.get_xydata()}
    assert drawn == {(mount.place[right], mount.place[up]) for mount in machine.mounts.rows()}
    assert [text.get_text() for text in axes.texts] == ["seat"]
