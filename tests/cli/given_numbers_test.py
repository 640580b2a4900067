# SPDX-License-Identifier: BSD-3-Clause
"""Input of a user has an effect or causes a message: numbers of the command line, analyses, excitations, points,
columns."""
import json
import unittest

from trivet_test import InTemporaryFolder, result_of, trivet

MACHINE = """trivet = 1
[bodies.machine]
mass = 100
inertia = {about = "center_of_mass", xx = 4, yy = 4, zz = 4}
points.seat = [0.1, 0, 0.2]
[elements.mount]
type = "bushing"
on = "machine"
at = [0, 0, 0]
translation = [1e5, 1e5, 1e5]
rotation = [1e4, 1e4, 1e4]
damping = {proportional = 0.001}
[excitations.push]
type = "harmonic"
on = "machine"
at = [0, 0, 0]
force = [0, 0, 100]
"""
CASES = """[cases.stiff]
elements.mount.scale = 4
[cases.other]
elements.mount.damping = {loss_factor = 0.1}
"""


class OrderOfChanges(InTemporaryFolder):
    def lowest(self, *arguments):
        return result_of("modes", self.file(MACHINE + CASES), *arguments)["modes"][0]["angular_frequency"]

    def test_a_setting_that_replaces_the_change_of_a_case_says_so_once(self):
        words = '--set elements.mount.scale=0.9: also replaces that of case "stiff"'
        text = MACHINE + CASES + '[requirements]\nhold_in = ["", "stiff"]\nlimits = {"machine.z" = "1 m"}\n'
        for command in ("verdict", "check"):
            said = trivet(command, self.file(text), "--set", "elements.mount.scale=0.9").stderr
            self.assertEqual(said.count(words), 1, said)
            beside = trivet(command, self.file(text), "--set", "elements.mount.stiffness_factor.z=0.9").stderr
            self.assertNotIn("also replaces", beside)

    def test_the_command_line_wins_over_the_case(self):
        base = self.lowest()
        self.assertAlmostEqual(self.lowest("--case", "stiff"), 2 * base, places=9)
        self.assertAlmostEqual(self.lowest("--case", "stiff", "--set", "elements.mount.scale=9"), 3 * base, places=9)
        light = (
            "--set",
            "bodies.machine.mass=25",
            "--set",
            'bodies.machine.inertia={about="center_of_mass",xx=1,yy=1,zz=1}',
        )
        self.assertAlmostEqual(self.lowest("--case", "stiff", *light), 4 * base, places=9)

    def test_braces_on_the_command_line_replace_those_of_the_case(self):
        found = result_of(
            "roots",
            self.file(MACHINE + CASES),
            "--case",
            "other",
            "--set",
            "elements.mount.damping={proportional=0.01}",
        )
        self.assertTrue(all(root["eigenvalue"][0] < -1 for root in found["roots"]), found)

    def test_a_law_in_braces_replaces_the_law_of_the_case_in_the_list_too(self):
        done = trivet(
            "run",
            self.file(MACHINE + CASES),
            "-o",
            self.folder / "out",
            "--set",
            "elements.mount.damping={proportional=0.01}",
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        cases = json.loads((self.folder / "out/results.json").read_text())["cases"]
        self.assertEqual(cases[2]["changes"], ["elements.mount.damping.proportional = 0.01"])

    def test_a_run_lists_the_number_that_is_used(self):
        request = "[analyses]\nmodes = {}\nresponse = {of = [\"machine\", \"machine.seat\"]}\n"
        done = trivet(
            "run", self.file(MACHINE + CASES + request), "-o", self.folder / "out", "--set", "elements.mount.scale=9"
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        cases = json.loads((self.folder / "out/results.json").read_text())["cases"]
        self.assertEqual(cases[1]["changes"], ["elements.mount.scale = 9"])
        self.assertEqual(cases[2]["changes"], ["elements.mount.damping.loss_factor = 0.1", "elements.mount.scale = 9"])

    def test_a_number_that_is_set_twice_is_an_error(self):
        done = trivet("modes", self.file(MACHINE), "--set", "elements.mount.scale=2", "--set", "elements.mount.scale=3")
        self.assertEqual(done.returncode, 2)
        self.assertIn("elements.mount.scale: 3, and elements.mount.scale = 2 in an earlier setting", done.stderr)
        both = trivet("modes", self.file(MACHINE), "--set", "elements.mount.scale=2", "--set", "bodies.machine.mass=3")
        self.assertEqual(both.returncode, 0)


class Analyses(InTemporaryFolder):
    def test_a_bad_analysis_stops_only_itself_check_and_run(self):
        path = self.file(MACHINE + "[analyses]\nstatic = {}\nresponse = {}\n[limits]\n\"machine.seat.z\" = 1\n")
        for command in ("modes", "roots", "response", "peaks", "explain", "suspension"):
            with self.subTest(command=command):
                done = trivet(command, path)
                self.assertEqual(done.returncode, 0)
                self.assertNotIn("error: ", done.stderr)
        self.assertEqual(trivet("element", path, "mount").returncode, 0)
        for command in (("static",), ("check",), ("run", "-o", str(self.folder / "out"))):
            done = trivet(command[0], path, *command[1:])
            self.assertEqual(done.returncode, 2, command)
            self.assertIn("analyses.static: neither gravity nor a constant force", done.stderr)
        self.assertFalse((self.folder / "out").exists())

    def test_a_bad_analysis_of_one_case_stops_only_that_case(self):
        path = self.file(MACHINE + "[analyses]\nresponse = {}\n[cases.wrong]\nanalyses.response.of = \"mashine\"\n")
        self.assertEqual(trivet("response", path).returncode, 0)
        done = trivet("response", path, "--case", "wrong")
        self.assertEqual(done.returncode, 2)
        self.assertIn('case "wrong": analyses.response.of: "mashine"', done.stderr)

    def test_peaks_follow_the_response_and_its_errors(self):
        done = trivet("peaks", self.file(MACHINE + "[analyses]\nresponse = {of = \"mashine\"}\n"))
        self.assertEqual(done.returncode, 2)
        self.assertIn("analyses.response.of", done.stderr)

    def test_a_misspelt_analysis_stops_the_commands_that_might_be_meant(self):
        path = self.file(MACHINE + "[analyses]\nrespnse = {of = \"ground\"}\n")
        self.assertIn('did you mean "response"?', trivet("response", path).stderr)
        self.assertEqual(trivet("modes", path).returncode, 0)
        self.assertEqual(trivet("peaks", self.file(MACHINE + "[analyses]\noptimise = {}\n")).returncode, 0)

    def test_errors_of_the_model_stop_everything(self):
        self.assertEqual(trivet("modes", self.file(MACHINE.replace("mass = 100", "mass = -100"))).returncode, 2)


class Unused(InTemporaryFolder):
    def warnings(self, text, *command):
        done = trivet(*(command or ("check",)), self.file(MACHINE + text))
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout + done.stderr

    def test_excitations_that_no_analysis_uses(self):
        spectrum = (
            '[excitations.road]\ntype = "random"\nbase = true\ntranslation = [0, 0, 1]\n'
            "psd = [[1, 1e-6], [10, 1e-8]]\n"
        )
        said = self.warnings(spectrum + "[analyses]\nresponse = {}\n")
        self.assertIn("excitations.road: no analysis of this file uses it", said)
        self.assertNotIn("excitations.push", said)
        self.assertNotIn("no analysis", self.warnings(spectrum))  # a file without analyses
        self.assertNotIn("no analysis", self.warnings(spectrum + "[analyses]\nmodes = {}\n"))
        self.assertNotIn("no analysis", self.warnings(spectrum + "[analyses]\nresponse = {}\n", "peaks"))
        used = spectrum + "[analyses]\nresponse = {of = \"machine.seat.z\"}\nrandom = {}\n"
        self.assertNotIn("no analysis", self.warnings(used))
        pull = '[excitations.pull]\ntype = "harmonic"\non = "machine"\nat = [0, 0, 0]\nforce = [1, 0, 0]\n'
        selected = self.warnings(pull + "[analyses]\nresponse = {excitations = [\"pull\"]}\n")
        self.assertIn("excitations.push: no analysis of this file uses it", selected)
        self.assertNotIn("excitations.pull", selected)

    def test_a_second_column_of_a_history(self):
        (self.folder / "a.csv").write_text("time,value,other\n0,0,1\n1,1,2\n2,0,3\n")
        history = (
            '[excitations.bump]\ntype = "time"\nbase = true\ntranslation = [0, 0, 1]\nhistory = {file = "a.csv"%s}\n'
        )
        ask = "[analyses]\ntransient = {of = [\"machine.seat\"]}\nresponse = {}\n"
        self.assertIn('excitations.bump.history.file: column "other" not used', self.warnings(history % "" + ask))
        self.assertNotIn("not used", self.warnings(history % ', value = "other"' + ask))

    def test_keys_without_effect(self):
        ask = (
            '[analyses]\nresponse = {of = "mount", quantity = "velocity"}\n'
            'transient = {of = "machine.seat", initial_velocity = {"machine.z" = 1}, to = 1, nearest_linear_system = true}\n'
        )
        said = self.warnings(ask)
        self.assertIn('analyses.response.quantity: "velocity" of forces alone', said)
        self.assertIn("analyses.transient.nearest_linear_system", self.warnings(ask, "transient"))

    def test_places_without_effect(self):
        done = trivet(
            "check", self.file(MACHINE.replace("damping = {proportional", "center = 0.3\ndamping = {proportional"))
        )
        self.assertEqual(done.returncode, 0)
        self.assertIn("center of an element without length", done.stderr)
        apart = MACHINE.replace(
            "damping = {proportional", "from_at = [0, 0, -0.1]\ncenter = 0.3\ndamping = {proportional"
        )
        self.assertEqual(trivet("check", self.file(apart)).stderr, "")

    def test_a_transmissibility_of_an_unbalance_is_found_by_check(self):
        wheel = '[excitations.wheel]\ntype = "unbalance"\non = "machine"\nat = [0, 0, 0]\naxis = "x"\nmass_eccentricity = 0.01\n'
        done = trivet(
            "check", self.file(MACHINE + wheel + '[analyses]\nresponse = {}\ntransmissibility = {force = "wheel"}\n')
        )
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("analyses.transmissibility.force", done.stderr)

    def test_empty_options(self):
        for arguments in (
            ("response", "--at", ""),
            ("response", "--band", ""),
            ("modes", "--case", ""),
            ("suspension", "--torque", ""),
        ):
            done = trivet(arguments[0], self.file(MACHINE), *arguments[1:])
            self.assertEqual(done.returncode, 2, arguments)
            self.assertIn("an empty text", done.stderr)

    def test_excitations_that_act_together_are_listed(self):
        second = '[excitations.unit]\ntype = "harmonic"\non = "machine"\nat = [0, 0, 0]\nforce = [1, 0, 0]\n'
        self.assertIn("Excited simultaneously by push, unit", trivet("response", self.file(MACHINE + second)).stdout)
        self.assertNotIn("Excited", trivet("response", self.file(MACHINE)).stdout)
        one = '[analyses]\nresponse = {}\npeaks = {excitations = ["unit"]}\n'
        self.assertIn("Excited simultaneously", trivet("response", self.file(MACHINE + second + one)).stdout)
        self.assertNotIn("Excited", trivet("peaks", self.file(MACHINE + second + one)).stdout)

    def test_the_force_of_one_of_several_mounts_is_a_share(self):
        other = (
            MACHINE[MACHINE.index("[elements.mount]") : MACHINE.index("[excitations.push]")]
            .replace("mount", "other")
            .replace("at = [0, 0, 0]", "at = [1, 0, 0]")
        )
        ask = '[analyses]\ntransmissibility = {force = "push"}\n'
        found = {one["name"]: one for one in result_of("transmissibility", self.file(MACHINE + other + ask))["results"]}
        self.assertIsNotNone(found["ground"]["isolates_from"])
        for name in ("mount", "other"):
            self.assertEqual((found[name]["isolates_from"], found[name]["isolation_efficiency"]), (None, None))
        alone = {one["name"]: one for one in result_of("transmissibility", self.file(MACHINE + ask))["results"]}
        self.assertIsNotNone(alone["mount"]["isolates_from"])

    def test_an_overdamped_mode_of_little_mass_does_not_stop_an_earthquake(self):
        small = (
            '[bodies.small]\nmass = 0.001\ninertia = {about = "center_of_mass", xx = 1e-6, yy = 1e-6, zz = 1e-6}\n'
            '[elements.link]\ntype = "bushing"\non = "small"\nfrom = "machine"\nat = [0, 0, 0]\ntranslation = [100, 100, 100]\nrotation = [1, 1, 1]\n'
            'damping = {translation = [1, 1, 1], rotation = [1, 1, 1]}\n'
        )
        ask = '[analyses]\nearthquake = {rows = [[0.1, 5], [100, 5]], direction = "x", of = ["machine.x"]}\n'
        values = []
        for more in ("", small):
            done = trivet("run", self.file(MACHINE + more + ask), "-o", self.folder / "out")
            self.assertEqual(done.returncode, 0, done.stderr)
            text = (self.folder / "out/results.json").read_text()
            values.append(json.loads(text)["cases"][0]["earthquake"]["results"][0])
        neglected = 1e-4  # ten times the share of the mass
        self.assertAlmostEqual(values[0]["cqc"] / values[1]["cqc"], 1, delta=neglected)

    def test_limit_lines_are_reported_with_the_response(self):
        line = (
            '[analyses]\nresponse = {of = ["machine.seat"]}\n'
            '[limit_lines.severe]\nof = "machine.seat.z"\nrows = [[1, 1e-9], [1000, 1e-9]]\n'
        )
        self.assertIn("severe", self.warnings(line, "response"))

    def test_limit_lines_name_the_range_that_was_compared(self):
        line = (
            '[analyses]\nresponse = {of = ["machine.seat"], band = ["5 Hz", "12 Hz"]}\n'
            '[limit_lines.severe]\nof = "machine.seat.z"\nrows = [[1, 1], [1000, 1]]\n'
        )
        self.assertIn("5 … 12", trivet("limit_lines", self.file(MACHINE + line)).stdout)
        self.assertIn(",5 to 12,", trivet("limit_lines", self.file(MACHINE + line), "--csv").stdout)

    def test_the_deep_check_in_json(self):
        done = trivet("check", self.file(MACHINE), "--deep", "--json")
        self.assertEqual(json.loads(done.stdout)["deep"][0]["verdict"], "agrees")


class Rejections(InTemporaryFolder):
    def test_a_rejected_transient_names_the_key_that_helps(self):
        ask = "[analyses]\ntransient = {to = 1, initial_velocity = {\"machine.z\" = 1}}\n"
        lossy = trivet("transient", self.file((MACHINE + ask).replace("proportional = 0.001", "loss_factor = 0.1")))
        self.assertEqual(lossy.returncode, 2)
        self.assertIn("replace `damping` of these elements", lossy.stderr)
        self.assertIn("damping = {proportional = ", lossy.stderr)
        law = "fractional_zener = {ratio = 1, time = 0.01, order = 0.5}"
        fractional = trivet("transient", self.file((MACHINE + ask).replace("proportional = 0.001", law)))
        self.assertEqual(fractional.returncode, 2)
        self.assertIn("nearest_linear_system = true in analyses.transient", fractional.stderr)
        self.assertIn("damping = {zener", fractional.stderr)


if __name__ == "__main__":
    unittest.main()
