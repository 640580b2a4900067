# SPDX-License-Identifier: BSD-3-Clause
"""Modes and functions of universal files, read back by SDynPy (it does not read the nodes of set 15)."""

import os

import numpy as np
import pytest
from test_universal import nodes_of, recomputed, shape_of

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
import sdynpy  # noqa: E402


@pytest.fixture(params=["universal", "universal_binary"])
def form(request):
    return request.param


@pytest.fixture
def content(program, tmp_path, form):
    program.export(form, tmp_path / "machine.uff")
    return sdynpy.unv.readunv(str(tmp_path / "machine.uff"))


def test_modes(program, content, tmp_path):
    given = program.json("modes")["modes"]
    shapes = sdynpy.shape.ShapeArray.from_unv(content)
    expected = [mode["angular_frequency"] / (2 * np.pi) for mode in given]
    assert np.ravel(shapes.frequency) == pytest.approx(expected, rel=1e-5)
    node = nodes_of(tmp_path)["raft"]
    for shape, mode in zip(np.ravel(shapes), given, strict=True):
        places = np.ravel(shape.coordinate)
        (at,) = np.flatnonzero((places["node"] == node) & (abs(places["direction"]) == 3))
        assert np.ravel(shape.shape_matrix)[at] == pytest.approx(shape_of(mode, "raft.z"), abs=2e-5)


def test_functions(program, content, form):
    """SDynPy holds abscissas in single precision; in text they have six digits, in binary single precision."""
    read = sdynpy.data.NDDataArray.from_unv(content)
    compared = 0
    for group in read if isinstance(read, list) else [read]:
        for function in np.ravel(group)[::5]:
            hertz = np.ravel(function.abscissa)[::50]
            if form == "universal":
                hertz = [float(f"{x:.5e}") for x in hertz]
            expected = recomputed(program, hertz)[str(function.comment1).strip()]
            found = np.ravel(function.ordinate)[::50]
            assert abs(found - expected).max() < 1e-6 * abs(expected).max()
            compared += 1
    assert compared == 5
