# SPDX-License-Identifier: BSD-3-Clause
"""The program in one file runs where there is nothing else, and computes what the ordinary program computes."""

import json
import math
import os
import pathlib
import shutil
import subprocess
import tarfile
import tempfile
import unittest

FILES = pathlib.Path(os.environ["TRIVET_RELEASE_FILES"])
SOURCE = pathlib.Path(__file__).resolve().parents[2]

MACHINE = """trivet = 1
title = "Fan"
[bodies.fan]
mass = "250 lb"
inertia = {about = "center_of_mass", xx = 4, yy = 5, zz = 6}
[elements.a]
type = "bushing"
on = "fan"
at = ["-12 in", 0, "-100 mil"]
translation = ["200 lbf/in", "200 lbf/in", "300 lbf/in"]
[elements.b]
type = "bushing"
on = "fan"
at = ["12 in", "3 in", "-100 mil"]
translation = ["200 lbf/in", "200 lbf/in", "300 lbf/in"]
[elements.c]
type = "bushing"
on = "fan"
at = ["1 in", "-9 in", "-100 mil"]
translation = ["200 lbf/in", "200 lbf/in", "300 lbf/in"]
"""

# Ten examples with different analyses; what each prints as JSON.
COMMANDS = [
    ("peaks", "paper/corrected.toml"),
    ("modes", "three_coil_springs/machine.toml"),
    ("peaks", "genset/genset.toml"),
    ("random", "optical_table/table.toml"),
    ("transient", "transport_shock/device.toml"),
    ("orders", "roll_stop/idle.toml"),
    ("steady", "isolator/hardening.toml"),
    ("explain", "free_pair/coupled_bodies.toml"),
    ("verdict", "genset/mounts.toml"),
    ("static", "genset/load_cases.toml"),
]


def numbers(value, path=""):
    """Every number of a JSON document with the path to it."""
    if isinstance(value, dict):
        for key, one in value.items():
            yield from numbers(one, f"{path}/{key}")
    elif isinstance(value, list):
        for at, one in enumerate(value):
            yield from numbers(one, f"{path}/{at}")
    elif isinstance(value, (int, float)) and not isinstance(value, bool):
        yield path, float(value)


def list_of(path):
    """The list of numbers that a number belongs to, for instance a curve."""
    return "/".join("*" if part.isdigit() else part for part in path.split("/"))


class StaticProgram(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        (archive,) = FILES.glob("trivet-*-linux-x86_64.tar.gz")
        cls.folder = tempfile.TemporaryDirectory()
        with tarfile.open(archive) as packed:
            packed.extractall(cls.folder.name, filter="data")
        (cls.unpacked,) = pathlib.Path(cls.folder.name).iterdir()

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_the_archive_has_the_program_its_licence_and_those_of_its_libraries(self):
        self.assertEqual(
            sorted(one.name for one in self.unpacked.iterdir()), ["LICENSE", "example.toml", "licences", "trivet"]
        )
        licences = {one.name for one in (self.unpacked / "licences").iterdir()}
        self.assertLessEqual({"libnlopt-dev", "libc6-dev", "page"}, licences)

    def test_needs_no_loader_and_no_library(self):
        headers = subprocess.run(
            ["readelf", "-lW", self.unpacked / "trivet"], check=True, capture_output=True, text=True
        ).stdout
        self.assertNotIn("INTERP", headers)
        self.assertNotIn("DYNAMIC", headers)

    def test_runs_in_a_root_that_has_nothing_but_the_file(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "trivet").write_bytes((self.unpacked / "trivet").read_bytes())
            (root / "trivet").chmod(0o755)
            (root / "example.toml").write_bytes((self.unpacked / "example.toml").read_bytes())
            (root / "fan.toml").write_text(MACHINE)
            nothing = {"PATH": os.environ["PATH"]}  # of no use in the new root
            inside = ["unshare", "--map-root-user", "chroot", str(root), "/trivet"]
            for arguments in (
                ["--version"],
                ["run", "example.toml", "-o", "results"],
                ["modes", "fan.toml"],
                ["export", "example.toml", "--to", "numpy", "-o", "a.npz"],
                ["export", "example.toml", "--to", "excel", "-o", "a.xlsx"],
                ["export", "example.toml", "--to", "matlab", "-o", "a.mat"],
            ):
                ran = subprocess.run([*inside, *arguments], env=nothing, capture_output=True, text=True)
                self.assertEqual(ran.returncode, 0, f"{arguments}: {ran.stdout}{ran.stderr}")
            self.assertIn("<svg", (root / "results" / "report.html").read_text())
            self.assertEqual((root / "a.xlsx").read_bytes()[:2], b"PK")
            modes = json.loads(
                subprocess.run(
                    [*inside, "modes", "fan.toml", "--json"], env=nothing, check=True, capture_output=True
                ).stdout
            )
            vertical = math.sqrt(3 * 300 * 4.4482216152605 / 0.0254 / (250 * 0.45359237))
            found = [number for path, number in numbers(modes) if path.endswith("angular_frequency")]
            self.assertTrue(min(found) < vertical < max(found), found)

    @unittest.skipUnless("TRIVET_OLDER_ROOT" in os.environ, "no older system (scripts/release makes one)")
    def test_runs_in_an_older_system(self):
        root = pathlib.Path(os.environ["TRIVET_OLDER_ROOT"])
        with tempfile.TemporaryDirectory(dir=root) as folder:
            for name in ("trivet", "example.toml"):
                shutil.copy(self.unpacked / name, folder)
            inside = pathlib.Path("/") / pathlib.Path(folder).name
            command = f"cd {inside} && ./trivet run example.toml -o results"
            ran = subprocess.run(["chroot", root, "sh", "-c", command], capture_output=True, text=True)
            self.assertEqual(ran.returncode, 0, ran.stderr)
            self.assertTrue((pathlib.Path(folder) / "results" / "report.html").exists())

    def test_has_the_numbers_of_the_ordinary_program(self):
        ordinary = os.environ.get("TRIVET", SOURCE / "build/release/apps/cli/trivet")
        compared = 0
        for command, example in COMMANDS:
            documents = [
                json.loads(
                    subprocess.run(
                        [program, command, SOURCE / "examples" / example, "--json"], capture_output=True
                    ).stdout
                )
                for program in (ordinary, self.unpacked / "trivet")
            ]
            expected, found = (list(numbers(one)) for one in documents)
            self.assertEqual([path for path, _ in expected], [path for path, _ in found], example)
            largest: dict[str, float] = {}
            for path, number in expected:
                largest[list_of(path)] = max(largest.get(list_of(path), 0), abs(number))
            for (path, number), (_, other) in zip(expected, found, strict=True):
                self.assertLessEqual(abs(number - other), 1e-12 * largest[list_of(path)], f"{example} {path}")
            compared += len(expected)
        self.assertGreater(compared, 10000)
        print(f"{compared} numbers of {len(COMMANDS)} examples are the same to 1e-12")


if __name__ == "__main__":
    unittest.main()
