# SPDX-License-Identifier: BSD-3-Clause
"""Requirements in maps, and maps of several pairs of parameters, against closed forms and single maps."""
import csv
import io
import math
import unittest
import xml.etree.ElementTree

from trivet_test import InTemporaryFolder, result_of, trivet

STORED = 1e-6  # a map stores margins in single precision
M, G, SAG, RATIO, WINDOW = 40.0, 9.80665, 4e-3, 0.05, (8.0, 12.0)

MODEL = f"""trivet = 1
gravity = [0, 0, -{G}]
[bodies.m]
mass = {M}
free = ["z"]
[elements.s]
type = "bushing"
on = "m"
at = [0, 0, 0]
translation = [1, 1, 1e5]
damping = {{translation = [0, 0, 400]}}
[parameters.stiffness]
path = "elements.s.translation.z"
from = 5e4
to = 5e5
spacing = "logarithmic"
[parameters.damper]
path = "elements.s.damping.translation.z"
from = 50
to = 2000
[parameters.mass]
path = "bodies.m.mass"
from = 20
to = 80
"""
PUSH = """[excitations.f]
type = "harmonic"
on = "m"
at = [0, 0, 0]
force = [0, 0, 30]
"""
GAP = 6e-3
FLOOR = """[clearances.floor]
between = ["m", "ground"]
direction = "-z"
gap = "6 mm"
"""
REQUIRED = f"""[requirements]
damping_ratio = {RATIO}
static = {{"m.z" = {SAG}}}
natural_frequencies = {{avoid = [["{WINDOW[0]} Hz", "{WINDOW[1]} Hz"]]}}
"""
PAIRS = '[analyses.map]\npairs = [["stiffness", "damper"], ["stiffness", "mass"], ["damper", "mass"]]\npoints = 7\n'
ONE = '[analyses.map]\nx = {parameter = "stiffness", points = 7}\ny = {parameter = "damper", points = 9}\n'


def values(axis):
    shares = [i / (axis["points"] - 1) for i in range(axis["points"])]
    low, high = axis["from"], axis["to"]
    if axis["spacing"] == "logarithmic":
        return [low * (high / low) ** s for s in shares]
    return [low + s * (high - low) for s in shares]


def margin(k, c, m):
    """The least margin of REQUIRED."""
    omega = math.sqrt(k / m)
    hertz = omega / (2 * math.pi)
    ratio = c / (2 * math.sqrt(k * m))
    met = [SAG * k / (m * G), max(WINDOW[0] / hertz, hertz / WINDOW[1])]
    return min(met + ([ratio / RATIO] if ratio < 1 else []))


class MapRequirements(InTemporaryFolder):
    def test_every_design_has_the_least_margin_of_all_requirements(self):
        for excitation in ("", PUSH):
            found = result_of("map", self.file(MODEL + excitation + ONE + REQUIRED))
            places = [(k, c) for c in values(found["y"]) for k in values(found["x"])]
            self.assertEqual(len(places), 63)
            for (k, c), stored in zip(places, found["grid"]["margin"]):
                self.assertAlmostEqual(stored / margin(k, c, M), 1, delta=STORED)
            self.assertEqual(
                [rule["kind"] for rule in found["rules"]], ["damping_ratio", "static", "avoided_frequencies"]
            )
            self.assertEqual({rule["governs_kept"] + rule["governs_broken"] > 0 for rule in found["rules"]}, {True})
            self.assertNotIn("no result changes", str(found["warnings"]))
            self.assertIn("judged design by design: every damping ratio", found["way"])
            self.assertIn("natural frequencies of the matrices as a sum of", found["way"])

    def test_boundary_is_where_the_margin_is_one(self):
        found = result_of("map", self.file(MODEL + ONE + REQUIRED))
        points = [p for line in found["feasible"]["boundary"] for p in line]
        self.assertGreater(len(points), 5)
        for k, c in points:
            self.assertAlmostEqual(margin(k, c, M), 1, delta=1e-4)

    def test_each_pair_is_the_map_of_its_two_parameters(self):
        both = result_of("map", self.file(MODEL + PAIRS + REQUIRED))
        self.assertEqual(
            [(m["x"]["name"], m["y"]["name"]) for m in both["pairs"]][1:], [("stiffness", "mass"), ("damper", "mass")]
        )
        shared = both["pairs"][0]["colours"]
        self.assertEqual({c["governing"] for c in shared}, {g for m in both["pairs"] for g in m["grid"]["governing"]})
        for one in both["pairs"]:
            axes = ", ".join(f'{a} = {{parameter = "{one[a]["name"]}", points = 7}}' for a in "xy")
            alone = result_of("map", self.file(MODEL + f"[analyses]\nmap = {{{axes}}}\n" + REQUIRED))
            alone.pop("warnings")
            alone.pop("colours")  # of all three maps they are the same
            self.assertEqual(one.pop("colours"), shared)
            self.assertEqual(one, alone)
        text = trivet("map", self.file(MODEL + PAIRS + REQUIRED)).stdout
        self.assertIn("Maps of 3 pairs of parameters", text)
        rows = list(csv.reader(io.StringIO(trivet("map", self.file(MODEL + PAIRS + REQUIRED), "--csv").stdout)))
        self.assertEqual(rows[0][:4], ["x parameter", "y parameter", "x", "y"])
        self.assertEqual(len(rows), 1 + 3 * 49)

    def test_limits_and_peaks_of_requirements_are_those_of_a_map(self):
        rules = 'limits = {"m.z" = "1 mm", "ground.force.z" = "60 N"}\nno_peak = "m"\nband = ["1 Hz", "9 Hz"]\npeak_tolerance = 0.2\n'
        own = result_of("map", self.file(MODEL + PUSH + ONE + rules))
        required = result_of("map", self.file(MODEL + PUSH + ONE + "[requirements]\n" + rules))
        self.assertEqual(own, required)
        # A band of the map is that of all its limits; other excitations are judged design by design.
        other = rules.replace('"1 Hz"', '"2 Hz"')
        moved = result_of("map", self.file(MODEL + PUSH + ONE + 'band = ["1 Hz", "9 Hz"]\n[requirements]\n' + other))
        self.assertEqual(own["grid"], moved["grid"])

    def test_limits_with_two_bands_are_judged_in_their_own(self):
        low, high = 'band = ["1 Hz", "6 Hz"]\n', 'band = ["9 Hz", "20 Hz"]\n'
        still, force = '"m.z" = "0.4 mm"', 'limits = {"ground.force.z" = "40 N"}\n'
        one = result_of("map", self.file(MODEL + PUSH + ONE + low + f"limits = {{{still}}}\n"))
        other = result_of("map", self.file(MODEL + PUSH + ONE + high + force))
        both = result_of(
            "map",
            self.file(
                MODEL + PUSH + ONE + f"[analyses.response]\n{low}[limits]\n{still}\n[requirements]\n{high}{force}"
            ),
        )
        self.assertIn("judged design by design: ground.force.z", both["way"])
        for a, b, least in zip(one["grid"]["margin"], other["grid"]["margin"], both["grid"]["margin"]):
            self.assertAlmostEqual(least / min(a, b), 1, delta=STORED)

    def test_own_limits_and_peaks_replace_those_of_the_requirements(self):
        own = 'limits = {"m.z" = "1 mm"}\nno_peak = []\n'
        required = REQUIRED + 'limits = {"m.z" = "1 um"}\nno_peak = "m"\n'
        found = result_of("map", self.file(MODEL + PUSH + ONE + own + required))
        kinds = [(rule["kind"], rule["allowed"]) for rule in found["rules"]]
        self.assertEqual(kinds[0], ("amplitude", 1e-3))
        self.assertEqual([kind for kind, _ in kinds], ["amplitude", "damping_ratio", "static", "avoided_frequencies"])

    def test_designs_hold_in_further_cases(self):
        text = MODEL + ONE + REQUIRED + 'hold_in = ["", "heavy"]\n[cases.heavy]\nbodies.m.mass = 80\n'
        found = result_of("map", self.file(text))
        places = [(k, c) for c in values(found["y"]) for k in values(found["x"])]
        for (k, c), stored in zip(places, found["grid"]["margin"]):
            self.assertAlmostEqual(stored / min(margin(k, c, M), margin(k, c, 80)), 1, delta=STORED)
        self.assertEqual(sum('in case "heavy"' in rule["words"] for rule in found["rules"]), 3)
        # The given design is judged in the heavy case too, the heavy one only for itself.
        base, heavy = found["marks"]
        self.assertAlmostEqual(base["margin"] / min(margin(1e5, 400, M), margin(1e5, 400, 80)), 1, delta=STORED)
        self.assertAlmostEqual(heavy["margin"] / margin(1e5, 400, 80), 1, delta=STORED)
        self.assertEqual([r["value"] for r in heavy["rules"][3:]], [None] * 3)

    def test_a_case_that_sets_a_number_of_the_map_is_refused(self):
        # Every design would replace the stiffness of the case: its own change would be lost.
        text = MODEL + ONE + REQUIRED + 'hold_in = ["", "stiff"]\n[cases.stiff]\nelements.s.'
        lost = self.file(text + "translation.z = 1.4e5\n")
        words = 'case "stiff" sets elements.s.translation.z, which the parameter "stiffness" moves'
        refused = trivet("map", lost)
        self.assertEqual(refused.returncode, 2, refused.stdout)
        self.assertIn(f"map: {words}; change another number in the case, such as stiffness_factor", refused.stderr)
        self.assertIn(f"warning: map: {words}", trivet("check", lost).stderr)
        ran = trivet("run", lost, "-o", self.folder / "out")
        self.assertEqual(ran.returncode, 1)
        self.assertIn(words, ran.stdout + ran.stderr)
        # As a factor it holds beside the axis, and each design is judged 1.4 times as stiff.
        found = result_of("map", self.file(text + "stiffness_factor.z = 1.4\n"))
        places = [(k, c) for c in values(found["y"]) for k in values(found["x"])]
        for (k, c), stored in zip(places, found["grid"]["margin"]):
            self.assertAlmostEqual(stored / min(margin(k, c, M), margin(1.4 * k, c, M)), 1, delta=STORED)
        # A case that only clearances judge is left out with a warning, and is a point on the map.
        done = trivet("map", self.file(MODEL + FLOOR + ONE + "[cases.stiff]\nelements.s.translation.z = 1.4e5\n"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(f"{words}; every design would undo the case", done.stderr)

    def test_clearance_is_always_a_rule(self):
        # The mass sinks by m g / k and moves by F / (2 ζ √(1 − ζ²) k) at its peak.
        def closed(k, c):
            ratio = c / (2 * math.sqrt(k * M))
            moves = 30 / k / (2 * ratio * math.sqrt(1 - ratio**2) if ratio < math.sqrt(0.5) else 1)
            return GAP / (M * G / k + moves), 1e-3 / moves

        limit = 'limits = {"m.z" = "1 mm"}\n'
        for rules, limited in (("", False), (limit, True), ("[requirements]\n" + limit, True)):
            found = result_of("map", self.file(MODEL + FLOOR + PUSH + ONE + rules))
            self.assertEqual([r["kind"] for r in found["rules"]], ["amplitude"] * limited + ["clearance"])
            places = [(k, c) for c in values(found["y"]) for k in values(found["x"])]
            for (k, c), stored in zip(places, found["grid"]["margin"]):
                expected = closed(k, c)
                self.assertAlmostEqual(stored / (min(expected) if limited else expected[0]), 1, delta=STORED)
        self.assertIn("clearance", [r["kind"] for r in result_of("map", self.file(MODEL + FLOOR + ONE))["rules"]])

    def test_clearance_is_judged_in_the_band_of_the_map(self):
        own = result_of(
            "map", self.file(MODEL + FLOOR + PUSH + ONE + 'band = ["0 Hz", "2 Hz"]\nlimits = {"m.z" = "1 m"}\n')
        )
        places = [(k, c) for c in values(own["y"]) for k in values(own["x"])]
        omega = 4 * math.pi  # below the peak of every design
        for (k, c), stored in zip(places, own["grid"]["margin"]):
            moves = max(30 / k, 30 / math.hypot(k - M * omega**2, c * omega))
            self.assertAlmostEqual(stored / (GAP / (M * G / k + moves)), 1, delta=STORED)

    def test_clearance_is_one_rule_beside_natural_frequencies(self):
        found = result_of("map", self.file(MODEL + FLOOR + PUSH + ONE + REQUIRED))
        self.assertEqual(sum(rule["kind"] == "clearance" for rule in found["rules"]), 1)
        self.assertEqual(len({rule["words"] for rule in found["rules"]}), len(found["rules"]))

    def test_clearances_without_requirements_hold_in_all_cases(self):
        text = MODEL + FLOOR + ONE + "[cases.heavy]\nbodies.m.mass = 80\n"
        found = result_of("map", self.file(text))
        places = [(k, c) for c in values(found["y"]) for k in values(found["x"])]
        for (k, c), stored in zip(places, found["grid"]["margin"]):
            self.assertAlmostEqual(stored / (GAP * k / (80 * G)), 1, delta=STORED)

    def test_own_limits_have_the_band_of_the_requirements(self):
        limits = 'limits = {"m.z" = "0.4 mm"}\n'
        response = '[analyses.response]\nband = ["9 Hz", "20 Hz"]\n'
        low = 'band = ["1 Hz", "6 Hz"]\n'
        own = result_of("map", self.file(MODEL + PUSH + ONE + limits + low + response))
        required = result_of("map", self.file(MODEL + PUSH + ONE + limits + response + "[requirements]\n" + low))
        self.assertEqual(own["band"], required["band"])
        self.assertEqual(own["grid"], required["grid"])
        of_response = result_of("map", self.file(MODEL + PUSH + ONE + limits + response))
        self.assertNotEqual(own["grid"], of_response["grid"])
        self.assertAlmostEqual(of_response["band"][0], 18 * math.pi, delta=1e-9)

    def test_each_line_of_a_mark_names_another_case(self):
        limits = 'limits = {"m.z" = "0.1 mm"}\nno_peak = "m"\n'
        cases = '[cases.soft]\nelements.s.stiffness_factor.z = 0.6\nbodies.m.mass = 80\n'
        required = '[requirements]\nhold_in = ["", "soft"]\n'
        found = result_of(
            "map", self.file(MODEL + FLOOR.replace("6 mm", "1 mm") + PUSH + ONE + limits + required + cases)
        )
        self.assertEqual(len({rule["words"] for rule in found["rules"]}), 6)
        base, soft = found["marks"]
        self.assertEqual(base["case"], "")
        self.assertEqual(len(set(base["words"])), 6)
        self.assertEqual(sum('in case "soft"' in line for line in base["words"]), 3, base["words"])
        self.assertEqual(len(set(soft["words"])), len(soft["words"]))
        self.assertNotIn("in case", str(soft["words"]))

    def test_a_case_is_not_charged_with_the_rules_of_another_case_on_the_map(self):
        required = (
            '[requirements]\nstatic = {"m.z" = "5 mm"}\nhold_in = ["", "heavy"]\n[cases.heavy]\nbodies.m.mass = 80\n'
        )
        ran = trivet("run", self.file(MODEL + ONE + required), "-o", self.folder / "out", "--strict")
        self.assertEqual(ran.returncode, 3, ran.stderr)
        self.assertRegex(ran.stdout, r"\n  base model +2 of 2 met ")
        self.assertRegex(ran.stdout, r"\n  heavy +2 of 2 VIOLATED ")
        self.assertIn("VIOLATED: 1 of 2 requirements, 1 of 2 verdicts of a map", ran.stdout)

    def test_case_whose_own_map_is_wrong_is_still_judged(self):
        heavy = '[cases.heavy]\nbodies.m.mass = 80\nanalyses.map.x.points = 1.5\n'
        found = result_of("map", self.file(MODEL + ONE + REQUIRED + 'hold_in = ["", "heavy"]\n' + heavy))
        places = [(k, c) for c in values(found["y"]) for k in values(found["x"])]
        for (k, c), stored in zip(places, found["grid"]["margin"]):
            self.assertAlmostEqual(stored / min(margin(k, c, M), margin(k, c, 80)), 1, delta=STORED)

    def test_case_without_the_numbers_of_the_map_is_named(self):
        lossy = "[cases.lossy]\nelements.s.damping = {loss_factor = 0.1}\n"
        done = trivet("map", self.file(MODEL + ONE + REQUIRED + 'hold_in = ["", "lossy"]\n' + lossy))
        self.assertEqual(done.returncode, 1)
        self.assertIn('case "lossy" has no number', done.stderr)
        done = trivet("map", self.file(MODEL + FLOOR + ONE + lossy))
        self.assertEqual(done.returncode, 0)
        self.assertIn('case "lossy" has no number', done.stderr)

    def test_free_motion_is_no_natural_frequency(self):
        # Two masses of 40 and 10 kg on a spring k between them, ω² = k (1/40 + 1/10), which a thread of 2e-8 N/m or
        # nothing holds: the verdict calls their common motion free.
        window = '[requirements]\nnatural_frequencies = {avoid = [["0 Hz", "5 Hz"]], separation = 1.2}\n'
        axes = (
            '[analyses.map]\nx = {parameter = "elements.k.translation.z", from = 1e5, to = 1e6, points = 3}\n'
            'y = {parameter = "bodies.n.mass", from = 8, to = 12, points = 3}\n'
        )
        for thread in ("2e-8", "0"):
            text = (
                'trivet = 1\n[bodies.m]\nmass = 40\nfree = ["z"]\n[bodies.n]\nmass = 10\nfree = ["z"]\n'
                '[elements.k]\ntype = "bushing"\non = "n"\nfrom = "m"\nat = [0, 0, 0]\ntranslation = [1, 1, 1e6]\n'
                f'[elements.thread]\ntype = "bushing"\non = "m"\nat = [0, 0, 0]\ntranslation = [1, 1, {thread}]\n'
            )
            found = result_of("map", self.file(text + axes + window))
            places = [(k, n) for n in values(found["y"]) for k in values(found["x"])]
            for (k, n), stored in zip(places, found["grid"]["margin"]):
                hertz = math.sqrt(k * (1 / 40 + 1 / n)) / (2 * math.pi)
                self.assertAlmostEqual(stored / (hertz / 5), 1, delta=STORED)
            judged = result_of("verdict", self.file(text + window))["cases"][0]["requirements"]
            self.assertAlmostEqual(
                found["marks"][0]["margin"] / min(r["margin"] or math.inf for r in judged), 1, delta=STORED
            )

    def test_text_has_the_units_of_the_display(self):
        rules = 'band = ["1 Hz", "9 Hz"]\nlimits = {"m.z" = "2.4 mm/s"}\n'
        text = trivet("map", self.file(MODEL + PUSH + ONE + rules)).stdout
        self.assertIn("amplitudes over 1 … 9 Hz", text)
        self.assertIn("m.z ≤ 1.697 mm/s rms", text)  # 2.4/√2
        self.assertNotIn("rad/s", text)
        in_rad = self.file(MODEL + PUSH + ONE + rules.replace(" Hz", " rad/s"))
        self.assertIn("amplitudes over 0.159155 … 1.43239 Hz", trivet("map", in_rad).stdout)
        self.assertIn("amplitudes over 1 … 9 rad/s", trivet("map", in_rad, "--set", "display.frequency=rad/s").stdout)

    def test_requirement_that_cannot_be_judged_is_no_result(self):
        moving = '[excitations.w]\ntype = "time"\non = "m"\nat = [0, 0, 0]\nforce = [0, 0, 1]\nhistory = {half_sine = {amplitude = 5, duration = "11 ms"}}\n'
        text = MODEL.replace("{translation = [0, 0, 400]}", "{loss_factor = 0.1}").split("[parameters.damper]")[0]
        mass = '[parameters.mass]\npath = "bodies.m.mass"\nfrom = 20\nto = 80\n'
        axes = ONE.replace('"damper"', '"mass"')
        done = trivet("map", self.file(text + mass + moving + axes + '[requirements]\nlargest = {"m.z" = "1 mm"}\n'))
        self.assertEqual(done.returncode, 1)
        self.assertIn("none of the 63 designs could be computed", done.stderr)

    def test_picture_has_a_panel_for_each_pair(self):
        project, picture = self.file(MODEL + PAIRS + REQUIRED), self.folder / "maps.svg"
        trivet("map", project, "--picture", picture)
        texts = [t.text or "" for t in xml.etree.ElementTree.parse(picture).iter("{http://www.w3.org/2000/svg}text")]
        self.assertEqual(sum("% feasible" in text for text in texts), 3)
        self.assertIn("Rule with the least margin", texts)
        trivet("run", project, "-o", self.folder / "out")
        self.assertTrue(list((self.folder / "out").glob("*/map.svg")))
        self.assertIn("stiffness and mass", (self.folder / "out/report.html").read_text())


if __name__ == "__main__":
    unittest.main()
