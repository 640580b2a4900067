# SPDX-License-Identifier: BSD-3-Clause
"""Bodies out of STEP files are drawn by their surface, which encloses the volume that their mass has."""
import collections
import json
import os
import shutil
import unittest

from trivet_test import SOURCE, InTemporaryFolder, trivet

DATA = SOURCE / "tests/samples/data"
DENSITY = 1000
FACETS = 0.03  # relative: 36 chords along a turn enclose 0.5 % less than the circle
PROJECT = """
trivet = 1
[bodies.part]
solids = [{file = "FILE", CHOICE density = 1000, at = [0.3, -0.2, 0.1], orientation = {axis = "x", angle = "30 deg"}}]
[elements.mount]
type = "bushing"
on = "part"
at = [0, 0, 0]
translation = [1e5, 1e5, 1e5]
rotation = [1e4, 1e4, 1e4]
[analyses]
modes = {}
"""


def enclosed(mesh):
    """Volume and centre of a closed surface."""
    v = [mesh["vertices"][i : i + 3] for i in range(0, len(mesh["vertices"]), 3)]
    t = [mesh["triangles"][i : i + 3] for i in range(0, len(mesh["triangles"]), 3)]
    volume, moment = 0, [0, 0, 0]
    for a, b, c in ((v[i], v[j], v[k]) for i, j, k in t):
        six = (
            a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
        )
        volume += six / 6
        moment = [m + six / 24 * (a[n] + b[n] + c[n]) for n, m in enumerate(moment)]
    return volume, [m / volume for m in moment]


@unittest.skipUnless(shutil.which("gmsh"), "no gmsh")
class StepDrawing(InTemporaryFolder):
    def project(self, file, choice=""):
        shutil.copy(DATA / file, self.folder)
        path = self.folder / "machine.toml"
        path.write_text(PROJECT.replace("FILE", file).replace("CHOICE", choice))
        return path

    def drawn(self, file, choice=""):
        done = trivet("scene", self.project(file, choice), "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)["bodies"][0]

    def check(self, body):
        """Its surface is closed, faces outwards, and has the volume and the centre of its mass."""
        self.assertEqual(body["drawn_as"], "1 solid")
        mesh = body["solids"][0]
        triangles = [mesh["triangles"][i : i + 3] for i in range(0, len(mesh["triangles"]), 3)]
        edges = collections.Counter((t[i], t[(i + 1) % 3]) for t in triangles for i in range(3))
        self.assertTrue(all(edges[b, a] == count for (a, b), count in edges.items()))
        volume, centre = enclosed(mesh)
        exact = body["mass"] / DENSITY
        self.assertLess(volume, exact * (1 + 1e-4))  # vertices of a convex solid are on it, chords inside
        self.assertAlmostEqual(volume, exact, delta=FACETS * exact)
        size = exact ** (1 / 3)
        for found, mass in zip(centre, body["centre_of_mass"]):
            self.assertAlmostEqual(found, mass, delta=FACETS * size)
        return volume

    def test_the_surface_encloses_the_mass(self):
        self.check(self.drawn("cylinder.step"))

    def test_chosen_solids_alone_are_drawn(self):
        parts = [self.check(self.drawn("rubber_on_steel.step", f"solids = [{k}],")) for k in (1, 2)]
        self.assertNotAlmostEqual(*parts)
        self.assertAlmostEqual(self.check(self.drawn("rubber_on_steel.step")), sum(parts), 9)

    def test_gmsh_runs_once_for_the_drawings_of_a_report(self):
        counted, real = self.folder / "bin", shutil.which("gmsh")
        counted.mkdir()
        (counted / "gmsh").write_text(f'#!/bin/sh\ncat job.geo >> "{self.folder}/jobs"\nexec {real} "$@"\n')
        (counted / "gmsh").chmod(0o755)
        path = f"{counted}{os.pathsep}{os.environ['PATH']}"
        done = trivet("run", self.project("cylinder.step"), "-o", self.folder / "out", env=os.environ | {"PATH": path})
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual((self.folder / "jobs").read_text().count("Mesh 2;"), 1)
        self.assertNotIn("box of equal mass and inertia", (self.folder / "out/report.html").read_text())

    def test_a_solid_that_gmsh_cannot_mesh_is_drawn_as_its_box(self):
        broken, real = self.folder / "bin", shutil.which("gmsh")
        broken.mkdir()
        (broken / "gmsh").write_text(f'#!/bin/sh\ngrep -q "Mesh 2" job.geo && exit 1\nexec {real} "$@"\n')
        (broken / "gmsh").chmod(0o755)
        path = f"{broken}{os.pathsep}{os.environ['PATH']}"
        done = trivet("scene", self.project("cylinder.step"), "--json", env=os.environ | {"PATH": path})
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(json.loads(done.stdout)["bodies"][0]["drawn_as"], "box of equal inertia")

    def test_a_surface_that_is_a_link_is_not_read(self):
        odd, real = self.folder / "bin", shutil.which("gmsh")
        odd.mkdir()
        link = f'ln -s "{DATA / "box.stl"}" surface1.stl; echo 1 > solids.txt; exit 0'
        (odd / "gmsh").write_text(f'#!/bin/sh\nif grep -q "Mesh 2" job.geo; then {link}; fi\nexec {real} "$@"\n')
        (odd / "gmsh").chmod(0o755)
        path = f"{odd}{os.pathsep}{os.environ['PATH']}"
        done = trivet("scene", self.project("cylinder.step"), "--json", env=os.environ | {"PATH": path})
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(json.loads(done.stdout)["bodies"][0]["drawn_as"], "box of equal inertia")


if __name__ == "__main__":
    unittest.main()
