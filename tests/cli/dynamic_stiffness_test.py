# SPDX-License-Identifier: BSD-3-Clause
"""Rubber that is stiffer in vibration than at rest: sag by the static stiffness, frequencies by the dynamic one."""
import math
import unittest

from trivet_test import InTemporaryFolder, result_of, trivet

DIGITS = 9  # the program states nine
G, M, K, STIFFENING = 9.80665, 40.0, 2.5e5, 1.4
SAG, NATURAL = M * G / K, math.sqrt(STIFFENING * K / M)
BODY = f"""trivet = 1
gravity = [0, 0, -{G}]
[bodies.m]
mass = {M}
free = ["z"]
[analyses]
static = {{of = ["m.z", "s.force.z"]}}
"""
BUSHING = f"""[elements.s]
type = "TYPE"
on = "m"
at = [0, 0, 0]
axis = "z"
translation = [1, 1, {K}]
stiffening = {STIFFENING}
damping = {{loss_factor = 0.1}}
"""
CATALOGUE = f"""catalogue = 1
title = "maker"
source = "made up"
[mounts.soft]
maker = "none"
translation = [1, 1, {K}]
stiffening = {STIFFENING}
loss_factor = 0.1
static_load = ["0 N", "500 N"]
static_deflection_limit = "2 mm"
[mounts.plain]
maker = "none"
translation = [1, 1, {K}]
loss_factor = 0.1
static_load = ["0 N", "500 N"]
static_deflection_limit = "2 mm"
"""
MOUNT = """[elements.s]
type = "catalogue:soft"
catalogue = "maker.toml"
on = "m"
at = [0, 0, 0]
axis = "z"
"""
DISC = """[elements.s]
type = "rubber_disc"
on = "m"
at = [0, 0, 0]
axis = "z"
diameter = "60 mm"
thickness = "25 mm"
material = {G = "0.8 MPa", stiffening = %s}
"""
FORCE = '[excitations.f]\ntype = "harmonic"\non = "m"\nat = [0, 0, 0]\nforce = [0, 0, 1]\n'


class DynamicStiffness(InTemporaryFolder):
    def setUp(self):
        super().setUp()
        self.file(CATALOGUE, "maker.toml")

    def test_sag_and_natural_frequency_of_bushings_springs_and_mounts(self):
        for element in (
            BUSHING.replace("TYPE", "bushing"),
            BUSHING.replace("TYPE", "three_springs"),
            MOUNT,
        ):
            project = self.file(BODY + element)
            static = {r["name"]: r["value"] for r in result_of("static", project)["results"]}
            self.assertAlmostEqual(static["m.z"] / -SAG, 1, DIGITS)
            self.assertAlmostEqual(static["s.force.z"] / (-M * G), 1, DIGITS)  # equilibrium, by either stiffness
            self.assertAlmostEqual(
                result_of("modes", project)["modes"][0]["angular_frequency"] / NATURAL,
                1,
                DIGITS,
            )
            self.assertEqual(result_of("static", project)["warnings"], [])
            self.assertIn(
                "in vibration 1.4 times as stiff",
                trivet("element", project, "s").stdout,
            )
        # The response: k(1 + iη) of vibration.
        found = result_of(
            "peaks",
            self.file(BODY + MOUNT + FORCE),
            "--set",
            "analyses.peaks.of = ['m.z']",
        )
        self.assertAlmostEqual(found["peaks"][0]["amplitude"] * 0.1 * STIFFENING * K, 1, DIGITS)

    def test_rubber_by_its_material_sags_as_without_stiffening(self):
        plain, stiff = (self.file(BODY + DISC % s, f"{s}.toml") for s in (1, STIFFENING))
        sags = [result_of("static", p)["results"][0]["value"] for p in (plain, stiff)]
        self.assertAlmostEqual(sags[1] / sags[0], 1, DIGITS)
        squares = [result_of("modes", p)["modes"][0]["eigenvalue_squared"] for p in (plain, stiff)]
        self.assertAlmostEqual(squares[1] / squares[0], STIFFENING, DIGITS)

    def test_verdict_and_select_judge_sag_by_the_static_stiffness(self):
        requirements = (
            '[requirements]\nmount_load = "catalogue"\nnatural_frequencies = {avoid = [["12.6 Hz", "13 Hz"]]}\n'
        )
        project = self.file(BODY + MOUNT + requirements + 'static = {"m.z" = "2 mm"}\n')
        rows = result_of("verdict", project)["cases"][0]["requirements"]
        sags = [row["value"] for row in rows if row["kind"] in ("mount_deflection", "static")]
        for sag in sags:
            self.assertAlmostEqual(abs(sag) / SAG, 1, DIGITS)
        choice = '[parameters.c]\npath = "elements.s.type"\ncatalogue = "maker.toml"\n'
        found = result_of("select", self.file(BODY + MOUNT + choice + requirements))
        self.assertEqual(found["without_bounds"], "")
        lowest = {
            d["mounts"]["c"]: (
                d["lowest_angular_frequency"],
                d["deflection"],
                d["margin"],
            )
            for d in found["best"]
        }
        plain = math.sqrt(K / M)  # 12.58 Hz
        for mount, natural in (("soft", NATURAL), ("plain", plain)):
            frequency, sag, margin = lowest[mount]
            self.assertAlmostEqual(frequency / natural, 1, DIGITS)
            self.assertAlmostEqual(sag / SAG, 1, DIGITS)
            hertz = natural / (2 * math.pi)
            self.assertAlmostEqual(
                margin,
                min(500 / (M * G), 2e-3 / SAG, max(12.6 / hertz, hertz / 13)),
                DIGITS,
            )

    def test_optimize_balances_the_sag_at_rest_against_the_frequency_of_vibration(self):
        text = (
            BODY
            + BUSHING.replace("TYPE", "bushing")
            + """[parameters.k]
path = "elements.s.translation.z"
from = 1e5
to = 1e6
[requirements]
static = {"m.z" = "1 mm"}
natural_frequencies = {avoid = [["15 Hz", "200 Hz"]]}
[analyses.optimize]
starts = 2
"""
        )
        found = result_of("optimize", self.file(text))
        # k / (m g) · 1 mm = 15 Hz / f, f = √(1.4 k / m) / 2π
        k = (15 * 2 * math.pi * M * G / 1e-3 * math.sqrt(M / STIFFENING)) ** (2 / 3)
        self.assertAlmostEqual(found["parameters"][0]["optimum"] / k, 1, 6)

    def test_wrong_factors(self):
        for line, words in (
            ("stiffening = 0.7", "stiffness in vibration over static stiffness is 1"),
            ("stiffening = 140", 'write "140 %"'),
            (
                'stiffening = 1.4\ndamping = {zener = {ratio = 0.3, time = "1 ms"}}',
                "relaxes",
            ),
        ):
            text = BODY + BUSHING.replace("TYPE", "bushing").replace(f"stiffening = {STIFFENING}", line)
            if "zener" in line:
                text = text.replace("damping = {loss_factor = 0.1}\n", "")
            done = trivet("check", self.file(text))
            self.assertEqual(done.returncode, 2, done.stdout)
            self.assertIn(words, done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
