# SPDX-License-Identifier: BSD-3-Clause
"""What cannot be exported is said before anything is written."""

import pytest

ARRAYS = ["matlab", "numpy", "hdf5", "excel", "universal", "matrix_market", "csv", "nastran", "fmu", "fmu3"]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("--to", "matlba", "-o", "x"), 'did you mean "matlab"'),
        (("--to", "matlab", "-o", "x", "--what", "mods"), 'did you mean "modes"'),
        (("--to", "matlab", "-o", "absent/x"), "no folder"),
        (("--to", "matlab", "-o", "machine.toml"), "project file"),
        (("--to", "matlab", "-o", "."), "folder"),
        (("--to", "csv", "-o", "."), "not empty"),
        (("--to", "csv", "-o", "machine.toml"), "is a file"),
        (("--to", "fmu", "-o", "x", "--what", "modes"), "fixed content"),
        (("--to", "matrix_market", "-o", "x", "--what", "modes"), "only matrices"),
        (("--to", "universal", "-o", "x", "--what", "static"), "only modes and response"),
        (("--to", "matlab", "-o", "x", "--case", "cold"), "no such case"),
    ],
)
def test_wrong_command_lines(program, tmp_path, monkeypatch, arguments, words):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "machine.toml").write_text(program.path.read_text())
    said = program("export", "machine.toml", *arguments, code=2).stderr
    assert words in said
    assert [file.name for file in tmp_path.iterdir()] == ["machine.toml"]


def test_lossy_mounts_have_no_motion_in_time(with_text, program, tmp_path):
    lossy = with_text(program.path.read_text().replace("proportional = 5e-7", "loss_factor = 0.1"))
    said = lossy.export("fmu", tmp_path / "x.fmu", code=1)
    assert "loss factor" in said and "replace" in said
    assert not (tmp_path / "x.fmu").exists()
    lossy.export("matlab", tmp_path / "x.mat")  # harmonic results have loss factors


@pytest.mark.parametrize("name", ARRAYS)
def test_full_disk(program, tmp_path, name):
    """A file size limit stands for a full disk: a message, and nothing left."""
    import os
    import resource
    import subprocess

    ran = subprocess.run(
        [os.environ["TRIVET"], "export", program.path, "--to", name, "-o", tmp_path / "out"],
        capture_output=True, text=True, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100)),
    )  # fmt: skip
    assert ran.returncode in (1, 2), (ran.returncode, ran.stderr)
    assert "error" in ran.stderr
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", ["matlab", "numpy", "hdf5", "excel", "universal", "matrix_market", "csv", "nastran"])
def test_a_machine_at_rest_has_no_load(with_text, program, tmp_path, name):
    """Arrays without a single number, and a default content that cannot be computed."""
    text, _, _ = program.path.read_text().partition("[excitations.")
    notes = with_text(text).export(name, tmp_path / "out")
    assert (tmp_path / "out").exists()
    assert ("left out: response: no harmonic excitation" in notes) == (name == "universal")


@pytest.mark.parametrize("share", [0.3, 0.7, 0.95, 0.9995])
@pytest.mark.parametrize("name", ["matlab", "numpy", "hdf5", "excel", "universal", "nastran", "fmu"])
def test_a_disk_that_is_full_before_the_end(program, tmp_path, name, share):
    import os
    import resource
    import subprocess

    folder = tmp_path / "complete"
    folder.mkdir()
    program.export(name, folder / "out")
    limit = int(share * (folder / "out").stat().st_size)
    cut = tmp_path / "cut"
    cut.mkdir()
    ran = subprocess.run(
        [os.environ["TRIVET"], "export", program.path, "--to", name, "-o", cut / "out"],
        capture_output=True, text=True, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)),
    )  # fmt: skip
    assert ran.returncode in (1, 2) and "error" in ran.stderr
    assert list(cut.iterdir()) == []


@pytest.mark.parametrize("missing", [1, 4, 8, 9, 40, 200])
@pytest.mark.parametrize("name", ["matlab", "excel"])
def test_a_disk_that_lacks_a_few_bytes(program, tmp_path, name, missing):
    """The libraries of these formats do not report it."""
    import os
    import resource
    import subprocess

    program.export(name, tmp_path / "out")
    size = (tmp_path / "out").stat().st_size
    cut = tmp_path / "cut"
    cut.mkdir()
    ran = subprocess.run(
        [os.environ["TRIVET"], "export", program.path, "--to", name, "-o", cut / "out"],
        capture_output=True, text=True,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size - missing, size - missing)),
    )  # fmt: skip
    assert ran.returncode == 1 and "cannot write" in ran.stderr
    assert list(cut.iterdir()) == []


@pytest.mark.parametrize(
    ("name", "file", "side"), [("matlab", "a.mat", "a_check.m"), ("universal", "a.uff", "a_nodes.csv")]
)
def test_the_file_beside_replaces_only_exports(program, tmp_path, name, file, side):
    (tmp_path / side).write_text("mine\n")
    said = program("export", program.path, "--to", name, "-o", tmp_path / file, code=2).stderr
    assert side in said and "move it" in said
    assert sorted(one.name for one in tmp_path.iterdir() if one.name.startswith("a")) == [side]
    (tmp_path / side).unlink()
    program.export(name, tmp_path / file)
    first = (tmp_path / side).read_text()
    program.export(name, tmp_path / file)
    assert (tmp_path / side).read_text() == first


def test_an_old_check_does_not_stay_beside_new_matrices(with_text, program, tmp_path):
    program.export("matlab", tmp_path / "a.mat")
    text, _, _ = program.path.read_text().partition("[excitations.")
    with_text(text).export("matlab", tmp_path / "a.mat", "--what", "matrices")
    assert not (tmp_path / "a_check.m").exists()
    notes = program.export("matlab", tmp_path / "it's.mat")
    assert "cannot quote" in notes
