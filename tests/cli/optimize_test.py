# SPDX-License-Identifier: BSD-3-Clause
"""`trivet optimize` against optima in closed form."""
import json
import math
import unittest

from trivet_test import SOURCE, InTemporaryFolder, result_of, trivet

# A search stops at steps of 1e-10 of a range; at a smooth maximum of a margin this leaves half of the digits of a place.
PLACE, OBJECTIVE = 1e-6, 1e-9
M, G = 40.0, 9.80665

OSCILLATOR = f"""trivet = 1
gravity = [0, 0, -{G}]
[bodies.m]
mass = {M}
free = ["z"]
[elements.s]
type = "bushing"
on = "m"
at = [0, 0, 0]
translation = [1, 1, 1e5]
damping = {{translation = [1e-3, 1e-3, 400]}}
[excitations.f]
type = "harmonic"
on = "m"
at = [0, 0, 0]
force = [0, 0, 30]
[parameters.stiffness]
path = "elements.s.translation.z"
from = "20 N/mm"
to = "500 N/mm"
spacing = "logarithmic"
"""

# A mass on a spring, with an absorber on a spring and a damper.
ABSORBER = """trivet = 1
[bodies.main]
mass = 100
free = ["z"]
[bodies.absorber]
mass = 5
free = ["z"]
position = [0, 0, 0.5]
[elements.spring]
type = "three_springs"
on = "main"
at = [0, 0, 0]
translation = [1e5, 1e5, 1e5]
[elements.tuned]
type = "three_springs"
on = "absorber"
from = "main"
at = [0, 0, 0]
translation = [1e4, 1e4, 5e3]
damping = {translation = [0, 0, 30]}
[excitations.f]
type = "harmonic"
on = "main"
at = [0, 0, 0]
force = [0, 0, 1]
[parameters.stiffness]
path = "elements.tuned.translation.z"
from = 1e3
to = 1e4
[parameters.damper]
path = "elements.tuned.damping.translation.z"
from = 1
to = 200
"""


class Optimize(InTemporaryFolder):
    def optimum(self, text):
        if "[analyses.optimize]" not in text:
            text += "[analyses.optimize]\nstarts = 4\n"
        found = result_of("optimize", self.file(text))
        return found, {p["name"]: p["optimum"] for p in found["parameters"]}

    def test_absorber_with_the_lowest_peaks(self):
        # Nishihara and Asami, J. Vib. Acoust. 124 (2002): exact, unlike the rule of the fixed points.
        mu = 0.05
        root = math.sqrt(4 + 3 * mu)
        tuning = (
            2
            / (1 + mu)
            * math.sqrt(2 * (16 + 23 * mu + 9 * mu**2 + 2 * (2 + mu) * root) / (3 * (64 + 80 * mu + 27 * mu**2)))
        )
        ratio = math.sqrt((8 + 9 * mu - 4 * root) / (1 + mu)) / 4
        omega = tuning * math.sqrt(1e5 / 100)
        found, best = self.optimum(
            ABSORBER
            + '[analyses.response]\nband = ["0.1 Hz", "20 Hz"]\n[analyses.optimize]\nminimize = "main.z"\nstarts = 4\n'
        )
        self.assertAlmostEqual(best["stiffness"] / (5 * omega**2), 1, delta=PLACE)
        self.assertAlmostEqual(best["damper"] / (2 * ratio * 5 * omega), 1, delta=PLACE)
        self.assertLess(found["residual"], PLACE)
        self.assertGreaterEqual(found["agreeing"], 3)
        self.assertAlmostEqual(found["active"][0]["multiplier"], 1, delta=PLACE)
        # The two peaks of the optimum have one height.
        settings = [
            f"elements.tuned.translation.z={best['stiffness']!r}",
            f"elements.tuned.damping.translation.z={best['damper']!r}",
        ]
        peaks = json.loads(
            trivet(
                "peaks",
                self.file(ABSORBER),
                "--json",
                *(x for s in settings for x in ("--set", s)),
            ).stdout
        )["peaks"]
        heights = [p["amplitude"] for p in peaks if p["name"] == "main.z"]
        self.assertEqual(len(heights), 2)
        self.assertAlmostEqual(heights[0] / heights[1], 1, delta=PLACE)
        self.assertAlmostEqual(max(heights) / found["after"], 1, delta=OBJECTIVE)

    # Sag m g/k ≤ s pulls the stiffness up, a natural frequency below a window pulls it down.
    SAG, WINDOW = 5e-3, 2 * math.pi * 12

    def between(self, sag):
        k = (self.WINDOW * M**1.5 * G / sag) ** (2 / 3)
        return k, sag * k / (M * G)

    def test_two_requirements_in_balance(self):
        k, margin = self.between(self.SAG)
        found, best = self.optimum(
            OSCILLATOR
            + f'[requirements]\nstatic = {{"m.z" = {self.SAG}}}\nnatural_frequencies = {{avoid = [["12 Hz", "80 Hz"]]}}\n'
        )
        self.assertGreater(margin, 1)
        self.assertTrue(found["feasible"])
        self.assertAlmostEqual(best["stiffness"] * 1e3 / k, 1, delta=PLACE)
        self.assertAlmostEqual(found["after"] / margin, 1, delta=OBJECTIVE)
        # ln of the margins rises with ln k by 1 and falls by 1/2: multipliers 1/3 and 2/3.
        multipliers = {a["requirement"]: a["multiplier"] for a in found["active"]}
        self.assertAlmostEqual(multipliers["at rest m.z ≤ 5 mm"], 1 / 3, delta=PLACE)
        self.assertAlmostEqual(multipliers["no natural frequency in 12 … 80 Hz"], 2 / 3, delta=PLACE)
        self.assertEqual(found["conflicts"], [])
        self.assertEqual(found["differenced"], [])  # the sag has its adjoint
        self.assertEqual(found["looked_at"], 100000)
        self.assertRegex(
            found["families"][0], r"^a sum of \d+ terms from \d+ assembled designs, compared with 24 others"
        )
        self.assertEqual(found["no_families"], [])

    def test_a_case_that_sets_a_number_of_a_parameter_is_named_by_check_and_run(self):
        text = """trivet = 1
[bodies.m]
mass = 10
free = ["z"]
[elements.k]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [0, 0, 4000]
[parameters.spring]
path = "elements.k.scale"
from = 0.5
to = 2
[requirements]
natural_frequencies = {avoid = [["3 Hz", "4 Hz"]]}
hold_in = HOLD
[cases.cold]
elements.k.scale = 1.5
"""
        words = 'case "cold" sets elements.k.scale, which the parameter "spring" moves'
        held = self.file(text.replace("HOLD", '["", "cold"]'))
        self.assertIn(words, trivet("optimize", held).stderr)
        freed = self.file(text.replace("HOLD", '[""]'), "freed.toml")
        for command in (["check"], ["run", "--output", self.folder / "out"]):
            for project, named in ((held, True), (freed, False)):
                done = trivet(*command, project)
                shown = " ".join((done.stdout + done.stderr).split())
                self.assertEqual(words in shown, named, shown)

    def test_cases_without_a_family_are_named(self):
        laws = OSCILLATOR.replace(
            "damping = {translation = [1e-3, 1e-3, 400]}", "damping = {maxwell = {ratios = [0.4], times = [0.005]}}"
        )
        found, _ = self.optimum(
            laws
            + f'[requirements]\nstatic = {{"m.z" = {self.SAG}}}\nnatural_frequencies = {{avoid = [["12 Hz", "80 Hz"]]}}\n'
        )
        self.assertEqual(found["families"], [])
        self.assertEqual(found["no_families"], ["coordinates without mass"])
        self.assertEqual(found["looked_at"], 0)
        self.assertEqual(found["differenced"], [])

    def test_slopes_by_differences_are_listed_with_their_number(self):
        found, best = self.optimum(
            OSCILLATOR
            + '[excitations.t]\ntype = "time"\non = "m"\nat = [0, 0, 0]\nforce = [0, 0, 1]\n'
            + 'history = {half_sine = {amplitude = 100, duration = "11 ms"}}\n'
            + '[requirements]\nlargest = {"m.z" = "0.1 mm"}\n[analyses.optimize]\nstarts = 1\n'
        )
        (largest,) = found["differenced"]
        self.assertEqual(largest["requirement"], "largest")
        # Four or five models per gradient, for one parameter.
        self.assertGreaterEqual(largest["evaluations"], 4)
        self.assertLess(largest["evaluations"], 5 * found["designs"])

    def test_requirements_that_contradict_each_other(self):
        sag = 1e-3
        k, margin = self.between(sag)
        self.assertLess(margin, 1)
        found, best = self.optimum(
            OSCILLATOR
            + f'[requirements]\nstatic = {{"m.z" = {sag}}}\ndamping_ratio = 1e-3\n'
            + 'natural_frequencies = {avoid = [["12 Hz", "80 Hz"]]}\n'
        )
        self.assertFalse(found["feasible"])
        self.assertAlmostEqual(best["stiffness"] * 1e3 / k, 1, delta=PLACE)
        conflicts = {c["requirement"]: c for c in found["conflicts"]}
        self.assertEqual(set(conflicts), {"at rest m.z ≤ 1 mm", "no natural frequency in 12 … 80 Hz"})
        for conflict in conflicts.values():
            self.assertAlmostEqual(conflict["factor"] * margin, 1, delta=OBJECTIVE)
        # Without the sag the softest spring, without the window the stiffest one is best.
        self.assertAlmostEqual(
            conflicts["at rest m.z ≤ 1 mm"]["without"],
            self.WINDOW / math.sqrt(2e4 / M),
            delta=PLACE,
        )
        self.assertAlmostEqual(
            conflicts["no natural frequency in 12 … 80 Hz"]["without"],
            sag * 5e5 / (M * G),
            delta=PLACE,
        )

    def test_limit_holds_while_another_result_is_made_small(self):
        # Force on the ground at 60 Hz falls with the stiffness until the sag allows no less.
        found, best = self.optimum(
            OSCILLATOR
            + f'[analyses.response]\nband = ["60 Hz", "61 Hz"]\n[requirements]\nstatic = {{"m.z" = {self.SAG}}}\n'
            + '[analyses.optimize]\nminimize = "ground.force.z"\nstarts = 4\n'
        )
        k, w, c = M * G / self.SAG, 2 * math.pi * 60, 400
        self.assertAlmostEqual(best["stiffness"] * 1e3 / k, 1, delta=PLACE)
        force = 30 * math.hypot(k, c * w) / math.hypot(k - M * w * w, c * w)
        self.assertAlmostEqual(found["after"] / force, 1, delta=PLACE)
        self.assertIn("at rest m.z ≤ 5 mm", [a["requirement"] for a in found["active"]])

        multipliers = {a["requirement"]: a["multiplier"] for a in found["active"]}
        relaxed = lambda sag: 30 * math.hypot(M * G / sag, c * w) / math.hypot(M * G / sag - M * w * w, c * w)
        h = 1e-4
        rate = math.log(relaxed(self.SAG * (1 - h)) / relaxed(self.SAG * (1 + h))) / (2 * h)
        self.assertAlmostEqual(multipliers["at rest m.z ≤ 5 mm"], rate, delta=PLACE)
        self.assertEqual(
            [a["requirement"] for a in found["active"] if a["minimized"]],
            ["the largest amplitude of ground.force.z"],
        )
        [one] = found["minimized"]
        self.assertEqual((one["name"], one["unit"]), ("ground.force.z", "N"))
        self.assertAlmostEqual(one["after"] / found["after"], 1, delta=OBJECTIVE)

    def damper(self, least, most):
        """The oscillator with its damper as the parameter."""
        text = OSCILLATOR.replace('path = "elements.s.', 'path = "elements.s.damping.')
        old = 'from = "20 N/mm"\nto = "500 N/mm"\nspacing = "logarithmic"'
        return text.replace(old, f"from = {least}\nto = {most}")

    def test_requirements_come_first_if_they_cannot_be_met(self):
        k, margin = self.between(1e-3)
        found, best = self.optimum(
            OSCILLATOR
            + '[analyses.response]\nband = ["60 Hz", "61 Hz"]\n[requirements]\nstatic = {"m.z" = 1e-3}\n'
            + 'natural_frequencies = {avoid = [["12 Hz", "80 Hz"]]}\n'
            + '[analyses.optimize]\nminimize = "ground.force.z"\nstarts = 4\n'
        )
        self.assertEqual((found["falls_short"], found["feasible"], found["objective"]), (True, False, "margin"))
        self.assertAlmostEqual(best["stiffness"] * 1e3 / k, 1, delta=PLACE)
        self.assertAlmostEqual(found["after"] / margin, 1, delta=OBJECTIVE)
        self.assertEqual(len(found["conflicts"]), 2)

    def test_peak_above_its_tolerance(self):
        # p of a damped mass, by its transfer function: 1/(2ζ √(1 − ζ²)) − 1 over its value at rest.
        text = self.damper(300, 600)
        found, best = self.optimum(text + '[requirements]\nno_peak = "m.z"\n')
        zeta = 600 / (2 * math.sqrt(1e5 * M))
        p, a = 1 / (2 * zeta * math.sqrt(1 - zeta**2)) - 1, 0.01
        self.assertAlmostEqual(best["stiffness"], 600, delta=PLACE)
        [conflict] = found["conflicts"]
        self.assertAlmostEqual(conflict["factor"] / (p / a), 1, delta=PLACE)
        self.assertIsNone(conflict["without"])
        self.assertAlmostEqual(found["active"][0]["multiplier"], a / (1 + a), delta=PLACE)
        self.assertIn(
            "This requirement cannot be met",
            trivet("optimize", self.file(text + '[requirements]\nno_peak = "m.z"\n')).stdout,
        )

    def test_optimum_beside_invalid_models(self):
        # Above resonance the least damping is best, and below none the file is rejected.
        found, best = self.optimum(
            self.damper(-400, 1000)
            + '[analyses.response]\nband = ["60 Hz", "61 Hz"]\n'
            + '[analyses.optimize]\nminimize = "ground.force.z"\nstarts = 4\n'
        )
        self.assertGreaterEqual(best["stiffness"], 0)
        self.assertLess(best["stiffness"], 5)
        self.assertGreater(found["failed"], 0)
        self.assertFalse(found["parameters"][0]["idle"])
        self.assertEqual(found["no_slopes"], "")
        # Held by nothing that the search knows; ln of the force √(k² + c²ω²)/√((k − mω²)² + c²ω²) is even in c.
        k, square, c = 1e5, (2 * math.pi * 60) ** 2, best["stiffness"]
        slope = 1400 * c * square * (1 / k**2 - 1 / (k - M * square) ** 2)
        self.assertAlmostEqual(found["residual"], min(1, slope / 1e-2), delta=1e-6)

    def test_lone_valid_design_has_no_slopes(self):
        # One damper rises as the other falls below zero: only the given design, without both, is valid.
        text = OSCILLATOR.replace("1e-3, 400]", "1e-3, 0]") + '[elements.t]\ntype = "bushing"\non = "m"\n'
        text += "at = [0, 0, 0]\ntranslation = [1, 1, 1]\ndamping = {translation = [1e-3, 1e-3, 0]}\n"
        text = text.replace(
            'path = "elements.s.translation.z"',
            "path = {'elements.s.damping.translation.z' = 1, 'elements.t.damping.translation.z' = -1}",
        )
        text = text.replace('from = "20 N/mm"\nto = "500 N/mm"\nspacing = "logarithmic"', "from = -1\nto = 1")
        text += f'[requirements]\nstatic = {{"m.z" = {self.SAG}}}\n'
        found, best = self.optimum(text)
        self.assertEqual(best["stiffness"], 0)
        self.assertNotEqual(found["no_slopes"], "")
        self.assertEqual((found["residual"], found["active"], found["parameters"][0]["idle"]), (None, [], False))
        self.assertIn("What holds the optimum is not known", trivet("optimize", self.file(text)).stdout)

    def test_idle_parameter_keeps_its_value(self):
        text = OSCILLATOR + '[parameters.side]\npath = "elements.s.translation.x"\nfrom = 0.5\nto = 5\n'
        found, best = self.optimum(
            text
            + f'[requirements]\nstatic = {{"m.z" = {self.SAG}}}\nnatural_frequencies = {{avoid = [["12 Hz", "80 Hz"]]}}\n'
        )
        self.assertEqual(best["side"], 1)
        self.assertEqual([p["idle"] for p in found["parameters"]], [False, True])

    def test_optimum_on_a_window_meets_it_in_the_written_file_too(self):
        text = OSCILLATOR + '[requirements]\nnatural_frequencies = {avoid = [["12 Hz", "80 Hz"]]}\n'
        text += '[analyses.optimize]\nminimize = {static = ["m.z"]}\nstarts = 4\n'
        project = self.file(text)
        written = project.parent / "best.toml"
        found = result_of("optimize", project)
        self.assertAlmostEqual(found["parameters"][0]["optimum"] * 1e3 / (M * (24 * math.pi) ** 2), 1, delta=PLACE)
        self.assertTrue(found["feasible"])
        self.assertEqual(trivet("optimize", project, "--write", str(written)).returncode, 0)
        window = result_of("verdict", written)["cases"][0]["requirements"][0]
        self.assertEqual((window["met"], window["margin"]), (True, 1))

    def test_it_holds_in_every_case_named(self):
        text = OSCILLATOR + f"[cases.heavy]\nbodies.m.mass = {2 * M}\n"
        text += f'[requirements]\nhold_in = ["", "heavy"]\nstatic = {{"m.z" = {self.SAG}}}\n'
        text += 'natural_frequencies = {avoid = [["12 Hz", "80 Hz"]]}\n'
        found, best = self.optimum(text)
        # The sag of the heavy one, the frequency of the light one: s k/(2 m g) = w √(m/k).
        k = (self.WINDOW * 2 * M**1.5 * G / self.SAG) ** (2 / 3)
        self.assertAlmostEqual(best["stiffness"] * 1e3 / k, 1, delta=PLACE)
        self.assertEqual([c["case"] for c in found["cases"]], ["", "heavy"])
        overruled = self.file(text.replace("bodies.m.mass = 80.0", 'elements.s.translation.z = "70 N/mm"'))
        self.assertIn(
            'case "heavy" sets elements.s.translation.z',
            trivet("optimize", overruled).stderr,
        )

    def test_parameter_with_factors_moves_places_together(self):
        feet = (
            OSCILLATOR.split("[parameters")[0]
            .replace('free = ["z"]', 'free = ["z", "rx"]')
            .replace(
                f"mass = {M}",
                f'mass = {M}\ninertia = {{about = "center_of_mass", xx = 3, yy = 3, zz = 3}}',
            )
        )
        foot = '[elements.{0}]\ntype = "bushing"\non = "m"\nat = [0, {1}, 0]\ntranslation = [1, 1, 5e4]\n'
        text = feet + foot.format("left", 0.2) + foot.format("right", -0.2)
        text += "[parameters.spread]\npath = {'elements.left.at.y' = 1, 'elements.right.at.y' = -1}\n"
        text += 'from = "400 mm"\nto = "600 mm"\n[requirements]\nnatural_frequencies = {separation = 1.2}\n'
        found, best = self.optimum(text)
        # The rotation is the faster motion here, √(2 k y²/J) over √((2 k + 1e5)/m): as far apart as possible.
        self.assertAlmostEqual(best["spread"], 600, delta=PLACE)
        self.assertTrue(found["parameters"][0]["at_bound"])
        wide = text.replace("at = [0, 0.2, 0]", "at = [0, 0.6, 0]").replace("at = [0, -0.2, 0]", "at = [0, -0.6, 0]")
        modes = [m["angular_frequency"] for m in result_of("modes", self.file(wide))["modes"]]
        for one, other in zip(found["cases"][0]["angular_frequencies_after"], modes):
            self.assertAlmostEqual(one / other, 1, delta=OBJECTIVE)

    def test_map_takes_parameters_as_axes(self):
        rules = 'limits = {"m.z" = "1 mm"}}\n'
        axis = '{parameter = "elements.s.translation.z", from = "20 N/mm", to = "500 N/mm", spacing = "logarithmic", points = 5}'
        mass = '{parameter = "bodies.m.mass", from = 20, to = 60, points = 4}'
        named = '{parameter = "stiffness", points = 5}'
        margins = []
        for x in (axis, named):
            project = self.file(OSCILLATOR + f"[analyses]\nmap = {{x = {x}, y = {mass}, {rules}")
            margins.append(result_of("map", project)["grid"]["margin"])
        self.assertEqual(margins[0], margins[1])

    def test_search_is_the_same_in_every_run(self):
        project = self.file(
            ABSORBER
            + '[analyses.response]\nband = ["0.1 Hz", "20 Hz"]\n[analyses.optimize]\nminimize = "main.z"\nstarts = 3\n'
        )
        runs = [trivet("optimize", project, "--json").stdout for _ in range(2)]
        self.assertEqual(*runs)
        # The settings that the text ends with are the optimum.
        best = {place["path"]: p["optimum"] for p in json.loads(runs[0])["parameters"] for place in p["places"]}
        text = trivet("optimize", project).stdout
        settings = dict(
            line[len("--set '") : -1].split(" = ") for line in text.splitlines() if line.startswith("--set ")
        )
        self.assertEqual(set(settings), set(best))
        for path, value in settings.items():
            self.assertAlmostEqual(float(value) / best[path], 1, delta=1e-11)

    def test_example_decouples_the_powertrain(self):
        project = str(SOURCE / "examples/powertrain/decoupled.toml")
        found = result_of("optimize", project)
        self.assertLess(found["before"], 1)
        self.assertTrue(found["feasible"])
        self.assertLess(found["residual"], 1e-4)
        settings = []
        for p in found["parameters"]:
            for place in p["places"]:
                value = p["optimum"] * place["factor"]
                settings += [
                    "--set",
                    f'{place["path"]}="{value!r} {p["unit"]}"' if p["unit"] else f'{place["path"]}={value!r}',
                ]
        judged = json.loads(trivet("verdict", project, "--json", *settings).stdout)
        least = min(r["margin"] for r in judged["cases"][0]["requirements"])
        self.assertAlmostEqual(least / found["after"], 1, delta=PLACE)

    def test_hopeless_searches_are_refused(self):
        undamped = OSCILLATOR.replace("damping = {translation = [1e-3, 1e-3, 400]}\n", "")
        said = trivet(
            "optimize",
            self.file(undamped + '[requirements]\nlimits = {"m.z" = "1 mm"}\n'),
        )
        self.assertEqual(said.returncode, 1)
        self.assertIn('the margin of "m.z ≤ 1 mm" is 0 in every design', said.stderr)
        still = self.file(OSCILLATOR + '[analyses.optimize]\nminimize = "s.force.x"\n')
        self.assertIn("zero in every design", trivet("optimize", still).stderr)
        unbounded = self.file(undamped + '[analyses.optimize]\nminimize = "m.z"\n')
        self.assertIn("the largest amplitude of m.z is unbounded", trivet("optimize", unbounded).stderr)
        for words, said in (
            ('["m.z", "ground.force.z"]', "different units"),
            ('["m.z", "m.z"]', "named twice"),
        ):
            mixed = self.file(OSCILLATOR + f"[analyses.optimize]\nminimize = {words}\n")
            self.assertIn(said, trivet("optimize", mixed).stderr)

    def test_nothing_to_meet_is_refused(self):
        project = self.file(OSCILLATOR)
        self.assertIn("neither requirements nor limits", trivet("optimize", project).stderr)
        bare = self.file(OSCILLATOR.split("[parameters")[0] + "[requirements]\ndamping_ratio = 0.1\n")
        self.assertIn("no parameters", trivet("optimize", bare).stderr)


if __name__ == "__main__":
    unittest.main()
