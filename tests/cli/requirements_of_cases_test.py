# SPDX-License-Identifier: BSD-3-Clause
"""Requirements and limits that only a case has are judged in it, by every command."""
import json
import math
import re
import unittest

from trivet_test import InTemporaryFolder, trivet

DONE, OVER_A_LIMIT = 0, 3
MASS, STIFFNESS, DASHPOT, G = 40.0, 2.5e5, 400.0, 9.80665
MACHINE = f"""trivet = 1
gravity = [0, 0, -{G}]
[bodies.m]
mass = {MASS}
free = ["z"]
[elements.s]
type = "bushing"
on = "m"
at = [0, 0, 0]
translation = [1, 1, {STIFFNESS}]
damping = {{translation = [1e-3, 1e-3, {DASHPOT}]}}
[excitations.rotor]
type = "unbalance"
on = "m"
at = [0, 0, 0]
axis = "x"
mass_eccentricity = 0.001
"""
RATIO = DASHPOT / (2 * math.sqrt(STIFFNESS * MASS))
PEAK = 0.001 / MASS / (2 * RATIO * math.sqrt(1 - RATIO**2))  # of the mass under the unbalance
WINTER = "[cases.winter]\n"
REQUIRED = WINTER + 'requirements.limits = {"m.z" = "0.05 mm"}\n'  # below the peak


class RequirementsOfCases(InTemporaryFolder):
    def code(self, command, text, *arguments):
        return trivet(command, self.file(MACHINE + text), *arguments).returncode

    def cases(self, text):
        done = trivet("verdict", self.file(MACHINE + text), "--json")
        self.assertEqual(done.returncode, DONE, done.stderr)
        return json.loads(done.stdout)

    def test_a_violated_requirement_of_a_case_alone_is_violated(self):
        found = self.cases(REQUIRED)
        self.assertFalse(found["met"])
        base, winter = found["cases"]
        self.assertEqual((base["requirements"], winter["decides"], winter["met"]), ([], True, False))
        self.assertAlmostEqual(winter["requirements"][0]["value"] / PEAK, 1, 9)
        path = self.file(MACHINE + REQUIRED)
        strict = trivet("verdict", path, "--strict")
        self.assertEqual(strict.returncode, OVER_A_LIMIT)
        self.assertIn("1 requirement violated", strict.stderr)
        self.assertIn("Base model: nothing to judge", strict.stdout)
        self.assertIn("Case winter: VIOLATES its requirements, 0 of 1 requirements met", strict.stdout)

    def test_run_and_its_report_judge_it(self):
        path, target = self.file(MACHINE + REQUIRED), self.folder / "out"
        run = trivet("run", path, "-o", target, "--strict")
        self.assertEqual(run.returncode, OVER_A_LIMIT, run.stderr)
        self.assertTrue(run.stdout.startswith("VIOLATED: 1 of 1 requirement"), run.stdout)
        report = (target / "report.html").read_text()
        self.assertTrue("✗ VIOLATED: 1 of 1 requirement" in report)
        words = " ".join(re.sub("<[^>]*>", "", report).split())
        self.assertTrue("Case winter violates m.z" in words)
        self.assertFalse("✓ MET" in words)
        base, winter = json.loads((target / "results.json").read_text())["cases"]
        self.assertIsNone(base.get("verdict"))
        self.assertEqual((winter["verdict"]["decides"], winter["verdict"]["met"]), (True, False))

    def test_check_names_verdict_for_it(self):
        done = trivet("check", self.file(MACHINE + REQUIRED))
        self.assertIn("Not judged here: requirements and limits, in all cases", done.stdout)

    def test_limits_and_limits_at_a_speed_of_a_case_alone_are_judged(self):
        for text in (
            'analyses.response = {of = ["m.z"], band = ["1 Hz", "40 Hz"]}\nlimits = {"m.z" = "0.05 mm"}\n',
            'operation = {speeds = "750 rpm", limits = {"m.z" = "0.05 mm"}}\n',
        ):
            for command in (("verdict",), ("run", "-o", self.folder / "out")):
                self.assertEqual(self.code(command[0], WINTER + text, "--strict", *command[1:]), OVER_A_LIMIT, text)
            met = text.replace("0.05 mm", "5 mm").replace("750 rpm", "300 rpm")
            self.assertEqual(self.code("verdict", WINTER + met, "--strict"), DONE, met)

    def test_a_limit_of_the_file_holds_in_every_case(self):
        """`verdict`, `run` and the report count the same; the case alone violates the limit."""
        limit = '[analyses]\nresponse = {of = ["m.z"], band = ["1 Hz", "40 Hz"]}\n[limits]\n'
        limit += f'"m.z" = "{1e3 * PEAK * 1.01} mm"\n'
        weak = WINTER + f"elements.s.damping.translation.z = {DASHPOT / 2}\n"
        path, target = self.file(MACHINE + limit + weak), self.folder / "out"
        for done in (trivet("verdict", path, "--strict"), trivet("run", path, "-o", target, "--strict")):
            self.assertEqual(done.returncode, OVER_A_LIMIT, done.stdout + done.stderr)
        base, winter = self.cases(limit + weak)["cases"]
        self.assertEqual((base["decides"], base["met"]), (True, True))
        self.assertEqual((winter["decides"], winter["met"]), (True, False))
        self.assertIn("Case winter violates", re.sub("<[^>]*>", "", (target / "report.html").read_text()))
        # The project says otherwise.
        base_alone = limit + '[requirements]\nhold_in = [""]\n' + weak
        self.assertEqual(self.code("verdict", base_alone, "--strict"), DONE)
        self.assertEqual(self.code("run", base_alone, "--strict", "-o", target), DONE)

    def test_a_case_that_is_a_point_of_a_map_is_judged_there(self):
        limit = '[analyses]\nresponse = {of = ["m.z"], band = ["1 Hz", "40 Hz"]}\n'
        axes = "map = {x = {parameter = 'elements.s.scale', from = 0.9, to = 1.1}, "
        axes += "y = {parameter = 'bodies.m.mass', from = 35, to = 45}}\n"
        text = limit + axes + '[limits]\n"m.z" = "1 m"\n' + WINTER
        stiffer = trivet("map", self.file(MACHINE + text + "elements.s.scale = 1.05\n"), "--strict", "--points", "5")
        self.assertEqual(stiffer.returncode, DONE, stiffer.stderr)
        other = trivet(
            "map", self.file(MACHINE + text + "elements.s.stiffness_factor = {z = 1.1}\n"), "--json", "--points", "5"
        )
        words = [rule["words"] for rule in json.loads(other.stdout)["rules"]]
        self.assertEqual(len(words), 2, words)
        self.assertTrue(any("winter" in one for one in words), words)

    def test_hold_in_alone_is_no_requirement(self):
        done = trivet("verdict", self.file(MACHINE + '[requirements]\nhold_in = [""]\n'))
        self.assertEqual(done.returncode, 2)
        self.assertIn("neither requirements nor limits nor clearances", done.stderr)

    def test_hold_in_still_decides(self):
        base = '[requirements]\nlimits = {"m.z" = "5 mm"}\n'
        own = base + WINTER + 'requirements.limits = {"m.z" = "0.05 mm"}\n'
        self.assertEqual(self.code("verdict", own, "--strict"), DONE)  # documented: the base model alone has to hold
        self.assertFalse(self.cases(own)["cases"][1]["decides"])
        self.assertEqual(
            self.code("verdict", own.replace("5 mm\"}", "5 mm\"}\nhold_in = [\"winter\"]", 1), "--strict"), 3
        )
        self.assertEqual(self.code("verdict", own + 'requirements.hold_in = ["winter"]\n', "--strict"), OVER_A_LIMIT)
        self.assertEqual(self.code("verdict", REQUIRED + 'requirements.hold_in = [""]\n', "--strict"), DONE)

    def test_searches_and_maps_judge_it(self):
        parameters = "[parameters.stiffness]\npath = 'elements.s.scale'\nfrom = 0.5\nto = 2\n"
        done = trivet("optimize", self.file(MACHINE + parameters + REQUIRED), "--json")
        self.assertEqual(done.returncode, DONE, done.stderr)
        found = json.loads(done.stdout)
        self.assertEqual([len(case["after"]["requirements"]) for case in found["cases"]], [0, 1])
        self.assertFalse(found["feasible"])
        axes = "x = {parameter = 'elements.s.scale', from = 0.9, to = 1.1}, y = {parameter = 'bodies.m.mass', "
        axes += "from = 35, to = 45}"
        rule = 'limits = {"m.z" = "5 mm"}'
        text = MACHINE + f"[analyses]\nmap = {{{axes}, {rule}}}\n" + WINTER + "requirements.damping_ratio = 0.5\n"
        mapped = trivet("map", self.file(text), "--strict", "--points", "5")  # ζ is 0.06
        self.assertEqual(mapped.returncode, OVER_A_LIMIT, mapped.stdout + mapped.stderr)
        self.assertIn("Feasible: 0.00 % of the map", mapped.stdout)

    def test_one_case_is_judged_alone(self):
        text = '[requirements]\nlimits = {"m.z" = "5 mm"}\n' + WINTER + 'requirements.limits = {"m.z" = "0.05 mm"}\n'
        path, target = self.file(MACHINE + text), self.folder / "out"
        self.assertEqual(trivet("verdict", path, "--strict").returncode, DONE)  # hold_in names the base model alone
        alone = trivet("verdict", path, "--case", "winter", "--strict")
        self.assertEqual(alone.returncode, OVER_A_LIMIT)
        self.assertIn("Case winter: VIOLATES its requirements, 0 of 1 requirements met", alone.stdout)
        self.assertNotIn("Base model", alone.stdout)
        self.assertNotIn("not binding", alone.stdout)
        (case,) = json.loads(trivet("verdict", path, "--case", "winter", "--json").stdout)["cases"]
        self.assertEqual((case["case"], case["decides"], case["met"]), ("winter", True, False))
        run = trivet("run", path, "--case", "winter", "-o", target, "--strict")
        self.assertEqual(run.returncode, OVER_A_LIMIT, run.stderr)
        (case,) = json.loads((target / "results.json").read_text())["cases"]
        self.assertEqual((case["name"], case["verdict"]["decides"]), ("winter", True))
        check = trivet("check", path, "--case", "winter").stdout
        self.assertIn("Case winter\n", check)
        self.assertNotIn("Base model", check)
        self.assertIn(f"trivet verdict {path} --case winter", check)
        wrong = trivet("verdict", path, "--case", "wnter")
        self.assertEqual(wrong.returncode, 2)
        self.assertIn('did you mean "winter"?', wrong.stderr)

    def test_a_search_for_all_cases_refuses_one(self):
        for command in ("optimize", "select"):
            refused = trivet(command, self.file(MACHINE + REQUIRED), "--case", "winter")
            self.assertEqual(refused.returncode, 2)
            self.assertIn("one design is sought for all cases in which it has to hold", refused.stderr)
            self.assertIn("requirements.hold_in names them", " ".join(trivet(command, "--help").stdout.split()))


if __name__ == "__main__":
    unittest.main()
