# SPDX-License-Identifier: BSD-3-Clause
"""Every analysis is a method, and results what the command line results."""

import inspect
import json
import keyword
import math

import numpy as np
import pytest
from conftest import example

import trivet
from trivet import _core

ANALYSES = [name for name, _ in _core.analyses()]
#: An example that has each analysis.
REQUESTED_IN = {
    "operation": "fan/fan.toml",
    "random": "track/bogie.toml",
    "transient": "transport_shock/device.toml",
    "shock_spectrum": "transport_shock/device.toml",
    "orders": "genset/genset.toml",
    "power": "genset/genset.toml",
    "shapes": "genset/genset.toml",
    "transmissibility": "optical_table/table.toml",
    "limit_lines": "genset/genset.toml",
    "measurements": "measured_response/machine.toml",
    "static": "genset/load_cases.toml",
    "steady": "isolator/hardening.toml",
    "backbone": "isolator/hardening.toml",
}


def found_example(analysis: str) -> str:
    """An example in which the analysis has a result."""
    if analysis in REQUESTED_IN:
        return REQUESTED_IN[analysis]
    return "paper/corrected.toml"


def without_warnings(text: str) -> object:
    found = json.loads(text)
    if isinstance(found, dict):
        found.pop("warnings", None)
    return found


def test_every_analysis_is_a_method():
    for name, about in _core.analyses():
        method = getattr(trivet.Project, name)
        assert callable(method)
        assert method.__doc__.lower().startswith(about.lower()[:20])


def test_signatures_and_help_have_the_keys_of_the_schema():
    """The methods that the build writes: each key is an argument, and help() has the words of the command line on it."""
    file = json.loads(trivet.schema())["properties"]
    compared = 0
    for name in ANALYSES:
        tables = file if _core.file_table(name) == name else file["analyses"]["properties"]
        method = getattr(trivet.Project, name)
        parameters = inspect.signature(method).parameters
        for key in tables.get(name, {}).get("properties", {}):
            word = key + "_" if keyword.iskeyword(key) else key
            if key != "accept":
                assert repr(parameters[word].default) == "as in the file"
                assert f"    {word}" in method.__doc__
                compared += 1
    assert compared > 60
    words = _core.file_keys("response")
    about_of = next(line for line in words.splitlines() if line.split()[0] == "of").split(maxsplit=1)[1]
    assert f"of: {about_of}" in " ".join(trivet.Project.response.__doc__.split())


def test_other_commands_have_the_options_of_their_method():
    own = {
        "map": {"points", "case"}, "select": {"most", "by"}, "verdict": {"case"}, "check": {"deep", "case"},
        "explain": {"of", "most", "case"}, "suspension": {"torques", "excitations", "case"},
        "element": {"name", "all", "case"}, "run": {"folder"},
    }  # fmt: skip
    for name, options in own.items():
        found = set(inspect.signature(getattr(trivet.Project, name)).parameters) - {"self", "keys"}
        assert found - {"threads"} == options | {"progress"}, name


@pytest.mark.filterwarnings("ignore::trivet.ModelWarning")
def test_the_operation_takes_its_keys_from_a_table_of_its_own():
    fan = trivet.open(example("fan/fan.toml"))
    told = json.loads(fan.operation(speeds=["1450 rpm", ["600 rpm", "900 rpm"]], of="fan.bearing.z").to_json())
    velocities = [row for row in told["values"] if row["quantity"] == "velocity"]
    assert [(row["name"], round(row["to"] * 30 / math.pi)) for row in velocities] == [
        ("fan.bearing.z", 1450),
        ("fan.bearing.z", 900),
    ]


@pytest.mark.filterwarnings("ignore::trivet.ModelWarning")
@pytest.mark.parametrize("analysis", [name for name in ANALYSES if name != "earthquake"])
def test_json_is_that_of_the_command_line(analysis, command_line):
    path = example(found_example(analysis))
    result = getattr(trivet.open(path), analysis)()
    assert without_warnings(result.to_json()) == without_warnings(command_line(analysis, path, "--json"))
    assert result.to_csv() == command_line(analysis, path, "--csv")


@pytest.mark.filterwarnings("ignore::trivet.ModelWarning")
@pytest.mark.parametrize(
    ("command", "path", "arguments"),
    [
        ("verdict", "genset/load_cases.toml", []),
        ("map", "paper/map.toml", []),
        ("optimize", "powertrain/decoupled.toml", []),
        ("select", "genset/mounts.toml", []),
        ("suspension", "powertrain/decoupled.toml", []),
        ("explain", "two_stage/pump_on_raft.toml", []),
        ("check", "paper/corrected.toml", []),
    ],
)
def test_other_commands_too(command, path, arguments, command_line):
    result = getattr(trivet.open(example(path)), command)()
    given = json.loads(command_line(command, example(path), "--json", *arguments))
    assert json.loads(result.to_json()) == given


def test_element_too(command_line):
    path = example("two_stage/pump_on_raft.toml")
    project = trivet.open(path)
    name = project.elements[0]
    assert json.loads(project.element(name).to_json()) == json.loads(command_line("element", path, name, "--json"))
    assert project.element(name).svg().startswith("<svg")


def test_keywords_replace_keys_of_the_file(machine, command_line):
    path = example("paper/corrected.toml")
    result = trivet.open(path).response(at=["1 Hz", "2 Hz"])
    assert without_warnings(result.to_json()) == without_warnings(
        command_line("response", path, "--json", "--at", "1 Hz,2 Hz")
    )
    band = machine.response(at=[10.0, 20.0]).project.response(band=(0, 100.0))
    assert band.angular_frequency[-1] == 100
    velocity = machine.response(at=[10.0], quantity="velocity")
    np.testing.assert_allclose(
        velocity.array("machine.z"), 10j * machine.response(at=[10.0]).array("machine.z"), rtol=1e-13
    )


def test_cases(command_line):
    project = trivet.open(example("paper/map.toml"))
    case = project.cases[2]
    assert without_warnings(project.peaks(case=case).to_json()) == without_warnings(
        command_line("peaks", project.source, "--case", case, "--json")
    )
    with pytest.raises(trivet.InputError, match="Figure 3"):
        project.peaks(case="Figure33")


def test_best_design(command_line):
    project = trivet.open(example("powertrain/decoupled.toml"))
    found = project.optimize()
    best = found.best
    assert best != project
    margins = [row["margin"] for one in best.verdict().to_dict()["cases"] for row in one["requirements"]]
    assert min(margins) == pytest.approx(found.to_dict()["after"], rel=1e-9)


def test_run_writes_the_folder_of_the_command_line(tmp_path, command_line):
    path = example("paper/corrected.toml")
    with pytest.warns(trivet.ModelWarning) if trivet.open(path).check().warnings else _nothing():
        run = trivet.open(path).run(tmp_path / "python")
    command_line("run", path, "-o", str(tmp_path / "program"))
    names = sorted(
        file.relative_to(tmp_path / "program") for file in (tmp_path / "program").rglob("*") if file.is_file()
    )
    assert names == sorted(
        file.relative_to(tmp_path / "python") for file in (tmp_path / "python").rglob("*") if file.is_file()
    )
    for name in names:
        if name.suffix in (".csv", ".svg"):
            assert (tmp_path / "python" / name).read_bytes() == (tmp_path / "program" / name).read_bytes()
    assert run.report.exists()
    assert "Report" in run._repr_html_()


def _nothing():
    import contextlib

    return contextlib.nullcontext()


@pytest.mark.filterwarnings("ignore::trivet.ModelWarning")
def test_run_has_the_json_of_each_case(tmp_path):
    run = trivet.open(example("genset/load_cases.toml")).run(tmp_path / "run")
    whole = json.loads((tmp_path / "run" / "results.json").read_text(encoding="utf-8"))
    assert len(run.cases) == len(whole["cases"]) > 1
    for result, case in zip(run.cases.values(), whole["cases"], strict=True):
        assert result.to_dict()["cases"] == [case]


@pytest.mark.filterwarnings("ignore::trivet.ModelWarning")
def test_points_of_numpy():
    project = trivet.open(example("paper/map.toml"))
    assert project.map(points=np.int64(5)).array("margin").shape == (5, 5)
