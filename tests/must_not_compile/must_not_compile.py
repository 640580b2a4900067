# SPDX-License-Identifier: BSD-3-Clause
"""Each program of this folder compiles, and with -DWRONG it does not: the types reject what could be confused."""
import pathlib
import subprocess
import sys

compiler, source, *options = sys.argv[1:]


def compiles(program, *more):
    done = subprocess.run(
        [compiler, "-std=c++20", "-fsyntax-only", f"-I{source}", *options, *more, str(program)],
        capture_output=True,
        text=True,
    )
    return done.returncode == 0, done.stderr


for program in sorted(pathlib.Path(__file__).parent.glob("*.cpp")):
    right, errors = compiles(program)
    assert right, errors
    wrong, _ = compiles(program, "-DWRONG")
    assert not wrong, f"{program.name} compiles with -DWRONG"
