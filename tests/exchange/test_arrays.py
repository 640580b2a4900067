# SPDX-License-Identifier: BSD-3-Clause
"""MATLAB, NumPy, HDF5, Matrix Market and CSV, read back by Octave, SciPy, NumPy, h5py and xarray."""

import csv
import json
import shutil
import subprocess

import h5py
import numpy as np
import pytest
import scipy.io
import scipy.linalg
import xarray
from conftest import ROOT

COORDINATES = [f"{body}.{c}" for body in ("pump 1", "raft") for c in ("x", "y", "z", "rx", "ry", "rz")]


def response(program):
    """Curves of the command line."""
    found = program.json("response")
    values = {one["name"]: np.array(one["complex"]) for one in found["results"]}
    return np.array(found["angular_frequency"]), {
        name: pairs[..., 0] + 1j * pairs[..., 1] if pairs.ndim == 2 else pairs[::2] + 1j * pairs[1::2]
        for name, pairs in values.items()
    }


def frequencies(program):
    return np.array([mode["angular_frequency"] for mode in program.json("modes")["modes"]])


def test_numpy(program, tmp_path):
    program.export("numpy", tmp_path / "machine.npz")
    data = np.load(tmp_path / "machine.npz")
    omega, curves = response(program)
    np.testing.assert_array_equal(data["response/angular_frequency"], omega)
    for name, values in curves.items():
        np.testing.assert_array_equal(data[f"response/{name}"], values)
    assert list(data["matrices/coordinate"]) == COORDINATES
    squared = scipy.linalg.eigh(data["matrices/K"], data["matrices/A"], eigvals_only=True)
    np.testing.assert_allclose(np.sqrt(squared), frequencies(program), rtol=1e-10)
    about = json.loads(str(data["about"]))
    assert about["arrays"]["response/pump 1.flange.z"] == {
        "name": "response/pump 1.flange.z",
        "unit": "m",
        "axes": ["angular_frequency"],
    }
    assert {f"{name}" for name in about["arrays"]} | {"about"} == set(data.files)


def test_hdf5(program, tmp_path):
    program.export("hdf5", tmp_path / "machine.h5")
    omega, curves = response(program)
    with h5py.File(tmp_path / "machine.h5") as file:
        assert 'bodies."pump 1".mass = 180' in file.attrs["input"]
        assert len(file.attrs["sha256"]) == 64
        for name, values in curves.items():
            set_ = file["response"][name]
            np.testing.assert_array_equal(set_[()], values)
            assert set_.dims[0][0].name == "/response/angular_frequency"
            assert set_.attrs["units"] in ("m", "rad", "N", "N m")
        np.testing.assert_array_equal(file["modes"]["angular_frequency"][()], frequencies(program))
        assert [one.decode() for one in file["matrices"]["coordinate"][()]] == COORDINATES
        assert file["modes"]["shape"].dims[1][0].name == "/modes/coordinate"
    data = xarray.open_dataset(tmp_path / "machine.h5", group="response", engine="h5netcdf", phony_dims="sort",
                               invalid_netcdf=True)  # fmt: skip
    np.testing.assert_array_equal(data["angular_frequency"], omega)
    assert data["pump 1.flange.z"].dims == ("angular_frequency",)
    np.testing.assert_array_equal(data["pump 1.flange.z"].values, curves["pump 1.flange.z"])


def test_hdf5_has_the_kept_designs_of_a_sample(with_text, tmp_path):
    text = (ROOT / "examples/paper/robust.toml").read_text().replace("designs = 100_000", "designs = 1000")
    robust = with_text(text)
    robust.export("hdf5", tmp_path / "robust.h5", "--what", "sample")
    found = robust.json("sample")
    with h5py.File(tmp_path / "robust.h5") as data:
        sample = data["sample"]
        for name in ("numbers", "margins"):
            expected = np.array([[np.inf if x is None else x for x in one[name]] for one in found["kept"]])
            np.testing.assert_array_equal(sample[f"kept.{name}"][()], expected)
        np.testing.assert_array_equal(sample["kept.design"][()], [one["design"] for one in found["kept"]])
        verdicts = [text.decode() for text in sample["kept.verdict"][()]]
        assert verdicts == [one["verdict"] for one in found["kept"]]
        assert [text.decode() for text in sample["kept_number"][()]] == [one["path"] for one in found["kept_numbers"]]


def test_names_of_hdf5_have_no_slash(program, with_text, tmp_path):
    of_mount = with_text(program.path.read_text().replace('"pump 1.flange", "ground"]', '"c/d"]'))
    notes = of_mount.export("hdf5", tmp_path / "machine.h5")
    curve = next(name for name in response(of_mount)[1] if name.startswith("c/d"))
    assert f'"{curve}" is named "{curve.replace("/", "_")}": names of HDF5 have no slash' in " ".join(notes.split())
    with h5py.File(tmp_path / "machine.h5") as file:
        np.testing.assert_array_equal(file["response"][curve.replace("/", "_")][()], response(of_mount)[1][curve])


def test_matlab_in_scipy(program, tmp_path):
    program.export("matlab", tmp_path / "machine.mat")
    data = scipy.io.loadmat(tmp_path / "machine.mat", squeeze_me=True, struct_as_record=False)
    omega, curves = response(program)
    matrices = data["matrices"]
    q = np.linalg.solve
    for k, w in list(enumerate(omega))[:: len(omega) // 9]:
        stiffness = matrices.K + 1j * matrices.K_loss + 1j * w * matrices.B - w * w * matrices.A
        found = q(stiffness, np.atleast_2d(matrices.load)[0])
        expected = [curves[name][k] for name in COORDINATES]
        np.testing.assert_allclose(found, expected, rtol=0, atol=1e-10 * max(abs(np.array(expected))))
    about = data["about"]
    fields = dict(zip(about.name, about.field, strict=True))
    assert fields["pump 1.flange.z"] == "response.pump_1_flange_z"
    np.testing.assert_array_equal(data["response"].pump_1_flange_z, curves["pump 1.flange.z"])


def test_matlab_in_octave(program, tmp_path):
    """Octave's own backslash."""
    program.export("matlab", tmp_path / "machine.mat")
    script = "load machine.mat; printf('%.17g\\n', modes.angular_frequency); run('machine_check.m')"
    ran = subprocess.run(["octave", "--no-gui", "-qf", "--eval", script], cwd=tmp_path, capture_output=True, text=True)
    assert ran.returncode == 0, ran.stderr
    lines = ran.stdout.split("\n")
    np.testing.assert_array_equal([float(line) for line in lines[:12]], frequencies(program))
    difference = float(lines[12].split("difference ")[1].split()[0])
    assert difference < 1e-12, lines[12]


def test_matrix_market(program, tmp_path):
    program.export("matrix_market", tmp_path / "matrices")
    program.export("numpy", tmp_path / "machine.npz", "--what", "matrices")
    data = np.load(tmp_path / "machine.npz")
    for name in ("A", "B", "K", "K_loss"):
        read = scipy.io.mmread(tmp_path / "matrices" / f"{name}.mtx").toarray()
        np.testing.assert_array_equal(read, data[f"matrices/{name}"])
    rows = (tmp_path / "matrices" / "coordinates.csv").read_text().splitlines()
    assert rows[1] == '1,pump 1.x,m'


def test_csv(program, tmp_path):
    program.export("csv", tmp_path / "tables", "--what", "response, peaks,matrices")
    assert (tmp_path / "tables" / "response.csv").read_text() == program("response", program.path, "--csv").stdout
    assert (tmp_path / "tables" / "peaks.csv").read_text() == program("peaks", program.path, "--csv").stdout


def test_matrices_as_csv(program, tmp_path):
    program.export("csv", tmp_path / "tables", "--what", "matrices")
    program.export("numpy", tmp_path / "machine.npz", "--what", "matrices")
    data = np.load(tmp_path / "machine.npz")
    for name in ("A", "B", "K", "K_loss"):
        rows = list(csv.reader((tmp_path / "tables" / f"{name}.csv").open()))
        assert rows[0][2:] == [row[0] for row in rows[1:]]
        np.testing.assert_array_equal(np.array([row[2:] for row in rows[1:]], float), data[f"matrices/{name}"])


def test_parts_are_read_back(program, with_text, tmp_path):
    """Tables of bodies, elements and points in place of the parts give the same results."""
    program.export("csv", tmp_path / "tables", "--what", "modes")
    rest = program.path.read_text().split("[excitations.shaft]")[1]
    tables = "".join(f'[tables.{kind}]\nfile = "tables/{kind}.csv"\n' for kind in ("bodies", "elements", "points"))
    read = with_text(f'trivet = 1\ntitle = "Pump on a raft"\n{tables}[excitations.shaft]{rest}')
    assert read.json("modes") == program.json("modes")
    assert read.json("response")["results"] == program.json("response")["results"]


@pytest.mark.parametrize("ending", ["\n", "\r\n"])
@pytest.mark.parametrize("separator", [",", ";", "\t"])
def test_sheets_saved_as_csv(program, with_text, tmp_path, separator, ending):
    """With a byte order mark, empty cells at the end of rows, and empty rows at the end, as spreadsheets save them."""
    program.export("csv", tmp_path / "tables", "--what", "modes")
    for kind in ("bodies", "elements", "points"):
        path = tmp_path / "tables" / f"{kind}.csv"
        lines = [line.replace(",", separator) + 2 * separator for line in path.read_text().splitlines()]
        lines += [separator * lines[0].count(separator)] * 2
        path.write_bytes(b"\xef\xbb\xbf" + ending.join(lines).encode() + ending.encode())
    rest = program.path.read_text().split("[excitations.shaft]")[1]
    tables = "".join(f'[tables.{kind}]\nfile = "tables/{kind}.csv"\n' for kind in ("bodies", "elements", "points"))
    read = with_text(f'trivet = 1\ntitle = "Pump on a raft"\n{tables}[excitations.shaft]{rest}')
    assert read.json("modes") == program.json("modes")


NAMES = """trivet = 1
[bodies."a/b"]
mass = 10
inertia = {about = "center_of_mass", xx = 1, yy = 1, zz = 1}
[bodies.a_b]
mass = 20
inertia = {about = "center_of_mass", xx = 1, yy = 1, zz = 1}
position = [1, 0, 0]
[bodies.'C:\\x//y']
mass = 30
inertia = {about = "center_of_mass", xx = 1, yy = 1, zz = 1}
position = [2, 0, 0]
[element_types.mount]
type = "bushing"
translation = [1e5, 1e5, 1e5]
rotation = [1e3, 1e3, 1e3]
damping = {proportional = 1e-4}
[elements.1]
type = "mount"
on = "a/b"
at = [0, 0, -0.1]
[elements.2]
type = "mount"
on = "a_b"
at = [0, 0, -0.1]
[elements."three \\"quoted\\""]
type = "mount"
on = 'C:\\x//y'
at = [0, 0, -0.1]
[excitations.push]
type = "harmonic"
on = "a_b"
at = [0, 0, 0]
force = [0, 0, 1]
[excitations.pull]
type = "harmonic"
on = "a/b"
at = [0, 0, 0]
force = [0, 0, 2]
[analyses]
response = {at = ["3 Hz", "5 Hz"]}
""".replace(
    "\\\\", "\\"
)


def test_names_that_formats_dislike(with_text, tmp_path):
    program = with_text(NAMES)
    _, curves = response(program)
    program.export("hdf5", tmp_path / "a.h5")
    with h5py.File(tmp_path / "a.h5") as file:
        group = file["response"]
        found = {set_.attrs.get("long_name", name): set_[()] for name, set_ in group.items()}
        np.testing.assert_array_equal(group["a_b.z"][()], curves["a_b.z"])
    notes = program.export("numpy", tmp_path / "a.npz")
    assert "is named" in notes
    data = np.load(tmp_path / "a.npz")
    named = {one["name"]: data[key] for key, one in json.loads(str(data["about"]))["arrays"].items()}
    for name, values in curves.items():
        np.testing.assert_array_equal(found[name], values)
        np.testing.assert_array_equal(named[f"response/{name}"], values)


def test_quotes_in_tables_of_names(with_text, tmp_path):
    text = NAMES.replace('"a/b"', "'a\"b'")
    program = with_text(text)
    program.export("matrix_market", tmp_path / "m")
    program.export("universal", tmp_path / "a.uff", "--what", "modes")
    with open(tmp_path / "m" / "coordinates.csv", newline="") as file:
        assert 'a"b.x' in [row["coordinate"] for row in csv.DictReader(file)]
    with open(tmp_path / "a_nodes.csv", newline="") as file:
        assert 'a"b' in [row["name"] for row in csv.DictReader(file)]


def test_a_folder_that_is_no_unicode(program, tmp_path):
    import os
    import shutil

    folder = os.fsencode(tmp_path) + b"/caf\xe9"
    os.mkdir(folder)
    shutil.copy(program.path, folder + b"/machine.toml")
    for name in ("numpy", "hdf5", "matlab", "excel", "universal"):
        program(*("export", os.fsdecode(folder + b"/machine.toml"), "--to", name, "-o", str(tmp_path / f"out.{name}")))
        assert (tmp_path / f"out.{name}").exists()


def test_parts_with_names_like_quantities(with_text, program, tmp_path):
    """Names "1 N" and "2 N" stay names, one vector has one unit, and the points of a body that fits in no row stay
    with it."""
    text = (
        program.path.read_text().replace("[elements.a]", '[elements."1 N"]').replace("[elements.b]", '[elements."2 N"]')
    )
    text = text.replace("at = [0.25, 0.2, -0.2]", 'at = ["250 mm", 0.2, -0.2]')
    text = text.replace("points.flange", "free = [\"x\", \"y\", \"z\", \"rx\", \"ry\", \"rz\"]\npoints.flange")
    with_text(text).export("csv", tmp_path / "tables", "--what", "modes")
    rows = list(csv.DictReader((tmp_path / "tables" / "elements.csv").open()))
    assert {row["name"] for row in rows} >= {"1 N", "2 N"}
    assert {key for key in rows[0] if key.startswith("at.")} == {"at.x [mm]", "at.y [mm]", "at.z [mm]"}
    assert [float(rows[0][f"at.{axis} [mm]"]) for axis in "xyz"] == [250, 200, -200]
    assert not (tmp_path / "tables" / "points.csv").exists()


def test_damping_that_nastran_cannot_hold(with_text, program, tmp_path):
    skew = np.zeros((6, 6))
    skew[0, 1], skew[1, 0] = 50.0, -50.0
    matrix = skew + 100 * np.eye(6)
    text = program.path.read_text().replace(
        "damping = {proportional = 5e-7}", f"symmetric = false\ndamping = {{matrix = {matrix.tolist()}}}"
    )
    said = with_text(text).export("nastran", tmp_path / "x.bdf", code=1)
    assert "damping" in said and "not symmetric" in said
    assert not (tmp_path / "x.bdf").exists()


def test_wrong_names_before_what_a_format_holds(program, tmp_path):
    said = program("export", program.path, "--to", "matrix_market", "-o", tmp_path / "x", "--what", "matrises", code=2)
    assert 'did you mean "matrices"' in said.stderr
