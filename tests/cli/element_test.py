# SPDX-License-Identifier: BSD-3-Clause
"""`trivet element`: one element as text, JSON and picture, and its comparison with three springs."""
import json
import math
import os
import pathlib
import random
import shutil
import subprocess
import tempfile
import unittest
import xml.dom.minidom

from trivet_test import HANGS_AFTER

TRIVET = os.environ["TRIVET"]
SOURCE = pathlib.Path(os.environ["TRIVET_SOURCE"])
PAPER = SOURCE / "examples/paper/three_elements.toml"

BODY = """trivet = 1
[bodies.mass]
mass = 50
center_of_mass = [0, 0, 0]
inertia = {about = "center_of_mass", xx = 2, yy = 3, zz = 4}
"""

COIL = """[elements."coil spring"]
type = "coil_spring"
on = "mass"
at = [0, 0, 0]
axis = "z"
wire_diameter = "12 mm"
mean_diameter = "120 mm"
active_coils = 7.6
free_length = "394 mm"
material = "spring_steel"
level = "with_mass"
"""

BUSHING = """[elements.mount]
type = "bushing"
on = "mass"
at = [0, 0, 0]
translation = [1e5, 2e5, 3e5]
rotation = [100, 200, 300]
damping = {loss_factor = 0.1}
"""

FORCE = """[excitations.engine]
type = "harmonic"
on = "mass"
at = [0, 0, 0.1]
force = [1, 2, 3]
"""

MEASURED = """[elements.rig]
type = "measured"
on = "mass"
at = [0, 0, 0]
from_at = [0, 0, -0.1]
load_cases = "rig.csv"
damping = {loss_factor = 0.05}
"""


def rig_data(spoilt_case):
    """Load cases of an uncoupled stiffness with noise of 0.1 % and one wrong reading."""
    noise = random.Random(1)
    stiffness, reach = [2e5, 2e5, 8e5, 1.2e3, 1.2e3, 300], [1e-3] * 3 + [1e-2] * 3
    lines = ["name,x,y,z,rx,ry,rz,fx,fy,fz,mx,my,mz"]
    for case in range(1, 21):
        moved = [r * noise.uniform(-1, 1) for r in reach]
        load = [k * (q + 1e-3 * r * noise.gauss(0, 1)) for k, q, r in zip(stiffness, moved, reach)]
        if case == spoilt_case:
            load[2] += 100
        lines.append(",".join([f"case {case}"] + [f"{x:.9g}" for x in moved + load]))
    return "\n".join(lines) + "\n"


class Element(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder, True)

    def project(self, *parts):
        path = self.folder / "project.toml"
        path.write_text("".join(parts))
        return path

    def run_element(self, *arguments):
        done = subprocess.run(
            [TRIVET, "element", *map(str, arguments)], capture_output=True, text=True, timeout=HANGS_AFTER
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def json(self, *arguments):
        return json.loads(self.run_element(*arguments, "--json"))

    def test_text_names_what_an_engineer_asks_for(self):
        text = self.run_element(self.project(BODY, COIL), "coil spring")
        for words in (
            "end N on the ground",
            'end K on body "mass"',
            "N θ_z [rad]",
            "M_x [N m]",
            "spring index",
            "elastic centre",
            "no force under rigid motion",
            "Own natural frequencies",
            "replaced by three springs",
            "also neglected: the mass",
        ):
            self.assertIn(words, text)
        self.assertIn("no harmonic excitation", text)

    def test_json_keeps_its_contract(self):
        result = self.json(self.project(BODY, COIL), "coil spring")
        self.assertEqual([len(row) for row in result["stiffness"]], [12] * 12)
        self.assertEqual([len(row) for row in result["mass"]], [12] * 12)
        self.assertEqual([len(row) for row in result["rigid_motion_residual"]], [6] * 12)
        self.assertIsNone(result["preload"])
        self.assertEqual(result["warnings"], [])
        self.assertGreater(len(result["facts"]), 3)
        self.assertIsNone(result["uncertainty"])

    def test_a_single_coil_spring_loses_its_tilting_as_three_springs(self):
        modes = self.json(self.project(BODY, COIL), "coil spring")["simplification"]["modes"]
        self.assertEqual(len(modes), 6)
        vertical = min(modes, key=lambda mode: abs(mode["relative_difference"]))
        self.assertLess(abs(vertical["relative_difference"]), 1e-2)  # the mass of the wire is also omitted
        self.assertEqual(sum(mode["simplified_angular_frequency"] == 0 for mode in modes), 3)

    def test_all_replaces_every_element(self):
        one, every = self.json(PAPER, "element x"), self.json(PAPER, "element x", "--all")
        self.assertEqual(one["simplification"]["replaced"], ["element x"])
        self.assertEqual(every["simplification"]["replaced"], ["element x", "element y", "element z"])
        softened = [mode["relative_difference"] for mode in every["simplification"]["modes"]]
        self.assertLess(min(softened), -0.3)

    def test_peaks_are_those_of_the_peaks_command(self):
        project = self.project(BODY, BUSHING, FORCE)
        peaks = json.loads(
            subprocess.run([TRIVET, "peaks", str(project), "--json"], capture_output=True, text=True, check=True).stdout
        )["peaks"]
        highest = max((p for p in peaks if p["name"] == "mass.rx"), key=lambda p: p["amplitude"])
        compared = {p["name"]: p for p in self.json(project, "mount")["simplification"]["peaks"]}
        self.assertEqual(compared["mass.rx"]["peak"]["amplitude"], highest["amplitude"])
        self.assertAlmostEqual(
            compared["mass.z"]["simplified_peak"]["amplitude"] / compared["mass.z"]["peak"]["amplitude"], 1, places=9
        )
        self.assertNotIn("mass.rz", compared)  # no load turns it in either model

    def test_a_measured_element_shows_its_uncertainty_and_names_its_outlier(self):
        (self.folder / "rig.csv").write_text(rig_data(spoilt_case=8))
        project = self.project(BODY, MEASURED)
        text = self.run_element(project, "rig", "--picture", self.folder / "rig.svg")
        self.assertIn("Uncertainty (95 % confidence)", text)
        self.assertIn("outlier: case 8, force z at K", text)
        result = self.json(project, "rig")
        self.assertEqual([r["what"] for r in result["residuals"] if r["outlier"]], ["case 8, force z at K"])
        self.assertTrue(result["warnings"])
        self.assertLess(abs(result["stiffness"][6][6] - 2e5), 3 * result["uncertainty"]["stiffness"][6][6])
        self.assertIn("outlier 1: case 8", (self.folder / "rig.svg").read_text())

    def test_pictures_are_whole_svg_files_without_non_numbers(self):
        relaxing = BUSHING.replace("{loss_factor = 0.1}", '{zener = {ratio = 0.8, time = "2 ms"}}').replace(
            "mount", "relaxing"
        )
        project = self.project(BODY, COIL, BUSHING, relaxing)
        for name, dynamic in (("coil spring", True), ("mount", False), ("relaxing", True)):
            with self.subTest(element=name):
                file = self.folder / "picture.svg"
                self.run_element(project, name, "--picture", file)
                text = file.read_text()
                xml.dom.minidom.parseString(text)
                self.assertEqual("Dynamic stiffness" in text, dynamic)
                for word in ("nan", "inf"):
                    self.assertNotIn(f'"{word}', text)
                    self.assertNotIn(f">{word}", text)

    def test_a_picture_that_cannot_be_written_is_reported(self):
        done = subprocess.run(
            [
                TRIVET,
                "element",
                str(self.project(BODY, BUSHING)),
                "mount",
                "--picture",
                str(self.folder / "no" / "x.svg"),
            ],
            capture_output=True,
            text=True,
        )
        self.assertEqual(done.returncode, 2)
        self.assertIn("there is no folder", done.stderr)

    def test_factors_of_rubber_may_be_given_in_percent(self):
        disc = """[elements.mount]
type = "rubber_disc"
on = "mass"
at = [0, 0, 0]
diameter = "50 mm"
thickness = "20 mm"
material = {hardness = 55, stiffening = %s, creep = %s}
"""
        plain = self.json(self.project(BODY, disc % ("1.3", "1.2")), "mount")
        percent = self.json(self.project(BODY, disc % ('"130 %"', '"120 %"')), "mount")
        self.assertEqual(plain["stiffness"], percent["stiffness"])
        self.assertEqual(plain["facts"], percent["facts"])

    def test_principal_stiffnesses_do_not_depend_on_the_attitude(self):
        turned = BUSHING.replace("translation", 'orientation = {axis = [1, 2, 3], angle = "40 deg"}\ntranslation')
        for parts in (BUSHING, turned):
            character = self.json(self.project(BODY, parts), "mount")["character"]
            for found, expected in zip(character["principal_stiffnesses"], (1e5, 2e5, 3e5)):
                self.assertTrue(math.isclose(found, expected, rel_tol=1e-12))


if __name__ == "__main__":
    unittest.main()
