# SPDX-License-Identifier: BSD-3-Clause
"""Functional mock-up units in FMPy: validation, co-simulation against `transient`, model exchange, two instances."""

import json

import numpy as np
import pytest

from fmpy import extract, read_model_description, simulate_fmu
from fmpy.fmi2 import FMU2Slave
from fmpy.fmi3 import FMU3Slave
from fmpy.validation import validate_fmu

TIMES, FORCE, FLOOR = [0, 0.02, 0.05, 0.1, 1], [0, 50, -20, 0, 0], [0, 1e-3, 1e-3, 0, 0]
DRIVEN = f"""
[excitations.push]
type = "time"
on = "pump 1"
at = [0.3, 0.1, 0.2]
force = [0, 0, 1]
history = {{rows = {[list(row) for row in zip(TIMES, FORCE, strict=True)]}}}
[excitations.floor]
type = "time"
base = true
translation = [0, 0, 1]
history = {{rows = {[list(row) for row in zip(TIMES, FLOOR, strict=True)]}}}
"""


@pytest.fixture
def driven(program, with_text):
    """The machine with two time histories in place of its harmonic force, more damping, and a result in time."""
    text = program.path.read_text().replace("proportional = 5e-7", "proportional = 2e-4")
    head, rest = text.split("[excitations.shaft]")
    analyses = rest.split("[analyses]")[1].replace("peaks = {}", "")
    analyses = analyses.replace(
        'response = {band = ["1 Hz", "30 Hz"], of = ', 'transient = {from = 0, to = 0.3, step = 1e-4, of = '
    )
    return with_text(head + DRIVEN + "[analyses]" + analyses)


VERSIONS = {"fmu": FMU2Slave, "fmu3": FMU3Slave}


class Unit:
    """One instance of a unit for co-simulation."""

    def __init__(self, path, kind):
        self.description = read_model_description(str(path))
        self.references = {variable.name: variable.valueReference for variable in self.description.modelVariables}
        identifier = self.description.coSimulation.modelIdentifier
        self.slave = kind(guid=self.description.guid, unzipDirectory=extract(str(path)), modelIdentifier=identifier,
                          instanceName=f"unit {id(self)}")  # fmt: skip
        self.slave.instantiate()
        if kind is FMU3Slave:
            self.slave.setReal, self.slave.getReal = self.slave.setFloat64, self.slave.getFloat64
            self.slave.enterInitializationMode(startTime=0.0)
        else:
            self.slave.setupExperiment(startTime=0.0)
            self.slave.enterInitializationMode()
        self.slave.exitInitializationMode()

    def inputs_at(self, t):
        """Values of the inputs and their slopes until the next corner."""
        piece = np.searchsorted(TIMES, t + 1e-9, side="right") - 1
        rate = (FLOOR[piece + 1] - FLOOR[piece]) / (TIMES[piece + 1] - TIMES[piece])
        push = (FORCE[piece + 1] - FORCE[piece]) / (TIMES[piece + 1] - TIMES[piece])
        given = {"push.force.z": (np.interp(t, TIMES, FORCE), push), "floor.z": (np.interp(t, TIMES, FLOOR), rate),
                 "floor.z.velocity": (rate, 0.0)}  # fmt: skip
        return {name: given[name] for name in given if name in self.references}

    def step(self, t, h, straight):
        inputs = self.inputs_at(t)
        references = [self.references[name] for name in inputs]
        self.slave.setReal(references, [value for value, _ in inputs.values()])
        if straight:
            self.slave.setRealInputDerivatives(references, [1] * len(inputs), [slope for _, slope in inputs.values()])
        self.slave.doStep(currentCommunicationPoint=t, communicationStepSize=h)

    def read(self, names):
        return self.slave.getReal([self.references[name] for name in names])


def transient(program) -> dict:
    found = json.loads(program("transient", program.path, "--json").stdout)
    return found


def curve(found, name):
    (one,) = [one for one in found["results"] if one["name"] == name]
    return np.array(one["value"])


@pytest.mark.parametrize("to", list(VERSIONS))
def test_validation(driven, tmp_path, to):
    driven.export(to, tmp_path / "machine.fmu")
    assert validate_fmu(str(tmp_path / "machine.fmu")) == []


@pytest.mark.parametrize("h", [1e-4, 1e-3, 1e-2])
def test_co_simulation_is_the_transient(driven, tmp_path, h):
    """Straight inputs: exact at any step size."""
    driven.export("fmu", tmp_path / "machine.fmu")
    unit = Unit(tmp_path / "machine.fmu", FMU2Slave)
    found = transient(driven)
    time = np.array(found["time"])
    names = ["pump 1.x", "pump 1.z", "raft.ry", "pump 1.flange.z"]
    values = []
    for k in range(round(0.3 / h)):
        unit.step(k * h, h, straight=True)
        values.append(unit.read(names))
    stride = round(h / 1e-4)
    for i, name in enumerate(names):
        expected = curve(found, name)[stride::stride]
        assert len(time[stride::stride]) == len(values)
        difference = np.max(np.abs(np.array(values)[:, i] - expected)) / np.max(np.abs(expected))
        assert difference < 1e-10, name
    unit.slave.terminate()
    unit.slave.freeInstance()


def test_two_instances_of_fmi_3(driven, tmp_path):
    driven.export("fmu3", tmp_path / "machine.fmu")
    one, two = (Unit(tmp_path / "machine.fmu", FMU3Slave) for _ in range(2))
    h = 1e-3
    for k in range(50):
        one.step(k * h, h, straight=False)
    before = one.read(["raft.z"])
    for k in range(50):
        two.step(k * h, h, straight=False)
    assert two.read(["raft.z"]) == before
    assert one.read(["raft.z"]) == before
    assert before[0] != 0
    for unit in (one, two):
        unit.slave.terminate()
        unit.slave.freeInstance()


@pytest.mark.parametrize("to", list(VERSIONS))
def test_model_exchange_is_the_transient(driven, tmp_path, to):
    """FMPy integrates from a displaced state without inputs; the program does the same by exact steps."""
    driven.export(to, tmp_path / "machine.fmu")
    text = driven.path.read_text().split("[excitations.push]")
    free = (
        text[0]
        + "[analyses]"
        + text[1].split("[analyses]")[1].replace("to = 0.3", 'to = 0.3, initial_displacement = {"raft.z" = 1e-3}')
    )
    driven.path.write_text(free)
    expected = curve(transient(driven), "pump 1.z")
    driven.path.write_text(text[0] + "[excitations.push]" + text[1])
    result = simulate_fmu(str(tmp_path / "machine.fmu"), fmi_type="ModelExchange", stop_time=0.3, output_interval=1e-3,
                          relative_tolerance=1e-10, start_values={"state.raft.z": 1e-3}, output=["pump 1.z"])  # fmt: skip
    found = np.array([row[1] for row in result])
    wanted = np.interp([row[0] for row in result], np.arange(len(expected)) * 1e-4, expected)
    assert np.max(np.abs(found - wanted)) < 1e-6 * np.max(np.abs(wanted))


def test_names_units_and_directional_derivatives(driven, tmp_path):
    driven.export("fmu", tmp_path / "machine.fmu")
    unit = Unit(tmp_path / "machine.fmu", FMU2Slave)
    variables = {variable.name: variable for variable in unit.description.modelVariables}
    assert variables["push.force.z"].unit == "N"
    assert variables["pump 1.flange.z"].unit == "m"
    assert variables["pump 1.flange.z"].causality == "output"
    known, unknown = unit.references["state.raft.z"], unit.references["raft.z"]
    assert unit.slave.getDirectionalDerivative([unknown], [known], [2.0]) == pytest.approx([2.0], rel=1e-14)
    # Rotation and translation of a rigid body: a force along z through a point off the centre of mass.
    [along] = unit.slave.getDirectionalDerivative(
        [unit.references["der(state.pump 1.z.velocity)"]], [unit.references["push.force.z"]], [1.0]
    )
    assert along == pytest.approx(1 / 180, rel=1e-9)  # the mass; z of the origin, which is the centre of mass
    unit.slave.freeInstance()


def test_an_excitation_may_be_called_like_a_body(program, with_text, tmp_path):
    """Its inputs get a prefix: "raft.z" is the output."""
    head, rest = program.path.read_text().split("[excitations.shaft]")
    base = """[excitations.raft]
type = "base"
translation = [0, 0, 1e-3]
[analyses]"""
    shaken = with_text(
        (head + base + rest.split("[analyses]")[1]).replace("proportional = 5e-7", "proportional = 2e-4")
    )
    notes = shaken.export("fmu", tmp_path / "machine.fmu")
    assert 'prefix of "input.raft.z"' in notes
    variables = {v.name: v for v in read_model_description(str(tmp_path / "machine.fmu")).modelVariables}
    assert variables["raft.z"].causality == "output"
    assert variables["input.raft.z"].causality == "input"
    assert not validate_fmu(str(tmp_path / "machine.fmu"))
