# SPDX-License-Identifier: BSD-3-Clause
"""Load cases and their envelope against calculations by hand."""
import json
import math
import os
import re
import unittest

from clearances_test import OSCILLATOR
from trivet_test import SOURCE, InTemporaryFolder, result_of, trivet

CLOSE = 1e-9  # relative: statics of six coordinates, and peaks with their nine digits
G = 9.80665

# A generating set on four mounts in one plane; the pole is in the middle of the mounts.
A, B = 0.9, 0.4  # half distances of the mounts along x and y
MASS, CENTRE = 1200.0, (0.13, -0.05, 0.45)
STIFFNESS = (8e5, 6e5, 1.5e6)
TORQUE = 1400.0  # about x, reaction of the generator
PLACES = {"fl": (A, B), "fr": (A, -B), "rl": (-A, B), "rr": (-A, -B)}
POINT = (1.1, 0.2, 0.9)
DIRECTION = (0.48, 0.6, -0.64)
GAP = 0.009


def tilted(list_angle, trim_angle, factor=1.0):
    """Gravity in the frame of a ship with the side of y and the end of x down."""
    sl, cl, st = math.sin(list_angle), math.cos(list_angle), math.sin(trim_angle)
    ct = math.cos(trim_angle)
    return [factor * G * st, factor * G * ct * sl, -factor * G * ct * cl]


CASES = {
    "": (tilted(0, 0), 0),
    "list and trim": (tilted(math.radians(15), math.radians(5)), 0),
    "torque": (tilted(0, 0), TORQUE),
    "2 g down": (tilted(0, 0, 2), 0),
    "all": (tilted(math.radians(15), math.radians(5), 2), TORQUE),
}


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b, strict=True))


def of_mounts(force, moment):
    """Translation and rotation at the pole by the mounts alone: the springs in one plane do not couple there."""
    kx, ky, kz = STIFFNESS
    turning = (4 * kz * B * B, 4 * kz * A * A, 4 * (kx * B * B + ky * A * A))
    translation = [f / (4 * k) for f, k in zip(force, STIFFNESS, strict=True)]
    return translation, [m / k for m, k in zip(moment, turning, strict=True)], turning


def forces_at_rest(translation, rotation, weight):
    """What the forces on the body add to its stiffness against rotation: ∑ (a·F) 1 − ½ (a Fᵀ + F aᵀ)."""
    forces = [(CENTRE, weight)]
    for x, y in PLACES.values():
        at = (x, y, 0)
        sag = [t + c for t, c in zip(translation, cross(rotation, at), strict=True)]
        forces.append((at, [-k * d for k, d in zip(STIFFNESS, sag, strict=True)]))
    return [
        [sum((dot(a, f) if i == j else 0) - (a[i] * f[j] + f[i] * a[j]) / 2 for a, f in forces) for j in range(3)]
        for i in range(3)
    ]


def motion(gravity, torque):
    """At the pole: by the weight to first order; the torque meets what the weight and it leave of the stiffness."""
    weight = [MASS * g for g in gravity]
    moment = cross(CENTRE, weight)
    translation, rotation, turning = of_mounts(weight, moment)
    if torque == 0:
        return translation, rotation
    added = forces_at_rest(translation, of_mounts(weight, [moment[0] + torque, *moment[1:]])[1], weight)
    held = [[added[i][j] + (turning[i] if i == j else 0) for j in range(3)] for i in range(3)]
    across = cross(held[1], held[2])  # Cramer's rule for held · θ = (torque, 0, 0)
    determinant = dot(held[0], across)
    return translation, [r + torque * c / determinant for r, c in zip(rotation, across, strict=True)]


def moved(at, gravity, torque):
    translation, rotation = motion(gravity, torque)
    return [t + c for t, c in zip(translation, cross(rotation, at), strict=True)]


REACTION = """[excitations.reaction]
type = "constant"
on = "genset"
at = [0, 0, 0]
moment = [0, 0, 0]
"""


UPRIGHT = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]


def genset(more="", reaction=REACTION, gap=GAP, turn=UPRIGHT):
    """@param turn  rows of the rotation of the whole machine in the ground frame"""

    def turned(vector):
        return [dot(row, vector) for row in turn]

    text = f"""trivet = 1
gravity = {turned(CASES[""][0])}
[bodies.genset]
mass = {MASS}
orientation = {{matrix = {turn}}}
center_of_mass = {list(CENTRE)}
inertia = {{about = "center_of_mass", xx = 90, yy = 210, zz = 230}}
points.corner = {list(POINT)}
{reaction}[clearances.casing]
between = ["genset.corner", "ground"]
direction = {turned(DIRECTION)}
gap = {gap}
[analyses]
static = {{of = ["genset"]}}
"""
    for name, (x, y) in PLACES.items():
        text += (
            f'[elements.{name}]\ntype = "bushing"\non = "genset"\nat = [{x}, {y}, 0]\ntranslation = {list(STIFFNESS)}\n'
        )
    for name, (gravity, torque) in CASES.items():
        if name:
            text += f'[cases."{name}"]\ngravity = {turned(gravity)}\n'
            text += f"excitations.reaction.moment = [{torque}, 0, 0]\n" if reaction else ""
    return text + more


def by_hand():
    """Every quantity of the envelope in every case."""
    values = {}
    for case, (gravity, torque) in CASES.items():
        translation, rotation = motion(gravity, torque)
        for name, value in zip(("x", "y", "z", "rx", "ry", "rz"), translation + rotation, strict=True):
            values.setdefault(f"genset.{name}", {})[case] = value
        for name, (x, y) in PLACES.items():
            u = moved((x, y, 0), gravity, torque)
            values.setdefault(f"{name}, compression", {})[case] = -STIFFNESS[2] * u[2]
            values.setdefault(f"{name}, force across", {})[case] = math.hypot(STIFFNESS[0] * u[0], STIFFNESS[1] * u[1])
            values.setdefault(f"{name}, deflection", {})[case] = u[2]
        values.setdefault("casing, gap left", {})[case] = GAP - dot(DIRECTION, moved(POINT, gravity, torque))
    return values


class LoadCases(InTemporaryFolder):
    def near(self, found, expected, scale=None):
        self.assertLessEqual(abs(found - expected), CLOSE * (scale or abs(expected)), (found, expected))

    def test_envelope_over_list_trim_torque_and_2_g(self):
        found = result_of("verdict", self.file(genset()))
        expected = by_hand()
        rows = {row["name"]: row for row in found["envelope"]["quantities"]}
        self.assertEqual(set(rows), set(expected))
        for name, values in expected.items():
            row, scale = rows[name], max(map(abs, values.values()))
            for end, pick in (("least", min), ("largest", max)):
                self.near(row[end], pick(values.values()), scale)
                self.near(values[row[f"{end}_in"]], row[end], scale)
        self.assertEqual(found["envelope"]["left_out"], [])

    def test_turning_the_whole_machine_changes_nothing(self):
        c, s, d, t = math.cos(0.5), math.sin(0.5), math.cos(1.1), math.sin(1.1)
        turn = [[d, -t * c, t * s], [t, d * c, -d * s], [0, s, c]]  # about x, then about z
        rows = {
            row["name"]: row for row in result_of("verdict", self.file(genset(turn=turn)))["envelope"]["quantities"]
        }
        for name, values in by_hand().items():
            scale = max(map(abs, values.values()))
            self.near(rows[name]["least"], min(values.values()), scale)
            self.near(rows[name]["largest"], max(values.values()), scale)

    def test_clearance_of_every_case(self):
        found = result_of("verdict", self.file(genset()))
        for case in found["cases"]:
            gravity, torque = CASES[case["case"]]
            approach = dot(DIRECTION, moved(POINT, gravity, torque))
            (result,) = case["requirements"]
            self.assertEqual((result["kind"], result["subject"]), ("clearance", "casing"))
            self.near(result["value"], approach, GAP)
            self.near(result["allowed"], GAP)
            if approach > 0:
                self.near(result["margin"], GAP / approach)
            else:
                self.assertEqual((result["margin"], result["met"]), (None, True))  # it opens: nothing limits it

    def test_round_off_of_the_largest_load_or_deflection_is_0(self):
        preloaded = result_of("check", SOURCE / "examples/bogie/loaded_frame.toml")["mounts"]
        self.assertTrue(all(mount["compression"] > 1e4 for mount in preloaded if "spring" in mount["element"]))
        self.assertEqual({mount["deflection"] for mount in preloaded}, {0})  # the preload bears all of it
        self.assertEqual({mount["across"] for mount in preloaded}, {0})
        upright = result_of("check", self.file(genset()))["mounts"]
        self.assertTrue(all(abs(mount["deflection"]) > 1e-4 for mount in upright))

    def test_a_gap_closed_at_rest_has_its_overlap(self):
        path = self.file(genset(gap=1e-3))
        approaches = {case: dot(DIRECTION, moved(POINT, *loads)) for case, loads in CASES.items()}
        found = result_of("verdict", path)
        for case in found["cases"]:
            (result,) = case["requirements"]
            overlap = approaches[case["case"]] - 1e-3
            self.assertEqual(result["met"], overlap <= 0)
            if overlap > 0:
                value, unit = re.search(r"closed at rest, overlap (\S+) (µ?m+)", result["detail"]).groups()
                self.near(float(value) * {"mm": 1e-3, "µm": 1e-6}[unit], overlap, 5e-4 * overlap / CLOSE)  # four digits
        self.assertTrue(any(a > 1e-3 for a in approaches.values()))
        strict = trivet("verdict", path, "--strict")
        self.assertEqual(strict.returncode, 3)
        self.assertIn("VIOLATED", strict.stdout)
        self.assertTrue(
            all(case["decides"] for case in found["cases"])
        )  # no requirements: nothing may touch in any case
        required = result_of("verdict", self.file(genset("[requirements]\ndamping_ratio = 1e-3\n", gap=1e-3)))
        self.assertEqual([case["decides"] for case in required["cases"]], [True] + [False] * (len(CASES) - 1))

    def test_a_case_has_a_force_of_its_own(self):
        own = "[cases.own.excitations.reaction]" + REACTION.partition("]")[2].replace(
            "[0, 0, 0]\n", f"[{TORQUE}, 0, 0]\n"
        )
        own = own.replace(f"at = [{TORQUE}, 0, 0]", "at = [0, 0, 0]")
        found = result_of("verdict", self.file(genset(own, reaction="")))
        case = next(c for c in found["cases"] if c["case"] == "own")
        self.near(case["requirements"][0]["value"], dot(DIRECTION, moved(POINT, CASES[""][0], TORQUE)), GAP)
        driven = genset(own.replace("constant", "harmonic"), reaction="")
        self.assertIn("no such key or part", trivet("verdict", self.file(driven)).stderr)

    def test_cases_without_rest_are_named(self):
        done = trivet("verdict", self.file(OSCILLATOR.replace(f"gravity = [0, 0, -{G}]", "")))
        self.assertEqual(done.returncode, 2)
        self.assertIn("clearances: static: the model has no static load", done.stderr)
        # With the weight to second order the case falls over, which is an error of every command.
        first_order = genset().replace("trivet = 1", "trivet = 1\nsecond_order = false")
        floating = first_order + (
            "[cases.afloat]\n" + "".join(f"elements.{n}.translation = [0, 0, 1]\n" for n in PLACES)
        )
        path = self.file(floating)
        done = trivet("verdict", path)
        self.assertEqual(done.returncode, 2)
        self.assertIn('case "afloat": clearances', done.stderr)
        self.assertIn("position of rest is not unique", done.stderr)
        self.assertEqual(trivet("modes", path).returncode, 0)  # does not request it

    def test_a_stop_is_compressed_by_what_presses_it(self):
        text = """trivet = 1
gravity = [0, 0, GRAVITY]
[bodies.m]
mass = 10
free = ["z"]
[elements.spring]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [0, 0, 10000]
[elements.bump]
type = "stop"
on = "m"
at = [0, 0, 0]
axis = "AXIS"
gaps = ["4 mm", "5 mm"]
stiffness = 20000
"""
        for gravity, axis, gap in ((-9.81, "-z", 4e-3), (-9.81, "z", 5e-3), (9.81, "z", 4e-3)):
            path = self.file(text.replace("GRAVITY", str(gravity)).replace("AXIS", axis))
            of = {mount["element"]: mount for mount in result_of("check", path)["mounts"]}
            travel = (98.1 + 20000 * gap) / 30000
            self.near(of["bump"]["compression"], 20000 * (travel - gap))
            self.near(of["spring"]["compression"], math.copysign(10000 * travel, -gravity))
            notes = trivet("modes", path)
            self.assertIn(": it bears", notes.stdout + notes.stderr)

    def test_run_and_check(self):
        path, target = self.file(genset()), self.folder / "out"
        done = trivet("run", path, "-o", target, "--full")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("casing, gap left", done.stdout)
        results = json.loads((target / "results.json").read_text())
        rows = {row["name"]: row for row in results["envelope"]["quantities"]}
        self.assertEqual(set(rows), set(by_hand()))
        self.assertEqual(len((target / "envelope.csv").read_text().splitlines()), 1 + len(rows))
        page = (target / "report.html").read_text()
        self.assertIn("Load cases", page)
        self.assertNotIn("after the largest dynamic motion", page)
        self.assertIn("after the motions that the requirement of the clearance counts", page)
        two_stages = self.folder / "two stages"
        trivet("run", SOURCE / "examples/two_stage/pump_on_raft.toml", "-o", two_stages)
        page = (two_stages / "report.html").read_text()
        self.assertIn("Every case under its own gravity", page)
        self.assertNotIn("gap left", page)  # it has no clearances
        check = trivet("check", path).stdout
        self.assertIn("mount at rest", check)
        self.assertIn(f"trivet verdict {path}", check)
        mounts = result_of("check", path)["mounts"]
        self.assertEqual(len(mounts), len(CASES) * len(PLACES))
        hand = by_hand()
        for mount in mounts:
            self.near(mount["compression"], hand[f"{mount['element']}, compression"][mount["case"]], 1e4)

    def test_a_value_and_its_case_stay_together_on_a_narrow_screen(self):
        path = self.file(genset())
        rows = result_of("verdict", path)["envelope"]["quantities"]
        wide, narrow = (
            trivet("verdict", path, env={**os.environ, "COLUMNS": width}).stdout.split("at rest, over all cases")[1:]
            for width in ("200", "60")
        )
        self.assertEqual((len(wide), len(narrow)), (1, 2))  # below each other
        for row in rows:
            for part, key in zip(narrow, ("least", "largest"), strict=True):
                line = next(line for line in part.splitlines() if line.strip().startswith(row["name"] + "  "))
                self.assertTrue(line.endswith(row[key + "_in"] or "base model"), line)

    def test_of_cases_that_do_not_differ_the_first_is_named(self):
        """Four equal mounts share the weight equally, however stiff they are, but for the second order of their deflection."""
        rows = result_of("verdict", SOURCE / "examples/compressor/requirements.toml")["envelope"]["quantities"]
        loads = [row for row in rows if row["name"].endswith(", compression")]
        self.assertEqual(len(loads), 4)
        for row in loads:
            self.assertLess(row["largest"] - row["least"], 1e-6 * row["largest"])
            self.assertEqual((row["least_in"], row["largest_in"]), ("", ""))


if __name__ == "__main__":
    unittest.main()
