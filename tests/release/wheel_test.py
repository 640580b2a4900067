# SPDX-License-Identifier: BSD-3-Clause
"""The wheels in a clean environment of every Python that is installed, from pip to the first picture."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time
import unittest
import zipfile

FILES = pathlib.Path(os.environ["TRIVET_RELEASE_FILES"])
SOURCE = pathlib.Path(__file__).resolve().parents[2]
WHEELS = sorted(FILES.glob("*.whl"))

most_bytes = 8_000_000
most_seconds = 60

PICTURE = """
import trivet
trivet.open(r"{machine}").response().plot().savefig("first.png")
"""


def pythons():
    """Installed versions from 3.11 on that have a wheel, each once."""
    found = {}
    for python in subprocess.run(
        [SOURCE / "scripts/pythons"], check=True, capture_output=True, text=True
    ).stdout.split():
        minor = int(python.rsplit(".", 1)[1])
        if wheel_for(minor):
            found[minor] = python
    return found


def wheel_for(minor):
    for wheel in WHEELS:
        if f"-cp3{minor}-cp3{minor}-" in wheel.name or (minor >= 12 and "-cp312-abi3-" in wheel.name):
            return wheel
    return None


class Wheels(unittest.TestCase):
    def test_are_small_and_for_the_c_library_2_28(self):
        self.assertTrue(WHEELS)
        for wheel in WHEELS:
            with self.subTest(wheel.name):
                self.assertIn("manylinux_2_28_x86_64", wheel.name)
                self.assertLessEqual(wheel.stat().st_size, most_bytes)
                with zipfile.ZipFile(wheel) as files, tempfile.TemporaryDirectory() as folder:
                    (module,) = [name for name in files.namelist() if re.search(r"_core\..*so$", name)]
                    files.extract(module, folder)
                    path = pathlib.Path(folder) / module
                    needed = subprocess.run(
                        ["readelf", "-dVW", path], check=True, capture_output=True, text=True
                    ).stdout
                libraries = set(re.findall(r"Shared library: \[(.*?)\]", needed))
                allowed = {
                    "libc.so.6",
                    "libm.so.6",
                    "libdl.so.2",
                    "libpthread.so.0",
                    "libgcc_s.so.1",
                    "ld-linux-x86-64.so.2",
                }
                self.assertLessEqual(libraries, allowed)
                versions = {tuple(map(int, v.split("."))) for v in re.findall(r"GLIBC_([0-9.]+)", needed)}
                self.assertLessEqual(max(versions), (2, 28))

    @unittest.skipUnless("TRIVET_OLDER_ROOT" in os.environ, "no older system (scripts/release makes one)")
    def test_modules_find_all_they_need_in_an_older_system(self):
        root = pathlib.Path(os.environ["TRIVET_OLDER_ROOT"])
        for wheel in WHEELS:
            with self.subTest(wheel.name), tempfile.TemporaryDirectory(dir=root) as folder:
                with zipfile.ZipFile(wheel) as files:
                    (module,) = [name for name in files.namelist() if re.search(r"_core\..*so$", name)]
                    files.extract(module, folder)
                inside = pathlib.Path("/") / pathlib.Path(folder).name / module
                ran = subprocess.run(["chroot", root, "ldd", "-r", inside], capture_output=True, text=True)
                missing = [
                    line
                    for line in (ran.stdout + ran.stderr).splitlines()
                    if "not found" in line or "undefined" in line
                ]
                self.assertEqual([line for line in missing if not re.search(r"undefined symbol: _?Py", line)], [])
                self.assertTrue(missing, "ldd found even the names of Python")

    def test_first_picture_within_a_minute_of_pip_install(self):
        self.assertTrue(pythons(), "no Python from 3.11 on has a wheel")
        for minor, python in pythons().items():
            with self.subTest(python=f"3.{minor}"), tempfile.TemporaryDirectory() as folder:
                place = pathlib.Path(folder)
                subprocess.run([python, "-m", "venv", place / "environment"], check=True)
                here = place / "environment" / "bin"
                start = time.monotonic()
                subprocess.run(
                    [here / "pip", "install", "-q", "--disable-pip-version-check", f"{wheel_for(minor)}[plots]"],
                    check=True,
                )
                script = PICTURE.format(machine=SOURCE / "examples/paper/corrected.toml")
                subprocess.run([here / "python", "-c", script], cwd=place, check=True)
                seconds = time.monotonic() - start
                self.assertEqual((place / "first.png").read_bytes()[1:4], b"PNG")
                self.assertLessEqual(seconds, most_seconds)
                for program in ([here / "trivet"], [here / "python", "-m", "trivet"]):
                    ran = subprocess.run(
                        [*program, "run", SOURCE / "examples/genset/genset.toml", "-o", place / "results"],
                        capture_output=True, text=True,
                    )  # fmt: skip
                    self.assertEqual(ran.returncode, 0, ran.stderr)
                    self.assertTrue((place / "results" / "report.html").exists())
                subprocess.run([here / "python", SOURCE / "tests/python/bare.py"], cwd=place, check=True)
                print(f"Python 3.{minor}: {seconds:.0f} s from pip install to the first picture", file=sys.stderr)


if __name__ == "__main__":
    unittest.main()
