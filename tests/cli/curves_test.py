# SPDX-License-Identifier: BSD-3-Clause
"""`trivet curves`: rational models of the characteristics, evaluated here and compared with the solved response."""
import bisect
import cmath
import json
import math
import os
import pathlib
import random
import subprocess
import tempfile
import unittest

from trivet_test import HANGS_AFTER

TRIVET = os.environ["TRIVET"]
SOURCE = pathlib.Path(os.environ["TRIVET_SOURCE"])
EXAMPLES = SOURCE / "examples"
TEN_BODIES = SOURCE / "benchmarks/ten_bodies.toml"
ALLOWED = 1e-3  # relative error of a plot; the models are built to a tenth of it

# One body with 8 results, of the size that a page redraws at every move of a slider.
ONE_BODY = """trivet = 1
[bodies.machine]
mass = 120
inertia = {about = "center_of_mass", xx = 6, yy = 9, zz = 7}
[element_types.mount]
type = "bushing"
translation = [4e5, 4e5, 8e5]
damping = {loss_factor = 0.1}
[elements.a]
type = "mount"
on = "machine"
at = [0.4, 0.3, -0.2]
[elements.b]
type = "mount"
on = "machine"
at = [-0.4, 0.3, -0.2]
[elements.c]
type = "mount"
on = "machine"
at = [0, -0.35, -0.2]
[excitations.shake]
type = "harmonic"
on = "machine"
at = [0.1, 0.05, 0.2]
force = [30, 10, 100]
[analyses]
response = {of = ["machine", "ground.force.x", "ground.force.z"]}
"""

# A ground that moves with a wave, so that each end has its own delay, loss factors, and a delayed force.
MOVING_GROUND = """trivet = 1
[bodies.car]
mass = 900
inertia = {about = "center_of_mass", xx = 300, yy = 900, zz = 1000}
points.seat = [0.4, 0.2, 0.3]
[element_types.leg]
type = "bushing"
translation = [6e4, 6e4, 3e4]
damping = {loss_factor = 0.15}
[elements.front]
type = "leg"
on = "car"
at = [1.2, 0, -0.3]
[elements.rear_left]
type = "leg"
on = "car"
at = [-1.2, 0.6, -0.3]
[elements.rear_right]
type = "leg"
on = "car"
at = [-1.2, -0.6, -0.3]
[excitations.road]
type = "base"
translation = [0, 0, 1e-3]
wave = {direction = "-x", speed = "60 km/h"}
[excitations.engine]
type = "harmonic"
on = "car"
at = [1, 0, 0]
force = [0, 0, 50]
delay = "20 ms"
[analyses]
response = {of = ["coordinates"], band = ["0.2 Hz", "8 Hz"]}
"""


def result(*arguments):
    done = subprocess.run([TRIVET, *map(str, arguments), "--json"], capture_output=True, text=True, timeout=HANGS_AFTER)
    assert done.returncode == 0, (arguments[:4], done.stderr[:2000])
    return json.loads(done.stdout)


def written(test, text):
    folder = tempfile.TemporaryDirectory()
    test.addCleanup(folder.cleanup)
    file = pathlib.Path(folder.name) / "machine.toml"
    file.write_text(text, encoding="utf-8")
    return file


def pairs(flat):
    return [complex(re, im) for re, im in zip(flat[::2], flat[1::2])]


class Model:
    """Evaluates a model as docs/json.md defines it: barycentric in each piece, times e^(−iωd) for each delay d."""

    def __init__(self, model):
        self.delays = model["delays"]
        self.pieces = [
            (piece["band"], piece["nodes"], pairs(piece["weights"]), [pairs(row) for row in piece["values"]])
            for piece in model["pieces"]
        ]

    def at(self, omega):
        ends = [band[1] for band, *_ in self.pieces]
        _, nodes, weights, values = self.pieces[min(bisect.bisect_left(ends, omega), len(ends) - 1)]
        if omega in nodes:
            shares = [float(node == omega) for node in nodes]
        else:
            shares = [weight / (omega - node) for weight, node in zip(weights, nodes)]
        whole = sum(shares)
        rows = [sum(share * value for share, value in zip(shares, row)) / whole for row in values]
        curves = len(rows) // len(self.delays)
        return [
            sum(cmath.exp(-1j * omega * delay) * rows[d * curves + c] for d, delay in enumerate(self.delays))
            for c in range(curves)
        ]


class Curves(unittest.TestCase):
    def compare(self, file, seed):
        """Models against solved responses at 200 random frequencies. Returns the largest relative error."""
        curves = result("curves", file)
        low, high = curves["band"]
        chance = random.Random(seed)
        omega = sorted(chance.uniform(low + 1e-9 * high, high) for _ in range(200))
        names = [one["name"] for one in curves["results"]]
        solved = result(
            *("response", file, "--at", ",".join(f"{w!r} rad/s" for w in omega)),
            *("--set", f"analyses.response.of = {json.dumps(names)}"),
        )
        self.assertEqual([one["name"] for one in solved["results"]], names)
        self.assertEqual([one["unit"] for one in solved["results"]], [one["unit"] for one in curves["results"]])
        model = Model(curves["models"][0])
        found = [model.at(w) for w in solved["angular_frequency"]]
        worst = 0.0
        for c, one in enumerate(solved["results"]):
            truth = [complex(*z) for z in one["complex"]]
            top = max(map(abs, truth))
            of_unit = max(abs(complex(*z)) for r in solved["results"] if r["unit"] == one["unit"] for z in r["complex"])
            if names[c] in curves["vanishing"] or top < 1e-10 * of_unit:
                continue  # round-off in both
            for k, z in enumerate(truth):
                around = max(abs(t) for t in truth[max(k - 3, 0) : k + 4])
                error = abs(found[k][c] - z) / max(abs(z), 1e-3 * around)
                worst = max(worst, error)
        self.assertLessEqual(worst, ALLOWED)
        self.assertLessEqual(curves["interpolation_error"], 1e-4)
        return worst

    def test_models_are_the_solved_response_at_random_frequencies(self):
        for seed, file in enumerate(
            (
                EXAMPLES / "isolator/hardening.toml",
                EXAMPLES / "genset/genset.toml",
                EXAMPLES / "paper/corrected.toml",
                EXAMPLES / "bogie/loaded_frame.toml",
                EXAMPLES / "track/bogie.toml",
                EXAMPLES / "frame/frame.toml",
                TEN_BODIES,
                written(self, ONE_BODY),
                written(self, MOVING_GROUND),
            )
        ):
            with self.subTest(file=file):
                self.compare(file, seed)

    def test_constant_matrices_need_one_solve_for_each_pole_and_a_few_tests(self):
        for file, bodies in ((TEN_BODIES, 10), (written(self, ONE_BODY), 1)):
            curves = result("curves", file, "--draft")
            self.assertEqual(len(curves["models"][0]["pieces"]), 1)
            self.assertLessEqual(curves["solves"], 12 * bodies + 11)
            self.assertLess(curves["interpolation_error"], 1e-5)

    def test_a_wave_and_a_delayed_force_have_delays_of_their_own(self):
        model = result("curves", written(self, MOVING_GROUND))["models"][0]
        speed = 60 / 3.6
        # −x: the front leg moves with the origin's motion 1.2 m / speed earlier, the rear ones as much later
        self.assertEqual(len(model["delays"]), 3)
        found = sorted(model["delays"])
        for delay, wanted in zip(found, sorted((-1.2 / speed, 1.2 / speed, 0.02))):
            self.assertAlmostEqual(delay, wanted, 12)
        self.assertEqual(model["excitations"], ["road", "engine"])

    def test_peaks_natural_frequencies_and_results_are_those_of_their_commands(self):
        file = written(self, ONE_BODY + '[limits]\n"machine.z" = "1 mm"\n')
        curves = result("curves", file)
        of = [one["name"] for one in curves["results"]]
        self.assertEqual(of[:6], [f"machine.{c}" for c in ("x", "y", "z", "rx", "ry", "rz")])
        self.assertEqual(of[6:8], ["ground.force.x", "ground.force.z"])
        self.assertEqual(set(of[8:]), {"ground.force.y", "ground.moment.x", "ground.moment.y", "ground.moment.z"})
        kinds = {one["name"]: one["kind"] for one in curves["results"]}
        self.assertEqual((kinds["machine.z"], kinds["machine.rx"]), ("displacement", "rotation"))
        self.assertEqual((kinds["ground.force.z"], kinds["ground.moment.z"]), ("force", "moment"))
        peaks = result("peaks", file, "--set", f"analyses.response.of = {json.dumps(of)}")["peaks"]
        self.assertGreater(len(peaks), 10)
        self.assertEqual(len(curves["peaks"]), len(peaks))
        model, place = Model(curves["models"][0]), {name: c for c, name in enumerate(of)}
        for drawn, exact in zip(curves["peaks"], peaks):
            self.assertEqual(drawn["result"], exact["name"])
            self.assertEqual(drawn["amplitude"], exact["amplitude"])
            self.assertEqual(drawn["angular_frequency"], exact["angular_frequency"])
            value = model.at(drawn["angular_frequency"])[place[drawn["result"]]]
            self.assertAlmostEqual(abs(value) / drawn["amplitude"], 1, delta=1e-4)
            self.assertAlmostEqual(cmath.phase(value), drawn["phase"], delta=1e-9)
            extrema = next(one["extrema"] for one in curves["results"] if one["name"] == drawn["result"])
            self.assertIn([drawn["angular_frequency"], drawn["amplitude"]], extrema)
        modes = result("modes", file)["modes"]
        self.assertEqual(curves["natural"], [mode["angular_frequency"] for mode in modes])
        limit = curves["limits"][0]
        self.assertEqual((limit["result"], limit["limit"]), ("machine.z", 1e-3))
        response = result("response", file)
        largest = max(abs(complex(*z)) for z in response["results"][2]["complex"])
        self.assertAlmostEqual(limit["in_band"] / largest, 1, 9)
        self.assertEqual(curves["band"], [response["angular_frequency"][0], response["angular_frequency"][-1]])

    def test_limit_lines_are_those_of_the_file(self):
        text = ONE_BODY + '[limit_lines.hall]\nof = "machine.z"\nunit = "mm/s"\nrows = [[5, 2], [30, 1]]\n'
        file = written(self, text)
        line = result("curves", file)["lines"][0]
        judged = result("limit_lines", file)[0]
        self.assertEqual(line["limit"], [0.002, 0.001])
        for omega, hertz in zip(line["angular_frequency"], (5, 30)):
            self.assertAlmostEqual(omega, 2 * math.pi * hertz, 9)
        self.assertEqual((line["least_margin"], line["exceeded"]), (judged["least_margin"], judged["exceeded"]))

    def test_keys_choose_results_and_band(self):
        file = written(self, ONE_BODY)
        curves = result("curves", file, "--of", "machine.z", "--of", "a.force.z", "--band", "4 Hz,30 Hz")
        self.assertEqual([one["name"] for one in curves["results"]], ["machine.z", "a.force.z"])
        for omega, hertz in zip(curves["band"], (4, 30)):
            self.assertAlmostEqual(omega, 2 * math.pi * hertz, 9)
        done = subprocess.run([TRIVET, "curves", file, "--of", "machine.q"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("machine.q", done.stderr)

    def test_motions_in_another_quantity_are_those_of_the_file_times_i_omega(self):
        file = written(self, ONE_BODY + '[limits]\n"machine.z" = "1 mm"\n')
        given, velocity = result("curves", file), result("curves", file, "--quantity", "velocity")
        self.assertEqual([len(given["limits"]), len(velocity["limits"])], [1, 0])
        low, high = given["band"]
        for omega in (low + 0.21 * (high - low), low + 0.77 * (high - low)):
            before, after = (Model(one["models"][0]).at(omega) for one in (given, velocity))
            for c, one in enumerate(given["results"]):
                motion = one["unit"] in ("m", "rad")
                self.assertEqual(velocity["results"][c]["unit"], one["unit"] + "/s" if motion else one["unit"])
                expected = 1j * omega * before[c] if motion else before[c]
                self.assertLess(abs(after[c] - expected), ALLOWED * abs(expected))

    def test_three_springs_in_place_of_every_element_have_the_peaks_of_element(self):
        file = EXAMPLES / "three_coil_springs/machine.toml"
        compared = result("element", file, "spring x", "--all")["simplification"]["peaks"]
        full, simple = (result("curves", file, *more)["peaks"] for more in ([], ["--three-springs"]))
        checked = 0
        for one in compared:
            for key, peaks in (("peak", full), ("simplified_peak", simple)):
                mine = [p for p in peaks if p["result"] == one["name"]]
                if one[key] is None or not mine:
                    continue
                highest = max(mine, key=lambda p: p["amplitude"])
                self.assertAlmostEqual(highest["amplitude"] / one[key]["amplitude"], 1, 6)
                self.assertAlmostEqual(highest["angular_frequency"] / one[key]["angular_frequency"], 1, 6)
                checked += 1
        self.assertGreater(checked, 8)

    def test_a_draft_has_the_curves_without_exact_peaks(self):
        for file in (written(self, ONE_BODY), EXAMPLES / "genset/genset.toml", EXAMPLES / "track/bogie.toml"):
            draft, whole = result("curves", file, "--draft"), result("curves", file)
            self.assertEqual((draft["peaks"], draft["limits"]), ([], []))
            self.assertTrue(all(one["extrema"] == [] for one in draft["results"]))
            self.assertEqual(draft["natural"], whole["natural"])
            for a, b in zip(draft["band"], whole["band"]):  # a root may be the highest, and a draft does not refine it
                self.assertAlmostEqual(a, b, delta=1e-9 * b)
            first, second = Model(draft["models"][0]), Model(whole["models"][0])
            low, high = draft["band"]
            chance = random.Random(54)
            omega = [chance.uniform(low + 1e-9 * high, high) for _ in range(200)]
            names = [one["name"] for one in draft["results"]]
            pairs_of_values = [(first.at(w), second.at(w)) for w in omega]
            for c, name in enumerate(names):
                top = max(abs(b[c]) for _, b in pairs_of_values)
                of_unit = max(
                    abs(b[d])
                    for _, b in pairs_of_values
                    for d, one in enumerate(draft["results"])
                    if one["unit"] == draft["results"][c]["unit"]
                )
                if name in whole["vanishing"] or top < 1e-9 * of_unit:
                    continue
                for a, b in pairs_of_values:
                    self.assertLessEqual(abs(a[c] - b[c]), ALLOWED * abs(b[c]) + 1e-6 * top, name)

    def test_one_body_with_eight_results_travels_in_20_kilobytes(self):
        eight = [f"machine.{c}" for c in ("x", "y", "z", "rx", "ry", "rz")] + ["ground.force.x", "ground.force.z"]
        keys = [word for name in eight for word in ("--of", name)]
        done = subprocess.run(
            [TRIVET, "curves", written(self, ONE_BODY), *keys, "--json"], capture_output=True, timeout=HANGS_AFTER
        )
        self.assertEqual(len(json.loads(done.stdout)["results"]), 8)
        self.assertLess(len(done.stdout), 20000)

    def test_the_table_for_people_has_the_largest_amplitudes(self):
        file = written(self, ONE_BODY)
        done = subprocess.run([TRIVET, "curves", file], capture_output=True, text=True, timeout=HANGS_AFTER)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("machine.rz", done.stdout)
        self.assertRegex(done.stdout, r"Rational model from 0 Hz to .* Hz: \d+ nodes")


if __name__ == "__main__":
    unittest.main()
