# SPDX-License-Identifier: BSD-3-Clause
"""Messages of `trivet map` for a file without a map, and the digits of numbers in its texts."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

from trivet_test import HANGS_AFTER

TRIVET = os.environ["TRIVET"]

BODY = """
trivet = 1
[bodies.m]
mass = 100
free = ["z"]
[elements.s]
type = "bushing"
on = "m"
at = [0, 0, 0]
translation = [1e6, 1e6, 1e6]
scale = 1
damping = {proportional = 1e-4}
[excitations.p]
type = "harmonic"
on = "m"
at = [0, 0, 0]
force = [0, 0, 100]
[analyses]
modes = {}
[analyses.map]
x = {parameter = "elements.s.scale", from = 0.5, to = 1.5, points = 3}
y = {parameter = "elements.s.damping.proportional", from = 1e-5, to = 1e-3, points = 3}
limits = {"m.z" = "1 mm"}
"""
SCALE = 'parameter = "elements.s.scale", from = 0.5, to = 1.5'
DAMPING = 'parameter = "elements.s.damping.proportional", from = 1e-5, to = 1e-3'


class MapMessages(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.project = pathlib.Path(folder.name) / "body.toml"

    def map(self, text, *arguments, code=0):
        self.project.write_text(text)
        done = subprocess.run(
            [TRIVET, "map", str(self.project), *arguments], capture_output=True, text=True, timeout=HANGS_AFTER
        )
        self.assertEqual(done.returncode, code, done.stderr)
        return done.stderr if code else done.stdout

    def test_errors_of_both_axes_are_reported_at_once(self):
        misspelt = self.map(
            BODY.replace(SCALE, 'parameter = "elements.q.scale", from = 1, to = 2').replace(
                DAMPING, 'parameter = "bodies.m.mas", from = 1, to = 2'
            ),
            code=2,
        )
        self.assertIn('no "q" there', misspelt)
        self.assertIn("bodies.m.mas: unknown key", misspelt)
        units = self.map(
            BODY.replace(SCALE, 'parameter = "bodies.m.mass", from = "1 s", to = "2 s"').replace(
                DAMPING, 'parameter = "elements.s.damping.proportional", from = "1 kg", to = "2 kg"'
            ),
            code=2,
        )
        self.assertIn('bodies.m.mass: "1 s"', units)
        self.assertIn('elements.s.damping.proportional: "1 kg"', units)
        both = self.map(
            BODY.replace(SCALE, SCALE.replace(".scale", ".scal") + ', spacing = "log"').replace(
                DAMPING, 'parameter = "bodies.m.mas", from = -1, to = "5 kg"'
            ),
            code=2,
        )
        self.assertIn("elements.s.scal: unknown key", both)
        self.assertIn("bodies.m.mas: unknown key", both)

    def test_a_misspelt_limit_has_a_suggestion(self):
        self.assertIn('did you mean "m.z"?', self.map(BODY.replace('"m.z" =', '"m.zz" ='), code=2))

    def test_one_problem_has_one_message(self):
        self.assertEqual(self.map(BODY, "--set", "elements.s.scale=", code=2).count("error:"), 1)

    def test_an_empty_list_of_excitations_is_an_error(self):
        self.assertIn("at least one excitation is expected", self.map(BODY + "excitations = []\n", code=2))

    def test_numbers_have_enough_digits_to_differ(self):
        self.assertRegex(
            self.map(BODY.replace('"1 mm"', '"0.0999999 mm"') + 'band = [0, 1e-9]\n', "--full"),
            "m.z reaches 100 µm 0-p at 0 Hz, allowed 99.9999 µm 0-p",
        )
        narrow = self.map(
            BODY.replace("to = 1.5", "to = 0.5000000001").replace(
                'limits = {', 'band = ["99.9999 rad/s", "100.0001 rad/s"]\nlimits = {'
            )
        )
        self.assertIn("0.5 … 0.5000000001", narrow)
        self.assertIn("15.9154784 … 15.9155102 Hz", narrow)

    def test_bare_numbers_have_their_si_unit_everywhere(self):
        self.assertRegex(self.map(BODY), r"base model +1 +0.0001 s ")
        self.assertEqual(json.loads(self.map(BODY, "--json"))["y"]["unit"], "s")
        self.assertIn("elements.s.damping.proportional [s],margin", self.map(BODY, "--csv"))


if __name__ == "__main__":
    unittest.main()
