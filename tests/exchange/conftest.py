# SPDX-License-Identifier: BSD-3-Clause
"""Exports read back by other programs. TRIVET names the program."""

import json
import os
import pathlib
import subprocess

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]

#: Light damping (1e-5), two bodies, turned axes, names that formats dislike.
MACHINE = """trivet = 1
title = "Pump on a raft"
[bodies."pump 1"]
mass = 180
inertia = {about = "center_of_mass", xx = 6, yy = 9, zz = 8, xy = 0.4}
points.flange = [0.3, 0.1, 0.2]
[bodies.raft]
mass = 420
position = [0, 0, -0.4]
inertia = {about = "center_of_mass", xx = 30, yy = 44, zz = 60}
[element_types.mount]
type = "bushing"
translation = [3e5, 4e5, 9e5]
rotation = [900, 800, 300]
damping = {proportional = 5e-7}
[elements.a]
type = "mount"
on = "pump 1"
at = [0.25, 0.2, -0.2]
from = "raft"
[elements.b]
type = "mount"
on = "pump 1"
at = [-0.25, 0.2, -0.2]
from = "raft"
orientation = {axis = [1, 2, 3], angle = "30 deg"}
[elements."c/d"]
type = "mount"
on = "pump 1"
at = [0, -0.22, -0.2]
from = "raft"
[elements.e]
type = "mount"
on = "raft"
at = [0.5, 0.4, -0.1]
[elements.f]
type = "mount"
on = "raft"
at = [-0.5, 0.4, -0.1]
[elements.g]
type = "mount"
on = "raft"
at = [0, -0.4, -0.1]
[excitations.shaft]
type = "harmonic"
on = "pump 1"
at = [0.3, 0.1, 0.2]
force = [0, 0, 25]
[analyses]
response = {band = ["1 Hz", "30 Hz"], of = ["coordinates", "pump 1.flange", "ground"]}
peaks = {}
modes = {}
"""


class Program:
    """The command line on one project file."""

    def __init__(self, path: pathlib.Path) -> None:
        self.path = path

    def __call__(self, *arguments: str, code: int = 0) -> subprocess.CompletedProcess:
        program = os.environ["TRIVET"]
        ran = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True)
        assert ran.returncode == code, (arguments, ran.returncode, ran.stderr)
        return ran

    def json(self, analysis: str, *arguments: str) -> dict:
        return json.loads(self(analysis, self.path, "--json", *arguments).stdout)

    def export(self, format_name: str, target: pathlib.Path, *arguments: str, code: int = 0) -> str:
        """The notes."""
        return self("export", self.path, "--to", format_name, "-o", target, *arguments, code=code).stderr


@pytest.fixture(scope="session")
def program(tmp_path_factory) -> Program:
    path = tmp_path_factory.mktemp("machine") / "machine.toml"
    path.write_text(MACHINE, encoding="utf-8")
    return Program(path)


@pytest.fixture
def with_text(tmp_path):
    """The program on another text."""

    def made(text: str) -> Program:
        path = tmp_path / "other.toml"
        path.write_text(text, encoding="utf-8")
        return Program(path)

    return made
