# SPDX-License-Identifier: BSD-3-Clause
"""rms, 0-p and p-p after units: in limits, limit lines, requirements and excitations, and in what people read."""
import json
import math
import re
import unittest

from trivet_test import InTemporaryFolder, result_of, trivet

ROUND_OFF = 1e-15
M, K, C, F = 40.0, 2.5e5, 300.0, 30.0
MACHINE = f"""trivet = 1
[bodies.machine]
mass = {M}
inertia = {{about = "center_of_mass", xx = 2, yy = 2, zz = 2}}
free = ["z"]
[elements.mount]
type = "matrix"
on = "machine"
at = [0, 0, 0]
stiffness = [[0,0,0,0,0,0],[0,0,0,0,0,0],[0,0,{K},0,0,0],[0,0,0,0,0,0],[0,0,0,0,0,0],[0,0,0,0,0,0]]
damping = {{proportional = {C / K}}}
"""
PUSH = f'[excitations.push]\ntype = "harmonic"\non = "machine"\nat = [0, 0, 0]\nforce = [0, 0, "{F} N"]\n'
NOISE = '[excitations.noise]\ntype = "random"\nbase = true\ntranslation = [0, 0, 1]\nquantity = "acceleration"\npsd = {flat = "0.01 (m/s2)2/Hz", band = ["1 Hz", "100 Hz"]}\n'
LEVELS = {"rms": "4.5 mm/s rms", "0-p": f"{4.5 * math.sqrt(2)!r} mm/s 0-p", "p-p": f"{9 * math.sqrt(2)!r} mm/s p-p"}
RESPONSE = '[analyses]\nresponse = {of = ["machine.z"], quantity = "velocity", band = ["2 Hz", "40 Hz"]}\n'


def velocity():
    """Largest velocity of the mass over all frequencies: F/C, where stiffness and inertia cancel."""
    return F / C


class Levels(InTemporaryFolder):
    def margin(self, more):
        done = trivet("verdict", self.file(MACHINE + PUSH + more), "--json")
        self.assertIn(done.returncode, (0, 1), done.stderr)
        (result,) = json.loads(done.stdout)["cases"][0]["requirements"]
        return result["margin"]

    def test_a_limit_has_one_margin_at_every_level(self):
        margins = [
            self.margin(f'[requirements]\nlimits = {{"machine.z" = "{limit}"}}\nband = ["2 Hz", "40 Hz"]\n')
            for limit in LEVELS.values()
        ]
        self.assertAlmostEqual(margins[0], 4.5e-3 / (velocity() / math.sqrt(2)), delta=1e-9)
        for margin in margins:
            self.assertAlmostEqual(margin / margins[0], 1, delta=ROUND_OFF)

    def test_a_limit_line_has_one_margin_at_every_level(self):
        def line(one):
            rows = f'[limit_lines.severity]\nof = "machine.z"\nrows = [["1 Hz", "{one}"], ["50 Hz", "{one}"]]\n'
            (found,) = result_of("limit_lines", self.file(MACHINE + PUSH + RESPONSE + rows))
            return found

        lines = {word: line(limit) for word, limit in LEVELS.items()}
        self.assertEqual([lines[word]["level"] for word in LEVELS], ["rms", "zero_to_peak", "zero_to_peak"])
        for found in lines.values():
            self.assertAlmostEqual(found["least_margin"] / lines["rms"]["least_margin"], 1, delta=ROUND_OFF)

    def test_a_unit_of_a_whole_line_may_have_a_level(self):
        self.file("frequency_hz,limit [mm/s p-p]\n1,12\n50,12\n", "line.csv")
        file = '[limit_lines.severity]\nof = "machine.z"\nfile = "line.csv"\n'
        rows = '[limit_lines.severity]\nof = "machine.z"\nunit = "mm/s 0-p"\nrows = [[1, 6], [50, 6]]\n'
        found = [
            result_of("limit_lines", self.file(MACHINE + PUSH + RESPONSE + more, "p.toml"))[0] for more in (file, rows)
        ]
        self.assertEqual([one["level"] for one in found], ["zero_to_peak"] * 2)
        self.assertAlmostEqual(found[0]["least_margin"] / found[1]["least_margin"], 1, delta=ROUND_OFF)

    def test_a_force_has_one_response_at_every_level(self):
        at = ("--at", "10 Hz")
        amplitude = lambda force: math.hypot(
            *result_of("response", self.file(MACHINE + PUSH.replace(f"{F} N", force) + RESPONSE, "force.toml"), *at)[
                "results"
            ][0]["complex"][0]
        )
        w = 20 * math.pi
        expected = F * w / math.hypot(K - M * w * w, C * w)
        for force in (f"{F} N", f"{F / math.sqrt(2)!r} N rms", f"{2 * F} N p-p", f"{F} N 0-p"):
            self.assertAlmostEqual(amplitude(force) / expected, 1, delta=1e-12)

    def test_a_motion_of_the_ground_has_a_level(self):
        floor = '[excitations.floor]\ntype = "base"\ntranslation = [0, 0, "LEVEL"]\n'
        values = [
            result_of("response", self.file(MACHINE + floor.replace("LEVEL", level) + RESPONSE), "--at", "5 Hz")[
                "results"
            ][0]["complex"][0]
            for level in ("0.1 mm p-p", "0.05 mm")
        ]
        self.assertEqual(values[0], values[1])

    def test_people_read_velocities_in_rms_and_the_level_of_every_amplitude(self):
        requirement = '[requirements]\nlimits = {"machine.z" = "4.5 mm/s rms"}\nband = ["2 Hz", "40 Hz"]\n'
        path = self.file(MACHINE + PUSH + RESPONSE.replace("[analyses]\n", "[analyses]\npeaks = {}\n") + requirement)
        shown = trivet("verdict", path).stdout
        self.assertIn("machine.z ≤ 4.5 mm/s rms", shown)
        self.assertIn(f"{1000 * velocity() / math.sqrt(2):.2f} mm/s rms", shown)
        self.assertIn("|machine.z| [mm/s rms]", trivet("response", path, "--full").stdout)
        self.assertIn("mm/s rms", trivet("peaks", path).stdout)
        displacement = trivet("response", path, "--set", "analyses.response.quantity=displacement", "--full").stdout
        self.assertRegex(displacement, r"\|machine\.z\| \[[mµ]*m 0-p\]")

    def test_the_display_has_the_last_word(self):
        path = self.file(MACHINE + PUSH + RESPONSE)
        for level, word in (("amplitude", "0-p"), ("peak_to_peak", "p-p"), ("rms", "rms")):
            shown = trivet("response", path, "--set", f"display.level={level}", "--full").stdout
            self.assertIn(f"|machine.z| [mm/s {word}]", shown)

    def test_a_limit_and_its_value_have_the_level_of_the_file(self):
        w = 2 * math.pi * 5
        amplitude = F / math.hypot(K - M * w**2, C * w)
        for bound, share, word in (("1 mm p-p", 2, "p-p"), ("1 mm rms", math.sqrt(0.5), "rms"), ("1 mm", 1, "0-p")):
            limit = f'[requirements.limits]\n"machine.z" = {{limit = "{bound}", band = ["5 Hz", "5.0001 Hz"]}}\n'
            path = self.file(MACHINE + PUSH + limit)
            shown = trivet("verdict", path).stdout
            self.assertIn(f"machine.z ≤ 1 mm {word} in 5", shown)
            (value,) = re.findall(rf"([\d.]+) µm {word} ", shown)
            self.assertAlmostEqual(float(value) / (1e6 * share * amplitude), 1, 3)
            self.assertIn(" rms", trivet("verdict", path, "--set", "display.level=rms").stdout)
            (row,) = json.loads(trivet("verdict", path, "--json").stdout)["cases"][0]["requirements"]
            self.assertEqual(row["level"], "0-p")  # of its numbers
            self.assertAlmostEqual(row["value"] / amplitude, 1, 3)

    def test_requirement_rows_name_the_level_of_their_numbers(self):
        rows = PUSH + NOISE + '[requirements]\nlimits = {"machine.z" = "4.5 mm/s"}\nrms = {"machine.z" = "5 mm"}\n'
        rows += "damping_ratio = 0.01\n"
        found = json.loads(trivet("verdict", self.file(MACHINE + rows), "--json").stdout)["cases"][0]["requirements"]
        self.assertEqual(
            {row["kind"]: row["level"] for row in found}, {"amplitude": "0-p", "rms": "rms", "damping_ratio": None}
        )
        words = {row["kind"]: row["requirement"] for row in found}
        self.assertEqual(words["amplitude"], "machine.z ≤ 4.5 mm/s 0-p")
        self.assertEqual(words["rms"], "rms of machine.z ≤ 5 mm rms")
        self.assertEqual(words["damping_ratio"], "every damping ratio ≥ 0.01")

    def test_searches_and_maps_state_the_level_of_their_bounds(self):
        axes = "x = {parameter = 'bodies.machine.mass', from = 38, to = 42}, "
        axes += "y = {parameter = 'elements.mount.scale', from = 0.9, to = 1.1}"
        text = MACHINE + PUSH + NOISE + f"[analyses]\nmap = {{{axes}}}\n[requirements]\n"
        text += 'limits = {"machine.z" = {limit = "0.1 mm", band = ["5 Hz", "20 Hz"]}}\nrms = {"machine.z" = "1 um"}\n'
        text += "[parameters.scale]\npath = 'elements.mount.scale'\nfrom = 0.5\nto = 2\n"
        path = self.file(text)
        for arguments in (("optimize", path), ("map", path, "--points", "3", "--full")):
            said = trivet(*arguments).stdout
            self.assertIn("machine.z ≤ 100 µm 0-p in 5 … 20 Hz", said, arguments)
            self.assertIn("rms of machine.z ≤ 1 µm rms", said, arguments)
        found = json.loads(trivet("map", path, "--points", "3", "--json").stdout)
        self.assertEqual(
            {rule["words"]: rule["level"] for rule in found["rules"]},
            {"machine.z ≤ 100 µm 0-p in 5 … 20 Hz": "0-p", "rms of machine.z ≤ 1 µm rms": "rms"},
        )
        for mark in found["marks"]:
            self.assertEqual([rule["level"] for rule in mark["rules"]], [rule["level"] for rule in found["rules"]])

    def test_names_with_signs_of_bounds_do_not_divide_a_requirement(self):
        named = (MACHINE + PUSH).replace("bodies.machine]", "bodies.'a ≤ b']").replace('on = "machine"', 'on = "a ≤ b"')
        named += '[requirements]\nlimits = {"a ≤ b.z" = "1 um"}\nband = ["2 Hz", "40 Hz"]\n'
        target = self.folder / "out"
        said = trivet("run", self.file(named), "-o", target).stdout
        self.assertIn("a ≤ b.z ≤ 1 µm 0-p", said)
        words = " ".join(re.sub("<[^>]*>", "", (target / "report.html").read_text()).split())
        self.assertIn("violates a ≤ b.z:", words)
        self.assertIn("allowed ≤ 1", words)

    def test_a_misspelt_level_is_named(self):
        for limit, meant in (
            ("4.5 mm/s rmss", "4.5 mm/s rms"),
            ("4.5 mm/s RMS", "4.5 mm/s rms"),
            ("1 mm pk", "1 mm 0-p"),
        ):
            text = MACHINE + PUSH + f'[requirements]\nlimits = {{"machine.z" = "{limit}"}}\n'
            done = trivet("check", self.file(text))
            self.assertEqual(done.returncode, 2)
            self.assertIn(
                f'is no level; levels are rms, 0-p (zero-to-peak) and p-p (peak-to-peak); did you mean "{meant}"?',
                done.stderr,
            )

    def test_data_stay_zero_to_peak(self):
        path = self.file(MACHINE + PUSH + RESPONSE)
        found = result_of("response", path, "--at", f"{math.sqrt(K / M)!r} rad/s")["results"][0]
        self.assertAlmostEqual(math.hypot(*found["complex"][0]), F / C, delta=1e-9)
        self.assertIn("machine.z amplitude [m/s]", trivet("response", path, "--csv").stdout.splitlines()[0])

    def test_an_rms_limit_of_random_vibration_may_state_it(self):
        values = [
            json.loads(
                trivet(
                    "verdict",
                    self.file(MACHINE + NOISE + f'[requirements]\nrms = {{"machine.z" = "{limit}"}}\n'),
                    "--json",
                ).stdout
            )["cases"][0]["requirements"][0]["margin"]
            for limit in ("1 mm rms", "1 mm")
        ]
        self.assertEqual(values[0], values[1])


if __name__ == "__main__":
    unittest.main()
