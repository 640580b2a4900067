# SPDX-License-Identifier: BSD-3-Clause
"""Optima within tolerances as a user meets them: what the result promises is what trivet sample finds there."""
import json
import unittest

from trivet_test import SOURCE, trivet

FAN = SOURCE / "examples/fan/robust.toml"
FEWER = ["--set", "analyses.sample.designs = 4000"]


def optimize(*arguments):
    return trivet("optimize", FAN, *FEWER, *arguments)


def with_springs(scale):
    sides = (f"{place} {side}" for place in ("front", "middle", "rear") for side in ("left", "right"))
    return [word for name in sides for word in ("--set", f'elements."{name}".scale = {scale!r}')]


class RobustOptimum(unittest.TestCase):
    def test_promises_what_is_sampled(self):
        found = json.loads(optimize("--json").stdout)
        self.assertEqual(found["wanted"], 0.99)
        self.assertTrue(found["held"])
        self.assertTrue(found["feasible"])
        self.assertEqual(found["starts"], 33)  # of the first search: 32 and the given design
        designs = {one["design"]: one for one in found["sampled_designs"]}
        self.assertEqual(list(designs), ["given", "nominal", "optimum"])
        changes = with_springs(found["parameters"][0]["optimum"])
        sampled = json.loads(trivet("sample", FAN, *FEWER, *changes, "--json").stdout)
        self.assertEqual(sampled["yield"], designs["optimum"]["yield"])
        given = json.loads(trivet("sample", FAN, *FEWER, "--json").stdout)
        self.assertEqual(given["yield"], designs["given"]["yield"])
        self.assertGreater(designs["optimum"]["kept_margin"], designs["nominal"]["kept_margin"])
        self.assertEqual(found["after"], designs["optimum"]["kept_margin"])
        for one in found["kept_margins"]:  # alone it keeps more than all together
            self.assertGreaterEqual(one["kept"], found["after"])
            self.assertGreater(one["nominal"], one["kept"])

    def test_is_never_worse_than_the_given_design(self):
        best = json.loads(optimize("--json").stdout)
        again = json.loads(optimize("--json", *with_springs(best["parameters"][0]["optimum"])).stdout)
        self.assertAlmostEqual(again["before"] / best["after"], 1, 9)
        self.assertGreaterEqual(again["after"], again["before"])

    def test_says_a_yield_that_is_not_held(self):
        narrow = ["--set", 'requirements.static = {"fan.z" = "23 mm"}']
        done = optimize(*narrow, "--strict")
        self.assertEqual(done.returncode, 3)
        self.assertIn("NOT the wanted 99 %", done.stdout)
        self.assertRegex(
            done.stdout, "of 33 starts of the first search, which ignores the tolerances, reached its optimum"
        )
        self.assertIn("best design violates a requirement", done.stdout + done.stderr)

    def test_worst_machines(self):
        worst = [
            "--set",
            "analyses.optimize = {worst_case = true}",
            "--set",
            'requirements.static = {"fan.z" = "31 mm"}',
        ]
        text = FAN.read_text().replace('\n[analyses.optimize]\nyield = "99 %"\n', "")
        done = trivet("optimize", "-", *FEWER, *worst, input=text)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("the worst machines found within the tolerances meet every requirement", done.stdout)
        self.assertIn("no proof", done.stdout)
        self.assertNotIn("99 %", done.stdout)


if __name__ == "__main__":
    unittest.main()
