# SPDX-License-Identifier: BSD-3-Clause
"""Constraints are fixed in space: a ground that moves along a constrained direction causes a warning, and the results
agree with the warning."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

from trivet_test import HANGS_AFTER

TRIVET = os.environ["TRIVET"]

MODEL = """trivet = 1
[bodies.machine]
mass = 100
position = [0, 0, 0.5]
free = ["z"]
{turned}
[elements.mount]
type = "three_springs"
on = "machine"
at = [0, 0, 0]
translation = [1e6, 1e6, 4e5]
damping = {{proportional = 1e-3}}
[excitations.floor]
type = "base"
{motion}
[analyses]
response = {{of = ["machine", "mount"], at = [1e-3, 30]}}
"""


class GuidedGround(unittest.TestCase):
    def warnings(self, motion, turned="", command="response", extra=""):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "model.toml"
            path.write_text(MODEL.format(motion=motion, turned=turned) + extra)
            done = subprocess.run(
                [TRIVET, command, path, "--json"], capture_output=True, text=True, timeout=HANGS_AFTER
            )
            self.assertEqual(done.returncode, 0, done.stderr)
            self.result = json.loads(done.stdout)
            return [
                w
                for w in self.result.get("warnings", self.result.get("problems"))
                if "constraints are fixed in space" in json.dumps(w)
            ]

    def test_a_ground_that_moves_along_a_guide_has_a_warning(self):
        found = self.warnings('translation = ["1 mm", 0, "1 mm"]')
        self.assertEqual(len(found), 1)
        self.assertIn("is constrained in x", json.dumps(found))
        self.assertIn("floor", json.dumps(found))
        force = {one["name"]: one["complex"][0] for one in self.result["results"]}["mount.force.x"]
        self.assertAlmostEqual(abs(complex(*force)), 1e6 * 1e-3, delta=1e-3)  # the floor moves under the body

    def test_a_ground_that_the_body_follows_has_no_warning(self):
        self.assertEqual(self.warnings('translation = [0, 0, "1 mm"]'), [])

    def test_a_turning_floor_moves_the_body_at_its_place_too(self):
        self.assertIn("is constrained in x, ry", json.dumps(self.warnings("rotation = [0, 1e-3, 0]")))
        self.assertIn("is constrained in ry", json.dumps(self.warnings("rotation = [0, 1e-3, 0]\nat = [0, 0, 0.5]")))

    def test_directions_are_those_of_the_body(self):
        turned = 'orientation = {axis = "y", angle = "90 deg"}'  # its z is the x of the ground
        self.assertEqual(self.warnings('translation = ["1 mm", 0, 0]', turned), [])
        self.assertIn("is constrained in x", json.dumps(self.warnings('translation = [0, 0, "1 mm"]', turned)))

    def test_single_supports_do_not_move_the_guides(self):
        self.assertEqual(self.warnings('elements = ["mount"]\ntranslation = ["1 mm", 0, 0]'), [])

    def test_every_kind_of_motion_is_checked(self):
        noise = 'translation = [0, 0, "1 mm"]\n[excitations.noise]\ntype = "random"\nbase = true\nquantity = "acceleration"\ntranslation = [0, 1, 0]\npsd = {flat = 1, band = ["1 Hz", "10 Hz"]}\n'
        self.assertIn("noise", json.dumps(self.warnings(noise, command="check")))
        shock = 'translation = [0, 0, "1 mm"]\n[excitations.shock]\ntype = "time"\nbase = true\nquantity = "acceleration"\ntranslation = [1, 0, 0]\nhistory = {half_sine = {amplitude = "5 g", duration = "11 ms"}}\n'
        self.assertIn("shock", json.dumps(self.warnings(shock, command="check")))
        self.assertEqual(
            len(
                self.warnings(
                    'translation = [0, 0, "1 mm"]',
                    command="transmissibility",
                    extra='transmissibility = {base = "x", of = ["machine"]}\n',
                )
            ),
            1,
        )
        self.assertEqual(
            self.warnings(
                'translation = [0, 0, "1 mm"]',
                command="transmissibility",
                extra='transmissibility = {base = "z", of = ["machine"]}\n',
            ),
            [],
        )


if __name__ == "__main__":
    unittest.main()
