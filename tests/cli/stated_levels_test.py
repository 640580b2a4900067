# SPDX-License-Identifier: BSD-3-Clause
"""A limit has one level in all words of a run: verdict, best design, map, selection, box and messages."""
import re
import unittest

from trivet_test import SOURCE, InTemporaryFolder, result_of, trivet

MACHINE = (
    (SOURCE / "tests/data/projects/driven_mass.toml").read_text()
    + """[requirements]
limits = {"m.z" = "LIMIT"}
[analyses]
response = {band = ["1 Hz", "30 Hz"], of = ["m.z"], quantity = "velocity"}
optimize = {}
map = {x = {parameter = "elements.s.scale", from = 0.5, to = 2, points = 5}, y = {parameter = "bodies.m.mass", from = 20, to = 80, points = 5}}
[parameters.p]
path = "elements.s.scale"
from = 0.5
to = 2
[tolerances.t]
path = "elements.s.scale"
half_width = "10 %"
"""
)
# The design may meet both requirements, but not with machines that are 10 % softer or stiffer.
TOLERATED = """trivet = 1
gravity = [0, 0, -9.80665]
[bodies.m]
mass = 40
free = ["z"]
[elements.s]
type = "bushing"
on = "m"
at = [0, 0, 0]
translation = [1, 1, 2.5e5]
[requirements]
static = {"m.z" = "1.7 mm"}
natural_frequencies = {avoid = [["12.6 Hz", "30 Hz"]]}
[analyses]
sample = {designs = 2000}
optimize = {yield = "99 %"}
[parameters.p]
path = "elements.s.scale"
from = 0.5
to = 2
[tolerances.t]
path = "elements.s.scale"
half_width = "10 %"
"""
IN_BAND = '{limit = "2.8 mm/s rms", band = ["5 Hz", "25 Hz"]}'
BOUND = re.compile(r"m\.z ≤ ([^ ]+ [^ ]+( rms| 0-p| p-p)?)")


class StatedLevels(InTemporaryFolder):
    def bounds(self, text, *arguments):
        done = trivet(arguments[0], self.file(text), *arguments[1:])
        return {found[0] for found in BOUND.findall(done.stdout + done.stderr)}

    def test_a_limit_has_the_level_of_the_file_everywhere(self):
        text = MACHINE.replace("LIMIT", "2.8 mm/s rms")
        for command in ("verdict", "optimize", "box", "sample", "map"):
            with self.subTest(command=command):
                self.assertEqual(self.bounds(text, command), {"2.8 mm/s rms"})
        self.assertEqual(self.bounds(text, "run", "-o", self.folder / "out", "--full"), {"2.8 mm/s rms"})

    def test_peak_to_peak_and_the_level_of_the_display(self):
        text = MACHINE.replace("LIMIT", "8 mm/s p-p")
        self.assertEqual(self.bounds(text, "optimize"), {"8 mm/s p-p"})
        shown = text + '[display]\nlevel = "amplitude"\n'
        self.assertEqual(self.bounds(shown, "optimize"), {"4 mm/s 0-p"})
        self.assertEqual(self.bounds(shown, "verdict"), {"4 mm/s 0-p"})

    def test_values_of_a_map_have_the_level_of_their_limit(self):
        path = self.file(MACHINE.replace('"LIMIT"', IN_BAND))
        bound = r"m\.z ≤ 2\.8 mm/s rms in 5 … 25 Hz"
        (value,) = re.findall(bound + " +([0-9.]+) mm/s rms", trivet("verdict", path).stdout)
        self.assertIn(value, re.findall(bound + ": ([0-9.]+) mm/s rms", trivet("map", path, "--full").stdout))

    def test_data_stay_zero_to_peak(self):
        text = MACHINE.replace("LIMIT", "2.8 mm/s rms")
        (case,) = result_of("verdict", self.file(text))["cases"]
        self.assertEqual(case["requirements"][0]["requirement"], "m.z ≤ 3.96 mm/s 0-p")
        self.assertEqual(case["requirements"][0]["level"], "0-p")
        for level in ("rms", "amplitude", "peak_to_peak"):
            shown = MACHINE.replace('"LIMIT"', IN_BAND) + f'[display]\nlevel = "{level}"\n'
            self.assertEqual(self.bounds(shown, "map", "--csv"), {"3.96 mm/s 0-p"})
            (rule,) = result_of("map", self.file(shown))["rules"]
            self.assertEqual(rule["words"], "m.z ≤ 3.96 mm/s 0-p in 5 … 25 Hz")


class BestDesign(InTemporaryFolder):
    def test_of_a_search_that_does_not_suffice_is_not_the_machine(self):
        out = self.folder / "out"
        done = trivet("run", self.file(MACHINE.replace("LIMIT", "2.8 mm/s rms")), "-o", out)
        self.assertIn("even the best design that was found does not meet every requirement: Least margin", done.stdout)
        report = (out / "report.html").read_text()
        self.assertIn("Even the best design that was found does not meet", report)
        self.assertNotIn("best design of the search", report)

    def test_within_tolerances_its_machines_are_judged_not_itself(self):
        out = self.folder / "out"
        done = trivet("run", self.file(TOLERATED), "-o", out)
        self.assertIn("2 of 2 met", done.stdout)  # of the machine
        self.assertRegex(
            done.stdout, r"VIOLATED: 1 of 1 best design\n  machines that meet every requirement: [^\n]*, NOT the wanted"
        )
        report = (out / "report.html").read_text()
        self.assertRegex(
            report, "<li><a [^>]*><strong>Machines that meet every requirement: [^<]*, NOT the wanted 99 %<"
        )
        for said in (done.stdout, report):
            self.assertNotIn("best design that was found", said)
        worst = TOLERATED.replace('yield = "99 %"', "worst_case = true")
        done = trivet("run", self.file(worst), "-o", self.folder / "worst")
        self.assertIn(
            "VIOLATED: 1 of 1 best design\n  the worst machines found within the tolerances do NOT meet", done.stdout
        )
        self.assertNotIn("best design that was found", done.stdout)

    def test_a_yield_needs_requirements(self):
        text = MACHINE.replace('[requirements]\nlimits = {"m.z" = "LIMIT"}\n', "")
        text = text.replace("optimize = {}", 'optimize = {yield = "99 %", minimize = ["m.z"]}')
        done = trivet("optimize", self.file(text))
        self.assertEqual(done.returncode, 2)
        self.assertIn("optimize: yield without requirements and limits", done.stderr)


if __name__ == "__main__":
    unittest.main()
