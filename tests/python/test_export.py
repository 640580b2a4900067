# SPDX-License-Identifier: BSD-3-Clause
"""Exports from Python are those of the command line; tests/exchange reads them with other programs."""

import numpy as np
import pytest

import trivet


def test_by_ending(machine, tmp_path):
    notes = machine.export(tmp_path / "machine.npz", what=["matrices", "modes"])
    assert notes == []
    data = np.load(tmp_path / "machine.npz")
    np.testing.assert_array_equal(data["matrices/K"], machine.matrices().K)
    np.testing.assert_array_equal(data["modes/shape"], machine.modes().array("shape"))


def test_same_bytes(machine, tmp_path, command_line):
    machine.save(tmp_path / "machine.toml")
    read = trivet.open(tmp_path / "machine.toml")
    for name in ("numpy", "nastran", "universal", "fmu"):
        read.export(tmp_path / "python", name)
        command_line("export", str(tmp_path / "machine.toml"), "--to", name, "-o", str(tmp_path / "program"))
        assert (tmp_path / "python").read_bytes() == (tmp_path / "program").read_bytes()


def test_refusals(machine, tmp_path):
    for path, keys, words in (
        ("x.docx", {}, "ending"),
        ("x.mat", {"to": "matlba"}, 'did you mean "matlab"'),
        ("x.mat", {"what": ["mods"]}, 'did you mean "modes"'),
        ("absent/x.mat", {}, "no folder"),
    ):
        with pytest.raises(trivet.InputError, match=words):
            machine.export(tmp_path / path, **keys)
    assert list(tmp_path.iterdir()) == []


def test_formats():
    assert {"matlab", "hdf5", "excel"} <= {
        name for name, about in trivet._core.formats() if "not built in" not in about
    }
