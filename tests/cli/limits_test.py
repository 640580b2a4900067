# SPDX-License-Identifier: BSD-3-Clause
"""Sizes, ranges, names and messages for projects that are too large or unusual (docs/limits.md)."""
import os
import json
import pathlib
import re
import subprocess
import unittest

from trivet_test import HANGS_AFTER, PAPER, TRIVET, InTemporaryFolder, result_of, trivet

BODY = 'trivet = 1\n[bodies.b]\nmass = 100\ninertia = {about = "center_of_mass", xx = 8, yy = 9, zz = 10}\n'
FORCE = '[excitations.f]\ntype = "harmonic"\non = "b"\nat = [0.1, 0, 0.2]\nforce = [1, 2, 3]\n'


def mount(name, on="b", more=""):
    return f'[elements."{name}"]\ntype = "bushing"\non = "{on}"\nat = [0, 0, 0]\ntranslation = [1e5, 1.2e5, 3e5]\nrotation = [1e4, 1e4, 1e4]\ndamping = {{loss_factor = 0.1}}\n{more}\n'


class Refused(InTemporaryFolder):
    def refused(self, *words, files=(), text, command="check", code=2):
        for name, content in files:
            (self.folder / name).write_text(content)
        done = trivet(command, self.file(text), *(["-o", self.folder / "out"] if command == "run" else []))
        self.assertEqual(done.returncode, code, done.stderr[-500:])
        for word in words:
            self.assertIn(word, done.stderr)
        return done


class Messages(Refused):
    def test_one_mistake_in_thousands_of_places_is_reported_a_hundred_times(self):
        text = BODY + "".join(mount(f"m{i}", on="nobody") for i in range(2000))
        done = self.refused("no body has this name", "… and 1900 more (1900 errors, 0 warnings)", text=text)
        self.assertEqual(len(done.stderr.splitlines()), 101)
        problems = json.loads(trivet("check", self.folder / "project.toml", "--json").stdout)
        self.assertEqual((len(problems["problems"]), problems["not_listed"]), (100, 1900))

    def test_a_cut_cyrillic_text_is_still_a_message_and_json(self):
        text = BODY.replace("mass = 100", 'mass = "' + "x" + "ж" * 90 + '"')
        self.refused("…", text=text)
        found = trivet("check", self.folder / "project.toml", "--json")
        self.assertEqual(found.returncode, 2)
        self.assertFalse(json.loads(found.stdout)["ok"])

    def test_a_wrong_point_of_a_limit_line_has_its_unit(self):
        """The heading has mm/s, so that -0.003 without a unit would be another number."""
        text = BODY + mount("m") + FORCE + "[analyses]\nresponse = {}\n"
        text += '[limit_lines.norm]\nof = "b.z"\nfile = "norm.csv"\n'
        rows = "frequency [rpm],limit [mm/s rms]\n60,2\n600,-3\n"
        self.refused('limit line "norm": limit -0.003 m/s in row 2', files=[("norm.csv", rows)], text=text)

    def test_a_limit_line_beside_its_band_is_reported_in_hertz(self):
        text = BODY + mount("m") + FORCE + '[analyses]\nresponse = {band = ["1 Hz", "20 Hz"]}\n'
        text += '[limit_lines.norm]\nof = "b.z"\nrows = [["30 Hz", "2 mm/s rms"], ["60 Hz", "2 mm/s rms"]]\n'
        words = 'limit line "norm" runs from 30 to 60 Hz, the band from 1 to 20 Hz: they do not overlap'
        self.refused(words, text=text, command="limit_lines", code=1)

    def test_control_characters_of_the_command_line_do_not_reach_the_terminal(self):
        for arguments in (
            ("modes", PAPER, "--case", "\x1b[31mred"),
            ("element", PAPER, "a\x07b"),
            ("check", PAPER, "--set", "bodies.\x1b[2J=1"),
            ("check", self.folder / "\x1b[2J.toml"),
        ):
            done = trivet(*arguments)
            self.assertEqual(done.returncode, 2, arguments)
            self.assertNotRegex(done.stderr, r"[\x00-\x08\x0b-\x1f\x7f]")

    def test_json_is_valid_for_a_file_name_that_is_not_utf8(self):
        path = bytes(self.folder) + b"/M\xfcller.toml"
        pathlib.Path(path.decode("utf-8", "surrogateescape")).write_text(BODY + "mass = 1\n")
        done = subprocess.run([TRIVET.encode(), b"check", path, b"--json"], capture_output=True, timeout=HANGS_AFTER)
        self.assertEqual(done.returncode, 2)
        self.assertFalse(json.loads(done.stdout.decode())["ok"])
        self.assertIn(b"\\xfc", done.stderr)


class Frequencies(InTemporaryFolder):
    def test_units_are_on_all_values(self):
        for option, text in (
            ("--at", "1,5 Hz"),
            ("--at", "0,5 Hz"),
            ("--at", "1 Hz,5"),
            ("--at", "1,2.7,15 Hz"),
            ("--band", "10,50 Hz"),
        ):
            done = trivet("response", PAPER, option, text)
            self.assertEqual(done.returncode, 2, text)
            self.assertIn("some values have a unit and some have none", done.stderr)
            self.assertIn('"1 Hz,5 Hz"', done.stderr)
        self.assertEqual(trivet("suspension", PAPER, "--excitation", "25,50Hz").returncode, 2)

    def test_frequencies_without_units_are_rejected_with_both_units_offered(self):
        for command, option, text, in_hertz, in_rad in (
            ("response", "--band", "0,30", "0,30 Hz", "0,30 rad/s"),
            ("response", "--at", "20", "20 Hz", "20 rad/s"),
            ("response", "--at", "1,2.7", "1 Hz,2.7 Hz", "1 rad/s,2.7 rad/s"),
            ("suspension", "--excitation", "25,50", "25 Hz,50 Hz", "25 rad/s,50 rad/s"),
        ):
            done = trivet(command, PAPER, option, text)
            self.assertEqual(done.returncode, 2, text)
            self.assertIn(f'{option} "{text}": a frequency has a unit', done.stderr)
            self.assertIn(f'write {option} "{in_hertz}" or {option} "{in_rad}"', done.stderr)
            self.assertEqual(trivet(command, PAPER, option, in_hertz).returncode, 0, in_hertz)

    def test_lists_that_are_clear_are_accepted(self):
        self.assertEqual(result_of("response", PAPER, "--at", "1 rad/s,5 rad/s")["angular_frequency"], [1, 5])
        self.assertAlmostEqual(
            result_of("response", PAPER, "--at", "1.5 Hz")["angular_frequency"][0], 9.42477796076938, places=12
        )
        self.assertEqual(
            trivet("response", PAPER, "--band", "0,5 Hz").returncode, 0
        )  # 0 is 0 in every unit, and a band has two ends

    def test_a_band_has_two_ends(self):
        for band in ("0,1e-300 rad/s", "1 rad/s,1.0000000000000002 rad/s", "0,1e13 rad/s"):
            done = trivet("response", PAPER, "--band", band)
            self.assertEqual(done.returncode, 2, band)
            self.assertEqual(len(done.stderr.splitlines()), 1)


class Extremes(InTemporaryFolder):
    def test_a_motion_in_space_under_an_accelerated_ground_has_no_largest_amplitude(self):
        base = '[excitations.floor]\ntype = "base"\nquantity = "acceleration"\ntranslation = [0, 0, 1]\n[analyses]\nresponse = {of = ["b"], band = [5, 500]}\n[limits]\n"b.z" = 1\n"b.relative.z" = 1\n'
        done = trivet("response", self.file(BODY + mount("m") + base), "--full", env={**os.environ, "COLUMNS": "200"})
        rows = {
            line.split()[0]: re.split(r" {2,}", line.strip())
            for line in done.stdout.splitlines()
            if line.strip().startswith("b.") and " met" in line
        }
        self.assertEqual(rows["b.z"][-2], "∞", done.stdout[-600:])
        self.assertEqual(rows["b.relative.z"][-2], rows["b.relative.z"][2])


class Foundations(InTemporaryFolder):
    def test_a_mode_of_a_foundation_that_moves_no_mount_has_no_nan(self):
        text = (
            BODY
            + mount("m", more='foundation = "deck"')
            + FORCE
            + '[foundations.deck]\ntype = "modal"\nmodes = [{frequency = "12 Hz", modal_mass = 800, damping = 0.02, shapes = {m = [0, 0, 0]}}]\n'
        )
        project = self.file(text + "[analyses]\nmodes = {}\nroots = {}\n")
        for more in ((), ("--json",), ("--csv",)):
            done = trivet("modes", project, *more)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIsNone(re.search(r"\bnan\b", done.stdout))
        done = trivet("run", project, "-o", self.folder / "out")
        self.assertEqual(done.returncode, 0, done.stderr)
        for path in (self.folder / "out").rglob("*.csv"):
            self.assertIsNone(re.search(r"\bnan\b", path.read_text()), path)


if __name__ == "__main__":
    unittest.main()
