# SPDX-License-Identifier: BSD-3-Clause
"""--strict: an exit code for results that need action; the result itself stays the same."""
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

from trivet_test import HANGS_AFTER

TRIVET = os.environ["TRIVET"]
EXAMPLES = pathlib.Path(os.environ["TRIVET_SOURCE"]) / "examples"
DONE, NOT_COMPUTED, WRONG_INPUT, OVER_A_LIMIT, WITH_WARNINGS = 0, 1, 2, 3, 4

MASS = """trivet = 1
[bodies.mass]
mass = 10
free = ["z"]
[elements.spring]
type = "three_springs"
on = "mass"
at = [0, 0, 0]
translation = [0, 0, 4000]
damping = {proportional = 0.005}
[excitations.push]
type = "harmonic"
on = "mass"
at = [0, 0, 0]
force = [0, 0, 4]
[analyses]
response = {of = ["mass.z"], band = [0, "40 rad/s"]}
"""


def trivet(*arguments):
    return subprocess.run([TRIVET, *map(str, arguments)], capture_output=True, text=True, timeout=HANGS_AFTER)


class Strictness(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def file(self, text):
        path = pathlib.Path(self.folder.name) / "model.toml"
        path.write_text(MASS + text)
        return path

    def code(self, *arguments):
        return trivet(*arguments).returncode

    def test_an_exceeded_limit_is_3_and_the_result_is_written(self):
        path, output = self.file('[limits]\n"mass.z" = "2 mm"\n'), pathlib.Path(self.folder.name) / "results"
        self.assertEqual(self.code("run", path, "-o", output), DONE)
        strict = trivet("run", path, "-o", output, "--strict")
        self.assertEqual(strict.returncode, OVER_A_LIMIT)
        self.assertIn("1 limit violated", strict.stderr)
        self.assertTrue((output / "results.json").exists())
        self.assertIn("Report:", strict.stdout)
        for arguments in (("response", path), ("response", path, "--json"), ("response", path, "--csv")):
            plain, strict = trivet(*arguments), trivet(*arguments, "--strict")
            self.assertEqual((plain.returncode, strict.returncode), (DONE, OVER_A_LIMIT))
            self.assertEqual(plain.stdout, strict.stdout)

    def test_a_limit_that_is_met_is_0(self):
        path = self.file('[limits]\n"mass.z" = "20 mm"\n')
        self.assertEqual(self.code("run", path, "-o", pathlib.Path(self.folder.name) / "results", "--strict"), DONE)
        self.assertEqual(self.code("check", path, "--strict"), DONE)

    def test_an_exceeded_limit_line_is_3(self):
        path = self.file(
            '[limit_lines.severity]\nof = "mass.z"\nquantity = "displacement"\nlevel = "zero_to_peak"\nrows = [[1, 1e-3], [6, 1e-3]]\n'
        )
        self.assertEqual(
            self.code("run", path, "-o", pathlib.Path(self.folder.name) / "results", "--strict"), OVER_A_LIMIT
        )

    def test_a_required_limit_line_is_judged_in_its_band_alone_in_every_case(self):
        """It is exceeded at the resonance, outside of the band of the requirements, and met in that band."""
        path = self.file(
            '[limit_lines.severity]\nof = "mass.z"\nquantity = "displacement"\nlevel = "zero_to_peak"\n'
            "rows = [[1, 1e-3], [6, 1e-3]]\n"
            '[requirements]\nband = ["5.5 Hz", "6 Hz"]\nlimit_lines = ["severity"]\nhold_in = [""]\n'
            "[cases.soft]\nelements.spring.scale = 0.9\n"
        )
        done = trivet("run", path, "-o", pathlib.Path(self.folder.name) / "results", "--strict")
        self.assertEqual(done.returncode, DONE, done.stdout + done.stderr)
        self.assertTrue(done.stdout.startswith("MET: 1 of 1 requirement\n"), done.stdout)
        self.assertRegex(done.stdout, r"(?m)^  soft +1 of 1 met ")
        page = (pathlib.Path(self.folder.name) / "results" / "report.html").read_text()
        self.assertIn("above the line; judged as a requirement", page)
        self.assertNotIn("VIOLATED", re.sub("<script.*?</script>", "", page, flags=re.DOTALL))

    def test_warnings_alone_are_4(self):
        path = self.file("")
        warned = ("--set", "elements.spring.damping={loss_factor=8}")
        for command in ("check", "modes", "roots", "peaks", "response"):
            self.assertEqual(self.code(command, path, *warned), DONE, command)
            self.assertEqual(self.code(command, path, *warned, "--strict"), WITH_WARNINGS, command)

    def test_a_map_without_a_feasible_design_is_3(self):
        path = self.file(
            'map = {x = {parameter = "elements.spring.scale", from = 0.9, to = 1.1}, y = {parameter = "elements.spring.damping.proportional", from = 0.004, to = 0.006}, limits = {"mass.z" = "1 nm"}}\n'
        )
        self.assertEqual(self.code("map", path, "--points", 3), DONE)
        self.assertEqual(self.code("map", path, "--points", 3, "--strict"), OVER_A_LIMIT)

    def test_worse_codes_come_first(self):
        path = self.file('[limits]\n"mass.z" = "2 mm"\n')
        self.assertEqual(self.code("response", path, "--strict", "--case", "none"), WRONG_INPUT)
        path.write_text(
            path.read_text().replace(
                "[limits]", 'earthquake = {direction = "z", rows = [[1e-5, 1], [2e-5, 1]]}\n[limits]'
            )
        )
        refused = trivet("run", path, "--strict", "-o", pathlib.Path(self.folder.name) / "results")
        self.assertEqual(refused.returncode, NOT_COMPUTED, refused.stderr)

    def test_help_names_the_codes(self):
        self.assertIn("Exit codes", trivet("--help").stdout)
        self.assertIn("exit code 3", " ".join(trivet("run", "--help").stdout.split()))


if __name__ == "__main__":
    unittest.main()
