# SPDX-License-Identifier: BSD-3-Clause
"""`trivet optimize` from many starts against optima known from the literature, by hand, or from a map."""
import json
import math
import unittest

from optimize_test import ABSORBER, OBJECTIVE, PLACE
from trivet_test import SOURCE, InTemporaryFolder, result_of, trivet

STARTS = "[analyses.optimize]\nstarts = 32\n"
# Slopes of values without exact ones are differences over 1e-3 of a range.
DIFFERENCED = 1e-5
# A map stores margins in single precision.
MAPPED = 1e-6
# Ends of a search this near in ln(margin) are equally good: the one nearest to the given design is chosen.
EQUALLY_GOOD = 1e-5

# One axis of an engine on three mounts below its centre of mass: heave, and the two rotations that a torque couples.
# The places of two mounts are given. Stiffnesses in N/m.
LEFT, RIGHT, REAR_Y, REAR_STIFFNESS = (0.10, -0.40), (0.05, 0.45), 0.10, 1e5
XX, YY = 11.0, 6.2
POWERTRAIN = """trivet = 1
[bodies.engine]
mass = 208
free = ["z", "rx", "ry"]
inertia = {{about = "center_of_mass", xx = {xx}, yy = {yy}, zz = 9.8, xy = {xy!r}}}
[elements.left]
type = "bushing"
on = "engine"
at = [{left[0]}, {left[1]}, 0]
translation = [1, 1, 1e5]
[elements.right]
type = "bushing"
on = "engine"
at = [{right[0]}, {right[1]}, 0]
translation = [1, 1, 1e5]
[elements.rear]
type = "bushing"
on = "engine"
at = [-0.2, {rear_y}, 0]
translation = [1, 1, {rear_stiffness}]
[parameters.left]
path = "elements.left.translation.z"
from = 1.2e5
to = 3e5
[parameters.right]
path = "elements.right.translation.z"
from = 1.2e5
to = 3e5
[parameters.place]
path = "elements.rear.at.x"
from = -0.4
to = -0.2
[requirements]
decoupling = {{engine = 1}}
"""

# A mass on a spring with one relaxing branch (Zener), on a moving floor.
RELAXING = """trivet = 1
[bodies.m]
mass = 50
free = ["z"]
[elements.s]
type = "bushing"
on = "m"
at = [0, 0, 0]
translation = [1, 1, 8e4]
damping = {zener = {ratio = 2, time = "5 ms"}}
[excitations.floor]
type = "base"
translation = [0, 0, 1]
[parameters.ratio]
path = "elements.s.damping.zener.ratio"
from = 0.5
to = 4
[parameters.time]
path = "elements.s.damping.zener.time"
from = 1e-3
to = 1
spacing = "logarithmic"
"""

# A rocking machine: stiff enough for its weight, slow enough for a window of frequencies, damped enough.
ROCKING = """trivet = 1
gravity = [0, 0, -9.80665]
[bodies.m]
mass = 40
center_of_mass = [0, 0.05, 0]
free = ["rx"]
inertia = {about = "pole", xx = 1.5, yy = 3, zz = 3}
[elements.left]
type = "bushing"
on = "m"
at = [0, 0.3, 0]
translation = [1, 1, 6e4]
damping = {translation = [0, 0, 50]}
[elements.right]
type = "bushing"
on = "m"
at = [0, -0.3, 0]
translation = [1, 1, 6e4]
damping = {translation = [0, 0, 50]}
[parameters.stiffness]
path = ["elements.left.translation.z", "elements.right.translation.z"]
from = 2e4
to = 2e5
spacing = "logarithmic"
[parameters.inertia]
path = "bodies.m.inertia.xx"
from = 0.8
to = 4
[requirements]
static = {"m.rx" = "2 mrad"}
natural_frequencies = {avoid = [["12 Hz", "80 Hz"]]}
damping_ratio = 0.03
"""

# A damped machine far below its resonance at 80 Hz, and a bracket on it that rings with ζ = 1e-5 at 12 Hz.
MACHINE, BRACKET = 100.0, 0.44
NEEDLE = f"""trivet = 1
[bodies.machine]
mass = {MACHINE}
free = ["z"]
[bodies.bracket]
mass = {BRACKET}
free = ["z"]
position = [0, 0, 0.5]
[elements.foot]
type = "three_springs"
on = "machine"
at = [0, 0, 0]
translation = [1e7, 1e7, {MACHINE * (160 * math.pi) ** 2!r}]
damping = {{translation = [0, 0, {0.1 * MACHINE * 160 * math.pi!r}]}}
[elements.arm]
type = "three_springs"
on = "bracket"
from = "machine"
at = [0, 0, 0]
translation = [1e4, 1e4, {BRACKET * (24 * math.pi) ** 2!r}]
damping = {{translation = [0, 0, {2e-5 * BRACKET * 24 * math.pi!r}]}}
[excitations.f]
type = "harmonic"
on = "machine"
at = [0, 0, 0]
force = [0, 0, 1000]
[parameters.arm]
path = "elements.arm.translation.z"
from = 1500
to = 50000
spacing = "logarithmic"
"""
LIMIT = 1.9 * 1000 / (MACHINE * (160 * math.pi) ** 2)


class KnownOptima(InTemporaryFolder):
    def optimum(self, text):
        found = result_of("optimize", self.file(text))
        return found, {p["name"]: p["optimum"] for p in found["parameters"]}

    def test_absorber_with_the_least_rms(self):
        # Warburton, Earthquake Eng. Struct. Dyn. 10 (1982): white force on an undamped mass.
        mu, k, allowed = 0.05, 1e5, 1e-4
        tuning = math.sqrt(1 + mu / 2) / (1 + mu)
        ratio = math.sqrt(mu * (1 + 0.75 * mu) / (4 * (1 + mu) * (1 + mu / 2)))
        omega = math.sqrt(k / 100)
        noise = (
            '[excitations.noise]\ntype = "random"\non = "main"\nat = [0, 0, 0]\nforce = [0, 0, 1]\n'
            'psd = {flat = 1, band = ["1e-9 Hz", "1e6 Hz"]}\n'
        )
        found, best = self.optimum(ABSORBER + noise + f'[requirements]\nrms = {{"main.z" = {allowed}}}\n' + STARTS)
        self.assertAlmostEqual(best["stiffness"] / (5 * (tuning * omega) ** 2), 1, delta=DIFFERENCED)
        self.assertAlmostEqual(best["damper"] / (10 * ratio * tuning * omega), 1, delta=DIFFERENCED)
        # A density s per hertz gives the mean square s ω/(2 k²) √((1 + 3μ/4)/(μ(1 + μ))).
        rms = math.sqrt(omega / 2 * math.sqrt((1 + 0.75 * mu) / (mu * (1 + mu)))) / k
        self.assertAlmostEqual(found["after"] * rms / allowed, 1, delta=OBJECTIVE)
        self.assertEqual(found["agreeing"], found["starts"])
        self.assertFalse(any(parameter["idle"] for parameter in found["parameters"]))  # slopes are 0 at this top
        self.assertLess(found["residual"], 1e-2)  # a slope of 1e-5 by differences, over the least scale of 1e-2

    def test_torque_roll_axis_mounting(self):
        # The places and stiffnesses for which a constant torque about y turns the engine about its torque roll axis,
        # J⁻¹ e_y, with the centre of mass at rest: Σ k x = Σ k y = 0 and Σ k x y = Σ k y² J_xy/J_xx.
        rear_x, k3 = -0.3, REAR_STIFFNESS
        (x1, y1), (x2, y2) = LEFT, RIGHT
        k1 = k3 * (-rear_x * y2 + REAR_Y * x2) / (x1 * y2 - x2 * y1)
        k2 = k3 * (-REAR_Y * x1 + rear_x * y1) / (x1 * y2 - x2 * y1)
        mounts = [(k1, x1, y1), (k2, x2, y2), (k3, rear_x, REAR_Y)]
        total = lambda term: sum(k * term(x, y) for k, x, y in mounts)
        self.assertAlmostEqual(total(lambda x, y: x) / k3, 0, delta=1e-12)
        self.assertAlmostEqual(total(lambda x, y: y) / k3, 0, delta=1e-12)
        xy = XX * total(lambda x, y: x * y) / total(lambda x, y: y * y)
        text = POWERTRAIN.format(xx=XX, yy=YY, xy=xy, left=LEFT, right=RIGHT, rear_y=REAR_Y, rear_stiffness=k3)
        project = self.file(text, "exact.toml")
        found, best = self.optimum(text + STARTS.replace("32", "8"))  # flat, so that a climb is long
        self.assertLess(found["before"], 0.96)
        self.assertGreater(found["after"], 1 - 2 * EQUALLY_GOOD)
        # The shares fall with the square of the distance, here by a twentieth of it.
        flat = math.sqrt(20 * EQUALLY_GOOD)
        for name, expected in (("left", k1), ("right", k2), ("place", rear_x)):
            self.assertAlmostEqual(best[name] / expected, 1, delta=4 * flat)
        exact = zip(("left.translation.z", "right.translation.z", "rear.at.x"), (k1, k2, rear_x))
        settings = [x for path, value in exact for x in ("--set", f"elements.{path}={value!r}")]
        [judged] = json.loads(trivet("verdict", project, "--json", *settings).stdout)["cases"]
        self.assertAlmostEqual(judged["requirements"][0]["value"], 1, delta=OBJECTIVE)

    def test_relaxing_isolator(self):
        # Ruzicka: the largest transmissibility is at least 1 + 2/N, with ζ = N √(2(N + 2))/(4(N + 1)).
        found, best = self.optimum(RELAXING + '[analyses.optimize]\nminimize = "m.z"\nstarts = 32\n')
        n, m, k = 4, 50, 8e4
        self.assertAlmostEqual(best["ratio"] / n, 1, delta=OBJECTIVE)
        zeta = n * math.sqrt(2 * (n + 2)) / (4 * (n + 1))
        self.assertAlmostEqual(found["after"] / (1 + 2 / n), 1, delta=OBJECTIVE)
        self.assertAlmostEqual(best["time"] / (2 * zeta * math.sqrt(k * m) / (n * k)), 1, delta=PLACE)
        self.assertEqual([p["at_bound"] for p in found["parameters"]], [True, False])
        self.assertEqual(found["agreeing"], found["starts"])

    def test_three_requirements_hold_two_parameters(self):
        # κ = 2 k y² and J: margins θ κ/(M g d), w √(J/κ) and c y²/(ζ √(κ J)); their product depends on neither.
        weight, theta, w, damping, zeta = 40 * 9.80665 * 0.05, 2e-3, 24 * math.pi, 50 * 0.3**2, 0.03
        margin = (theta * w * damping / (weight * zeta)) ** (1 / 3)
        found, best = self.optimum(ROCKING + STARTS)
        kappa = margin * weight / theta
        self.assertAlmostEqual(found["after"] / margin, 1, delta=OBJECTIVE)
        self.assertAlmostEqual(best["stiffness"] / (kappa / (2 * 0.3**2)), 1, delta=PLACE)
        self.assertAlmostEqual(best["inertia"] / (kappa * (margin / w) ** 2), 1, delta=PLACE)
        self.assertEqual([round(a["multiplier"], 6) for a in found["active"]], [0.333333] * 3)
        # One corner of the box lies above the window of frequencies.
        self.assertGreaterEqual(found["agreeing"], found["starts"] - 1)

    def largest_on_grid(self, text, points=10000):
        grid = (
            f'[analyses.response]\nof = ["machine"]\nspacing = "linear"\npoints = {points}\nband = ["5 Hz", "35 Hz"]\n'
        )
        found = result_of("response", self.file(text + grid, "grid.toml"))
        [curve] = [c for c in found["results"] if c["name"] == "machine.z"]
        return max(math.hypot(*value) for value in curve["complex"])

    def test_needle_that_a_grid_misses(self):
        rules = f'[requirements]\nband = ["5 Hz", "35 Hz"]\nlimits = {{"machine.z" = {LIMIT!r}}}\n'
        self.assertLess(self.largest_on_grid(NEEDLE), LIMIT)
        found, best = self.optimum(NEEDLE + rules + STARTS)
        self.assertLess(found["before"], 0.5)
        self.assertGreater(found["after"], 1.3)
        self.assertTrue(found["feasible"])
        moved = NEEDLE.replace(f"{BRACKET * (24 * math.pi) ** 2!r}", f"{best['arm']!r}")
        reached = self.largest_on_grid(moved)
        self.assertLess(reached * found["after"] / LIMIT, 1 + OBJECTIVE)
        # The largest amplitude is at the end of the band, a point of the grid.
        self.assertAlmostEqual(reached * found["after"] / LIMIT, 1, delta=OBJECTIVE)
        # The needle is still there, outside of the band.
        settings = ["--set", f"elements.arm.translation.z={best['arm']!r}"]
        peaks = json.loads(trivet("peaks", self.file(NEEDLE), "--json", *settings).stdout)["peaks"]
        needle = [p for p in peaks if p["name"] == "machine.z" and p["relative_prominence"] > 1]
        self.assertTrue(all(p["angular_frequency"] > 70 * math.pi for p in needle))

    def test_the_paper_has_its_best_design_where_a_map_finds_it(self):
        path = SOURCE / "examples/paper/map.toml"
        model, rules = path.read_text().split("[analyses.map]\n")
        limits = rules.split("[analyses.map.limits]\n")[1].split("\n\n")[0]
        parameters = (
            '[parameters.scale]\npath = "elements.suspension.scale"\nfrom = 0.3\nto = 10\nspacing = "logarithmic"\n'
            '[parameters.delta]\npath = "elements.suspension.damping.proportional"\n'
            'from = "0.01 s"\nto = "0.5 s"\nspacing = "logarithmic"\n'
        )
        required = '[requirements]\nband = ["0 rad/s", "200 rad/s"]\nno_peak = "coordinates"\n[requirements.limits]\n'
        found, best = self.optimum(model + parameters + required + limits + "\n[analyses.optimize]\nstarts = 8\n")
        mapped = result_of("map", path, "--points", "41")
        self.assertAlmostEqual(best["scale"], 10, delta=10 * OBJECTIVE)  # stiffer is always better
        self.assertGreaterEqual(found["after"] * (1 + MAPPED), max(m for m in mapped["grid"]["margin"] if m))
        self.assertAlmostEqual(found["after"] / mapped["best"]["margin"], 1, delta=MAPPED)
        [governing] = found["active"]
        self.assertEqual(
            governing["requirement"],
            mapped["rules"][mapped["best"]["governing"]]["words"].replace("0.0205 rad", "20.5 mrad"),
        )


if __name__ == "__main__":
    unittest.main()
