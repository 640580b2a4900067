# SPDX-License-Identifier: BSD-3-Clause
"""Random results that vanish by symmetry are 0, and the others keep their accuracy; resonances of a floor given by its
mobility."""
import json
import math
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

from trivet_test import HANGS_AFTER

TRIVET = os.environ["TRIVET"]
MOVED_BY_MOUNTS = 0.02  # mounts of 9 % of the stiffness of the floor's first mode shift its resonances by less
FLOOR = ((14, 3000, 0.03), (38, 1500, 0.04))  # modes: natural frequency [Hz], modal mass [kg], damping ratio
ROWS = [10 ** (math.log10(1) + i * math.log10(120) / 159) for i in range(160)]  # [Hz], 1 … 120

MOUNT = """[elements.p{0}]
type = "bushing"
on = "table"
at = [{1}, {2}, 0]
translation = [20000, 20000, 26000]
damping = {{proportional = "10 ms"}}
foundation = "floor"
"""


def mobility(hertz):
    w = 2 * math.pi * hertz
    total = 0
    for natural, mass, ratio in FLOOR:
        own = 2 * math.pi * natural
        total += 1j * w / (mass * (own * own - w * w + 2j * ratio * own * w))
    return total


def project(offset):
    mounts = "".join(
        MOUNT.format(i + 1, x, y) for i, (x, y) in enumerate([(0.6, 0.4), (0.6, -0.4), (-0.6, 0.4), (-0.6, -0.4)])
    )
    return f"""trivet = 1
[bodies.table]
mass = "320 kg"
center_of_mass = [0.02, {offset}, 0.15]
inertia = {{about = "center_of_mass", xx = 30, yy = 75, zz = 95}}
points.laser = [0.4, 0.2, 0.3]
{mounts}
[foundations.floor]
type = "mobility"
file = "y.csv"
[excitations.pump]
type = "harmonic"
on = "table"
at = [0.1, 0.1, 0.2]
force = [3, 0, 10]
[excitations.ambient]
type = "random"
base = true
quantity = "velocity"
translation = [0, 0, 1]
psd = {{flat = 1e-8, band = ["2 Hz", "100 Hz"]}}
[analyses]
peaks = {{of = ["p1.foot"]}}
random = {{of = ["table.laser", "p1.deflection"], quantity = "velocity"}}
"""


class SymmetricTable(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder, True)
        rows = [f"{f:.6f},{mobility(f).real:.9e},{mobility(f).imag:.9e}" for f in ROWS]
        (self.folder / "y.csv").write_text("frequency_hz,y_z_z,y_z_z_im\n" + "\n".join(rows) + "\n")

    def result_of(self, command, offset=0):
        (self.folder / "table.toml").write_text(project(offset))
        done = subprocess.run(
            [TRIVET, command, "table.toml", "--json"],
            cwd=self.folder,
            capture_output=True,
            text=True,
            timeout=HANGS_AFTER,
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def test_results_that_vanish_by_symmetry_are_zero(self):
        results = {r["name"]: r for r in self.result_of("random")["results"]}
        aside = {r["name"]: r for r in self.result_of("random", 1e-9)["results"]}
        odd = ("y", "rx", "rz")
        settled = 1e-6  # accuracy required of the quadrature
        for name, one in results.items():
            if name.rsplit(".", 1)[1] in odd:
                self.assertTrue(one["vanishes"], name)
                self.assertEqual((one["rms"], one["reason"]), (0, ""), name)
            else:
                self.assertFalse(one["vanishes"], name)
                self.assertLess(one["estimated_error"], settled, name)
                self.assertAlmostEqual(one["rms"] / aside[name]["rms"], 1, delta=settled)

    def test_peaks_of_the_floor_are_found_to_the_end_of_its_table(self):
        result = self.result_of("peaks")
        found = [p["angular_frequency"] / (2 * math.pi) for p in result["peaks"] if p["name"] == "p1.foot.z"]
        for natural, _, _ in FLOOR:
            self.assertTrue(any(abs(f / natural - 1) < MOVED_BY_MOUNTS for f in found), (natural, found))

    def test_limits_are_judged_if_the_table_begins_above_rest(self):
        more = (
            'response = {of = ["table.z"], excitations = ["shaken"]}\n[limits]\n"table.z" = 1\n'
            '[excitations.shaken]\ntype = "base"\nquantity = "acceleration"\ntranslation = [0, 0, 1]\n'
        )
        (self.folder / "table.toml").write_text(project(0) + more)
        done = subprocess.run(
            [TRIVET, "response", "table.toml"], cwd=self.folder, capture_output=True, text=True, timeout=HANGS_AFTER
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("largest at any ω", done.stdout)


class SymmetricBox(unittest.TestCase):
    def test_on_equal_mounts_with_relaxation(self):
        mounts = "".join(
            f"""[elements.r{i}]
type = "bushing"
on = "box"
at = [{x}, {y}, 0.1]
translation = [18e3, 14e3, 30e3]
rotation = [2, 2, 2]
damping = {{zener = {{ratio = 0.6, time = "4 ms"}}}}
"""
            for i, (x, y) in enumerate((x, y) for x in (-0.2, 0, 0.2) for y in (-0.15, 0.15))
        )
        text = f"""trivet = 1
[bodies.box]
mass = 24
center_of_mass = [0.01, 0, 0]
inertia = {{about = "center_of_mass", xx = 0.277, yy = 0.4772, zz = 0.6098}}
{mounts}
[excitations.flight]
type = "random"
base = true
quantity = "acceleration"
translation = [0, 0, 1]
psd = [[15, 0.5], [100, 1.0], [500, 1.0], [2000, 0.1]]
[analyses]
random = {{of = ["box"], quantity = "acceleration"}}
"""
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "box.toml"
            path.write_text(text)
            done = subprocess.run(
                [TRIVET, "random", str(path), "--json"], capture_output=True, text=True, timeout=HANGS_AFTER
            )
        self.assertEqual(done.returncode, 0, done.stderr)
        for one in json.loads(done.stdout)["results"]:
            if one["name"].rsplit(".", 1)[1] in ("y", "rx", "rz"):
                self.assertEqual((one["rms"], one["reason"], one["vanishes"]), (0, "", True), one["name"])
            else:
                self.assertLess(one["estimated_error"], 1e-9, one["name"])  # integrals over the poles


if __name__ == "__main__":
    unittest.main()
