# SPDX-License-Identifier: BSD-3-Clause
"""Nastran decks, read back by pyNastran and by the importer of the program."""

import re

import numpy as np
import pytest
from pyNastran.bdf import bdf

MOUNTS = ["a", "b", "c/d", "e", "f", "g"]


ONE_MOUNT = """trivet = 1
[bodies.machine]
mass = 180
inertia = {about = "center_of_mass", xx = 6, yy = 9, zz = 8}
[elements.mount]
type = "bushing"
on = "machine"
at = [0.1, 0.2, -0.2]
orientation = {axis = [1, 2, 3], angle = "30 deg"}
translation = [3e5, 4e5, 9.87654321e5]
rotation = [9e4, 8e4, 3e4]
"""
READ_BACK = """type = "imported"
file = "mounts.bdf"
name = "MOUNTK"
on = "machine"
at = [0.1, 0.2, -0.2]
nodes = [1001, 1002]
"""


def test_own_importer(with_text, tmp_path):
    """A mount read from the deck gives the frequencies of the mount itself."""
    program = with_text(ONE_MOUNT)
    program.export("nastran", tmp_path / "mounts.bdf")
    given = [mode["angular_frequency"] for mode in program.json("modes")["modes"]]
    read = with_text(ONE_MOUNT.split('type = "bushing"')[0] + READ_BACK)
    found = [mode["angular_frequency"] for mode in read.json("modes")["modes"]]
    assert found == pytest.approx(given, rel=1e-11)


def test_pynastran(program, tmp_path):
    """Each matrix consists of the blocks of its mounts, and is zero elsewhere."""
    program.export("nastran", tmp_path / "mounts.bdf")
    model = bdf.BDF(debug=False)
    model.read_bdf(tmp_path / "mounts.bdf", punch=True, xref=False)
    assert sorted(model.nodes) == list(range(1001, 1001 + 2 * len(MOUNTS)))
    for name, json_key in (("MOUNTK", "stiffness"), ("MOUNTB", "damping")):
        matrix = whole_matrix(model.dmig[name])
        for e, mount in enumerate(MOUNTS):
            block = slice(12 * e, 12 * (e + 1))
            found = matrix[block, block].copy()
            matrix[block, block] = 0
            given = np.array(find(program, mount)[json_key])
            assert abs(given).max() > 0
            if mount == "b":  # its axes are turned
                assert np.linalg.eigvalsh(found) == pytest.approx(
                    np.linalg.eigvalsh(given), abs=1e-9 * abs(given).max()
                )
            else:
                np.testing.assert_allclose(found, given, rtol=1e-12, atol=1e-12 * abs(given).max())
        assert not matrix.any()


def whole_matrix(dmig) -> np.ndarray:
    """With a row for each direction of each node; the deck leaves out those with zeros."""
    matrix, rows, columns = dmig.get_matrix(is_sparse=False)
    whole = np.zeros((12 * len(MOUNTS), 12 * len(MOUNTS)))

    def places(names: dict) -> list:
        return [6 * (names[i][0] - 1001) + names[i][1] - 1 for i in range(len(names))]

    whole[np.ix_(places(rows), places(columns))] = matrix
    return whole


def find(program, mount: str) -> dict:
    import json

    return json.loads(program("element", program.path, mount, "--json").stdout)


def test_a_relaxing_mount_has_its_stiffness_at_rest(with_text, program, tmp_path):
    relaxing = "damping = {maxwell = {ratios = [0.4, 0.2], times = [0.001, 0.01]}}"
    other = with_text(program.path.read_text().replace("damping = {proportional = 5e-7}", relaxing))
    notes = other.export("nastran", tmp_path / "relaxing.bdf")
    program.export("nastran", tmp_path / "elastic.bdf")
    assert "condensed statically" in notes
    largest = []
    for name in ("elastic.bdf", "relaxing.bdf"):
        lines = (tmp_path / name).read_text().splitlines()
        values = [line[40:56].strip() for line in lines if line.startswith("*  ") and line[40:56].strip()]
        largest.append(max(float(re.sub(r"(?<=\d)([+-])", r"e\1", value)) for value in values))
    assert largest[1] == pytest.approx(largest[0], rel=1e-12)


def test_an_unsymmetric_stiffness_is_rejected(with_text, program, tmp_path):
    matrix = [[0.0] * 6 for _ in range(6)]
    for i in range(6):
        matrix[i][i] = 3e5
    matrix[0][1] = 2e4
    text = program.path.read_text() + (
        f'[elements.skew]\ntype = "matrix"\non = "raft"\nat = [0, 0, -0.1]\nstiffness = {matrix}\nsymmetric = false\n'
    )
    said = with_text(text).export("nastran", tmp_path / "x.bdf", code=1)
    assert "not symmetric" in said
    assert not (tmp_path / "x.bdf").exists()
