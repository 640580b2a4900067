# SPDX-License-Identifier: BSD-3-Clause
"""`optimize` and `map` in a study folder: several processes, a kill, a wrong folder. Every process ends with the bytes of one
process without a folder."""
import os
import shutil
import signal
import subprocess
import time
import unittest

from trivet_test import HANGS_AFTER, SOURCE, TRIVET, InTemporaryFolder, trivet

SEARCH = SOURCE / "examples/powertrain/decoupled.toml"
# Damping ratios are judged from models.
MAP = """trivet = 1
[bodies.machine]
mass = 80
inertia = {about = "center_of_mass", xx = 4, yy = 5, zz = 6}
[elements.mount]
type = "bushing"
on = "machine"
at = [0.1, 0, -0.2]
translation = [5e4, 5e4, 8e4]
rotation = [1e4, 1e4, 1e4]
damping = {loss_factor = 0.1}
[excitations.force]
type = "harmonic"
on = "machine"
at = [0, 0, 0]
force = [0, 0, 100]
[requirements]
damping_ratio = 0.04
[analyses.map]
x = {parameter = "elements.mount.scale", from = 0.5, to = 2, points = 9}
y = {parameter = "bodies.machine.mass", from = 60, to = 90, points = 9}
limits = {"machine.z" = "10 mm"}
"""


class SharedWork(InTemporaryFolder):
    def setUp(self):
        super().setUp()
        self.study = self.folder / "study"
        self.environment = {
            name: value for name, value in os.environ.items() if not name.startswith(("SLURM_", "PMI_", "OMPI_"))
        }

    def start(self, *arguments):
        return subprocess.Popen(
            [TRIVET, *map(str, arguments), "-o", str(self.study), "--json"],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            env=self.environment,
        )

    def all_at_once(self, *arguments, parts=3):
        """Standard outputs of all parts, and the numbers of items that each has read and computed."""
        runs = [self.start(*arguments, "--part", f"{part}/{parts}") for part in range(1, parts + 1)]
        outputs, counts = [], []
        for run in runs:
            output, errors = run.communicate(timeout=HANGS_AFTER)
            self.assertIn(run.returncode, (0, 1), errors)
            outputs.append(output)
            words = errors.split()
            counts.append((int(words[words.index("results") - 1]), int(words[words.index("computed") + 1])))
        return outputs, counts

    def test_processes_have_the_bytes_of_one(self):
        for name, arguments in {
            "search": ("optimize", SEARCH, "--set", "analyses.optimize.starts=60"),
            "map": ("map", self.file(MAP)),
        }.items():
            with self.subTest(name):
                expected = trivet(*arguments, "--json", env=self.environment).stdout
                outputs, counts = self.all_at_once(*arguments)
                self.assertEqual(outputs, [expected] * 3)
                self.assertEqual((self.study / "result.json").read_text(), expected)
                items = {read + computed for read, computed in counts}
                self.assertEqual(len(items), 1, counts)
                self.assertLess(sum(computed for _, computed in counts), 3 * items.pop())
                again = self.start(*arguments, "--part", "1/1")
                output, errors = again.communicate(timeout=HANGS_AFTER)
                self.assertEqual(output, expected)
                self.assertIn("computed 0", errors)
                shutil.rmtree(self.study)

    def test_a_killed_search_goes_on(self):
        arguments = ("optimize", SEARCH, "--set", "analyses.optimize.starts=150")
        expected = trivet(*arguments, "--json", env=self.environment).stdout
        run = self.start(*arguments)
        part = self.study / "part-1-of-1"
        while run.poll() is None and not (part.exists() and part.stat().st_size > 5000):
            time.sleep(0.01)
        run.send_signal(signal.SIGKILL)
        run.communicate(timeout=HANGS_AFTER)
        self.assertEqual(run.returncode, -signal.SIGKILL)
        again = self.start(*arguments)
        output, errors = again.communicate(timeout=HANGS_AFTER)
        self.assertEqual(output, expected)
        self.assertNotIn(" 0 results of others", errors)
        self.assertNotIn("computed 0", errors)

    def test_signals_say_how_to_go_on(self):
        for arguments in (
            ("optimize", SEARCH, "--set", "analyses.optimize.starts=1000"),
            ("map", self.file(MAP), "--points", "120"),
        ):
            for number in (signal.SIGINT, signal.SIGTERM, signal.SIGUSR1):
                with self.subTest(arguments[0], signal=number):
                    run = self.start(*arguments)
                    while run.poll() is None and not (self.study / "part-1-of-1").exists():
                        time.sleep(0.01)
                    time.sleep(0.3)
                    run.send_signal(number)
                    output, errors = run.communicate(timeout=HANGS_AFTER)
                    self.assertEqual(run.returncode, 128 + number, errors)
                    self.assertIn("ended by a signal; what was computed is kept", errors)
                    self.assertIn(f"trivet {' '.join(map(str, arguments))} --output {self.study}", errors)
                    self.assertFalse((self.study / "result.json").exists())
            shutil.rmtree(self.study)

    def test_after_a_time_limit_the_rest_has_none(self):
        arguments = ("optimize", SEARCH, "--set", "analyses.optimize.starts=1000")
        run = self.start(*arguments, "--time-limit", "1 s")
        output, errors = run.communicate(timeout=HANGS_AFTER)
        self.assertEqual(run.returncode, 1, errors)
        self.assertIn('"cut_short": true', output)
        self.assertIn(f"--output {self.study}\n", errors)
        self.assertNotIn("--time-limit", errors)
        self.assertFalse((self.study / "result.json").exists())

    def test_damaged_files_are_stated(self):
        expected = self.start("map", self.file(MAP)).communicate(timeout=HANGS_AFTER)[0]
        part = self.study / "part-1-of-1"
        part.write_text(part.read_text()[:-200])
        output, errors = self.start("map", self.file(MAP)).communicate(timeout=HANGS_AFTER)
        self.assertEqual(output, expected)
        self.assertIn("1 file (part-1-of-1) cannot be read: damaged", errors)

    def test_processes_without_a_folder_are_told_how_to_share(self):
        done = trivet("optimize", SEARCH, env=self.environment | {"PMI_RANK": "1", "PMI_SIZE": "4"})
        self.assertIn(
            "part 2 of 4 (PMI_RANK and PMI_SIZE): every process computes all of it; --output STUDY", done.stderr
        )

    def test_wrong_folders_and_parts(self):
        self.study.mkdir()
        (self.study / "other.txt").write_text("")
        wrong = {
            "it has no study but other files": ("optimize", SEARCH, "-o", self.study),
            "parts share a study folder": ("optimize", SEARCH, "--part", "1/2"),
            "writes no .svg file": ("map", self.file(MAP), "-o", self.folder / "map.svg"),
            "4/3": ("map", self.file(MAP), "-o", self.folder / "new", "--part", "4/3"),
        }
        for words, arguments in wrong.items():
            done = trivet(*arguments, env=self.environment)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(words, done.stderr)
        self.assertFalse((self.folder / "map.svg").exists())

    def test_a_folder_of_another_command_or_grid_is_refused(self):
        project = self.file(MAP)
        first = trivet("map", project, "-o", self.study, env=self.environment)
        self.assertEqual(first.returncode, 0, first.stderr)
        for arguments, words in {
            ("map", project, "--points", "7", "-o", self.study): "points: 9x9 there, 7x7 here",
            ("optimize", SEARCH, "-o", self.study): "it is of trivet map, not of trivet optimize",
            (
                "sample",
                SOURCE / "examples/paper/robust.toml",
                "-o",
                self.study,
            ): "it is of trivet map, not of trivet sample",
            ("sample", "--status", self.study): "it is of trivet map, which has no chunks of designs",
        }.items():
            done = trivet(*arguments, env=self.environment)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(words, done.stderr)


if __name__ == "__main__":
    unittest.main()
