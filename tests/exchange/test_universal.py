# SPDX-License-Identifier: BSD-3-Clause
"""Universal files, read back by pyuff."""

import csv

import numpy as np
import pyuff
import pytest

DIRECTIONS = ["x", "y", "z", "rx", "ry", "rz"]


def nodes_of(folder) -> dict[str, int]:
    with open(folder / "machine_nodes.csv", newline="") as file:
        return {row["name"]: int(row["node"]) for row in csv.DictReader(file)}


def sets(path, kind: int) -> list[dict]:
    file = pyuff.UFF(str(path))
    return [file.read_sets(i) for i in np.flatnonzero(file.get_set_types() == kind)]


def recomputed(program, hertz) -> dict[str, np.ndarray]:
    """The response of the program at the frequencies of the file, per newton."""
    found = program.json("response", "--at", ",".join(f"{2 * np.pi * f!r} rad/s" for f in map(float, hertz)))
    curves = {one["name"]: np.array(one["complex"]) for one in found["results"]}
    return {
        name: (c[..., 0] + 1j * c[..., 1] if c.ndim == 2 else c[::2] + 1j * c[1::2]) / 25 for name, c in curves.items()
    }


@pytest.mark.parametrize(("to", "digits"), [("universal", 1e-11), ("universal_binary", 1e-6)])
def test_functions_at_the_frequencies_of_the_file(program, tmp_path, to, digits):
    """ζ is about 1e-5 here, so a rounded frequency would change amplitudes near a peak by half."""
    program.export(to, tmp_path / "machine.uff")
    functions = sets(tmp_path / "machine.uff", 58)
    hertz = functions[0]["x"]
    expected = recomputed(program, hertz[::17])
    nodes = nodes_of(tmp_path)
    assert len(functions) == len(expected)
    for function in functions:
        name = function["id1"].strip()
        scale = abs(expected[name]).max()
        relative = abs(function["data"][::17] - expected[name]) / np.maximum(abs(expected[name]), 1e-9 * scale)
        assert relative.max() < digits, name
        place, _, direction = name.rpartition(".")
        if place in nodes:
            assert function["rsp_node"] == nodes[place]
            assert function["rsp_dir"] == DIRECTIONS.index(direction) + 1
        assert function["ref_node"] == nodes["pump 1.flange"]
        assert function["ref_dir"] == 3
        assert function["func_type"] == 4


def test_modes_nodes_and_units(program, tmp_path):
    program.export("universal", tmp_path / "machine.uff")
    given = program.json("modes")["modes"]
    modes = sets(tmp_path / "machine.uff", 55)
    nodes = nodes_of(tmp_path)
    assert len(modes) == len(given)
    for mode, expected in zip(modes, given, strict=True):
        assert mode["freq"] == pytest.approx(expected["angular_frequency"] / (2 * np.pi), rel=1e-5)
        at = list(mode["node_nums"]).index(nodes["raft"])
        shape = [mode[f"r{i}"][at] for i in range(1, 7)]
        names = [f"raft.{direction}" for direction in DIRECTIONS]
        wanted = np.array([shape_of(expected, name) for name in names])
        np.testing.assert_allclose(shape, wanted, rtol=0, atol=2e-5 * abs(wanted).max())
    (points,) = sets(tmp_path / "machine.uff", 15)
    flange = list(points["node_nums"]).index(nodes["pump 1.flange"])
    assert [points[axis][flange] for axis in "xyz"] == pytest.approx([0.3, 0.1, 0.2], rel=1e-5)
    (units,) = sets(tmp_path / "machine.uff", 164)
    assert (units["units_code"], units["length"], units["force"]) == (1, 1, 1)


def shape_of(mode: dict, name: str) -> float:
    body, _, direction = name.rpartition(".")
    shape = mode["shape"]
    if isinstance(shape, dict):
        return shape[name] if name in shape else shape[body][DIRECTIONS.index(direction)]
    index = ["pump 1", "raft"].index(body) * 6 + DIRECTIONS.index(direction)
    return float(np.ravel(shape)[index])


def test_coarse_digits_are_said(program, tmp_path):
    notes = program.export("universal", tmp_path / "machine.uff")
    assert "six digits of frequency" in notes
    assert "universal_binary" in notes


def test_directions_of_turned_bodies_are_those_of_the_ground(with_text, program, tmp_path):
    turned = '[bodies.raft]\norientation = {axis = [0, 0, 1], angle = "90 deg"}'
    askew = turned.replace("90 deg", "20 deg")
    for text, wanted in ((turned, {"x": 2, "y": -1, "z": 3, "rx": 5}), (askew, {"z": 3})):
        other = with_text(program.path.read_text().replace("[bodies.raft]", text))
        notes = other.export("universal", tmp_path / "machine.uff")
        nodes = nodes_of(tmp_path)
        found = {f["id1"].strip(): (f["rsp_node"], f["rsp_dir"]) for f in sets(tmp_path / "machine.uff", 58)}
        for direction, number in wanted.items():
            assert found[f"raft.{direction}"] == (nodes["raft"], number)
        assert ("raft.x: its axis is not an axis of the ground" in notes) == (text == askew)
        for file in tmp_path.glob("machine*"):
            if file.suffix != ".toml":
                file.unlink()


def test_one_selected_force_gives_frequency_responses(with_text, program, tmp_path):
    other = '[excitations.other]\ntype = "harmonic"\non = "raft"\nat = [0, 0, 0]\nforce = [1, 2, 3]\n'
    text = program.path.read_text().replace('response = {band', 'response = {excitations = ["shaft"], band')
    with_text(text.replace("[analyses]", other + "[analyses]")).export("universal", tmp_path / "machine.uff")
    assert {function["func_type"] for function in sets(tmp_path / "machine.uff", 58)} == {4}
