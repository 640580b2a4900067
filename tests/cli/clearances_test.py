# SPDX-License-Identifier: BSD-3-Clause
"""Gaps that must not close, against calculations by hand."""
import math
import unittest

from trivet_test import InTemporaryFolder, result_of, trivet
from verdict_test import OSCILLATOR as DRIVEN
from verdict_test import C, G, K, M

CLOSE = 1e-9  # relative: statics, and peaks with their nine digits

OSCILLATOR = (
    DRIVEN[: DRIVEN.index("[excitations.f]")]
    + """[clearances.floor]
between = ["m", "ground"]
direction = "-z"
gap = "6 mm"
"""
)
FORCE = '[excitations.f]\ntype = "harmonic"\non = "m"\nat = [0, 0, 0]\nforce = [0, 0, 30]\n'
STEP = '[excitations.s]\ntype = "time"\non = "m"\nat = [0, 0, 0]\nforce = [0, 0, -1]\nhistory = {step = {amplitude = 50}}\n'
RATIO = C / (2 * math.sqrt(K * M))
SAG, PEAK = M * G / K, 30 / K / (2 * RATIO * math.sqrt(1 - RATIO**2))
OVERSHOOT = 50 / K * (1 + math.exp(-math.pi * RATIO / math.sqrt(1 - RATIO**2)))


class Clearances(InTemporaryFolder):
    def judged(self, text):
        (result,) = result_of("verdict", self.file(text))["cases"][0]["requirements"]
        return result

    def near(self, found, expected):
        self.assertLessEqual(abs(found / expected - 1), CLOSE, (found, expected))

    def test_rest_harmonic_and_transient_motion_add(self):
        self.near(self.judged(OSCILLATOR)["value"], SAG)
        harmonic = self.judged(OSCILLATOR + FORCE)
        self.near(harmonic["value"], SAG + PEAK)
        self.near(harmonic["margin"], 6e-3 / (SAG + PEAK))
        self.near(harmonic["angular_frequency"], math.sqrt(K / M * (1 - 2 * RATIO**2)))
        both = self.judged(OSCILLATOR + FORCE + STEP + "[analyses]\ntransient = {}\n")
        self.near(both["value"], SAG + PEAK + OVERSHOOT)
        self.assertEqual([word in both["detail"] for word in ("at rest", "harmonic", "transient", "left")], [True] * 4)
        self.assertIn("not counted: time histories", self.judged(OSCILLATOR + FORCE + STEP)["detail"])

    def test_only_the_band_of_the_requirements_counts(self):
        low = self.judged(OSCILLATOR + FORCE + '[requirements]\nband = ["0 Hz", "5 Hz"]\n')
        w = 10 * math.pi
        self.near(low["value"], SAG + 30 / math.hypot(K - M * w * w, C * w))

    def test_a_restricted_band_is_named_with_what_it_leaves_out(self):
        banded = OSCILLATOR + FORCE + '[requirements]\nband = ["2 Hz", "5 Hz"]\n'
        detail = self.judged(banded)["detail"]
        self.assertIn(" harmonic over 2 … 5 Hz; ", detail)
        self.assertTrue(detail.endswith("; not counted: harmonic motion outside of the band"), detail)
        everywhere = self.judged(OSCILLATOR + FORCE)["detail"]
        self.assertNotIn("over", everywhere)
        self.assertNotIn("not counted", everywhere)
        unused = FORCE.replace("excitations.f", "excitations.g")
        selected = self.judged(OSCILLATOR + FORCE + unused + '[requirements]\nexcitations = ["f"]\n')["detail"]
        self.assertTrue(selected.endswith("; not counted: harmonic excitations that are not selected"), selected)

    def test_creep_is_not_counted_and_the_row_says_so(self):
        start = OSCILLATOR.index("translation = ")
        stiffness, rest = OSCILLATOR[start:].split("damping", 1)
        self.file(
            f'catalogue = 1\ntitle = "t"\nsource = "s"\n[mounts.a]\nmaker = "m"\n{stiffness}creep = 1.2\n', "a.toml"
        )
        mount = OSCILLATOR[:start].replace('"bushing"', '"catalogue:a"\ncatalogue = "a.toml"')
        found = self.judged(mount + rest[rest.index("\n") :])
        self.near(found["value"], SAG)
        self.assertTrue(found["detail"].endswith("; not counted: creep"), found["detail"])

    def test_motion_away_opens_the_gap(self):
        above = OSCILLATOR.replace('direction = "-z"', 'direction = "z"')
        self.near(self.judged(above)["value"], -SAG)
        self.assertIsNone(self.judged(above)["margin"])
        self.near(self.judged(above + FORCE)["value"], PEAK - SAG)
        # The transient counts only where it closes the gap: the force acts downwards and never lifts the mass.
        self.near(self.judged(above + FORCE + STEP + "[analyses]\ntransient = {}\n")["value"], PEAK - SAG)

    def test_on_a_nonlinear_machine_small_motions_are_named(self):
        nonlinear = OSCILLATOR.replace('type = "bushing"\n', 'type = "bushing"\nlaws.z = {cubic = 1e9}\n')
        self.assertNotEqual(nonlinear, OSCILLATOR)
        for text, named in ((OSCILLATOR, False), (nonlinear, True)):
            done = trivet("verdict", self.file(text + FORCE))
            self.assertEqual("clearances: a nonlinear machine" in done.stderr, named, done.stderr)

    def test_an_undamped_resonance_leaves_no_gap(self):
        undamped = OSCILLATOR.replace(f"damping = {{translation = [1e-3, 1e-3, {C}]}}\n", "")
        found = self.judged(undamped + FORCE)
        self.assertEqual((found["value"], found["margin"], found["met"]), (None, 0, False))
        self.assertIn("unbounded", found["detail"])

    def test_a_governing_clearance_names_its_cause(self):
        case = result_of("verdict", self.file(OSCILLATOR.replace("6 mm", "1.6 mm") + FORCE))["cases"][0]
        self.assertIn("floor.approach", case["cause"])

    def test_a_map_needs_a_position_of_rest_as_a_verdict_does(self):
        text = OSCILLATOR + (
            '[bodies.loose]\nmass = 1\nfree = ["z"]\n'
            "[analyses.map]\n"
            'x = {parameter = "elements.s.scale", from = 1, to = 2, points = 2}\n'
            'y = {parameter = "bodies.m.mass", from = 1, to = 2, points = 2}\n'
        )
        for command in ("verdict", "map"):
            done = trivet(command, self.file(text))
            self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
            self.assertIn("so every case needs a position of rest", done.stderr)

    def test_optimum_between_a_clearance_and_a_natural_frequency(self):
        # Stiffness s K: gap s K / (m g) grows with s, the factor below a window of natural frequencies falls with s.
        window = 2 * math.sqrt(K / M) / (2 * math.pi)
        text = (
            OSCILLATOR.replace("6 mm", "1 mm")
            + f'[requirements]\nnatural_frequencies = {{avoid = [["{window} Hz", "{9 * window} Hz"]]}}\n'
            + '[parameters.stiffness]\npath = "elements.s.scale"\nfrom = 0.2\nto = 5\nspacing = "logarithmic"\n'
            + '[analyses]\noptimize = {}\n'
        )
        found = result_of("optimize", self.file(text))
        scale = (2 * SAG / 1e-3) ** (2 / 3)
        self.assertAlmostEqual(found["parameters"][0]["optimum"] / scale, 1, 5)  # residual of the search
        self.assertAlmostEqual(found["after"] / (1e-3 * scale / SAG), 1, 5)
        self.assertIn("clearance", [one["requirement"] for one in found["differenced"]])


if __name__ == "__main__":
    unittest.main()
