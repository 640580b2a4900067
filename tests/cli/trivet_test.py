# SPDX-License-Identifier: BSD-3-Clause
"""The program as a user sees it: exit codes, outputs, files, faults of the system."""
import csv
import io
import json
import os
import pathlib
import shutil
import signal
import subprocess
import tempfile
import time
import tomllib
import unittest

TRIVET = os.environ["TRIVET"]
SOURCE = pathlib.Path(os.environ["TRIVET_SOURCE"])
PAPER = SOURCE / "examples/paper/corrected.toml"
PRINTED = SOURCE / "examples/paper/as_printed.toml"
EXAMPLES = sorted((SOURCE / "examples").glob("*/*.toml"))


# Ends a program that hangs. No measurement: an optimum within tolerances takes four minutes of processor time with
# sanitizers, and other tests run beside it.
HANGS_AFTER = 1200


def trivet(*arguments, **options):
    return subprocess.run(
        [TRIVET, *map(str, arguments)], capture_output=True, text=True, timeout=HANGS_AFTER, **options
    )


def result_of(*arguments):
    done = trivet(*arguments, "--json")
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


class InTemporaryFolder(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder, True)

    def file(self, text, name="project.toml"):
        path = self.folder / name
        path.write_text(text)
        return path


class Contract(InTemporaryFolder):
    def test_modes(self):
        found = result_of("modes", PAPER)
        self.assertEqual(found["bodies"], ["aggregate"])
        self.assertEqual(len(found["modes"]), 6)
        for key in (
            "eigenvalue_squared",
            "angular_frequency",
            "frequency_hz",
            "shape",
            "kinetic_energy_share",
            "strain_energy_share",
            "name",
        ):
            self.assertIn(key, found["modes"][0])
        self.assertEqual(found["warnings"], [])

    def test_the_lowest_modes(self):
        every = result_of("modes", PAPER)["modes"]
        done = trivet("modes", PAPER, "--lowest", "2", "--json")
        self.assertEqual(json.loads(done.stdout)["modes"], every[:2])
        self.assertIn("the lowest 2", trivet("modes", PAPER, "--lowest", "2").stdout)
        self.assertEqual(trivet("modes", PAPER, "--lowest", "0").returncode, 2)
        of_file = self.file(PAPER.read_text().replace("modes = {}", "modes = {lowest = 3}"))
        self.assertEqual(result_of("modes", of_file)["modes"], every[:3])

    def test_as_printed_every_output_carries_the_warning(self):
        for which in ("modes", "roots", "response", "peaks"):
            extra = ("--at", "1 rad/s") if which == "response" else ()
            self.assertTrue(any("inertia" in w for w in result_of(which, PRINTED, *extra)["warnings"]), which)
            self.assertIn("warning", trivet(which, PRINTED, *extra).stderr)
            self.assertIn("warning", trivet(which, PRINTED, *extra, "--csv").stderr)
        self.assertIsNone(result_of("modes", PRINTED)["modes"][0]["angular_frequency"])
        growing = [r for r in result_of("roots", PRINTED)["roots"] if r["kind"] == "growing"]
        self.assertEqual(len(growing), 1)
        self.assertIsNone(growing[0]["angular_frequency"])

    def test_as_printed_without_permission_is_rejected(self):
        bad = self.file(PRINTED.read_text().replace("allow_unphysical = true\n", ""))
        done = trivet("run", bad, "-o", self.folder / "out")
        self.assertEqual(done.returncode, 2)
        self.assertIn("131.596", done.stderr)
        self.assertFalse((self.folder / "out").exists())

    def test_response_at_frequencies_with_units(self):
        found = result_of("response", PAPER, "--at", "0 Hz,1 rad/s,2.5 Hz")
        self.assertEqual(found["angular_frequency"][:2], [0, 1])
        self.assertAlmostEqual(found["angular_frequency"][2], 15.70796326794897, places=12)
        self.assertEqual(found["results"][0]["name"], "aggregate.x")
        self.assertEqual(found["results"][3]["unit"], "rad")
        self.assertEqual(len(found["results"][0]["complex"]), 3)
        self.assertTrue(found["checks"]["second_solver"]["passed"])

    def test_roots_peaks_static_element(self):
        self.assertEqual(len(result_of("roots", PAPER)["roots"]), 12)
        peak = result_of("peaks", PAPER, "--case", "Figure 7")["peaks"][0]
        for key in ("name", "angular_frequency", "amplitude", "prominence", "ratio_to_static", "nearest_mode"):
            self.assertIn(key, peak)
        static = result_of("static", SOURCE / "examples/skew_mounts/machine.toml")
        total = next(r for r in static["results"] if r["name"] == "ground.force.z")
        self.assertAlmostEqual(total["value"], -400 * 9.80665, places=6)
        element = result_of("element", SOURCE / "examples/paper/three_elements.toml", "element x")
        self.assertEqual(len(element["stiffness"]), 12)
        self.assertEqual(len(element["rigid_motion_residual"]), 12)

    def test_csv_reads_back(self):
        rows = list(csv.reader(io.StringIO(trivet("response", PAPER, "--at", "1 rad/s,2 rad/s", "--csv").stdout)))
        self.assertEqual(len(rows), 3)
        self.assertEqual(len({len(row) for row in rows}), 1)

    def test_case_and_set(self):
        base = result_of("modes", PAPER)["modes"][0]["angular_frequency"]
        self.assertAlmostEqual(
            result_of("modes", PAPER, "--case", "Figure 8")["modes"][0]["angular_frequency"], base * 3**0.5, places=9
        )
        self.assertAlmostEqual(
            result_of("modes", PAPER, "--set", "elements.suspension.scale=4")["modes"][0]["angular_frequency"],
            2 * base,
            places=9,
        )
        done = trivet("modes", PAPER, "--case", "Figur 8")
        self.assertEqual(done.returncode, 2)
        self.assertIn('did you mean "Figure 8"', done.stderr)

    def test_check_as_json(self):
        bad = trivet("check", SOURCE / "tests/bad/mass_in_metres.toml", "--json")
        self.assertEqual(bad.returncode, 2)
        verdict = json.loads(bad.stdout)
        self.assertFalse(verdict["ok"])
        self.assertEqual(verdict["problems"][0]["severity"], "error")
        self.assertGreater(verdict["problems"][0]["line"], 0)

    def test_an_unknown_command_is_named(self):
        run = trivet("modess", PAPER)
        self.assertEqual((run.returncode, run.stderr), (2, 'error: "modess" is not a command; did you mean "modes"?\n'))
        none = trivet()
        self.assertEqual(none.returncode, 2)
        self.assertIn("subcommand is required", none.stderr)

    def test_schema_accepts_examples_and_finds_a_typing_error(self):
        import jsonschema

        schema = json.loads(trivet("schema").stdout)
        validator = jsonschema.Draft7Validator(schema)
        for example in EXAMPLES:
            validator.validate(tomllib.loads(example.read_text()))
        validator.validate(tomllib.loads(trivet("new").stdout))
        wrong = tomllib.loads(PAPER.read_text())
        wrong["bodies"]["aggregate"]["mas"] = 3
        self.assertFalse(validator.is_valid(wrong))

    def test_what_cannot_be_computed_does_not_stop_the_rest(self):
        text = (
            (SOURCE / "examples/free_pair/coupled_bodies.toml")
            .read_text()
            .replace("peaks = {}", "peaks = {}\nstatic = {}")
        )
        path = self.file("gravity = [0, 0, -9.81]\n" + text)
        done = trivet("run", path, "-o", self.folder / "out")
        self.assertEqual(done.returncode, 1)
        self.assertIn("NOT COMPUTED: static", done.stdout)
        self.assertTrue((self.folder / "out/report.html").exists())

    def test_free_system_is_named(self):
        found = result_of("modes", SOURCE / "examples/free_pair/coupled_bodies.toml")
        self.assertEqual(len(found["free_motions"]), 6)
        self.assertEqual([m["angular_frequency"] for m in found["modes"][:6]], [0] * 6)
        self.assertIsNone(found["modes"][0]["strain_energy_share"])


class Faults(InTemporaryFolder):
    def test_files_that_are_no_project(self):
        (self.folder / "empty.toml").write_text("")
        (self.folder / "blank.toml").write_text("\n \n")
        (self.folder / "zeros.toml").write_bytes(b"trivet = 1\0")
        with open(self.folder / "huge.toml", "wb") as huge:
            huge.truncate(1 << 30)
        for name, words in (
            ("missing.toml", "o such file"),
            (".", "directory"),
            ("empty.toml", "empty"),
            ("blank.toml", "empty"),
            ("zeros.toml", "NUL bytes"),
            ("huge.toml", "larger than 16 MiB"),
        ):
            started = time.monotonic()
            done = trivet("check", self.folder / name)
            self.assertEqual(done.returncode, 2, name)
            self.assertIn(words, done.stderr)
            self.assertLess(time.monotonic() - started, 20)

    @unittest.skipIf(os.geteuid() == 0, "root may read everything")
    def test_unreadable_file(self):
        path = self.file("trivet = 1")
        path.chmod(0)
        self.assertIn("Permission denied", trivet("check", path).stderr)

    def test_wrong_arguments(self):
        for arguments in (
            ("modes",),
            ("mode", PAPER),
            ("response", PAPER, "--at", "1,x"),
            ("response", PAPER, "--at", "-1 Hz"),
            ("response", PAPER, "--band", "5 Hz,1 Hz"),
            ("modes", PAPER, "--json", "--csv"),
            ("element", PAPER, "suspensio"),
            ("modes", PAPER, "--set", "nonsense"),
            (),
        ):
            self.assertEqual(trivet(*arguments).returncode, 2, arguments)

    def test_a_foreign_folder_is_not_overwritten(self):
        (self.folder / "mine").mkdir()
        (self.folder / "mine/thesis.txt").write_text("years of work")
        done = trivet("run", PAPER, "-o", self.folder / "mine")
        self.assertEqual(done.returncode, 1)
        self.assertIn("exists and is not an earlier result", done.stderr)
        self.assertEqual(os.listdir(self.folder / "mine"), ["thesis.txt"])

    def test_a_folder_that_only_looks_like_a_result_is_not_overwritten(self):
        (self.folder / "other").mkdir()
        (self.folder / "other/results.json").write_text('{"format":"trivet-results"}')
        done = trivet("run", PAPER, "-o", self.folder / "other")
        self.assertEqual(done.returncode, 1)
        self.assertIn("no manifest.json that lists its files", done.stderr)
        self.assertEqual(trivet("run", PAPER, "-o", ".", cwd=self.folder).returncode, 1)
        self.assertEqual(trivet("run", PAPER, "-o", "").returncode, 2)
        self.assertIn("choose another folder with -o", trivet("run", PAPER, "-o", "/proc/x").stderr)

    def test_an_earlier_result_survives_a_failed_run_and_is_replaced_by_a_good_one(self):
        target = self.folder / "out"
        self.assertEqual(trivet("run", PAPER, "-o", target).returncode, 0)
        before = (target / "results.json").read_bytes()
        bad = self.file(PAPER.read_text().replace("mass = 205.176", "mass = -1"))
        self.assertEqual(trivet("run", bad, "-o", target).returncode, 2)
        self.assertEqual((target / "results.json").read_bytes(), before)
        self.assertEqual(trivet("run", PRINTED, "-o", target).returncode, 0)
        self.assertNotEqual((target / "results.json").read_bytes(), before)
        self.assertEqual(sorted(os.listdir(self.folder)), ["out", "project.toml"])

    def test_a_full_disk_gives_a_message(self):
        with open("/dev/full", "w") as full:
            done = subprocess.run([TRIVET, "modes", str(PAPER)], stdout=full, stderr=subprocess.PIPE, text=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn("No space left", done.stderr)

    def test_without_a_reader_of_errors_it_ends_quietly(self):
        read, write = os.pipe()
        os.close(read)
        try:
            for arguments, code in ((["peaks", str(PAPER)], 141), (["peaks", "no such file"], 2)):
                done = subprocess.run([TRIVET, *arguments], stdout=write, stderr=write)
                self.assertEqual(done.returncode, code)  # not by a signal
        finally:
            os.close(write)

    def test_a_reader_that_leaves_is_no_error(self):
        mount = SOURCE / "examples/rubber_mounts/compressor.toml"
        element = next(iter(tomllib.loads(mount.read_text())["elements"]))
        commands = [
            [which, PAPER, *form] for which in ("modes", "roots", "peaks") for form in ((), ("--json",), ("--csv",))
        ]
        commands += [
            [which, SOURCE / "examples" / example, *form]
            for form in ((), ("--json",), ("--csv",))
            for which, example in (
                ("static", "skew_mounts/machine.toml"),
                ("orders", "genset/genset.toml"),
                ("random", "optical_table/table.toml"),
            )
        ]
        commands += [
            ["response", PAPER, "--csv"],
            ["check", PAPER],
            ["check", PAPER, "--json"],
            ["element", mount, element],
            ["explain", PAPER],
            ["suspension", PAPER],
            ["map", SOURCE / "examples/paper/map.toml", "--points", "5", "--json"],
            ["schema"],
            ["new"],
            ["run", PAPER, "-o", self.folder / "out"],
        ]
        for command in commands:
            with self.subTest(command=command):
                reader, writer = os.pipe()
                os.close(reader)
                done = subprocess.run([TRIVET, *map(str, command)], stdout=writer, stderr=subprocess.PIPE, text=True)
                os.close(writer)
                self.assertEqual(done.returncode, 141, done.stderr)
                self.assertNotIn("error", done.stderr)
                self.assertNotIn("pipe", done.stderr)
        self.assertTrue((self.folder / "out" / "report.html").exists())

    def test_closed_streams_get_no_file_of_ours(self):
        for closed, code, words in (
            (">&-", 1, "Bad file descriptor"),
            ("<&- >&- 2>&-", 1, ""),
            ("2>&-", 0, ""),
            ("<&-", 0, ""),
            ("<&- 2>&-", 0, ""),
        ):
            with self.subTest(closed=closed):
                done = subprocess.run(
                    ["sh", "-c", f'exec "{os.path.abspath(TRIVET)}" run "{PAPER}" -o "{self.folder}/out" {closed}'],
                    capture_output=True,
                    text=True,
                )
                self.assertEqual(done.returncode, code, done.stderr)
                self.assertIn(words, done.stderr)
        self.assertEqual(os.listdir(self.folder), ["out"])

    def test_the_picture_is_drawn_without_a_reader(self):
        picture = self.folder / "map.svg"
        reader, writer = os.pipe()
        os.close(reader)
        done = subprocess.run(
            [TRIVET, "map", str(SOURCE / "examples/paper/map.toml"), "--points", "5", "--picture", str(picture)],
            stdout=writer,
            stderr=subprocess.PIPE,
        )
        os.close(writer)
        self.assertEqual(done.returncode, 141)
        self.assertIn("</svg>", picture.read_text())

    def test_a_folder_that_cannot_be_written(self):
        done = trivet("run", PAPER, "-o", "/proc/nowhere/out")
        self.assertEqual(done.returncode, 1)
        self.assertIn("cannot be created", done.stderr)

    def test_an_interrupt_leaves_nothing_behind(self):
        text = 'trivet = 1\n'
        for i in range(24):
            text += f'[bodies.b{i}]\nmass = {1 + i}\ninertia = {{about = "pole", xx = 1, yy = 1, zz = 1}}\nposition = [0, 0, {i}]\n'
            text += f'[elements.e{i}]\ntype = "bushing"\non = "b{i}"\nat = [0, 0, 0]\ntranslation = [1e5, 2e5, 3e5]\nrotation = [1e4, 1e4, 2e4]\ndamping = {{loss_factor = 0.001}}\n'
            text += f'from = "b{i - 1}"\n' if i else ""
        text += '[excitations.f]\ntype = "harmonic"\non = "b0"\nat = [0, 0, 0]\nforce = [1, 1, 1]\nmoment = [1, 1, 1]\n[analyses]\npeaks = {}\nresponse = {}\n'
        process = subprocess.Popen(
            [TRIVET, "run", str(self.file(text)), "-o", str(self.folder / "out")],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
        )
        deadline = time.monotonic() + 60
        while not any(p.name.startswith(".trivet-") for p in self.folder.iterdir()) and time.monotonic() < deadline:
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=HANGS_AFTER)
        self.assertEqual(process.returncode, 130, errors)
        self.assertIn("interrupted", errors)
        self.assertEqual(os.listdir(self.folder), ["project.toml"])


if __name__ == "__main__":
    unittest.main()
