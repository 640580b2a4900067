# SPDX-License-Identifier: BSD-3-Clause
"""Matrices, state space and sweeps against NumPy, SciPy and single results."""

import pickle

import numpy as np
import pint
import pytest
import scipy.integrate
import scipy.linalg
import scipy.signal
from conftest import MACHINE, example

import trivet


def all_of(project: trivet.Project) -> list[str]:
    return project.matrices().coordinates


def test_matrices_have_the_frequencies_of_the_modes(machine):
    m = machine.matrices()
    assert m.coordinates == [f"machine.{c}" for c in ("x", "y", "z", "rx", "ry", "rz")]
    assert m.units == ["m"] * 3 + ["rad"] * 3
    squared = scipy.linalg.eigh(m.K, m.A, eigvals_only=True)
    np.testing.assert_allclose(np.sqrt(squared), machine.modes().angular_frequency, rtol=1e-12)
    assert m.exact


@pytest.mark.filterwarnings("ignore::trivet.ModelWarning")
@pytest.mark.parametrize("path", ["paper/corrected.toml", "genset/genset.toml", "two_stage/pump_on_raft.toml"])
def test_numpy_solves_what_the_response_gives(path):
    project = trivet.open(example(path))
    m = project.matrices()
    bodies = [name for name in m.coordinates if ".coordinate " not in name]
    response = project.response(
        of=["coordinates"], quantity="displacement", excitations=project_harmonics(project), band=("1 Hz", "30 Hz")
    )
    omega = response.angular_frequency[:: len(response.angular_frequency) // 7]
    for w in omega:
        q = np.linalg.solve(m.dynamic_stiffness(w), m.load(w))
        at = list(response.angular_frequency).index(w)
        for name in bodies:
            expected = response.array(name)[at]
            scale = max(abs(response.array(name)))
            assert abs(q[m.coordinates.index(name)] - expected) <= 1e-9 * scale


def project_harmonics(project):
    import tomllib

    table = tomllib.loads(project.to_toml())["excitations"]
    return [name for name, one in table.items() if one["type"] in ("harmonic", "unbalance")] or list(table)


def test_state_space_is_the_response(machine):
    space = machine.state_space(["coordinates", "machine.seat"])
    A, B, C, D = space
    assert space.inputs == ["force.force.z"]
    assert space.outputs[0] == "machine.x"
    assert space.states[6] == "machine.x.velocity"
    response = machine.response(at=[3.0, 25.0, 80.0], of=["coordinates", "machine.seat"])
    for i, w in enumerate(response.angular_frequency):
        y = (C @ np.linalg.solve(1j * w * np.eye(len(A)) - A, B) + D) @ [10.0]
        expected = [response.array(name)[i] for name in space.outputs]
        np.testing.assert_allclose(y, expected, rtol=1e-10, atol=1e-18)
    roots = machine.roots().to_dict()["roots"]
    damped = sorted(abs(np.linalg.eigvals(A)))
    assert len(damped) == 12
    assert damped[0] == pytest.approx(roots[0]["angular_frequency"], rel=1e-10)


def test_scipy_takes_a_state_space():
    """Its simulation of a ramp agrees with `transient`."""
    ramp = {"type": "time", "on": "machine", "at": [0.05, 0, 0], "force": [0, 0, 1.0]}
    history = {"rows": [[0, 0], [0.1, 50.0], [1, 50.0], [1.1, 0]]}
    project = trivet.Project(**MACHINE | {"excitations": {"push": {**ramp, "history": history}}})
    transient = project.transient(step=1e-3, to=1.6)
    time = transient.array("time")
    system = project.state_space(["machine.z"])
    assert isinstance(system, tuple)
    assert pickle.loads(pickle.dumps(system)).outputs == ["machine.z"]
    _, found, _ = scipy.signal.lsim(system, np.interp(time, [0, 0.1, 1, 1.1], [0, 50, 50, 0]), time)
    expected = transient.array("machine.z")
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-10 * max(abs(expected)))


def test_moving_ground_has_its_derivatives_as_inputs():
    project = trivet.Project(**MACHINE | {"excitations": {"floor": {"type": "base", "translation": [0, 0, 1e-3]}}})
    space = project.state_space(["machine.z", "machine.relative.z"])
    assert space.inputs[0] == "floor.z"
    assert "floor.z.velocity" in space.inputs
    A, B, C, D = space
    w = 30.0
    u = np.array(
        [(1j * w) ** name.count("velocity") * (-(w**2)) ** name.count("acceleration") * 1e-3 for name in space.inputs]
    )
    y = (C @ np.linalg.solve(1j * w * np.eye(len(A)) - A, B) + D) @ u
    response = project.response(at=[w], of=["machine.z", "machine.relative.z"])
    np.testing.assert_allclose(y, [response.array(name)[0] for name in space.outputs], rtol=1e-10)


@pytest.mark.parametrize("band", [None, ("3 Hz", "9 Hz")])
@pytest.mark.parametrize("damping", [{"proportional": 1e-3}, {"loss_factor": 0.1}])
def test_sweep_is_the_largest_amplitude_of_each_design(machine, band, damping):
    base = machine.changed({f"elements.{name}.damping": damping for name in machine.elements})
    values = {"elements.a.scale": [0.5, 1.3], "bodies.machine.mass": [100.0, 120.0, 150.0]}
    sweep = base.sweep(values, of=["coordinates", "ground"], band=band)
    assert sweep.parameters == list(values)
    assert sweep.amplitude.shape == (2, 3, 12)
    assert sweep.counts["in_kernels"] + sweep.counts["one_by_one"] == 6
    assert sweep.counts["in_kernels"] > 0
    for i, scale in enumerate(values["elements.a.scale"]):
        for j, mass in enumerate(values["bodies.machine.mass"]):
            design = base.changed({"elements.a.scale": scale, "bodies.machine.mass": mass})
            for k, name in enumerate(sweep.results):
                expected = largest(design, name, band)
                assert sweep.amplitude[i, j, k] == pytest.approx(
                    expected, rel=1e-7, abs=1e-12 * sweep.amplitude[..., k].max()
                )


def largest(project, name, band):
    """From the exact peaks and a fine response."""
    low, high = (0.0, np.inf) if band is None else (2 * np.pi * float(edge.split()[0]) for edge in band)
    peaks = project.peaks(of=[name])
    at = peaks.array("angular_frequency")
    inside = peaks.array("amplitude")[(at >= low) & (at <= high)]
    ends = project.response(of=[name], at=[low, high if np.isfinite(high) else 1e-3]).array(name)
    return max([*inside, *abs(ends)])


def test_sweep_of_designs_without_a_model(machine):
    with pytest.warns(trivet.ModelWarning, match="a mass must be > 0") as caught:
        sweep = machine.sweep({"bodies.machine.mass": [120.0, -1.0]}, of="machine.z")
    assert [str(one.message) for one in caught] == [str(one) for one in sweep.warnings]
    assert np.isnan(sweep.amplitude[1, 0])
    assert sweep.counts["without_model"] == 1
    assert sweep["machine.z"][0] > 0
    assert sweep.to_xarray().sel({"bodies.machine.mass": 120.0, "result": "machine.z"}) == sweep.amplitude[0, 0]


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({}, "no number to change"),
        ({"elements.nothing.scale": [1.0]}, "no such number"),
        ({"elements.a.scale": []}, "no values"),
        ({"elements.a.scale": [np.nan]}, "not a number"),
        ({"elements.a.scale": [[1.0]]}, "1-D"),
        ({"elements.a.scale": ["x"]}, "does not start with a finite number"),
        ({"elements.a.scale": ["2"]}, "without a unit"),
        ({"bodies.machine.mass": ["100 Hz"]}, '"100 Hz"'),
        ({"elements.a.scale": ["2 kg"]}, "2 kg"),
        ({"bodies.machine.mass": [True]}, "list of numbers"),
        (3, "dict from paths"),
        ({"elements.a.scale": 3}, "1-D"),
        ({"elements.a.scale": np.ones(100000), "elements.b.scale": np.ones(100000)}, "at most"),
    ],
)
def test_wrong_sweeps(machine, values, words):
    with pytest.raises(trivet.InputError, match=words):
        machine.sweep(values)
    with pytest.raises(trivet.InputError, match="band"):
        machine.sweep({"elements.a.scale": [1.0]}, band=(3.0, 1.0))


def test_sweep_takes_units(machine):
    """The same as in the project file: texts, and quantities of pint."""
    path, pound = "bodies.machine.mass", 0.45359237
    wanted = machine.sweep({path: [250 * pound, 300 * pound]})
    units = pint.UnitRegistry()
    for values in (["250 lb", "300 lb"], units.Quantity(np.array([250.0, 300.0]), "lb"), [250 * pound, "300 lb"]):
        sweep = machine.sweep({path: values})
        np.testing.assert_allclose(sweep.array(path), wanted.array(path), rtol=1e-14)
        np.testing.assert_allclose(sweep.amplitude, wanted.amplitude, rtol=1e-9)
    assert wanted.unit(path) == "kg"
    assert wanted.to_xarray()[path].attrs["units"] == "kg"


def test_sweep_with_chosen_excitations(machine):
    two = trivet.Project(
        **MACHINE
        | {
            "excitations": {
                **MACHINE["excitations"],
                "other": {**MACHINE["excitations"]["force"], "force": [0, 0, 90.0]},
            }
        }
    )
    values = {"elements.a.scale": [0.5, 1.0]}
    one = two.sweep(values, excitations="force", of="machine.z").amplitude
    np.testing.assert_allclose(one, machine.sweep(values, of="machine.z").amplitude, rtol=1e-9)
    np.testing.assert_allclose(two.sweep(values, of="machine.z").amplitude, 10 * one, rtol=1e-9)
    with pytest.raises(trivet.InputError, match="absent"):
        two.sweep(values, excitations=["absent"])


def test_sweeps_and_matrices_show_themselves(machine):
    sweep = machine.sweep(
        {"elements.a.scale": [0.5, 1.0], "bodies.machine.mass": [100.0, 120.0, 140.0]}, of="machine.z"
    )
    table = sweep.to_dataframe()
    assert list(table.columns) == ["elements.a.scale", "bodies.machine.mass [kg]", "machine.z [m]"]
    np.testing.assert_array_equal(table["machine.z [m]"].to_numpy().reshape(2, 3), sweep["machine.z"])
    assert table["bodies.machine.mass [kg]"].tolist() == [100, 120, 140] * 2
    assert "bodies.machine.mass [kg]: 3 values" in sweep._repr_html_()
    m = machine.matrices()
    assert m.to_dataframe("A").loc["machine.z", "machine.z"] == m.A[2, 2]
    assert "6 coordinates" in m._repr_html_()
    np.testing.assert_array_equal(m.load("5 Hz"), m.load(10 * np.pi))


@pytest.mark.parametrize("study", ["matrices", "state_space", "sweep", "modes"])
def test_studies_warn_of_the_model_but_not_of_unrequested_excitations(study):
    heavy = {"machine": {**MACHINE["bodies"]["machine"], "mass": 1.2e7}}
    excitations = {**MACHINE["excitations"], "other": MACHINE["excitations"]["force"]}
    analyses = {"response": {"excitations": ["force"], "at": [10.0]}}
    project = trivet.Project(**MACHINE | {"bodies": heavy, "excitations": excitations, "analyses": analyses})
    arguments = [{"elements.a.scale": [1.0]}] if study == "sweep" else []
    with pytest.warns(trivet.ModelWarning, match="mass") as caught:
        getattr(project, study)(*arguments)
    assert not any("no analysis of this file uses it" in str(one.message) for one in caught)
    with pytest.warns(trivet.ModelWarning) as caught:
        project.check()
    assert any("no analysis of this file uses it" in str(one.message) for one in caught)


def test_sweeps_read_texts_as_the_project_file_does(machine):
    """ "g" is a gram for a mass and the acceleration of gravity for an acceleration; angles and delays have units."""
    moving = {
        "type": "base",
        "translation": [0, 0, "1 mm"],
        "rotation": ["1 mrad", 0, 0],
        "phase": 0,
        "delay": 0,
    }
    shaken = trivet.Project(**MACHINE | {"excitations": {"ground": moving}})
    accelerated = {**moving, "quantity": "acceleration", "translation": [0, 0, "0.01 g"], "rotation": [0, 0, 0]}
    lifted = trivet.Project(**MACHINE | {"excitations": {"ground": accelerated}})
    for project, path, text, unit in [
        (machine, "bodies.machine.mass", "120e3 g", "kg"),
        (shaken, "excitations.ground.phase", "30 deg", "rad"),
        (shaken, "excitations.ground.delay", "1 ms", "s"),
        (shaken, "excitations.ground.rotation.x", "2 mrad", "rad"),
        (shaken, "excitations.ground.translation.z", "1 in", "m"),
        (lifted, "excitations.ground.translation.z", "0.02 g", "m/s²"),
        (machine, "elements.a.damping.proportional", "2 ms", "s"),
        (machine, "elements.a.at.x", "3 in", "m"),
    ]:
        sweep = project.sweep({path: [text]}, of="machine.z", band=("1 Hz", "50 Hz"))
        assert sweep.unit(path) == unit
        changed = project.changed({path: text})
        same = changed.sweep({"elements.a.scale": [1.0]}, of="machine.z", band=("1 Hz", "50 Hz"))
        np.testing.assert_allclose(sweep.amplitude[0], same.amplitude[0], rtol=1e-9, err_msg=path)


def test_sweeps_name_the_units_of_their_axes(machine):
    heavy = trivet.Project(**MACHINE | {"gravity": [0, 0, -9.81]})
    sweep = heavy.sweep({"gravity.z": [-9.8], "elements.a.translation.z": [1e5]}, of="machine.z")
    assert (sweep.unit("gravity.z"), sweep.unit("elements.a.translation.z")) == ("m/s²", "N/m")


def test_sweep_warns_of_infinite_amplitudes(machine):
    undamped = {name: {key: one[key] for key in one if key != "damping"} for name, one in MACHINE["elements"].items()}
    free = trivet.Project(**MACHINE | {"elements": undamped})
    with pytest.warns(trivet.ModelWarning, match="infinite amplitudes: 2 of 2"):
        sweep = free.sweep({"elements.a.scale": [1.0, 1.0]}, of="machine.z")
    assert np.isinf(sweep.amplitude).all()
