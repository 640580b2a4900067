# SPDX-License-Identifier: BSD-3-Clause
"""Installs the library into an empty folder, and builds and runs a program outside the tree that uses it."""
import pathlib
import shutil
import subprocess
import sys

build, source, work, compiler, flags = sys.argv[1:]
work = pathlib.Path(work)
shutil.rmtree(work, ignore_errors=True)


def run(*command):
    print("+", *command, flush=True)
    subprocess.run(command, check=True)


run("cmake", "--install", build, "--prefix", str(work / "installed"))
run("cmake", "-S", source, "-B", str(work / "build"), "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={work / 'installed'}",
    f"-DCMAKE_CXX_COMPILER={compiler}", f"-DCMAKE_CXX_FLAGS={flags}")
run("cmake", "--build", str(work / "build"))
run(str(work / "build" / "consumer"))
