# SPDX-License-Identifier: BSD-3-Clause
"""Installs the library into an empty folder, and builds and runs a program outside the tree that uses it."""
import math
import pathlib
import re
import shutil
import subprocess
import sys

build, source, examples, work, compiler, flags = sys.argv[1:]
work = pathlib.Path(work)
shutil.rmtree(work, ignore_errors=True)


def run(*command):
    print("+", *command, flush=True)
    subprocess.run(command, check=True)


run("cmake", "--install", build, "--prefix", str(work / "installed"))
licences = {file.name: file.read_text() for file in (work / "installed/share/trivet/licences").iterdir()}
for package in ("three", "lit", "uplot", "@codemirror/view"):  # of the page that the program contains
    assert re.search(rf"^{re.escape(package)} \d", licences["page"], re.MULTILINE), package
assert "Leon Sorokin" in licences["page"]  # of the charts, in every report


def built(source, name):
    run(
        "cmake",
        "-S",
        source,
        "-B",
        str(work / name),
        "-G",
        "Ninja",
        f"-DCMAKE_PREFIX_PATH={work / 'installed'}",
        f"-DCMAKE_CXX_COMPILER={compiler}",
        f"-DCMAKE_CXX_FLAGS={flags}",
    )
    run("cmake", "--build", str(work / name))
    return work / name


def output(*command):
    return subprocess.run(list(map(str, command)), check=True, capture_output=True, text=True).stdout


run(str(built(source, "consumer") / "consumer"))

programs = built(examples, "examples")
spring = output(programs / "coil_spring")
print(spring)
axial = float(re.match(r"axial ([\d.]+) N/mm", spring)[1])
assert abs(axial / 57.8 - 1) < 0.05, "G d^4 / (8 D^3 n) is 57.8 N/mm; the inclined wire differs by some percent"
assert spring.count("surge mode") == 4
machine = output(programs / "machine_on_mounts")
print(machine)
first = float(re.match(r" *2 Hz +([\d.]+) mm", machine)[1])
amplitude = 120 / abs(4 * 420e3 * (1 + 0.08j) - 250 * (2 * math.pi * 2) ** 2) * 1e3
assert abs(first - amplitude) < 1e-4, (first, amplitude)
modes = output(programs / "natural_frequencies", pathlib.Path(examples).parent / "genset" / "genset.toml")
print(modes)
assert modes.count("Hz") == 8  # with the two of the deck
