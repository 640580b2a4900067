# SPDX-License-Identifier: BSD-3-Clause
"""The command `trivet` of the package is the program."""

import importlib.metadata
import os
import pathlib
import signal
import subprocess
import sys
import sysconfig
import time

import pytest
from conftest import ROOT, example

import trivet

OF_THE_PACKAGE = str(pathlib.Path(sysconfig.get_path("scripts")) / "trivet")


@pytest.fixture(params=["command", "module"])
def command(request):
    return [OF_THE_PACKAGE] if request.param == "command" else [sys.executable, "-m", "trivet"]


def ran(command, *arguments):
    return subprocess.run([*command, *arguments], capture_output=True, cwd=ROOT)


@pytest.mark.parametrize(
    "arguments",
    [
        ["--version"],
        ["new"],
        ["respnse"],
        ["check", "absent.toml"],
        ["modes", example("genset/genset.toml"), "--json"],
        ["modes", example("genset/genset.toml")],
        ["verdict", example("genset/genset.toml"), "--strict"],
    ],
)
def test_it_says_what_the_program_says(command, arguments):
    ours, theirs = ran(command, *arguments), ran([os.environ["TRIVET"]], *arguments)
    assert (ours.returncode, ours.stdout, ours.stderr) == (theirs.returncode, theirs.stdout, theirs.stderr)


def test_help_lists_the_same_commands(command):
    ours, theirs = (ran(one, "--help").stdout.splitlines() for one in (command, [os.environ["TRIVET"]]))
    assert [line for line in ours if b"sage" not in line] == [line for line in theirs if b"sage" not in line]


def test_a_signal_ends_it_as_it_ends_the_program(command):
    long = [*command, "map", example("paper/map.toml"), "--points", "3000,3000"]
    with subprocess.Popen(long, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as running:
        time.sleep(1.0)
        assert running.poll() is None, running.stderr.read()
        running.send_signal(signal.SIGTERM)
        _, said = running.communicate(timeout=30)
    assert running.returncode == 128 + signal.SIGTERM
    assert b"interrupted" in said


def test_a_closed_pipe_has_the_exit_code_of_the_program(command):
    shell = " ".join(command) + " schema | true; echo ${PIPESTATUS[0]}"
    codes = {subprocess.run(["bash", "-c", shell], capture_output=True, text=True).stdout.strip() for _ in range(5)}
    assert codes <= {"0", "141"}


def test_the_metadata_describe_the_package():
    about = importlib.metadata.metadata("trivet")
    assert about["Version"] == trivet.__version__
    assert about["License-Expression"] == "BSD-3-Clause"
    assert "Typing :: Typed" in about.get_all("Classifier")
    assert "vibration" in about["Keywords"]
    assert about["Description-Content-Type"] == "text/markdown"
    assert "trivet" in {one.name for one in importlib.metadata.entry_points(group="console_scripts")}
