# SPDX-License-Identifier: BSD-3-Clause
"""Wrong input: all problems at once, in the words of the command line; nothing crashes."""

import errno
import pickle
import subprocess
import sys

import numpy as np
import pytest
from conftest import MACHINE, ROOT

import trivet


def test_all_problems_at_once():
    tables = {
        **MACHINE,
        "bodies": {"machine": {"mass": -1.0, "inertia": {"about": "center_of_mass", "xx": 1, "yy": 1, "zz": 1}}},
        "elemnts": {},
    }
    with pytest.raises(trivet.InputError) as wrong:
        trivet.Project(**tables)
    problems = wrong.value.problems
    assert len(problems) >= 2
    mass = next(problem for problem in problems if "mass" in problem.subject)
    assert (mass.severity, mass.subject) == ("error", "bodies.machine.mass")
    assert mass.place == ""  # the user has no file with lines
    assert str(wrong.value).startswith("error: ")
    assert mass.rule == "a mass must be > 0"
    assert "elements" in str(wrong.value)


def test_messages_are_those_of_the_command_line():
    import os
    import re

    path = ROOT / "tests" / "bad"
    files = sorted(path.glob("*.toml"))[:40]
    assert len(files) == 40
    compared = 0
    for file in files:
        said = subprocess.run([os.environ["TRIVET"], "check", str(file)], capture_output=True, text=True, cwd=ROOT)
        if said.returncode != 2:
            continue
        with pytest.raises(trivet.InputError) as wrong:
            trivet.open(str(file))
        errors = [
            line for line in said.stderr.splitlines() if ": warning: " not in line and not re.match(r" *\d* \|", line)
        ]
        assert str(wrong.value).splitlines() == errors, file
        compared += 1
    assert compared > 30


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"elements.e.scale": 2}, "no such key or part"),
        ({"bodies.machine.mass": 1 + 2j}, "a real number is wanted"),
        ({"bodies.machine.mass": object()}, "a value is a number, a text"),
        ({"bodies.machine.mass": "12 Hz"}, "mass"),
        ({"bodies.machine.mass": float("nan")}, "mass"),
        ({"bodies.machine.mass": [1, 2]}, "mass"),
        ({"bodies.machine.mass": "kg"}, "mass"),
        ({"bodies.machine.inertia": {1: 2}}, "keys are texts"),
        ({"": 3}, "a path is a text"),
        ({3: 3}, "a path is a text"),
        ({"elements.a.scale = 3 #": 3}, "keys with points"),
        ({"elements..scale": 3}, "keys with points"),
        ({"title": "\ud800"}, "Unicode"),
        ("elements.a.scale", "changes are a dict"),
    ],
)
def test_wrong_changes(machine, changes, words):
    with pytest.raises(trivet.InputError, match=words) as wrong:
        machine.changed(changes)
    assert all(problem.rule or problem.finding for problem in wrong.value.problems)


def test_two_wrong_changes_are_two_problems(machine):
    with pytest.raises(trivet.InputError) as wrong:
        machine.changed({"bodies.machine.mass": -3, "elements.e.scale": 2})
    assert len(wrong.value.problems) == 2


@pytest.mark.parametrize(
    ("keys", "words"),
    [
        ({"bamd": (0, 1)}, 'did you mean "band"'),
        ({"band": ("40 Hz", "40 Hz")}, "band"),
        ({"band": ("0 Hz",)}, "band"),
        ({"of": ["machine.w"]}, "machine"),
        ({"at": []}, "empty list"),
        ({"quantity": "jerk"}, "displacement"),
        ({"case": "x"}, "no such case"),
    ],
)
def test_wrong_analyses(machine, keys, words):
    with pytest.raises(trivet.InputError, match=words):
        machine.response(**keys)


def test_no_excitation_is_said_with_a_remedy():
    tables = {key: value for key, value in MACHINE.items() if key != "excitations"}
    project = trivet.Project(**tables)
    with pytest.raises(trivet.InputError, match="excitation"):
        project.response()


def test_what_does_not_exist_is_not_computable(machine):
    lossy = machine.changed({f"elements.{name}.damping": {"loss_factor": 0.1} for name in machine.elements})
    with pytest.raises(trivet.NotComputable, match="loss factor"):
        lossy.state_space()


def test_files(tmp_path):
    for name, words in (("absent.toml", "absent.toml"), (".", "folder|directory|file")):
        with pytest.raises((trivet.InputError, OSError), match=words):
            trivet.open(tmp_path / name)
    (tmp_path / "binary.toml").write_bytes(bytes(range(256)))
    with pytest.raises(trivet.InputError):
        trivet.open(tmp_path / "binary.toml")
    with pytest.raises(TypeError):
        trivet.open(3.5)


def test_a_missing_file_is_that_of_python(tmp_path):
    with pytest.raises(FileNotFoundError, match="absent.toml") as wrong:
        trivet.open(tmp_path / "absent.toml")
    assert isinstance(wrong.value, trivet.InputError)
    assert wrong.value.errno == errno.ENOENT
    assert wrong.value.filename == str(tmp_path / "absent.toml")
    assert wrong.value.problems


@pytest.mark.parametrize(
    ("ask", "kind", "words"),
    [
        (lambda machine: machine.response()["machine.zz"], KeyError, 'did you mean "machine.z"'),
        (lambda machine: machine.response().curve("machine.zz"), KeyError, 'did you mean "machine.z"'),
        (lambda machine: machine.response().curve("angular_frequency"), KeyError, "no such curve"),
        (lambda machine: machine.peaks().table("peak"), KeyError, "peaks"),
        (lambda machine: machine.peaks().table()["machine.zz"], KeyError, "machine.z"),
        (lambda machine: machine.peaks().table().column("amplitud"), KeyError, 'did you mean "amplitude"'),
        (lambda machine: machine.matrices().array("M"), KeyError, "no such array"),
        (lambda machine: machine.sweep({"elements.a.scale": [1.0]})["x"], KeyError, "no such result"),
        (lambda machine: machine["bodies.machine.mas"], KeyError, 'did you mean "bodies.machine.mass"'),
        (lambda machine: machine["bodies.machine.mass.x"], KeyError, "no such value"),
        (lambda machine: machine.bodies["machin"], KeyError, 'did you mean "machine"'),
        (lambda machine: machine.mounts["e"], KeyError, "no such part"),
        (lambda machine: machine.modes(case="cold"), KeyError, 'case "cold": no such case'),
        (lambda machine: machine.matrices(case="cold"), KeyError, 'case "cold": no such case'),
        (lambda machine: machine.element("e"), KeyError, 'no element has this name'),
        (lambda machine: machine[3], TypeError, "text"),
        (lambda machine: machine.modes(threads=1.5), TypeError, "whole number"),
        (lambda machine: machine.modes(case=3), TypeError, "text"),
        (lambda machine: machine.changed("x"), TypeError, "dict"),
        (lambda machine: machine.modes().plot(ax=3), TypeError, "axes"),
        (lambda machine: machine.plot(view="back"), ValueError, "front"),
        (lambda machine: machine.response(band=("40 Hz", "0 Hz")), ValueError, "band"),
    ],
)
def test_errors_are_of_the_classes_of_python(machine, ask, kind, words):
    with pytest.raises(kind, match=words) as wrong:
        ask(machine)
    assert isinstance(wrong.value, trivet.InputError)
    assert not str(wrong.value).startswith(("'", '"')), "a KeyError of Python shows its text in quotes"
    again = pickle.loads(pickle.dumps(wrong.value))
    assert type(again) is type(wrong.value) and str(again) == str(wrong.value)


def test_errors_pickle():
    with pytest.raises(trivet.InputError) as wrong:
        trivet.Project()
    again = pickle.loads(pickle.dumps(wrong.value))
    assert isinstance(again, trivet.InputError)
    assert str(again) == str(wrong.value)
    assert [one.subject for one in again.problems] == [one.subject for one in wrong.value.problems]
    assert [one.rule for one in again.problems] == [one.rule for one in wrong.value.problems]


@pytest.mark.parametrize(
    ("ask", "words"),
    [
        (lambda machine: machine.modes(threads=-1), "threads"),
        (lambda machine: machine.modes(threads=1.5), "threads"),
        (lambda machine: machine.modes(case=3), "case"),
        (lambda machine: machine.check(threads="x"), "threads"),
        (lambda machine: machine.sweep({"elements.a.scale": [1.0]}, band=5), "band"),
        (lambda machine: machine.sweep({"elements.a.scale": [1.0]}, of=3), "of"),
        (lambda machine: machine.matrices().load(None), "frequency"),
        (lambda machine: machine.matrices().load("5 kg"), "5 kg"),
        (lambda machine: machine.element("a").svg("x"), "no such picture"),
        (lambda machine: machine.element(3), "name"),
        (lambda machine: machine.suspension(excitations=[float("nan")]), "a frequency is ≥ 0"),
        (lambda machine: machine.suspension(excitations=[-5.0]), "a frequency is ≥ 0"),
        (lambda machine: machine.suspension(excitations=5), "excitations"),
        (lambda machine: machine.suspension(torques=3), "torques"),
        (lambda machine: machine.map(points="x"), "points"),
        (lambda machine: machine.map(points=(2, 3, 4)), "two axes"),
    ],
)
def test_wrong_kinds_of_arguments(machine, ask, words):
    with pytest.raises(trivet.InputError, match=words):
        ask(machine)


def test_warnings_are_python_warnings():
    light = {**MACHINE, "bodies": {"machine": {**MACHINE["bodies"]["machine"], "mass": 1.2e7}}}
    project = trivet.Project(**light)
    with pytest.warns(trivet.ModelWarning, match="mass") as caught:
        result = project.modes()
    assert [str(one.message) for one in caught] == [str(problem) for problem in result.warnings]
    assert all(one.filename == __file__ for one in caught)
    assert str(result.warnings[0].subject) in result._repr_html_()


def test_a_warning_comes_once_for_a_project_and_what_it_is_changed_to():
    light = {**MACHINE, "bodies": {"machine": {**MACHINE["bodies"]["machine"], "mass": 1.2e7}}}
    project = trivet.Project(**light)
    with pytest.warns(trivet.ModelWarning, match="mass"):
        project.modes()
    again = project.modes()  # a warning would be an error of this test
    assert project.changed({"title": "again"}).modes().warnings and again.warnings
    with pytest.warns(trivet.ModelWarning, match="mass"):
        trivet.Project(**light).modes()


def test_changes_are_named_as_in_python(machine):
    with pytest.raises(trivet.InputError) as wrong:
        machine.changed({"bodies.machine.mass": -3})
    assert str(wrong.value).startswith("changes: bodies.machine.mass = -3: error: bodies.machine.mass")
    assert (wrong.value.problems[0].place, wrong.value.problems[0].line) == ("changes: bodies.machine.mass = -3", 0)
    with pytest.raises(trivet.InputError) as wrong:
        machine.changed({"elements.e.scale": 2})
    assert "--set" not in str(wrong.value)


def test_import_is_quick():
    """Beyond NumPy at most 30 ms, the median of several starts."""
    program = "import numpy, time; t = time.perf_counter(); import trivet; print(time.perf_counter() - t)"
    times = [
        float(subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True).stdout)
        for _ in range(5)
    ]
    assert np.median(times) < 0.3  # a limit against mistakes, not a measurement: benchmarks/python.py measures
