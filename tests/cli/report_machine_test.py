# SPDX-License-Identifier: BSD-3-Clause
"""What a report stores for its machine in 3D: the results of `trivet scene`, `modes` and `shapes`."""
import base64
import gzip
import json
import math
import re
import unittest

from trivet_test import SOURCE, InTemporaryFolder, trivet

DIGITS = 5.001e-7  # relative: half a unit of the last of 7 digits
GENSET = SOURCE / "examples/genset/genset.toml"
FAN = SOURCE / "examples/fan/fan.toml"
PUMP = SOURCE / "examples/two_stage/pump_on_raft.toml"
FRAME = SOURCE / "examples/frame/frame.toml"  # three cases, one of which changes the machine

BASE = """
trivet = 1
[bodies.mass]
mass = 4
free = ["z"]
[elements.spring]
type = "bushing"
on = "mass"
at = [0, 0, 0]
translation = [900, 900, 900]
damping = {loss_factor = 0.1}
[excitations.engine]
type = "orders"
on = "mass"
at = [0, 0, 0]
table = [{order = 1, force = [0, 0, 3]}, {order = 2.5, force = [0, 0, 7]}]
[operation]
speeds = ["600 rpm", ["500 rpm", "900 rpm"]]
[analyses]
modes = {}
"""

BALL = """
trivet = 1
[bodies.ball]
mass = 10
solids = [{sphere = "200 mm"}]
[elements.mount]
type = "bushing"
on = "ball"
at = [0, 0, -0.1]
translation = [1e5, 1e5, 1e5]
rotation = [1e4, 1e4, 1e4]
[analyses]
modes = {}
"""


def numbers(part):
    if isinstance(part, (dict, list)):
        return [one for inside in (part.values() if isinstance(part, dict) else part) for one in numbers(inside)]
    return [part] if isinstance(part, float) else []


class Machine(InTemporaryFolder):
    def report(self, project, form="full"):
        done = trivet("run", project, "-o", self.folder / "out", "--report", form)
        self.assertEqual(done.returncode, 0, done.stderr)
        return (self.folder / "out/report.html").read_text()

    def part(self, page, name):
        found = re.search(f'<script type="text/plain" id="{name}">(.*?)</script>', page)
        return gzip.decompress(base64.b64decode(found.group(1), validate=True)).decode()

    def stored(self, project):
        """With the surfaces in their places in the scenes."""
        stored = json.loads(self.part(self.report(project), "machine-data"))
        for scene in stored["scenes"]:
            for body in scene["bodies"]:
                body["solids"] = [stored["surfaces"][place] for place in body["solids"]]
        return stored

    def command(self, *words):
        done = trivet(*words, "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def check_equal(self, stored, exact, place=""):
        """The stored value is the exact one, of which it may lack keys and items at the end."""
        if isinstance(stored, dict):
            for key, value in stored.items():
                self.check_equal(value, exact[key], f"{place}.{key}")
        elif isinstance(stored, list):
            self.assertLessEqual(len(stored), len(exact), place)
            for i, value in enumerate(stored):
                self.check_equal(value, exact[i], f"{place}[{i}]")
        elif isinstance(stored, float):
            self.assertAlmostEqual(stored, exact, delta=DIGITS * abs(exact), msg=place)
        else:
            self.assertEqual(stored, exact, place)

    def test_numbers_below_the_least_double_are_stored(self):
        """Each body of this chain moves 1e-5 as far as its neighbour, so that shares of energies fall below 1e-308."""
        text = "trivet = 1\n"
        for i in range(40):
            text += f'[bodies.b{i}]\nmass = 1\nfree = ["z"]\n[elements.g{i}]\ntype = "three_springs"\non = "b{i}"\n'
            text += f"at = [0, 0, 0]\ntranslation = [0, 0, {1000 * (i + 1)}]\n"
            if i:
                text += f'[elements.c{i}]\ntype = "three_springs"\non = "b{i}"\nfrom = "b{i - 1}"\n'
                text += "at = [0, 0, 0]\ntranslation = [0, 0, 0.01]\n"
        project = self.file(text + "[analyses]\nmodes = {}\n")
        exact = self.command("modes", project)
        small = [part for mode in exact["modes"] for part in numbers(mode) if 0 < abs(part) < 2.3e-308]
        self.assertTrue(small)
        self.check_equal(self.stored(project)["cases"][0]["modes"]["modes"], exact["modes"][:30])

    def test_scenes_and_modes_of_all_cases_are_those_of_the_commands(self):
        stored = self.stored(FRAME)
        names = [one["name"] for one in stored["cases"]]
        self.assertEqual(names[0], "Base model")
        self.assertGreater(len(names), 1)
        self.assertLess(len(stored["scenes"]), len(names) + 1)
        for one in stored["cases"]:
            words = [] if one["name"] == "Base model" else ["--case", one["name"]]
            scene = self.command("scene", FRAME, *words)
            self.assertEqual(set(stored["scenes"][one["scene"]]), set(scene))
            self.check_equal(stored["scenes"][one["scene"]], scene)
            modes = self.command("modes", FRAME, *words)
            self.assertEqual(one["modes"].pop("all"), len(modes["modes"]))
            self.assertEqual(len(one["modes"]["modes"]), min(30, len(modes["modes"])))
            self.check_equal(one["modes"], modes)

    def test_cases_of_another_mass_share_the_surface(self):
        project = self.folder / "ball.toml"
        cases = "".join(f"[cases.c{mass}]\nbodies.ball.mass = {mass}\n" for mass in (20, 30, 40))
        sizes = []
        for text in (BALL, BALL + cases):
            project.write_text(text)
            sizes.append(len(self.part(self.report(project), "machine-data")))
        stored = self.stored(project)
        self.assertEqual(len(stored["surfaces"]), 1)
        self.assertEqual([scene["bodies"][0]["mass"] for scene in stored["scenes"]], [10, 20, 30, 40])
        surface = len(json.dumps(stored["surfaces"][0], separators=(",", ":")))
        self.assertGreater(surface, 20_000)
        self.assertLess(sizes[1] - sizes[0], surface / 2)

    def test_damped_motions_are_the_roots_nearest_to_the_modes(self):
        stored = self.stored(PUMP)["cases"][0]
        roots = {root["eigenvalue"][1]: root for root in self.command("roots", PUMP)["roots"]}
        self.assertEqual(
            {root["nearest_mode"] for root in stored["roots"]["roots"]},
            {mode["number"] for mode in stored["modes"]["modes"]},
        )
        for one in stored["roots"]["roots"]:
            frequency = min(roots, key=lambda w: abs(w - one["eigenvalue"][1]))
            self.assertGreater(frequency, 0)
            self.check_equal(one, roots[frequency])
        self.assertIsNone(self.stored(GENSET)["cases"][0]["roots"])  # this file does not ask for them

    def test_operating_shapes_are_those_of_the_command(self):
        project = self.folder / "machine.toml"
        text = (SOURCE / "examples/paper/corrected.toml").read_text()
        project.write_text(text + '\n[analyses.shapes]\nat = ["4 Hz", "9 Hz"]\n')
        shapes = self.stored(project)["cases"][0]["shapes"]
        self.assertEqual(shapes.pop("all"), 2)
        self.check_equal(shapes, self.command("shapes", project))

    def test_the_shape_at_a_speed_of_the_machine_is_that_at_its_frequency(self):
        shapes = self.stored(FAN)["cases"][0]["shapes"]["shapes"]
        self.assertEqual([one.pop("at") for one in shapes], ["980 rpm, order 1"])
        project = self.folder / "fan.toml"  # the unbalance alone runs with the machine
        project.write_text(FAN.read_text() + '\nshapes = {at = ["980 rpm"], excitations = ["rotor"]}\n')
        self.check_equal(shapes, self.command("shapes", project)["shapes"])

    def test_the_orders_of_a_machine_at_a_speed_are_shapes_of_their_own(self):
        project = self.folder / "orders.toml"
        project.write_text(BASE)
        shapes = self.stored(project)["cases"][0]["shapes"]["shapes"]
        self.assertEqual([one["at"] for one in shapes], ["600 rpm, order 1", "600 rpm, order 2.5"])
        for one, order, force in zip(shapes, (1, 2.5), (3, 7)):
            omega = order * 600 * 2 * math.pi / 60
            self.assertAlmostEqual(one["angular_frequency"], omega, delta=DIGITS * omega)
            place = next(place for place in one["places"] if place["name"] == "mass")
            exact = force / (900 * (1 + 0.1j) - 4 * omega**2)  # one mass on one spring
            self.assertAlmostEqual(complex(*place["motion"][2]), exact, delta=2 * DIGITS * abs(exact))

    def test_the_same_file_gives_the_same_bytes_and_the_script_of_the_source(self):
        page = self.report(GENSET)
        self.assertEqual(page, self.report(GENSET))
        script = (SOURCE / "web/dist/report_machine.js").read_text()
        self.assertEqual(self.part(page, "machine-script"), script)
        for licence in ("three.js authors", "Google LLC"):
            self.assertIn(licence, script)

    def test_the_short_form_has_no_machine_in_3d(self):
        page = self.report(GENSET, "short")
        self.assertNotIn("machine-script", page)
        self.assertNotIn("machine-data", page)


if __name__ == "__main__":
    unittest.main()
