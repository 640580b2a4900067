# SPDX-License-Identifier: BSD-3-Clause
"""Warnings of searches: parameters and requirements that decide nothing, given designs outside the ranges; and errors where
no design could be better than another."""
import unittest

from optimize_test import OSCILLATOR
from trivet_test import InTemporaryFolder, result_of, trivet

SEARCH = "[analyses.optimize]\nstarts = 2\n"
SIDE = '[parameters.side]\npath = "elements.s.translation.x"\nfrom = 0.5\nto = 5\n'
SMALL = '[requirements]\nlimits = {"m.z" = "1 mm"}\n'


class IdleDesigns(InTemporaryFolder):
    def test_parameter_that_changes_nothing_stays_with_a_warning(self):
        project = self.file(OSCILLATOR + SEARCH + SIDE + SMALL)
        done = trivet("optimize", project)
        line = 1 + project.read_text().splitlines().index("[parameters.side]")
        self.assertIn(f"project.toml:{line}: warning: parameters.side: changes nothing at the optimum", done.stderr)
        self.assertEqual(done.returncode, 0)
        self.assertEqual([p["name"] for p in result_of("optimize", project)["parameters"]], ["stiffness", "side"])

    def test_given_design_outside_the_ranges(self):
        text = OSCILLATOR.replace('"20 N/mm"', '"200 N/mm"') + '[requirements]\nlimits = {"ground.force.z" = "40 N"}\n'
        text += 'band = ["14 Hz", "18 Hz"]\n'
        project = self.file(text + SEARCH)
        line = 1 + text.splitlines().index("[parameters.stiffness]")
        outside = "parameters.stiffness: 100 N/mm in the file is outside its range, 200 N/mm … 500 N/mm"
        done = trivet("optimize", project)
        self.assertIn(f"project.toml:{line}: warning: {outside}", done.stderr)
        self.assertIn("the given design is better than the optimum: least margin", done.stderr)
        found = result_of("optimize", project)
        self.assertGreater(found["before"], found["after"])
        self.assertEqual([outside in found["warnings"][0], len(found["warnings"])], [True, 2])
        self.assertIn(outside, trivet("run", project, "-o", self.folder / "out").stdout)
        ends = text.replace('"200 N/mm"', '"120 N/mm"').replace(
            "translation = [1, 1, 1e5]", "translation = [1, 1, 0.12e6]"
        )
        self.assertEqual(result_of("optimize", self.file(ends + SEARCH))["warnings"], [])  # on the end, in other units
        within = result_of("optimize", self.file(text.replace('"200 N/mm"', '"50 N/mm"') + SEARCH))
        self.assertEqual(within["warnings"], [])

    def test_places_with_different_values(self):
        pair = OSCILLATOR.replace("[elements.s]", "[elements.left]", 1).replace("elements.s.", "elements.left.")
        spring = pair[pair.index("[elements.left]") : pair.index("[excitations.f]")]
        pair = pair.replace(spring, spring.replace("[0, 0, 0]", "[0, 0.3, 0]") + spring.replace("left", "right"))
        places = "['elements.left.at.y', 'elements.right.at.y']"
        spread = f"[parameters.spread]\npath = {places}\nfrom = 0.1\nto = 1\n"
        pair = pair.replace("at = [0, 0, 0]\ntranslation", "at = [0, -0.3, 0]\ntranslation") + SEARCH + SMALL
        different = "its places have different values in the file: 0.3 and -0.3"
        self.assertIn(different, " ".join(result_of("optimize", self.file(pair + spread))["warnings"]))
        mirrored = spread.replace(places, "{'elements.left.at.y' = 1, 'elements.right.at.y' = -1}")
        self.assertNotIn("different", " ".join(result_of("optimize", self.file(pair + mirrored))["warnings"]))
        front = pair.replace(SEARCH, '[analyses.optimize]\nfront = ["m.z", "ground.force.z"]\npoints = 3\nstarts = 2\n')
        self.assertIn(different, " ".join(result_of("optimize", self.file(front + spread))["warnings"]))

    def test_axis_that_changes_no_requirement_has_a_warning(self):
        axes = '[analyses.map]\npairs = [["stiffness", "side"]]\npoints = 4\n'
        for required in (SMALL, '[requirements]\nstatic = {"m.z" = "1 mm"}\ndamping_ratio = 0.1\n'):
            done = trivet("map", self.file(OSCILLATOR + SIDE + axes + required))
            self.assertIn("map: side: no result changes along this axis", done.stderr)
            self.assertNotIn("map: stiffness: no result", done.stderr)
            self.assertIn("Maps of 1 pair of parameters", done.stdout)

    def test_peak_that_every_design_has_is_an_error(self):
        always = '[requirements]\nno_peak = "m.z"\nquantity = "velocity"\n'
        mass = '[parameters.mass]\npath = "bodies.m.mass"\nfrom = 20\nto = 80\n'
        axes = '[analyses.map]\npairs = [["stiffness", "mass"]]\npoints = 3\n'
        for command, more in (("optimize", SEARCH), ("map", mass + axes)):
            done = trivet(command, self.file(OSCILLATOR + more + always))
            self.assertEqual(done.returncode, 1)
            self.assertIn("requirements.no_peak: velocity of m.z: a curve that vanishes at ω = 0", done.stderr)
            self.assertIn("has a peak in every design", done.stderr)

    def test_result_that_is_zero_in_every_design(self):
        still = SMALL.replace("{", '{"s.force.x" = "1 N", ')
        done = trivet("optimize", self.file(OSCILLATOR + SEARCH + still))
        self.assertEqual(done.returncode, 0)
        self.assertIn("optimize: s.force.x ≤ 1 N: the result is zero except for round-off", done.stderr)
        done = trivet("optimize", self.file(OSCILLATOR + SEARCH + still.replace(', "m.z" = "1 mm"', "")))
        self.assertEqual(done.returncode, 1)
        self.assertIn("zero in every design", done.stderr)


if __name__ == "__main__":
    unittest.main()
