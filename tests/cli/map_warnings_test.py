# SPDX-License-Identifier: BSD-3-Clause
"""Warnings of `trivet map`: as text, in JSON and in the result folder of a run."""
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
inertia = {about = "center_of_mass", xx = 2, yy = 2, zz = 2.5}
[elements.s]
type = "bushing"
on = "m"
at = [0, 0, 0]
translation = [1e6, 1e6, 1e6]
rotation = [2e4, 2e4, 2e4]
damping = {proportional = 1e-4}
[excitations.p]
type = "harmonic"
on = "m"
at = [0, 0, 0]
force = [100, 0, 0]
[analyses]
modes = {}
[analyses.map]
x = {parameter = "elements.s.scale", from = 0.5, to = 1.5, points = 4}
y = {parameter = "elements.s.damping.proportional", from = 1e-5, to = 1e-3, points = 3}
limits = {"m.x" = "1 mm"}
"""


class MapWarnings(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.project = self.folder / "body.toml"

    def map(self, text, *arguments):
        self.project.write_text(text)
        done = subprocess.run(
            [TRIVET, "map", str(self.project), *arguments], capture_output=True, text=True, timeout=HANGS_AFTER
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def warned(self, text, words):
        """The warning must be in text, JSON and a run."""
        done = self.map(text)
        self.assertIn(words, done.stderr)
        found = json.loads(self.map(text, "--json").stdout)["warnings"]
        self.assertTrue(any(words in json.dumps(w, ensure_ascii=False) for w in found), found)
        run = subprocess.run(
            [TRIVET, "run", str(self.project), "-o", str(self.folder / "out")],
            capture_output=True,
            text=True,
            timeout=HANGS_AFTER,
        )
        self.assertIn(words, run.stdout)
        self.assertIn(words, (self.folder / "out" / "report.html").read_text())
        return done

    def test_a_range_in_another_unit_than_the_model(self):
        text = BODY.replace(
            '"elements.s.scale", from = 0.5, to = 1.5', '"elements.s.translation.x", from = 0.5, to = 1.5'
        )
        self.warned(text, "the model itself has 1e+06, far from all designs of the map")
        near = BODY.replace(
            '"elements.s.scale", from = 0.5, to = 1.5', '"elements.s.translation.x", from = 5e7, to = 2e8'
        )
        self.assertNotIn("far from all designs", self.map(near).stderr)

    def test_a_sound_map_has_no_warning(self):
        self.assertEqual(self.map(BODY).stderr, "")

    def test_a_case_that_contradicts_the_designs_around_it(self):
        strip = BODY.replace(
            'limits = {"m.x" = "1 mm"}', 'limits = {"m.x" = "1 mm"}\nband = ["99.9 rad/s", "100.1 rad/s"]'
        )
        done = self.warned(strip, "violates a rule that all designs of the grid around it meet")
        self.assertIn("use more points, or narrower ranges around it", done.stderr)
        self.assertIn("unreliable: a case is feasible where all designs around it are not, or the reverse", done.stdout)
        self.assertNotIn("contradict", self.map(strip, "--points", "5x3").stdout)

    def test_results_that_do_not_move(self):
        still = BODY.replace('limits = {"m.x" = "1 mm"}', 'limits = {"m.y" = "1 mm"}\nno_peak = ["m.ry", "m.x"]')
        done = self.warned(still, "is zero except for round-off")
        self.assertTrue("map: m.y:" in done.stderr and "map: m.ry:" in done.stderr)
        self.assertNotIn("map: m.x:", done.stderr)

    def test_forces_that_move_nothing(self):
        self.warned(BODY.replace("force = [100, 0, 0]", "force = [0, 0, 0]"), "all results are 0")

    def test_warnings_of_the_model_itself(self):
        guided = BODY.replace("mass = 100", 'mass = 100\nfree = ["x"]').replace(
            '"m.x" = "1 mm"', '"ground.force.x" = "1 kN"'
        )
        self.warned(guided, "without the forces of constraints")

    def test_an_axis_that_changes_nothing(self):
        self.warned(
            BODY.replace(
                'x = {parameter = "elements.s.scale", from = 0.5, to = 1.5',
                'x = {parameter = "excitations.p.phase", from = 0, to = 3',
            ),
            "no result changes along this axis",
        )

    def test_a_moving_foundation_that_drifts_off_at_rest(self):
        moved = BODY.replace(
            'type = "harmonic"\non = "m"\nat = [0, 0, 0]\nforce = [100, 0, 0]',
            'type = "base"\ntranslation = ["1 mm/s", 0, 0]\nquantity = "velocity"',
        )
        done = self.warned(moved, "has no bounded displacement at ω = 0")
        self.assertIn("start the band of the map above 0", done.stderr)
        self.assertIn("m.x is unbounded at 0 Hz, allowed 1 mm 0-p", self.map(moved, "--full").stdout)
        self.assertNotIn(
            "bounded", self.map(moved.replace("[analyses.map]", '[analyses.map]\nband = ["1 Hz", "60 Hz"]')).stderr
        )

    def test_cases_with_rules_of_their_own(self):
        strict = BODY + '[cases.strict]\nanalyses.map.limits = {"m.x" = "1 um"}\n[cases.same]\nelements.s.scale = 1\n'
        text = self.map(strict).stdout
        self.assertIn('judged by the rules of this map; its own map has other rules: map --case "strict"', text)
        self.assertEqual(text.count("has other rules"), 1)
        marks = {m["case"]: m["has_own_rules"] for m in json.loads(self.map(strict, "--json").stdout)["marks"]}
        self.assertEqual(marks, {"": False, "strict": True, "same": False})


if __name__ == "__main__":
    unittest.main()
