# SPDX-License-Identifier: BSD-3-Clause
"""What the best design of `trivet optimize` is put beside: designs a step away, and the decoupling of the given one."""
import math
import unittest

from optimize_test import ABSORBER, G, M, OSCILLATOR
from trivet_test import SOURCE, InTemporaryFolder, result_of, trivet

CLOSE = 1e-9  # peaks have nine digits


class OptimumNeighbours(InTemporaryFolder):
    def test_steps_of_each_parameter_against_designs_by_themselves(self):
        request = (
            '[analyses.response]\nband = ["0.1 Hz", "20 Hz"]\n[analyses.optimize]\nminimize = "main.z"\nstarts = 2\n'
        )
        project = self.file(ABSORBER + request)
        found = result_of("optimize", project)
        for parameter in found["parameters"]:
            for key, direction in (("one_percent_less", -1), ("one_percent_more", 1)):
                moved = parameter["optimum"] + direction * 0.01 * (parameter["to"] - parameter["from"])
                values = {p["places"][0]["path"]: p["optimum"] for p in found["parameters"]}
                values[parameter["places"][0]["path"]] = moved
                settings = [word for path, value in values.items() for word in ("--set", f"{path}={value!r}")]
                heights = [
                    p["amplitude"] for p in result_of("peaks", project, *settings)["peaks"] if p["name"] == "main.z"
                ]
                self.assertAlmostEqual(parameter[key]["objective"] / max(heights), 1, delta=CLOSE)
                self.assertGreater(parameter[key]["objective"], found["after"])
                self.assertAlmostEqual(parameter[key]["value"] / moved, 1, delta=CLOSE)
                self.assertTrue(parameter[key]["met"])

    def test_step_below_a_margin_of_one_violates(self):
        # The margin is the stiffness over that at which the machine sags by its limit, up to the end of the range.
        limit = M * G / (500e3 / 1.01)
        project = self.file(OSCILLATOR + f'[requirements]\nstatic = {{"m.z" = {limit}}}\n')
        found = result_of("optimize", project)
        (parameter,) = found["parameters"]
        self.assertAlmostEqual(found["after"], 1.01, delta=CLOSE)
        less = parameter["one_percent_less"]
        self.assertAlmostEqual(less["objective"], 1.01 * 25**-0.01, delta=CLOSE)
        self.assertLess(less["objective"], 1)
        self.assertFalse(less["met"])
        self.assertIsNone(parameter["one_percent_more"])
        self.assertRegex(trivet("optimize", project).stdout, r"stiffness .* -3\.17 %, violates")

    def test_step_that_violates_a_requirement_and_step_out_of_the_range(self):
        band = '[requirements]\nband = ["30 Hz", "60 Hz"]\n'
        search = '[analyses.optimize]\nminimize = "ground.force.z"\nstarts = 2\n'
        stiffness = 60e3  # where the machine sags by its limit
        project = self.file(OSCILLATOR + band + f'static = {{"m.z" = {M * G / stiffness}}}\n' + search)
        (parameter,) = result_of("optimize", project)["parameters"]
        self.assertAlmostEqual(parameter["optimum"] * 1e3 / stiffness, 1, delta=1e-6)
        self.assertEqual((parameter["one_percent_less"]["met"], parameter["one_percent_more"]["met"]), (False, True))
        self.assertRegex(trivet("optimize", project).stdout, r"stiffness .* -[0-9.]+ %, violates +\+[0-9.]+ %")
        (parameter,) = result_of("optimize", self.file(OSCILLATOR + band + search))["parameters"]
        self.assertTrue(parameter["at_bound"])
        self.assertIsNone(parameter["one_percent_less"])
        ratio = math.exp(0.01 * math.log(25))  # the range is logarithmic
        self.assertAlmostEqual(parameter["optimum"], 20, delta=1e-6)
        settings = ("--set", f'{parameter["places"][0]["path"]}="{20 * ratio!r} N/mm"')
        moved = result_of("optimize", self.folder / "project.toml", *settings, "--set", "analyses.optimize.starts=1")
        self.assertAlmostEqual(parameter["one_percent_more"]["objective"] / moved["before"], 1, delta=CLOSE)

    def test_decoupling_given_and_at_the_optimum(self):
        example = SOURCE / "examples/powertrain/decoupled.toml"
        (case,) = result_of("optimize", example)["cases"]
        given = {
            body["name"]: min(mode["decoupling"] for mode in body["modes"])
            for body in result_of("suspension", example)["bodies"]
        }
        self.assertEqual(set(case["decoupling_before"]), set(given))
        for body, least in given.items():
            self.assertAlmostEqual(case["decoupling_before"][body] / least, 1, delta=CLOSE)
            self.assertGreater(case["decoupling_after"][body], least)


if __name__ == "__main__":
    unittest.main()
