# SPDX-License-Identifier: BSD-3-Clause
"""Sizes, ranges, names and messages: what a user sees of a project that is too large or too strange (docs/limits.md)."""
import json
import pathlib
import re
import subprocess
import unittest

from trivet_test import PAPER, SOURCE, TRIVET, InTemporaryFolder, answer, trivet

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
    def test_one_mistake_in_thousands_of_places_is_told_a_hundred_times(self):
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

    def test_control_characters_of_the_command_line_do_not_reach_the_terminal(self):
        for arguments in (("modes", PAPER, "--case", "\x1b[31mred"), ("element", PAPER, "a\x07b"), ("check", PAPER, "--set", "bodies.\x1b[2J=1"), ("check", self.folder / "\x1b[2J.toml")):
            done = trivet(*arguments)
            self.assertEqual(done.returncode, 2, arguments)
            self.assertNotRegex(done.stderr, r"[\x00-\x08\x0b-\x1f\x7f]")

    def test_a_file_name_that_is_no_utf8_is_no_fault_of_json(self):
        path = bytes(self.folder) + b"/M\xfcller.toml"
        pathlib.Path(path.decode("utf-8", "surrogateescape")).write_text(BODY + "mass = 1\n")
        done = subprocess.run([TRIVET.encode(), b"check", path, b"--json"], capture_output=True, timeout=60)
        self.assertEqual(done.returncode, 2)
        self.assertFalse(json.loads(done.stdout.decode())["ok"])
        self.assertIn(b"\\xfc", done.stderr)


class Frequencies(InTemporaryFolder):
    def test_units_are_on_all_values_or_on_none(self):
        for option, text in (("--at", "1,5 Hz"), ("--at", "0,5 Hz"), ("--at", "1 Hz,5"), ("--at", "1,2.7,15 Hz"), ("--band", "10,50 Hz")):
            done = trivet("response", PAPER, option, text)
            self.assertEqual(done.returncode, 2, text)
            self.assertIn("some values have a unit and some have none", done.stderr)
            self.assertIn('"1 Hz,5 Hz"', done.stderr)
        self.assertEqual(trivet("suspension", PAPER, "--excitation", "25,50Hz").returncode, 2)

    def test_lists_that_are_clear_are_taken(self):
        self.assertEqual(answer("response", PAPER, "--at", "1,5")["angular_frequency"], [1, 5])
        self.assertAlmostEqual(answer("response", PAPER, "--at", "1.5 Hz")["angular_frequency"][0], 9.42477796076938, places=12)
        self.assertEqual(trivet("response", PAPER, "--band", "0,5 Hz").returncode, 0)  # 0 is 0 in every unit, and a band has two ends

    def test_a_band_has_two_ends(self):
        for band in ("0,1e-300", "1,1.0000000000000002", "0,1e13"):
            done = trivet("response", PAPER, "--band", band)
            self.assertEqual(done.returncode, 2, band)
            self.assertEqual(len(done.stderr.splitlines()), 1)


class Sizes(Refused):
    def test_two_hundred_free_bodies(self):
        text = "trivet = 1\n" + "".join(f'[bodies.b{i}]\nmass = 1\ninertia = {{about = "pole", xx = 1, yy = 1, zz = 1}}\n' for i in range(200))
        self.refused("1200 free coordinates", "at most 600", text=text, command="run")

    def test_twenty_thousand_answers(self):
        points = "".join(f"points.p{i} = [{i}e-4, 0, 0]\n" for i in range(4000))
        names = ", ".join(f'"b.p{i}.{c}"' for i in range(4000) for c in "xyzxy")
        self.refused("20000 answers", "at most 2000 are named", text=BODY + points + mount("m") + FORCE + f"[analyses]\nresponse = {{of = [{names}]}}\n")
        points = "".join(f"points.p{i} = [{i}e-4, 0, 0]\n" for i in range(400))
        names = ", ".join(f'"b.p{i}"' for i in range(400))
        self.refused("2400 curves", "at most 2000", text=BODY + points + mount("m") + FORCE + f"[analyses]\npeaks = {{of = [{names}]}}\n")

    def test_five_hundred_coherent_inputs(self):
        text = BODY + mount("m") + "".join(
            f'[excitations.e{i}]\ntype = "random"\non = "b"\nat = [{i}e-3, 0, 0]\nforce = [0, 0, 1]\npsd = {{flat = 1, band = ["1 Hz", "50 Hz"]}}\n'
            + (f'coherence = {{with = "e{i - 1}", value = 0.1}}\n' if i % 2 else "") for i in range(500))
        self.refused("250 random excitations with a coherence", "at most 100", text=text + "[analyses]\nrandom = {}\n")

    def test_a_thousand_cases_of_a_thousand_elements(self):
        text = BODY + "".join(mount(f"m{i}") for i in range(1000)) + "".join(f"[cases.c{i}]\nbodies.b.mass = {100 + i}\n" for i in range(1000))
        self.refused("1001000 bodies, elements and excitations", "at most 50000", text=text)

    def test_tables_that_are_too_long_or_too_wide(self):
        table = '[elements.t]\ntype = "table"\non = "b"\nat = [0, 0, 0]\nfrom_at = [0, 0, -0.1]\nfile = "t.csv"\n'
        rows = "frequency_hz,k_z,k_z_loss\n" + "".join(f"{1 + i * 1e-3:.3f},1e5,1e4\n" for i in range(20001))
        self.refused("more than 20000 rows", text=BODY + table, files=[("t.csv", rows)])
        self.refused("200000 columns", "at most 2000 columns", text=BODY + table, files=[("t.csv", ",".join(f"c{i}" for i in range(200000)) + "\n")])

    def test_peaks_of_a_large_system_are_refused_before_the_search(self):
        text = "trivet = 1\n" + "".join(f'[bodies.b{i}]\nmass = 1\nposition = [0, 0, {i}]\ninertia = {{about = "pole", xx = 1, yy = 1, zz = 1}}\n' for i in range(60))
        text += "".join(mount(f"m{i}", on=f"b{i}", more=f'from = "b{i - 1}"' if i else "") for i in range(60)) + FORCE.replace('"b"', '"b0"')
        self.refused("hours of search", "name fewer answers in `of`", text=text + "[analyses]\npeaks = {}\n")
        done = trivet("peaks", self.file(text))  # asked by the command line alone
        self.assertEqual(done.returncode, 1)
        self.assertIn("hours of search", done.stderr)


class Extremes(InTemporaryFolder):
    def test_random_answers_beside_a_stiffness_of_another_world(self):
        example = (SOURCE / "examples/optical_table/table.toml").read_text()
        for file in (SOURCE / "examples/optical_table").glob("*.csv"):
            (self.folder / file.name).write_text(file.read_text())
        done = trivet("random", self.file(example.replace("translation = [14000, 14000, 9500]", "translation = [1.4e15, 14000, 9500]", 1)))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("too far apart for partial fractions", done.stdout)


    def test_six_mounts_with_a_fractional_law(self):
        law = "damping = {fractional_zener = {ratio = 2, time = 1e-4, order = 0.5}}"
        text = BODY + "".join(mount(f"m{i}").replace("damping = {loss_factor = 0.1}", law) for i in range(6)) + FORCE
        done = trivet("peaks", self.file(text + '[analyses]\npeaks = {of = ["b.z"]}\n'))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("b.z", done.stdout)

    def test_a_motion_in_space_under_an_accelerated_ground_has_no_largest_amplitude(self):
        base = '[excitations.floor]\ntype = "base"\nquantity = "acceleration"\ntranslation = [0, 0, 1]\n[analyses]\nresponse = {of = ["b"], band = [5, 500]}\n[limits]\n"b.z" = 1\n"b.relative.z" = 1\n'
        done = trivet("response", self.file(BODY + mount("m") + base))
        rows = {line.split()[0]: line.split() for line in done.stdout.splitlines() if line.strip().startswith("b.") and "kept" in line}
        self.assertEqual(rows["b.z"][4], "∞", done.stdout[-600:])
        self.assertEqual(rows["b.relative.z"][4], rows["b.relative.z"][2])


class Foundations(InTemporaryFolder):
    def test_a_mode_of_a_foundation_that_moves_no_mount_has_no_nan(self):
        text = BODY + mount("m", more='foundation = "deck"') + FORCE + '[foundations.deck]\ntype = "modal"\nmodes = [{frequency = "12 Hz", modal_mass = 800, damping = 0.02, shapes = {m = [0, 0, 0]}}]\n'
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
