# SPDX-License-Identifier: BSD-3-Clause
"""A single point in millimetres, and limits at a speed in millimetres, on a sound machine."""
from trivet_test import InTemporaryFolder, trivet

MACHINE = """trivet = 1
[bodies.machine]
mass = "250 kg"
center_of_mass = [0.02, 0, 0.18]
inertia = {about = "center_of_mass", xx = 8.1, yy = 12.4, zz = 13.0}
points = {seat = [0.3, 0.2, 0.4], left = [0, 0.3, 0.2], right = [0, -0.3, 0.2], end = [-0.95, 0, 0.2]}
[element_types.mount]
type = "bushing"
translation = ["180 N/mm", "180 N/mm", "420 N/mm"]
damping = {loss_factor = 0.08}
[tables.elements]
rows = [
  {name = "a", type = "mount", on = "machine", at = [0.4, 0.25, 0]},
  {name = "b", type = "mount", on = "machine", at = [0.4, -0.25, 0]},
  {name = "c", type = "mount", on = "machine", at = [-0.4, 0.25, 0]},
  {name = "d", type = "mount", on = "machine", at = [-0.4, -0.25, 0]},
]
[excitations.rotor]
type = "unbalance"
on = "machine"
at = [0, 0, 0.2]
axis = "x"
mass_eccentricity = 0.001
[operation]
speeds = ["980 rpm"]
limits = {"machine.seat.z" = "2.8 mm/s rms", "machine.z" = "1 mm"}
"""


class PlaceSlips(InTemporaryFolder):
    def warnings(self, old="", new=""):
        return trivet("check", self.file(MACHINE.replace(old, new))).stderr

    def test_a_sound_machine_has_no_warning(self):
        self.assertEqual(self.warnings(), "")

    def test_a_single_far_point_is_named(self):
        said = self.warnings("-0.95", "-950")
        self.assertIn('bodies.machine.points.end: 950.02 m from the centre of mass; suspicion "points"', said)
        self.assertIn("950 mm are 0.95 m", said)
        self.assertIn('accept = {"points" = "reason"} in [bodies.machine]', said)
        self.assertEqual(said.count("warning"), 1)
        accepted = 'accept = {"points" = "a mirror on a hill"}\nmass = "250 kg"'
        text = MACHINE.replace("-0.95", "-950").replace('mass = "250 kg"', accepted)
        self.assertEqual(trivet("check", self.file(text)).stderr, "")

    def test_a_single_far_force_is_named(self):
        self.assertIn("excitations.rotor.at: 199.8", self.warnings("at = [0, 0, 0.2]\naxis", "at = [0, 0, 200]\naxis"))

    def test_a_far_mount_is_named(self):
        self.assertIn('suspicion "places"', self.warnings("at = [-0.4, -0.25, 0]", "at = [-950, -0.25, 0]"))

    def test_limits_at_a_speed_are_judged_too(self):
        for limit, words in (('"28 m/s"', "28 m/s allowed for machine.z"), ('"5 m"', "5 m allowed for machine.z")):
            said = self.warnings('"1 mm"', limit)
            self.assertIn("operation.limits.machine.z: " + words, said)
            self.assertIn('accept = {"limit" = "reason"} in [operation]', said)

    def test_advice_on_a_limit_keeps_its_level(self):
        said = self.warnings('"1 mm"', '"28 m/s rms"')
        self.assertIn("operation.limits.machine.z: 28 m/s rms allowed for machine.z", said)
        self.assertIn('write "28 mm/s rms"', said)


if __name__ == "__main__":
    import unittest

    unittest.main()
