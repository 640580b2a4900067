# SPDX-License-Identifier: BSD-3-Clause
"""Projects that are too large, and machines at the limits of the program (docs/limits.md)."""
import json
import math
import unittest

from limits_test import BODY, FORCE, Refused, mount
from trivet_test import SOURCE, InTemporaryFolder, trivet


class Sizes(Refused):
    def test_four_hundred_free_bodies(self):
        text = "trivet = 1\n" + "".join(
            f'[bodies.b{i}]\nmass = 1\ninertia = {{about = "pole", xx = 1, yy = 1, zz = 1}}\n' for i in range(400)
        )
        self.refused("2400 free coordinates", "at most 1800", text=text, command="run")

    def test_the_lowest_modes_of_four_hundred_free_bodies(self):
        text = "trivet = 1\n[element_types.k]\ntype = \"bushing\"\ntranslation = [1e5, 2e5, 3e5]\nrotation = [1e3, 1e3, 1e3]\n"
        for i in range(400):
            text += f'[bodies.b{i}]\nmass = 1\ninertia = {{about = "pole", xx = 1, yy = 1, zz = 1}}\n'
            text += (
                f'[elements.e{i}]\ntype = "k"\non = "b{i}"\nfrom = "{f"b{i - 1}" if i else "ground"}"\nat = [0, 0, 0]\n'
            )
        self.refused("2400 free coordinates", "6000 with modes = {lowest = 20}", text=text, command="modes")
        # A chain of masses held at one end: ω = 2 √(k/m) sin(π / (4 n + 2)).
        slowest = 2 * math.sqrt(1e3) * math.sin(math.pi / (4 * 400 + 2))
        done = trivet("modes", self.file(text + "[analyses]\npeaks = {}\n"), "--lowest", "2", "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        modes = json.loads(done.stdout)["modes"]
        self.assertEqual(len(modes), 2)
        self.assertAlmostEqual(modes[0]["angular_frequency"] / slowest, 1, 9)
        self.refused(
            "2400 free coordinates",
            "at most 1800",
            text=text + "[analyses]\nmodes = {lowest = 2}\n",
            command="suspension",
        )
        short = self.file(text + "[analyses]\nmodes = {lowest = 2}\n")
        self.assertEqual(trivet("check", short).returncode, 0)
        self.assertEqual(trivet("run", short, "-o", self.folder / "out").returncode, 0)

    def test_response_of_four_hundred_free_bodies(self):
        """Longitudinal motion of a chain of masses on springs: (k₁ + k₂ − m ω²) x = k₁ x₋ + k₂ x₊, from the held end."""
        stiffness, omega, count = 1e5, [2.0, 30.0], 400
        text = "trivet = 1\n[element_types.k]\ntype = \"bushing\"\ntranslation = [1e5, 2e5, 3e5]\nrotation = [1e3, 1e3, 1e3]\n"
        for i in range(count):
            text += f'[bodies.b{i}]\nmass = 1\ninertia = {{about = "pole", xx = 1, yy = 1, zz = 1}}\n'
            text += (
                f'[elements.e{i}]\ntype = "k"\non = "b{i}"\nfrom = "{f"b{i - 1}" if i else "ground"}"\nat = [0, 0, 0]\n'
            )
        text += '[excitations.f]\ntype = "harmonic"\non = "b399"\nat = [0, 0, 0]\nforce = [7, 0, 0]\n'
        path = self.file(text + f'[analyses.response]\nat = {omega}\nof = ["b0.x", "b399.x"]\n')
        done = trivet("response", path, "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        result = json.loads(done.stdout)
        self.assertTrue(result["checks"]["second_solver"]["passed"])
        for at, w in enumerate(omega):
            x = [0.0, 1.0]  # ground and first body; the last one has no spring behind it
            for _ in range(count - 1):
                x.append((2 - w * w / stiffness) * x[-1] - x[-2])
            force = stiffness * (x[-1] - x[-2]) - w * w * x[-1]
            for curve, shape in zip(result["results"], (x[1], x[-1])):
                exact = 7 * shape / force
                self.assertAlmostEqual(math.hypot(*curve["complex"][at]) / abs(exact), 1, 8)

    def test_twenty_thousand_results(self):
        points = "".join(f"points.p{i} = [{i}e-4, 0, 0]\n" for i in range(4000))
        names = ", ".join(f'"b.p{i}.{c}"' for i in range(4000) for c in "xyzxy")
        self.refused(
            "20000 results",
            "one analysis has at most 2000",
            text=BODY + points + mount("m") + FORCE + f"[analyses]\nresponse = {{of = [{names}]}}\n",
        )
        points = "".join(f"points.p{i} = [{i}e-4, 0, 0]\n" for i in range(400))
        names = ", ".join(f'"b.p{i}"' for i in range(400))
        self.refused(
            "2400 curves",
            "at most 2000",
            text=BODY + points + mount("m") + FORCE + f"[analyses]\npeaks = {{of = [{names}]}}\n",
        )

    def test_five_hundred_coherent_inputs(self):
        text = (
            BODY
            + mount("m")
            + "".join(
                f'[excitations.e{i}]\ntype = "random"\non = "b"\nat = [{i}e-3, 0, 0]\nforce = [0, 0, 1]\npsd = {{flat = 1, band = ["1 Hz", "50 Hz"]}}\n'
                + (f'coherence = {{with = "e{i - 1}", value = 0.1}}\n' if i % 2 else "")
                for i in range(500)
            )
        )
        self.refused("250 random excitations with a coherence", "at most 100", text=text + "[analyses]\nrandom = {}\n")

    def test_a_thousand_cases_of_a_thousand_elements(self):
        text = (
            BODY
            + "".join(mount(f"m{i}") for i in range(1000))
            + "".join(f"[cases.c{i}]\nbodies.b.mass = {100 + i}\n" for i in range(1000))
        )
        self.refused("1001000 bodies, nodes, elements and excitations", "at most 50000", text=text)

    def test_tables_that_are_too_long_or_too_wide(self):
        table = '[elements.t]\ntype = "table"\non = "b"\nat = [0, 0, 0]\nfrom_at = [0, 0, -0.1]\nfile = "t.csv"\n'
        rows = "frequency_hz,k_z,k_z_loss\n" + "".join(f"{1 + i * 1e-3:.3f},1e5,1e4\n" for i in range(20001))
        self.refused("more than 20000 rows", text=BODY + table, files=[("t.csv", rows)])
        self.refused(
            "200000 columns",
            "at most 2000 columns",
            text=BODY + table,
            files=[("t.csv", ",".join(f"c{i}" for i in range(200000)) + "\n")],
        )

    def test_ten_thousand_bodies(self):
        text = "trivet = 1\n" + "".join(f"[bodies.b{i}]\nmass = 1\nfree = ['z']\n" for i in range(10000))
        self.refused("10000 bodies", "at most 1000", text=text)

    def test_other_analyses_of_a_large_system(self):
        text = "trivet = 1\n" + "".join(
            f'[bodies.b{i}]\nmass = 1\ninertia = {{about = "pole", xx = 1, yy = 1, zz = 1}}\n' for i in range(101)
        )
        text += "".join(mount(f"m{i}", on=f"b{i}") for i in range(101)) + FORCE.replace('"b"', '"b0"')
        self.refused(
            "analyses.shapes: 606 free coordinates",
            "at most 600 (a hundred free bodies)",
            text=text + '[analyses]\nshapes = {at = ["10 Hz"]}\n',
        )
        kick = '[excitations.kick]\ntype = "time"\non = "b0"\nat = [0, 0, 0]\nforce = [0, 0, 1]\nhistory = {step = {amplitude = 5}}\n'
        kick += '[analyses.transient]\nto = "1 s"\nstep = "1 ms"\nof = ["b0.z"]\n'
        path = self.file(text.replace("loss_factor = 0.1", "proportional = 1e-4") + kick)
        self.assertEqual(trivet("check", path).returncode, 0, trivet("check", path).stderr)

    def test_curves_of_a_large_system_are_rejected_before_the_search(self):
        text = "trivet = 1\n" + "".join(
            f'[bodies.b{i}]\nmass = 1\nposition = [0, 0, {i}]\ninertia = {{about = "pole", xx = 1, yy = 1, zz = 1}}\n'
            for i in range(200)
        )
        text += "".join(
            mount(f"m{i}", on=f"b{i}", more=f'from = "b{i - 1}"' if i else "") for i in range(200)
        ) + FORCE.replace('"b"', '"b0"')
        self.refused("hours of search", "name fewer results in `of`", text=text + "[analyses]\nresponse = {}\n")
        done = trivet("response", self.file(text))  # requested only by the command line
        self.assertEqual(done.returncode, 1)
        self.assertIn("hours of search", done.stderr)


class Extremes(InTemporaryFolder):
    def test_random_results_with_one_extreme_stiffness(self):
        example = (SOURCE / "examples/optical_table/table.toml").read_text()
        for file in (SOURCE / "examples/optical_table").glob("*.csv"):
            (self.folder / file.name).write_text(file.read_text())
        done = trivet(
            "random",
            self.file(example.replace("translation = [14000, 14000, 9500]", "translation = [1.4e15, 14000, 9500]", 1)),
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("too far apart for partial fractions", done.stdout)

    def test_six_mounts_with_a_fractional_law(self):
        law = "damping = {fractional_zener = {ratio = 2, time = 1e-4, order = 0.5}}"
        text = BODY + "".join(mount(f"m{i}").replace("damping = {loss_factor = 0.1}", law) for i in range(6)) + FORCE
        done = trivet("peaks", self.file(text + '[analyses]\npeaks = {of = ["b.z"]}\n'))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("b.z", done.stdout)


if __name__ == "__main__":
    unittest.main()
