# SPDX-License-Identifier: BSD-3-Clause
"""`trivet scene`: what programs draw, and that it moves as the results of the other commands say."""

import json
import math
import os
import pathlib
import subprocess
import tempfile
import unittest

from trivet_test import HANGS_AFTER

TRIVET = os.environ["TRIVET"]
SOURCE = pathlib.Path(os.environ["TRIVET_SOURCE"])
EXAMPLES = SOURCE / "examples"
ROUND_OFF = 1e-12

# A turned body with solids and points, a node, all kinds of elements with dimensions, stops, a ring, a clearance.
WORKSHOP = """trivet = 1
title = "Workshop"
gravity = [0, 0, -9.81]
[bodies.press]
position = [0.3, 0.1, 0.5]
orientation = {axis = [1, 2, 3], angle = "40 deg"}
points.eye = [0.2, -0.1, 0.3]
[[bodies.press.solids]]
box = [0.4, 0.3, 0.2]
density = 7850
[[bodies.press.solids]]
tube = [0.2, 0.1, 0.3]
at = [0, 0, 0.25]
density = 7850
[bodies.motor]
mass = 40
inertia = {about = "center_of_mass", xx = 1.5, yy = 2.0, zz = 1.0}
position = [0, 0, 1]
points.tip = [0.1, 0, 0]
[nodes.knee]
position = [0, 0.5, 0.5]
[elements.spring]
type = "coil_spring"
wire_diameter = "12 mm"
mean_diameter = "90 mm"
active_coils = 5.5
free_length = "200 mm"
material = "spring_steel"
on = "press"
at = [0.1, 0, 0]
[elements.pad]
type = "rubber_block"
width_x = "60 mm"
width_y = "40 mm"
thickness = "20 mm"
material = {hardness = 55}
on = "press"
at = [-0.1, 0, 0]
[elements.sleeve]
type = "rubber_bush"
inner_diameter = "20 mm"
outer_diameter = "60 mm"
length = "50 mm"
material = {hardness = 55}
on = "press"
at = [0, 0.1, 0]
[elements.arm]
type = "beam"
section = {tube = ["50 mm", "40 mm"]}
material = "structural_steel"
on = "motor"
at = [0, 0, 0]
from = "knee"
[elements.leg]
type = "beam"
section = {rectangle = ["50 mm", "30 mm"]}
material = "structural_steel"
on = "knee"
from_at = [0, 0.5, 0]
[elements.bumper]
type = "stop"
on = "motor"
at = [0, 0, 0.1]
axis = "z"
gaps = ["3 mm", "5 mm"]
stiffness = 1e6
[elements.pin]
type = "stop"
on = "motor"
at = [0.1, 0, 0.1]
axis = "x"
ring = "2 mm"
stiffness = 1e6
[excitations.shake]
type = "harmonic"
on = "press"
at = [0.1, 0.2, 0]
force = [0, 0, 100]
moment = [5, 0, 0]
[analyses]
modes = {}
shapes = {at = ["11 Hz"]}
"""


def result(*arguments):
    done = subprocess.run([TRIVET, *map(str, arguments), "--json"], capture_output=True, text=True, timeout=HANGS_AFTER)
    assert done.returncode == 0, (arguments, done.stderr)
    return json.loads(done.stdout)


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def moved(body, pole_motion, at):
    """Displacement of a place of a body in the ground frame. @param pole_motion  u and θ in the ground frame"""
    arm = [x - p for x, p in zip(at, body["pole"])]
    return [u + t for u, t in zip(pole_motion[:3], cross(pole_motion[3:], arm))]


def into_ground(axes, three):
    """Components along the axes of a body, along those of the ground."""
    return [sum(axes[i][k] * three[i] for i in range(3)) for k in range(3)]


def integrals(mesh):
    """Volume and first moment of a closed mesh, by the divergence theorem."""
    flat, corners = mesh["vertices"], mesh["triangles"]
    v = [flat[i : i + 3] for i in range(0, len(flat), 3)]
    volume, moment = 0.0, [0.0, 0.0, 0.0]
    for i in range(0, len(corners), 3):
        a, b, c = (v[corner] for corner in corners[i : i + 3])
        six = dot(a, cross(b, c))
        volume += six / 6
        moment = [m + six * (x + y + z) / 24 for m, x, y, z in zip(moment, a, b, c)]
    return volume, [m / volume for m in moment]


class Scene(unittest.TestCase):
    def assert_near(self, found, wanted, tolerance, words=""):
        self.assertEqual(len(found), len(wanted), words)
        for a, b in zip(found, wanted):
            self.assertLessEqual(abs(a - b), tolerance, (words, found, wanted))

    def written(self, text, name="machine.toml"):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        file = pathlib.Path(folder.name) / name
        file.write_text(text, encoding="utf-8")
        return file

    def workshop(self):
        return self.written(WORKSHOP)

    def test_every_example_gives_a_scene_with_finite_numbers_and_all_its_parts(self):
        def numbers(value):
            if isinstance(value, dict):
                value = list(value.values())
            if isinstance(value, list):
                return [n for one in value for n in numbers(one)]
            return [value] if isinstance(value, float) else []

        examples = sorted(EXAMPLES.glob("*/*.toml"))
        self.assertGreater(len(examples), 25)
        for example in examples:
            with self.subTest(example=example.name):
                scene = result("scene", example)
                self.assertTrue(all(math.isfinite(n) for n in numbers(scene)))
                self.assertGreater(scene["size"], 0)
                modes = result("modes", example)
                self.assertEqual([body["name"] for body in scene["bodies"]], modes["bodies"])
                drawn = [element["name"] for element in scene["elements"]]
                self.assertEqual(drawn, [name for name in modes["elements"] if name in drawn])
                for body in scene["bodies"]:
                    self.assertTrue(body["node"] or body["solids"] or body["box"] or body["drawn_as"] == "point")
                    for a, axis in enumerate(body["axes"]):
                        self.assert_near([dot(axis, other) for other in body["axes"]], [a == b for b in range(3)], 1e-9)

    def test_the_number_that_scales_a_stiffness_is_accepted_and_scales_it(self):
        keys = set()
        for file in sorted([*EXAMPLES.glob("*/*.toml"), *(SOURCE / "tests/samples").glob("*.toml"), self.workshop()]):
            with self.subTest(file=file.name):
                elements = result("scene", file)["elements"]
                keys |= {element["stiffness_key"] for element in elements}
                changes = [
                    f"--set=elements.{json.dumps(element['name'])}.{element['stiffness_key']}=1.02"
                    for element in elements
                    if element["stiffness_key"]
                ]
                self.assertTrue(result("check", file, *changes)["ok"])
        self.assertEqual(keys, {"scale", "stiffness_factor.all", None})
        bogie = EXAMPLES / "bogie/loaded_frame.toml"
        scaled = {element["name"]: element["stiffness_key"] for element in result("scene", bogie)["elements"]}
        self.assertIsNone(scaled["damper left"])
        softer = [f'--set=elements."{name}".{key}=0.5' for name, key in scaled.items() if key]
        first, second = (result("modes", bogie, *more)["modes"][0]["angular_frequency"] for more in ([], softer))
        self.assertLess(second, 0.8 * first)

    def test_mode_shapes_move_the_centre_of_mass_as_modes_say(self):
        for file in (self.workshop(), EXAMPLES / "frame/frame.toml", EXAMPLES / "paper/corrected.toml"):
            scene, modes = result("scene", file), result("modes", file)["modes"]
            tried = 0
            for mode in modes:
                for body in scene["bodies"]:
                    at_pole = [mode["shape"][place] for place in body["dofs"]]
                    at_centre = [mode["shape_at_center_of_mass"][place] for place in body["dofs"]]
                    pole = into_ground(body["axes"], at_pole[:3]) + into_ground(body["axes"], at_pole[3:])
                    wanted = into_ground(body["axes"], at_centre[:3])
                    largest = max(map(abs, at_pole + at_centre), default=0)
                    self.assert_near(moved(body, pole, body["centre_of_mass"]), wanted, ROUND_OFF * (1 + largest))
                    tried += any(abs(a - b) > 1e-3 * largest for a, b in zip(at_pole, at_centre))
            self.assertTrue(tried or "frame" in str(file), "no centre of mass away from its pole")

    def test_modes_move_the_feet_on_foundations_like_bodies_in_their_place(self):
        # A compliant deck with a mass is the same as a body on springs.
        machine = """trivet = 1
[bodies.machine]
mass = 100
inertia = {about = "center_of_mass", xx = 4, yy = 5, zz = 6}
position = [0, 0, 0.4]
[elements.mount]
type = "bushing"
on = "machine"
at = [0.2, 0.1, -0.4]
translation = [1e5, 2e5, 4e5]
rotation = [3e4, 2e4, 1e4]
UNDER
"""
        deck = 'foundation = "deck"\n[foundations.deck]\ntype = "impedance"\ntranslation = [2e6, 3e6, 1e6]\nmass = 60\n'
        body = (
            'from = "plate"\nfrom_at = [0, 0, 0]\n[bodies.plate]\nmass = 60\ninertia = {about = "pole", xx = 1, yy = 1, zz = 1}\n'
            'position = [0.2, 0.1, 0]\nfree = ["x", "y", "z"]\n[elements.under]\ntype = "bushing"\non = "plate"\n'
            "at = [0, 0, 0]\ntranslation = [2e6, 3e6, 1e6]\nrotation = [1, 1, 1]\n"
        )
        found, wanted = (result("modes", self.written(machine.replace("UNDER", under))) for under in (deck, body))
        self.assertEqual(found["feet"], ["mount.foot"])
        self.assertNotIn("feet", wanted)
        self.assertEqual(len(found["modes"]), len(wanted["modes"]))
        for one, other in zip(found["modes"], wanted["modes"]):
            self.assertAlmostEqual(one["angular_frequency"] / other["angular_frequency"], 1, 9)
            foot, plate = one["feet"][0], other["shape"][6:]
            self.assertGreater(max(map(abs, foot)), 1e-5)
            sign = math.copysign(1, dot(foot[:3], plate[:3]))
            self.assert_near(foot, [sign * x for x in plate], 1e-9)

    def test_shapes_at_a_frequency_move_points_and_ends_of_elements_as_shapes_say(self):
        file = self.workshop()
        scene, shape = result("scene", file), result("shapes", file)["shapes"][0]
        places = {place["name"]: place for place in shape["places"]}
        bodies = {body["name"]: body for body in scene["bodies"]}
        pairs = [(f"{p['body']}.{p['name']}", p) for p in scene["points"]]
        pairs += [(f"{e['name']}.foot", e["from"]) for e in scene["elements"] if "body" in e["from"]]
        pairs += [(f"{e['name']}.head", e["to"]) for e in scene["elements"]]
        self.assertGreater(len(pairs), 9)
        scale = shape["largest_excursion"]
        for name, drawn in pairs:
            wanted, body = places[name], bodies[drawn["body"]]
            self.assert_near(drawn["at"], wanted["position"], 1e-9, name)
            pole = [complex(*z) for z in places[drawn["body"]]["motion"]]
            displacement = [complex(*z) for z in wanted["motion"][:3]]
            self.assert_near(moved(body, pole, drawn["at"]), displacement, 1e-9 * scale, name)

    def test_meshes_have_the_volume_and_the_centre_of_their_solids(self):
        press = next(body for body in result("scene", self.workshop())["bodies"] if body["name"] == "press")
        box, tube = (integrals(mesh) for mesh in press["solids"])
        self.assertAlmostEqual(box[0], 0.4 * 0.3 * 0.2, delta=1e-7)
        self.assert_near(box[1], press["pole"], 1e-6)
        polygon = 36 / (2 * math.pi) * math.sin(2 * math.pi / 36)  # area of 36 corners over that of the circle
        self.assertAlmostEqual(tube[0], polygon * math.pi / 4 * (0.2**2 - 0.1**2) * 0.3, delta=1e-7)
        self.assert_near(tube[1], [p + 0.25 * z for p, z in zip(press["pole"], press["axes"][2])], 1e-6)

    def test_the_box_has_the_mass_and_the_inertia_of_its_body(self):
        motor = next(body for body in result("scene", self.workshop())["bodies"] if body["name"] == "motor")
        self.assertEqual(motor["drawn_as"], "box of equal inertia")
        a, b, c = motor["box"]["size"]
        moments = sorted(40 / 12 * sum for sum in (b * b + c * c, a * a + c * c, a * a + b * b))
        self.assert_near(moments, [1.0, 1.5, 2.0], 1e-9)
        self.assert_near(motor["box"]["centre"], motor["centre_of_mass"], 1e-12)

    def test_elements_stops_and_forces_are_those_of_the_file(self):
        scene = result("scene", self.workshop())
        elements = {element["name"]: element for element in scene["elements"]}
        coil = elements["spring"]
        self.assertEqual((coil["kind"], coil["coil"]["wire"], coil["coil"]["turns"]), ("coil", [0.012, 0.012], 5.5))
        self.assertEqual(coil["size"][1], 0.102)
        self.assertEqual(coil["from"]["ground"], True)
        self.assertEqual(elements["pad"]["rubber"]["widths"], [0.06, 0.04])
        self.assertEqual(elements["pad"]["rubber"]["layers"], [{"thickness": 0.02, "metal": False}])
        self.assertEqual((elements["sleeve"]["kind"], elements["sleeve"]["size"]), ("bush", [0.05, 0.06]))
        self.assertEqual(elements["arm"]["section"], {"outer_diameter": 0.05, "inner_diameter": 0.04})
        self.assertEqual(elements["leg"]["section"], {"widths": [0.05, 0.03]})
        self.assertEqual(elements["leg"]["to"]["body"], "knee")
        for element in elements.values():
            if element["kind"] in ("coil", "beam", "rubber"):
                arm = [k - n for k, n in zip(element["to"]["at"], element["from"]["at"])]
                self.assertAlmostEqual(math.hypot(*arm), element["size"][0], 9)
                self.assert_near(arm, [element["size"][0] * x for x in element["axes"][2]], 1e-9)
        stops = scene["stops"]
        self.assertEqual([(s["name"], s["kind"]) for s in stops], [("bumper", "travel")] * 2 + [("pin", "ring")])
        self.assertAlmostEqual(stops[0]["gap"] + stops[1]["gap"], 0.008, 9)  # wherever the machine rests between
        self.assert_near(stops[0]["direction"], [0, 0, 1], ROUND_OFF)
        self.assert_near(stops[1]["direction"], [0, 0, -1], ROUND_OFF)
        self.assert_near(stops[2]["direction"], [1, 0, 0], ROUND_OFF)
        self.assertLessEqual(stops[2]["gap"], 0.002)
        force, moment = scene["forces"]
        press = next(body for body in scene["bodies"] if body["name"] == "press")
        self.assertEqual((force["kind"], moment["kind"], force["body"]), ("force", "moment", "press"))
        self.assert_near(force["direction"], press["axes"][2], ROUND_OFF)
        self.assert_near(moment["direction"], press["axes"][0], ROUND_OFF)
        arm = into_ground(press["axes"], [0.1, 0.2, 0])
        self.assert_near(force["at"], [p + x for p, x in zip(press["pole"], arm)], 1e-9)
        self.assertEqual(scene["gravity"], [0, 0, -9.81])

    def test_a_case_has_its_own_scene(self):
        text = WORKSHOP + "[cases.wide]\nelements.pad.width_x = 0.08\n"
        file = self.written(text)
        wide = result("scene", file, "--case", "wide")
        self.assertEqual({e["name"]: e for e in wide["elements"]}["pad"]["rubber"]["widths"], [0.08, 0.04])

    def test_a_fine_stl_file_is_coarsened_and_says_so(self):
        rings, around = 150, 150
        at = lambda i, j: (
            math.sin(math.pi * i / rings) * math.cos(2 * math.pi * j / around),
            math.sin(math.pi * i / rings) * math.sin(2 * math.pi * j / around),
            math.cos(math.pi * i / rings),
        )
        facets = []
        places = [[at(i, j if 0 < i < rings else 0) for j in range(around + 1)] for i in range(rings + 1)]
        for row in places:
            row[-1] = row[0]
        for i in range(rings):
            for j in range(around):
                a, b, c, d = places[i][j], places[i + 1][j], places[i + 1][j + 1], places[i][j + 1]
                facets += [f for f, there in (((a, b, c), i < rings - 1), ((a, c, d), i > 0)) if there]
        lines = ["solid ball"]
        for facet in facets:
            lines += ["facet normal 0 0 0", "outer loop"]
            lines += ["vertex %.9e %.9e %.9e" % corner for corner in facet] + ["endloop", "endfacet"]
        file = self.written(
            "trivet = 1\n[bodies.ball]\nsolids = [{file = 'ball.stl', unit = '1 m', density = 1000}]\n"
            "[elements.mount]\ntype = 'bushing'\non = 'ball'\nat = [0, 0, 0]\n"
            "translation = [1e6, 1e6, 1e6]\nrotation = [1e6, 1e6, 1e6]\n"
        )
        (file.parent / "ball.stl").write_text("\n".join(lines + ["endsolid ball"]), encoding="ascii")
        mesh = result("scene", file)["bodies"][0]["solids"][0]
        self.assertEqual(mesh["triangles_given"], len(facets))
        self.assertGreater(len(facets), 40000)
        self.assertLessEqual(len(mesh["triangles"]) // 3, 20000)
        self.assertGreater(len(mesh["triangles"]) // 3, 8000)
        volume, centre = integrals(mesh)
        self.assertAlmostEqual(volume, 4 / 3 * math.pi, delta=0.02)
        self.assert_near(centre, [0, 0, 0], 0.01)

    def test_the_table_for_people_names_bodies_and_elements(self):
        done = subprocess.run([TRIVET, "scene", self.workshop()], capture_output=True, text=True, timeout=HANGS_AFTER)
        self.assertEqual(done.returncode, 0, done.stderr)
        for words in ("press", "2 solids", "box of equal inertia", "coil_spring", "bumper", "shake"):
            self.assertIn(words, done.stdout)


if __name__ == "__main__":
    unittest.main()
