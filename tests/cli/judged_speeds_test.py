# SPDX-License-Identifier: BSD-3-Clause
"""No command calls a machine good that nothing judges at its operating speed, that `verdict` and `run` judge differently, or
that violates its requirements in some cases."""
import json
import unittest

from operation_test import MACHINE, ORDERS, ROTOR
from trivet_test import InTemporaryFolder, trivet

DONE, NOT_COMPUTED, OVER_A_LIMIT = 0, 1, 3
SPEED = '[operation]\nspeeds = ["600 rpm"]\n'  # 10 Hz
RESPONSE = '[analyses]\nresponse = {band = ["1 Hz", "5 Hz"], of = ["m"]}\n'
MISSED = "m.z at 600 rpm: no limit holds at this speed, 10 Hz"


class JudgedSpeeds(InTemporaryFolder):
    def run_of(self, text, *arguments):
        return trivet("run", self.file(MACHINE + text), "-o", self.folder / "out", *arguments)

    def headline(self, text):
        return self.run_of(text).stdout.splitlines()[0]

    def verdict(self, text):
        return json.loads(trivet("verdict", self.file(MACHINE + text), "--json").stdout)

    def test_a_limit_whose_band_misses_the_speed_is_not_judged_there(self):
        required = '[requirements.limits]\n"m.z" = "1 m"\n'
        own_band = '[requirements.limits]\n"m.z" = {limit = "1 m", band = ["1 Hz", "5 Hz"]}\n'
        alone = '[limits]\n"m.z" = "1 m"\n'
        for limits in (required + RESPONSE, own_band, alone + RESPONSE, SPEED.replace("600", "590") + own_band):
            text = ROTOR + limits + (SPEED if SPEED[:11] not in limits else "")
            done = self.run_of(text)
            self.assertTrue(done.stdout.startswith("NOT JUDGED: 1 of 2 requirements"), done.stdout)
            self.assertNotIn("✓ MET", (self.folder / "out" / "report.html").read_text())
            self.assertEqual(trivet("verdict", self.file(MACHINE + text)).returncode, NOT_COMPUTED)
            self.assertFalse(self.verdict(text)["met"])
        self.assertIn(MISSED, self.run_of(ROTOR + SPEED + own_band).stdout)

    def test_a_limit_that_holds_at_the_speed_is_enough(self):
        wide = '[requirements.limits]\n"m.z" = {limit = "1 m", band = ["1 Hz", "10 Hz"]}\n'
        both = (
            '[requirements.limits]\n"m.z" = {limit = "1 m", band = ["1 Hz", "5 Hz"]}\n'
            '[operation]\nspeeds = ["600 rpm"]\nlimits = {"m.z" = "1 m/s"}\n'
        )
        for text in (SPEED + wide, both):
            self.assertTrue(self.headline(ROTOR + text).startswith("MET"), text)

    def test_a_range_of_speeds_has_to_be_in_the_band(self):
        speeds = '[operation]\nspeeds = [["300 rpm", "600 rpm"]]\n'
        for end, word in (("9 Hz", "NOT JUDGED"), ("10 Hz", "MET")):
            limit = f'[requirements.limits]\n"m.z" = {{limit = "1 m", band = ["1 Hz", "{end}"]}}\n'
            self.assertTrue(self.headline(ROTOR + speeds + limit).startswith(word), end)

    def test_adjoining_bands_are_enough_together(self):
        speeds = '[operation]\nspeeds = [["300 rpm", "600 rpm"]]\n'
        bands = ['{limit = "1 m", band = ["1 Hz", "7 Hz"]}', '{limit = "2 m", band = ["7 Hz", "30 Hz"]}']
        limits = '[requirements.limits]\n"m.z" = [%s]\n'
        self.assertTrue(self.headline(ROTOR + speeds + limits % ", ".join(bands)).startswith("MET"))
        apart = bands[1].replace("7 Hz", "8 Hz")
        for items, first in (([bands[0], apart], 7), (bands[1:], 5), (bands[:1], 7)):
            said = self.run_of(ROTOR + speeds + limits % ", ".join(items)).stdout
            self.assertIn(f"m.z over 300 … 600 rpm: no limit holds from {first} Hz on", said)

    def test_limits_under_other_excitations_say_nothing_of_the_speed(self):
        push = '[excitations.floor]\ntype = "base"\ntranslation = [0, 0, 1e-6]\n'
        limit = '[requirements.limits]\n"m.z" = {limit = "1 m", band = ["1 Hz", "5 Hz"], excitations = ["floor"]}\n'
        self.assertTrue(self.headline(ROTOR + push + SPEED + limit).startswith("MET"))
        wide = '{limit = "1 m", band = ["1 Hz", "30 Hz"], excitations = ["floor"]}'
        own = '{limit = "2 m", band = ["1 Hz", "5 Hz"]}'
        both = f'[requirements.limits]\n"m.z" = [{wide}, {own}]\n'
        self.assertTrue(self.headline(ROTOR + push + SPEED + both).startswith("NOT JUDGED"))

    def test_a_line_that_misses_the_speed_is_not_judged_there(self):
        for end, band, word in (
            ("5 Hz", "30 Hz", "NOT JUDGED"),
            ("30 Hz", "5 Hz", "NOT JUDGED"),
            ("30 Hz", "30 Hz", "MET"),
        ):
            line = f'[limit_lines.l]\nof = "m.z"\nrows = [["1 Hz", "1 km/s"], ["{end}", "1 km/s"]]\n'
            response = RESPONSE.replace('"5 Hz"', f'"{band}"')
            self.assertTrue(self.headline(ROTOR + SPEED + line + response).startswith(word), (end, band))

    def test_searches_do_not_ask_for_it_and_say_so(self):
        text = (
            ROTOR + SPEED + '[requirements.limits]\n"m.z" = {limit = "1 m", band = ["1 Hz", "5 Hz"]}\n'
            '[parameters.k]\npath = "elements.s.scale"\nfrom = 0.5\nto = 2\n[analyses]\noptimize = {}\n'
        )
        done = trivet("optimize", self.file(MACHINE + text), "--json")
        self.assertEqual(done.returncode, DONE, done.stderr)
        self.assertTrue(json.loads(done.stdout)["feasible"])
        self.assertIn("m.z at 600 rpm: not judged", trivet("optimize", self.file(MACHINE + text)).stderr)
        axes = "x = {parameter = 'elements.s.scale', from = 0.9, to = 1.1}, y = {parameter = 'bodies.m.mass', from = 9, to = 11}"
        mapped = text.replace("optimize = {}", f"map = {{{axes}}}")
        self.assertIn("m.z at 600 rpm: not judged", trivet("map", self.file(MACHINE + mapped), "--points", "3").stderr)

    def test_lines_beside_requirements_are_judged_by_verdict_as_by_run(self):
        line = '[limit_lines.low]\nof = "m.z"\nrows = [["1 Hz", "1 nm/s"], ["5 Hz", "1 nm/s"]]\n'
        text = ROTOR + line + '[requirements.limits]\n"m.z" = {limit = "1 m", band = ["1 Hz", "5 Hz"]}\n' + RESPONSE
        self.assertTrue(self.headline(text).startswith("VIOLATED: 1 of 2 requirements"))
        self.assertEqual(self.run_of(text, "--strict").returncode, OVER_A_LIMIT)
        self.assertEqual(trivet("verdict", self.file(MACHINE + text), "--strict").returncode, OVER_A_LIMIT)
        self.assertFalse(self.verdict(text)["met"])
        other = line.replace(".low]", ".high]").replace("1 nm/s", "1 km/s")
        named = text.replace("[requirements.limits]", '[requirements]\nlimit_lines = ["high"]\n[requirements.limits]')
        kinds = [one["requirement"] for one in self.verdict(named + other)["cases"][0]["requirements"]]
        self.assertEqual([one for one in kinds if "within" in one], ['m.z within "high"'])

    def test_the_headline_names_violations_that_are_not_binding(self):
        limit = '[requirements.limits]\n"m.z" = {limit = "10 mm", band = ["1 Hz", "5 Hz"]}\n'
        cases = "[cases.bad]\nexcitations.rotor.mass_eccentricity = 1e9\n"
        text = ROTOR + limit + cases
        self.assertIn("; violated in 1 case in which they are not binding", self.headline(text))
        page = (self.folder / "out" / "report.html").read_text()
        self.assertNotIn("✓ MET", page)
        self.assertIn("MET: 1 of 1 requirement; violated in 1 case in which they are not binding", page)
        self.assertTrue(self.headline(ROTOR + limit).startswith("MET: 1 of 1 requirement"))
        self.assertIn("✓ MET", (self.folder / "out" / "report.html").read_text())

    def test_orders_count_as_running(self):
        limit = '[requirements.limits]\n"m.z" = {limit = "1 m", speed = ["100 rpm", "300 rpm"]}\n'
        self.assertIn(MISSED, self.run_of(ORDERS + SPEED + limit).stdout)


if __name__ == "__main__":
    unittest.main()
