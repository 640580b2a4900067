# SPDX-License-Identifier: BSD-3-Clause
"""What `trivet run` prints: first what is wrong, then one line per case, each warning once, all tables only with --full."""
import math
import os
import re
import unittest

from trivet_test import SOURCE, InTemporaryFolder, trivet

MACHINE = """trivet = 1
[bodies.machine]
mass = 4
free = ["z"]
[elements.spring]
type = "bushing"
on = "machine"
at = [0, 0, 0]
translation = [900, 900, 900]
damping = {proportional = 0.05}
[excitations.force]
type = "harmonic"
on = "machine"
at = [0, 0, 0]
force = [0, 0, 18]
[analyses]
modes = {}
peaks = {}
response = {band = ["0 Hz", "6 Hz"]}
"""
# ω0 = 15 rad/s, ζ = 0.375: the largest amplitude is (18/900)/(2ζ√(1 − ζ²)) = 28.766 mm at 12.7 rad/s = 2.024 Hz.
LIMITS = '[requirements]\nlimits = {"machine.z" = "12 mm"}\ndamping_ratio = 0.1\nhold_in = ["", "soft"]\n'
SOFT = "[cases.soft]\nelements.spring.scale = 0.25\n"
WIDEST = 100


class RunSummary(InTemporaryFolder):
    def summary(self, text, *options, code=0):
        done = trivet("run", self.file(text), "-o", self.folder / "out", *options)
        self.assertEqual(done.returncode, code, done.stderr)
        return done.stdout

    def test_violated_requirements_come_first_with_value_bound_and_place(self):
        text = self.summary(MACHINE + LIMITS + SOFT)
        first, words, soft, base = text.splitlines()[:4]
        self.assertEqual(first, "VIOLATED: 2 of 4 requirements")
        self.assertEqual(words, "  machine.z ≤ 12 mm 0-p")
        self.assertRegex(soft, r"^ +soft +\S+ mm 0-p at \S+ Hz, margin 0\.\d+$")  # a softer machine is worse
        self.assertEqual(base, "      base model   28.77 mm 0-p at 2.024 Hz, margin 0.4172")

    def test_each_case_has_one_line(self):
        text = self.summary(MACHINE + LIMITS + SOFT)
        [line] = re.findall(r"(?m)^  base model .*", text)
        self.assertEqual(
            line.split(), "base model 1 of 2 VIOLATED none 2.387 28.77 mm 0-p machine.z at 2.024 Hz".split()
        )
        self.assertEqual(len(re.findall(r"(?m)^  soft ", text)), 1)
        self.assertLess(len(text.splitlines()), 20)

    def test_a_design_that_meets_everything_says_so_with_the_least_margin(self):
        text = self.summary(MACHINE + LIMITS.replace("12 mm", "1 m") + SOFT)
        self.assertTrue(text.startswith("MET: 4 of 4 requirements\n  least margin: "), text)
        self.assertNotIn("VIOLATED", text)

    def test_a_case_in_which_the_design_need_not_hold_is_no_violation(self):
        text = self.summary(MACHINE + LIMITS.replace('"12 mm"', '"29 mm"').replace('["", "soft"]', '[""]') + SOFT)
        self.assertTrue(text.startswith("MET: 2 of 2 requirements"), text)
        self.assertRegex(text, r"(?m)^  soft +1 of 2 violated, not required ")

    def test_the_rules_of_a_map_are_violated_only_where_the_design_has_to_hold(self):
        axes = '[analyses.map]\nx = {parameter = "elements.spring.scale", from = 0.2, to = 4, points = 5}\n'
        axes += 'y = {parameter = "elements.spring.damping.proportional", from = 0.01, to = 0.3, points = 5}\n'
        text = MACHINE + axes + LIMITS.replace('"12 mm"', '"29 mm"') + SOFT
        met = self.summary(text.replace('["", "soft"]', '[""]'), "--strict")
        self.assertTrue(met.startswith("MET: 2 of 2 requirements, 1 of 1 verdict of a map; violated in 1 case"), met)
        elsewhere = met[met.index("Violated in cases in which the requirements are not binding:") :].split("\n\n")[0]
        self.assertIn("  rules of the map: machine.z reaches ", elsewhere)

    def test_an_analysis_that_fails_is_named_before_the_cases(self):
        free = 'gravity = [0, 0, -9.81]\n' + MACHINE.replace("[900, 900, 900]", "[900, 900, 0]")
        text = self.summary(free.replace("peaks = {}", "static = {}"), code=1)
        self.assertRegex(text, r"\A(VIOLATED.*\n(  .*\n)*\n)?NOT COMPUTED: static: ")
        self.assertLess(text.index("NOT COMPUTED"), text.index("  case "))
        self.assertEqual(text.count("NOT COMPUTED"), 1)

    def test_the_same_warning_of_several_cases_is_listed_once(self):
        idle = '[bodies.idle]\nmass = 1\nfree = ["z"]\n'  # no element holds it
        text = self.summary(MACHINE + idle + SOFT)
        warnings = [line for line in text.splitlines() if "warning:" in line]
        self.assertTrue(warnings)
        self.assertEqual(len(warnings), len(set(warnings)))
        self.assertTrue(all(line.endswith("(all cases)") for line in warnings), warnings)

    def test_tables_are_printed_with_full_only(self):
        short, full = self.summary(MACHINE + SOFT), self.summary(MACHINE + SOFT, "--full")
        self.assertNotIn("Undamped modes", short)
        self.assertEqual(full.count("Undamped modes"), 2)
        end = short.index("Report: ")
        self.assertEqual(full[:end], short[:end])

    def test_a_file_without_requirements_is_not_judged(self):
        text = self.summary(MACHINE + SOFT)
        self.assertTrue(text.startswith("Not judged: the file has no requirements, limits, clearances or map.\n"), text)

    def test_the_largest_results_of_other_analyses_are_in_the_table(self):
        for example, words in (
            ("transport_shock/device", r"largest in time .*largest of the shock spectra\n.* m/s² 0-p .* at .* s "),
            ("optical_table/table", r"largest rms of random\n.* rms \S+"),
        ):
            done = trivet("run", SOURCE / f"examples/{example}.toml", "-o", self.folder / example.replace("/", "-"))
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertRegex(done.stdout, words)

    def test_the_farthest_motion_of_a_nonlinear_machine_has_its_level(self):
        done = trivet("run", SOURCE / "examples/isolator/hardening.toml", "-o", self.folder / "out")
        self.assertRegex(done.stdout, r"base model .* mm 0-p machine\.z at ")
        self.assertRegex(done.stdout, r"tangent stiffness 243\.7 kN/m along z at rest, at a deflection of -2\.85 mm")

    def test_equal_mounts_have_one_warning(self):
        done = trivet("run", SOURCE / "examples/track/bogie.toml", "-o", self.folder / "out")
        [warning] = re.findall("(?m)^.*massless, but its own.*$", done.stdout)
        self.assertIn("elements.front left, front right, rear left, rear right: ", warning)

    def test_a_limit_line_has_the_value_and_the_limit_where_they_are_nearest(self):
        done = trivet("run", SOURCE / "examples/genset/genset.toml", "-o", self.folder / "out")
        found = re.search(r"“vibration severity”: (\S+) mm/s rms of (\S+) mm/s rms, least margin (\S+) dB", done.stdout)
        self.assertIsNotNone(found, done.stdout)
        value, limit, level = map(float, found.groups())
        self.assertAlmostEqual(20 * math.log10(limit / value), level, delta=0.01)

    def test_units_are_those_of_display(self):
        text = self.summary(MACHINE + '[display]\nlength = "in"\nfrequency = "rpm"\n')
        self.assertRegex(text, r"modes \[rpm\]")
        self.assertRegex(text, r"1\.133 in 0-p machine\.z at 121\.\d+ rpm")

    def test_tables_of_the_examples_fit_on_a_screen(self):
        for example in ("paper/corrected", "skew_mounts/machine", "compressor/requirements", "track/bogie"):
            target = self.folder / example.replace("/", "-")
            screen = {**os.environ, "COLUMNS": str(WIDEST)}
            done = trivet("run", SOURCE / f"examples/{example}.toml", "-o", target, env=screen)
            self.assertIn(done.returncode, (0, 1), done.stderr)
            table = done.stdout[done.stdout.index("  case ") :].split("\n\n")[0]
            self.assertLessEqual(max(map(len, table.splitlines())), WIDEST, example)
            self.assertLess(len(done.stdout.splitlines()), 30, example)


if __name__ == "__main__":
    unittest.main()
