# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the Python package share."""

import os
import pathlib
import signal
import subprocess

import pytest

import trivet

# A shell without job control starts programs in the background with interrupts ignored, and children inherit that.
signal.signal(signal.SIGINT, signal.default_int_handler)

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "examples"

#: A machine of one body on two springs, with everything that most analyses need.
MACHINE = {
    "title": "Machine",
    "bodies": {
        "machine": {
            "mass": 120.0,
            "inertia": {"about": "center_of_mass", "xx": 4.0, "yy": 5.0, "zz": 6.0},
            "points": {"seat": [0.1, 0.2, 0.3]},
        }
    },
    "elements": {
        name: {
            "type": "bushing",
            "on": "machine",
            "at": [x, y, -0.2],
            "translation": [4e4, 5e4, 9e4],
            "damping": {"proportional": 2e-4},
        }
        for name, x, y in (("a", -0.3, -0.2), ("b", 0.3, -0.2), ("c", -0.3, 0.2), ("d", 0.3, 0.2))
    },
    "excitations": {
        "force": {"type": "harmonic", "on": "machine", "at": [0.05, 0, 0], "force": [0, 0, 10.0]},
    },
}


@pytest.fixture(scope="session")
def machine() -> trivet.Project:
    return trivet.Project(**MACHINE)


@pytest.fixture(scope="session")
def command_line():
    """Runs the command line of the same build."""
    program = os.environ.get("TRIVET")
    assert program, "TRIVET must name the program trivet"

    def run(*arguments: str) -> str:
        return subprocess.run([program, *arguments], check=True, capture_output=True, text=True, cwd=ROOT).stdout

    return run


def example(name: str) -> str:
    return str(EXAMPLES / name)
