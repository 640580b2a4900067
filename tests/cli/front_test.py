# SPDX-License-Identifier: BSD-3-Clause
"""Fronts of `trivet optimize` against fronts in closed form."""
import json
import csv
import io
import math
import re
import unittest

from trivet_test import InTemporaryFolder, result_of, trivet

# A climb stops at steps of 1e-10 of a range.
PLACE = 1e-7
# Neighbours are spaced until their distances differ by 2 %.
EVEN = 1.021
W = 100.0  # rad/s
BAND = f"[analyses.response]\nband = [{W}, {W * (1 + 1e-9)!r}]\n"


def oscillator(name, mass, stiffness, more=""):
    return f"""[bodies.{name}]
mass = {mass}
free = ["z"]
[elements.s{name}]
type = "bushing"
on = "{name}"
at = [0, 0, 0]
translation = [1, 1, {stiffness}]
{more}[excitations.{name}]
type = "harmonic"
on = "{name}"
at = [0, 0, 0]
force = [0, 0, 10]
"""


# One stiffness for two masses, one below and one above its resonance: F/x_a + F/x_b = (m_b − m_a) ω², a hyperbola.
STIFF, F, M_A, M_B = 1e5, 10.0, 2.0, 50.0
TWO = "trivet = 1\n" + oscillator("a", M_A, STIFF) + oscillator("b", M_B, STIFF)
TWO += """[parameters.stiffness]
path = ["elements.sa.scale", "elements.sb.scale"]
from = 0.5
to = 4.5
[analyses.optimize]
front = ["a.z", "b.z"]
"""

# A damper above √2 of the resonance: f² + m ω² (m ω² − 2 k) x² = F², a quarter of an ellipse, hollow towards less.
DAMPED = "trivet = 1\n" + oscillator("m", 40.0, 1e4, "damping = {translation = [0, 0, 1000]}\n")
DAMPED += """[parameters.damper]
path = "elements.sm.damping.translation.z"
from = 100
to = 20000
[analyses.optimize]
front = ["m.z", "ground.force.z"]
starts = 4
"""


class Front(InTemporaryFolder):
    def front(self, text):
        found = result_of("optimize", self.file(text + BAND))
        for point in found["points"][1:-1]:
            self.assertLess(point["residual"], 1e-5)
        self.assertLess(found["unevenness"], EVEN)
        return found, [p["amplitudes"] for p in found["points"]]

    def distances(self, points):
        low, high = ([f(p[i] for p in points) for i in (0, 1)] for f in (min, max))
        scaled = [[(p[i] - low[i]) / (high[i] - low[i]) for i in (0, 1)] for p in points]
        return [math.dist(a, b) for a, b in zip(scaled, scaled[1:])]

    def test_csv_has_the_points(self):
        project = self.file(TWO + BAND)
        found = result_of("optimize", project)
        rows = list(csv.reader(io.StringIO(trivet("optimize", project, "--csv").stdout)))
        self.assertEqual(len(rows), 1 + len(found["points"]))
        self.assertEqual(rows[0][-2:], ["residual", "knee"])
        for row, point in zip(rows[1:], found["points"]):
            self.assertEqual([float(x) for x in row[:2]], point["amplitudes"])
        self.assertEqual(sum(int(row[-1]) for row in rows[1:]), 1)

    def test_hyperbola_with_its_knee(self):
        found, points = self.front(TWO)
        self.assertEqual(len(points), 11)
        total = (M_B - M_A) * W**2 / F
        for a, b in points:
            self.assertAlmostEqual((1 / a + 1 / b) / total, 1, delta=PLACE)
        # The ends are those of the range: amplitudes F / (k − m ω²) and F / (m ω² − k).
        for p, factor in ((points[0], 4.5), (points[-1], 0.5)):
            self.assertAlmostEqual(p[0] * (factor * STIFF - M_A * W**2) / F, 1, delta=PLACE)
            self.assertAlmostEqual(p[1] * (M_B * W**2 - factor * STIFF) / F, 1, delta=PLACE)
        gaps = self.distances(points)
        self.assertLess(max(gaps) / min(gaps), EVEN)
        # The knee is where 1/x_a² over the width of a is that of b; with 401 points it is found to a step.
        fine = result_of("optimize", self.file((TWO + "points = 101\n" + BAND)))
        a, b = fine["points"][fine["knee"]]["amplitudes"]
        width_a, width_b = (o["most"] - o["least"] for o in fine["objectives"])
        slope = (b / a) ** 2 * width_a / width_b  # −db/da in shares: 1 at the knee
        beside = [p["amplitudes"] for p in fine["points"][fine["knee"] - 1 : fine["knee"] + 2 : 2]]
        around = [(q[1] / q[0]) ** 2 * width_a / width_b for q in beside]
        self.assertTrue(around[0] >= 1 >= around[1], (around, slope))
        # 1 % more of a brings (b/a)² a/b % less of b.
        for p in found["points"][1:-1]:
            a, b = p["amplitudes"]
            self.assertAlmostEqual(p["exchange"] / (b / a), 1, delta=1e-4)

    def test_hollow_front_that_a_weighted_sum_cannot_find(self):
        found, points = self.front(DAMPED)
        self.assertEqual(len(points), 11)
        inertia = 40 * W**2
        for x, force in points:
            self.assertAlmostEqual((force**2 + inertia * (inertia - 2e4) * x**2) / F**2, 1, delta=PLACE)
        self.assertIsNone(found["knee"])
        said = trivet("optimize", self.file(DAMPED + BAND)).stdout
        self.assertIn("No knee", said)

    def test_requirement_cuts_the_front(self):
        limit = 3e-5
        found, points = self.front(TWO + f'[requirements]\nlimits = {{"b.z" = {limit}}}\n')
        self.assertAlmostEqual(points[0][1] / limit, 1, delta=PLACE)
        total = (M_B - M_A) * W**2 / F
        self.assertAlmostEqual((1 / points[0][0] + 1 / limit) / total, 1, delta=PLACE)

    def test_no_choice_is_one_point(self):
        text = TWO.replace('["a.z", "b.z"]', '["a.z", "sa.force.z"]')
        found = result_of("optimize", self.file(text + BAND))
        self.assertEqual(len(found["points"]), 1)
        self.assertIn("nothing to choose", trivet("optimize", self.file(text + BAND)).stdout)

    def test_three_results(self):
        # A third mass of its own spring: the front of the first two, with the third at its least.
        text = TWO + BAND
        text = text.replace("[parameters.stiffness]", oscillator("c", 60.0, 1e5) + "[parameters.stiffness]")
        text = text.replace('front = ["a.z", "b.z"]', 'front = ["a.z", "b.z", "c.z"]')
        text = text.replace('"elements.sb.scale"]', '"elements.sb.scale", "elements.sc.scale"]')
        found = result_of("optimize", self.file(text))
        total = (M_B - M_A) * W**2 / F
        for point in found["points"]:
            a, b, c = point["amplitudes"]
            self.assertAlmostEqual((1 / a + 1 / b) / total, 1, delta=PLACE)
        self.assertGreater(found["dominated"] + found["coinciding"], 0)

    def test_a_refused_file_beside_a_picture_is_an_error(self):
        """The model needs a file of its own folder, so it cannot be written to another one."""
        (self.folder / "more.csv").write_text("name,type,on,at.x,at.y,at.z\nmore,t,a,0,0,0\n")
        (self.folder / "other").mkdir()
        project = self.file(
            TWO
            + BAND
            + '[element_types.t]\ntype = "bushing"\ntranslation = [1, 1, 1]\n[tables.elements]\nfile = "more.csv"\n'
        )
        picture, target = self.folder / "front.svg", self.folder / "other" / "knee.toml"
        done = trivet("optimize", project, "--picture", picture, "--write", target)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("tables.elements.file", done.stderr)
        self.assertFalse(picture.exists() or target.exists())

    def test_picture_and_written_knee(self):
        project = self.file(TWO + BAND)
        picture, target = self.folder / "front.svg", self.folder / "knee.toml"
        done = trivet("optimize", project, "--picture", picture, "--write", target)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("knee</text>", picture.read_text())
        knee = json.loads(trivet("optimize", project, "--json").stdout)
        value = knee["points"][knee["knee"]]["values"][0]
        scales = [float(s) for s in re.findall(r"^scale = (.*)$", target.read_text(), re.M)]
        self.assertEqual(len(scales), 2)
        for scale in scales:
            self.assertAlmostEqual(scale / value, 1, delta=1e-14)  # fifteen digits
        plain = self.file(TWO.replace("front", "minimize").replace(', "b.z"]', "]") + BAND)
        done = trivet("optimize", plain, "--picture", picture)
        self.assertEqual(done.returncode, 2)
        self.assertIn("only a front has a picture", done.stderr)

    def test_requirements_that_cannot_be_met_have_no_front(self):
        done = trivet("optimize", self.file(TWO + BAND + '[requirements]\nlimits = {"b.z" = 1e-9}\n'))
        self.assertEqual(done.returncode, 1)
        self.assertIn("so there is no front", done.stderr)


if __name__ == "__main__":
    unittest.main()
