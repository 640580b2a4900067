# SPDX-License-Identifier: BSD-3-Clause
"""What `trivet optimize` can make small besides the largest amplitude, and how it goes on without a peak."""
import math
import unittest

from optimize_test import OSCILLATOR, PLACE, G, M
from trivet_test import InTemporaryFolder, result_of, trivet

# The measure of a peak that is gone is sampled from a thousandth of the natural frequencies on: x = 1e-6.
ABSENCE = 1e-4
WINDOW = 2 * math.pi * 12

# A white force, far beyond the natural frequency on both sides.
RANDOM = (
    OSCILLATOR
    + '''[excitations.noise]
type = "random"
on = "m"
at = [0, 0, 0]
force = [0, 0, 1]
psd = {rows = [[0.01, 2], [1000, 2]]}
'''
)


class Objectives(InTemporaryFolder):
    def optimum(self, text):
        if "[analyses.optimize]" not in text:
            text += "[analyses.optimize]\nstarts = 4\n"
        found = result_of("optimize", self.file(text))
        return found, {p["name"]: p["optimum"] for p in found["parameters"]}

    def damper(self, least, most):
        """The oscillator with its damper as the parameter."""
        text = OSCILLATOR.replace('path = "elements.s.', 'path = "elements.s.damping.')
        old = 'from = "20 N/mm"\nto = "500 N/mm"\nspacing = "logarithmic"'
        return text.replace(old, f"from = {least}\nto = {most}")

    def test_without_a_peak_the_furthest_from_one(self):
        # A damped mass has no peak from ζ = 1/√2 on. With y = |q|², x = ω²/ω₀², x₀ = 1 and c = 4ζ²,
        # (x + 1) y′/y = (2 − c − c x − 2 x²)/(1 + (c − 2) x + x²): 2 − c at x = 0 up to c = 4, −2 everywhere at c = 4,
        # and beyond it nearer to 0 again at some x.
        text = self.damper(10, 10000) + '[requirements]\nno_peak = "m.z"\n'
        found, best = self.optimum(text)
        self.assertAlmostEqual(best["stiffness"] / (2 * math.sqrt(1e5 * M)), 1, delta=ABSENCE)
        self.assertEqual((found["feasible"], found["active"], found["after"]), (True, [], None))
        [gone] = found["gone_peaks"]
        self.assertAlmostEqual(gone["measure"], -2, delta=ABSENCE)
        said = trivet("optimize", self.file(text)).stdout
        self.assertRegex(said, r"m\.z +2 ")
        # Up to a smaller damper the measure is that of x = 0. It is 0 at ζ = 1/√2; just below, the peak is still there,
        # but too low to count.
        for zeta in (0.9999 / math.sqrt(2), 0.75, 0.9):
            most = zeta * 2 * math.sqrt(1e5 * M)
            found, best = self.optimum(self.damper(10, most) + '[requirements]\nno_peak = "m.z"\n')
            self.assertAlmostEqual(best["stiffness"] / most, 1, delta=PLACE)
            self.assertAlmostEqual(found["gone_peaks"][0]["measure"], 2 - 4 * zeta**2, delta=ABSENCE)
        found, best = self.optimum(self.damper(10, 1.4 * math.sqrt(1e5 * M)) + '[requirements]\nno_peak = "m.z"\n')
        self.assertEqual(found["gone_peaks"], [])  # ζ = 0.7

    def test_rise_without_a_peak_that_is_furthest_from_one(self):
        # The acceleration of a damped mass rises to 1/m: the fall over 1/x of the displacement, mirrored.
        text = self.damper(10, 10000) + '[requirements]\nno_peak = "m.z"\nquantity = "acceleration"\n'
        found, best = self.optimum(text)
        self.assertAlmostEqual(best["stiffness"] / (2 * math.sqrt(1e5 * M)), 1, delta=ABSENCE)
        self.assertAlmostEqual(found["gone_peaks"][0]["measure"], -2, delta=ABSENCE)

    def test_weighted_sum(self):
        # One stiffness for two masses, below and above resonance: w/(k − m_a ω²) + v/(m_b ω² − k) is least where
        # √w (m_b ω² − k) = √v (k − m_a ω²).
        w, v, omega, m_a, m_b = 2.0, 0.5, 100.0, 2.0, 50.0
        text = "trivet = 1\n"
        for name, mass in (("a", m_a), ("b", m_b)):
            text += (
                f'[bodies.{name}]\nmass = {mass}\nfree = ["z"]\n[elements.s{name}]\ntype = "bushing"\non = "{name}"\n'
            )
            text += (
                f'at = [0, 0, 0]\ntranslation = [1, 1, 1e5]\n[excitations.{name}]\ntype = "harmonic"\non = "{name}"\n'
            )
            text += "at = [0, 0, 0]\nforce = [0, 0, 10]\n"
        text += '[parameters.stiffness]\npath = ["elements.sa.scale", "elements.sb.scale"]\nfrom = 0.5\nto = 4.5\n'
        text += f"[analyses.response]\nband = [{omega}, {omega * (1 + 1e-9)!r}]\n[analyses.optimize]\nstarts = 4\n"
        weighted = text + f'minimize = {{weighted = {{"a.z" = {w}, "b.z" = {v}}}}}\n'
        found, best = self.optimum(weighted)
        a, b = math.sqrt(v) * m_a, math.sqrt(w) * m_b
        k = (a + b) * omega**2 / (math.sqrt(v) + math.sqrt(w))
        least = 10 * (w / (k - m_a * omega**2) + v / (m_b * omega**2 - k))
        self.assertAlmostEqual(best["stiffness"] * 1e5 / k, 1, delta=PLACE)
        self.assertAlmostEqual(found["after"] / least, 1, delta=1e-7)  # the width of the band times 10
        self.assertLess(found["residual"], PLACE)
        self.assertEqual(found["unit"], "m")
        # With a bound on one of them.
        limit = 0.8 * found["minimized"][1]["after"]
        found, best = self.optimum(weighted + f'[requirements]\nlimits = {{"sb.deflection.z" = {limit}}}\n')
        k = m_b * omega**2 - 10 / limit
        self.assertAlmostEqual(best["stiffness"] * 1e5 / k, 1, delta=PLACE)
        for words in ("{}", '{weighted = {}}', '{weighted = {"a.z" = 0}}', '{weighted = {"c.z" = 1}}', '{sum = 1}'):
            said = trivet("optimize", self.file(text + f"minimize = {words}\n"))
            self.assertEqual(said.returncode, 2)
            self.assertIn("analyses.optimize.minimize", said.stderr)

    def test_root_mean_square_and_magnitude_at_rest(self):
        # White force: rms² of the displacement is π S/(2 k c) per rad/s, as large a damper as allowed; with the natural
        # frequency below a window, as large a stiffness.
        window = 'natural_frequencies = {avoid = [["12 Hz", "80 Hz"]]}\n'
        k = WINDOW**2 * M
        for minimize in ('{static = ["m.z"]}', '{static = "m.z"}'):
            found, best = self.optimum(
                OSCILLATOR + f"[requirements]\n{window}[analyses.optimize]\nminimize = {minimize}\nstarts = 2\n"
            )
            self.assertAlmostEqual(best["stiffness"] * 1e3 / k, 1, delta=PLACE)
            self.assertAlmostEqual(found["after"] / (M * G / k), 1, delta=PLACE)
            self.assertEqual((found["unit"], found["objective"]), ("m", ["m.z"]))
        # The same result with a limit is two requirements: with a window, and alone, where the stiffest is best.
        for other, stiffest in ((window, k), ("", 5e5)):
            limited = f'[requirements]\nstatic = {{"m.z" = "5 mm"}}\n{other}'
            found, best = self.optimum(
                OSCILLATOR + limited + '[analyses.optimize]\nminimize = {static = ["m.z"]}\nstarts = 2\n'
            )
            self.assertAlmostEqual(best["stiffness"] * 1e3 / stiffest, 1, delta=PLACE)
            self.assertAlmostEqual(found["after"] / (M * G / stiffest / 5e-3), 1, delta=PLACE)  # share of the limit
        optimize = '[analyses.optimize]\nminimize = {rms = ["m.z"]}\nstarts = 2\n'
        found, best = self.optimum(RANDOM + f"[requirements]\n{window}" + optimize)
        self.assertAlmostEqual(best["stiffness"] * 1e3 / k, 1, delta=PLACE)
        self.assertEqual(found["differenced"], [])
        self.assertIn(
            "Rms of m.z", trivet("optimize", self.file(RANDOM + f"[requirements]\n{window}" + optimize)).stdout
        )

    def test_minimised_results_of_a_case_with_more_limits(self):
        # A limit that a case adds comes before what is minimised in its list, and must not be taken for it.
        text = OSCILLATOR + '[analyses.response]\nband = ["30 Hz", "60 Hz"]\n[cases.heavy]\nbodies.m.mass = 60\n'
        search = '[analyses.optimize]\nminimize = "ground.force.z"\nstarts = 2\n'
        plain = result_of(
            "optimize", self.file(text.replace("[cases", '[requirements]\nhold_in = ["", "heavy"]\n[cases') + search)
        )
        loose = text.replace("[cases", '[requirements]\nhold_in = ["", "heavy"]\n[cases')
        more = result_of("optimize", self.file(loose + 'requirements.limits = {"m.z" = "1 m"}\n' + search))
        self.assertEqual(len(more["cases"][1]["after"]["requirements"]), 1)
        self.assertEqual([one["name"] for one in more["minimized"]], ["ground.force.z"] * 2)
        for key in ("before", "after"):
            self.assertAlmostEqual(more[key] / plain[key], 1, delta=1e-9)
        refused = trivet("optimize", self.file(loose + 'requirements.limits = {"ground.force.z" = "1 kN"}\n' + search))
        self.assertEqual(refused.returncode, 2)
        self.assertIn("some with a limit and some without (also in a case)", refused.stderr)


if __name__ == "__main__":
    unittest.main()
