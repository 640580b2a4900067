# SPDX-License-Identifier: BSD-3-Clause
"""Element types and tables: the same bytes as with every element written out, and every command accepts their paths."""
import csv
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

TRIVET = os.environ["TRIVET"]
SOURCE = pathlib.Path(os.environ["TRIVET_SOURCE"])
SINGLE_PRECISION = 1e-6  # of the margins of a map
WRITTEN_OUT = SOURCE / "tests" / "data" / "projects"


def trivet(*arguments, cwd=None):
    return subprocess.run([TRIVET, *map(str, arguments)], capture_output=True, text=True, cwd=cwd)


def results(project, folder):
    """All files of a run except those with the hash of the input, and the results without the hash."""
    run = trivet("run", project, "-o", folder)
    assert run.returncode == 0, run.stderr
    files = {
        path.relative_to(folder).as_posix(): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()
    }
    data = json.loads(files.pop("results.json"))
    data["input"] = None
    for name in ("manifest.json", "report.html"):
        files.pop(name)
    return data, files


class ElementTypes(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def compare(self, short, long):
        self.assertEqual(results(short, self.folder / "short"), results(long, self.folder / "long"))

    def test_the_genset_is_that_with_every_mount_written_out(self):
        self.compare(SOURCE / "examples" / "genset" / "genset.toml", WRITTEN_OUT / "genset_written_out.toml")

    def test_the_starter_is_that_with_every_mount_written_out(self):
        starter = self.folder / "machine.toml"
        starter.write_text(trivet("new").stdout)
        self.compare(starter, WRITTEN_OUT / "starter_written_out.toml")

    def project(self, elements, mounts=""):
        """A machine on four mounts, which `elements` describes."""
        if mounts:
            (self.folder / "mounts.csv").write_text(mounts)
        path = self.folder / f"machine{len(list(self.folder.iterdir()))}.toml"
        path.write_text(
            """trivet = 1
[bodies.machine]
mass = 250
inertia = {about = "center_of_mass", xx = 8, yy = 12, zz = 13}
"""
            + elements
        )
        return path

    def modes(self, path, *settings):
        result = trivet("modes", path, "--json", *settings)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout

    TYPE = """[element_types.mount]
type = "bushing"
translation = ["180 N/mm", "170 N/mm", "420 N/mm"]
scale = 1.5
"""
    TABLE = """[tables.elements]
file = "mounts.csv"
"""
    MOUNTS = """# four mounts
name,type,on,at.x [mm],at.y [mm],at.z [mm],scale
front left,mount,machine,400,250,0,1
front right,mount,machine,400,-250,0,2
rear left,mount,machine,-400,250,0,
rear right,mount,machine,-400,-250,0,
"""

    def written_out(self, factor=1.0):
        return self.project(
            "".join(
                f"""[elements."{name}"]
type = "bushing"
on = "machine"
at = [{x}, {y}, 0]
translation = [180e3, 170e3, 420e3]
scale = {scale * factor}
"""
                for name, x, y, scale in (
                    ("front left", 0.4, 0.25, 1.5),
                    ("front right", 0.4, -0.25, 3.0),
                    ("rear left", -0.4, 0.25, 1.5),
                    ("rear right", -0.4, -0.25, 1.5),
                )
            )
        )

    def test_rows_of_a_file_are_elements_and_scales_multiply(self):
        table = self.project(self.TYPE + self.TABLE, self.MOUNTS)
        self.assertEqual(self.modes(table), self.modes(self.written_out()))

    def test_rows_have_paths_by_name_and_types_change_all_their_elements(self):
        table = self.project(self.TYPE + self.TABLE, self.MOUNTS)
        written = self.written_out()
        moved = 'elements."rear left".at.y=0.3'
        self.assertEqual(self.modes(table, "--set", moved), self.modes(written, "--set", moved))
        self.assertNotEqual(self.modes(table, "--set", moved), self.modes(table))
        self.assertEqual(self.modes(table, "--set", "element_types.mount.scale=3"), self.modes(self.written_out(2)))
        cases = self.project(
            self.TYPE
            + self.TABLE
            + '[cases.stiff]\nelement_types.mount.scale = 3\n[cases.moved]\nelements."rear left".at.y = 0.3\n'
        )
        self.assertEqual(self.modes(cases, "--case", "stiff"), self.modes(self.written_out(2)))
        self.assertEqual(self.modes(cases, "--case", "moved"), self.modes(written, "--set", moved))

    def test_factors_of_a_type_and_of_its_element_multiply(self):
        table = self.project(self.TYPE + "stiffness_factor.z = 1.5\n" + self.TABLE, self.MOUNTS)
        one_by_one = [
            word
            for name in ("front right", "rear left", "rear right")
            for word in ("--set", f'elements."{name}".stiffness_factor.z=1.5')
        ]
        self.assertEqual(
            self.modes(table, "--set", 'elements."front left".stiffness_factor.z=2'),
            self.modes(self.written_out(), "--set", 'elements."front left".stiffness_factor.z=3', *one_by_one),
        )

    def test_a_wrong_component_of_a_setting_is_found_in_the_setting(self):
        starter = self.folder / "machine.toml"
        starter.write_text(trivet("new").stdout)
        refused = trivet("check", starter, "--set", "element_types.mount.translation.z=-2")
        self.assertIn(
            "--set element_types.mount.translation.z=-2: error: element_types.mount.translation: -2", refused.stderr
        )

    def test_a_map_varies_a_type_as_one_number(self):
        analyses = """[excitations.push]
type = "harmonic"
on = "machine"
at = [0, 0, 0.1]
force = [10, 0, 100]
[analyses.map]
x = {parameter = "element_types.mount.scale", from = 0.5, to = 2, points = 5}
y = {parameter = "element_types.mount.damping.loss_factor", from = 0.05, to = 0.3, points = 5}
limits = {"machine.z" = 1e-4}
"""
        table = self.project(self.TYPE + "damping = {loss_factor = 0.1}\n" + self.TABLE + analyses, self.MOUNTS)
        result = trivet("map", table, "--csv")
        self.assertEqual(result.returncode, 0, result.stderr)
        rows = list(csv.reader(result.stdout.splitlines()))
        margin = rows[0].index("margin")
        compared = 0
        for row in rows[1:]:
            scale, loss = float(row[0]), float(row[1])
            if scale not in (0.5, 2.0) or loss not in (0.05, 0.3):
                continue
            peaks = trivet(
                "peaks",
                table,
                "--json",
                "--set",
                f"element_types.mount.scale={scale}",
                "--set",
                f"element_types.mount.damping.loss_factor={loss}",
            )
            tallest = max(p["amplitude"] for p in json.loads(peaks.stdout)["peaks"] if p["name"] == "machine.z")
            self.assertAlmostEqual(float(row[margin]) * tallest / 1e-4, 1, delta=SINGLE_PRECISION)
            compared += 1
        self.assertEqual(compared, 4)

    def test_bodies_and_points_come_from_tables_too(self):
        listed = self.project(
            """[tables.bodies]
rows = [{name = "tank", mass = 20, free = ["z"], position = {x = 1, y = 0, z = 0.5}}]
[tables.points]
rows = [{name = "seat", on = "machine", at = [0.3, 0.2, 0.4]}, {name = "lid", on = "tank", at.x = 0, at.y = 0, at.z = 0.1}]
"""
            + self.TYPE
            + self.TABLE
            + """[elements.leg]
type = "bushing"
on = "tank"
from = "machine"
at = [0, 0, -0.5]
translation = [1e5, 1e5, 1e5]
""",
            self.MOUNTS,
        )
        written = self.project(
            """points.seat = [0.3, 0.2, 0.4]
[bodies.tank]
mass = 20
free = ["z"]
position = [1, 0, 0.5]
points.lid = [0, 0, 0.1]
"""
            + self.TYPE
            + self.TABLE
            + """[elements.leg]
type = "bushing"
on = "tank"
from = "machine"
at = [0, 0, -0.5]
translation = [1e5, 1e5, 1e5]
""",
            self.MOUNTS,
        )
        self.assertEqual(self.modes(listed), self.modes(written))
        push = '[excitations.push]\ntype = "harmonic"\non = "machine"\nat = [0, 0, 0]\nforce = [0, 0, 1]\n[analyses]\nresponse = {of = ["machine.seat", "tank.lid"], at = ["3 Hz"]}\n'
        for path in (listed, written):
            path.write_text(path.read_text() + push)
        self.assertEqual(trivet("response", listed, "--csv").stdout, trivet("response", written, "--csv").stdout)


if __name__ == "__main__":
    unittest.main()
