# SPDX-License-Identifier: BSD-3-Clause
"""Frequencies and speeds without a unit are read in rad/s, and say so once for each key."""
import json
import math

from trivet_test import EXAMPLES, InTemporaryFolder, trivet

MACHINE = """trivet = 1
[bodies.m]
mass = 40
free = ["z"]
[elements.s]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [0, 0, 36000]
damping = {translation = [0, 0, 120]}
[excitations.f]
type = "harmonic"
on = "m"
at = [0, 0, 0]
force = [0, 0, 1]
"""
WORDS = "without a unit; such a number is in rad/s, here "


class BareFrequencies(InTemporaryFolder):
    def warnings(self, text):
        done = trivet("check", self.file(MACHINE + text))
        return [line for line in done.stderr.splitlines() if WORDS in line]

    def test_a_band_states_what_it_is_in_hertz(self):
        (one,) = self.warnings("[analyses]\nresponse = {band = [5, 60]}\n")
        self.assertIn("project.toml:17: warning: analyses.response.band: [5, 60] " + WORDS, one)
        self.assertIn(f"{5 / 2 / math.pi:.3g} … {60 / 2 / math.pi:.3g} Hz", one)
        self.assertIn('write ["5 Hz", "60 Hz"] or ["5 rad/s", "60 rad/s"]', one)

    def test_each_key_warns_once(self):
        text = """[analyses]
response = {at = [3, 12, "4 Hz"]}
power = {band = [0, 62.8]}
shapes = {at = [4.5]}
[requirements]
natural_frequencies = {avoid = [[14.8, 18.1], [40, 50]]}
limits = {"m.z" = {limit = "1 mm", band = [10, 20]}}
isolation = {least = "10 %", at = 150}
"""
        found = self.warnings(text)
        keys = [line.split("warning: ")[1].split(": ")[0] for line in found]
        self.assertEqual(
            sorted(keys),
            [
                "analyses.power.band",
                "analyses.response.at",
                "analyses.shapes.at",
                "requirements.isolation.at",
                'requirements.limits."m.z".band',
                "requirements.natural_frequencies.avoid",
            ],
        )
        (avoid,) = [line for line in found if ".avoid: " in line]
        self.assertIn('[["14.8 Hz", "18.1 Hz"], ["40 Hz", "50 Hz"]]', avoid)
        (power,) = [line for line in found if "power" in line]
        self.assertIn('write [0, "62.8 Hz"]', power)  # 0 needs no unit

    def test_a_speed_is_stated_in_rpm(self):
        (one,) = self.warnings('[analyses]\norders = {of = ["m"], speed = [10, 100]}\n')
        self.assertIn(WORDS + f"{10 * 30 / math.pi:.3g} … {100 * 30 / math.pi:.3g} rpm", one)
        self.assertIn('write ["10 rpm", "100 rpm"] or ["10 rad/s", "100 rad/s"]', one)

    def test_numbers_with_units_and_declared_ones_do_not_warn(self):
        self.assertEqual(self.warnings('[analyses]\nresponse = {band = [0, "60 rad/s"]}\n'), [])
        self.assertEqual(self.warnings('[analyses]\nresponse = {band = [5, 60]}\n[display]\nfrequency = "rad/s"\n'), [])
        self.assertEqual(
            len(self.warnings('[analyses]\nresponse = {band = [5, 60]}\n[display]\nfrequency = "Hz"\n')), 1
        )

    def test_the_warning_is_in_every_result(self):
        path = self.file(MACHINE + "[analyses]\nresponse = {band = [5, 60]}\n")
        found = json.loads(trivet("response", path, "--json").stdout)["warnings"]
        self.assertEqual(sum(WORDS in one for one in found), 1)
        case = self.file(MACHINE + "[analyses]\nresponse = {band = [5, 60]}\n[cases.heavy]\nbodies.m.mass = 50\n")
        self.assertEqual(sum(WORDS in line for line in trivet("check", case).stderr.splitlines()), 1)

    def test_no_example_warns(self):
        for path in EXAMPLES:
            done = trivet("check", path)
            self.assertNotIn(WORDS, done.stderr, path)


if __name__ == "__main__":
    import unittest

    unittest.main()
