# SPDX-License-Identifier: BSD-3-Clause
"""Load cases, clearances, section forces and relative motions against calculations by hand."""
import json
import math
import re
import unittest

from trivet_test import InTemporaryFolder, answer, trivet

CLOSE = 1e-9  # relative: statics of six coordinates, and peaks with their nine digits
SINGLE = 1e-7  # relative: maps store margins in single precision
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


def motion(gravity, torque):
    """Translation and rotation at the pole: the springs in one plane do not couple there."""
    force = [MASS * g for g in gravity]
    moment = cross(CENTRE, force)
    moment[0] += torque
    kx, ky, kz = STIFFNESS
    turning = (4 * kz * B * B, 4 * kz * A * A, 4 * (kx * B * B + ky * A * A))
    return [f / (4 * k) for f, k in zip(force, STIFFNESS, strict=True)], [
        m / k for m, k in zip(moment, turning, strict=True)
    ]


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
        found = answer("verdict", self.file(genset()))
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
        rows = {row["name"]: row for row in answer("verdict", self.file(genset(turn=turn)))["envelope"]["quantities"]}
        for name, values in by_hand().items():
            scale = max(map(abs, values.values()))
            self.near(rows[name]["least"], min(values.values()), scale)
            self.near(rows[name]["largest"], max(values.values()), scale)

    def test_clearance_of_every_case(self):
        found = answer("verdict", self.file(genset()))
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

    def test_a_gap_closed_at_rest_has_its_overlap(self):
        path = self.file(genset(gap=1e-3))
        approaches = {case: dot(DIRECTION, moved(POINT, *loads)) for case, loads in CASES.items()}
        found = answer("verdict", path)
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
        required = answer("verdict", self.file(genset("[requirements]\ndamping_ratio = 1e-3\n", gap=1e-3)))
        self.assertEqual([case["decides"] for case in required["cases"]], [True] + [False] * (len(CASES) - 1))

    def test_a_case_has_a_force_of_its_own(self):
        own = "[cases.own.excitations.reaction]" + REACTION.partition("]")[2].replace(
            "[0, 0, 0]\n", f"[{TORQUE}, 0, 0]\n"
        )
        own = own.replace(f"at = [{TORQUE}, 0, 0]", "at = [0, 0, 0]")
        found = answer("verdict", self.file(genset(own, reaction="")))
        case = next(c for c in found["cases"] if c["case"] == "own")
        self.near(case["requirements"][0]["value"], dot(DIRECTION, moved(POINT, CASES[""][0], TORQUE)), GAP)
        driven = genset(own.replace("constant", "harmonic"), reaction="")
        self.assertIn("no such key or part", trivet("verdict", self.file(driven)).stderr)

    def test_cases_without_rest_are_named(self):
        done = trivet("verdict", self.file(OSCILLATOR.replace(f"gravity = [0, 0, -{G}]", "")))
        self.assertEqual(done.returncode, 2)
        self.assertIn("clearances: static: the model has no static load", done.stderr)
        floating = genset("[cases.afloat]\n" + "".join(f"elements.{n}.translation = [0, 0, 1]\n" for n in PLACES))
        path = self.file(floating)
        done = trivet("verdict", path)
        self.assertEqual(done.returncode, 2)
        self.assertIn('case "afloat": clearances', done.stderr)
        self.assertIn("position of rest is not unique", done.stderr)
        self.assertEqual(trivet("modes", path).returncode, 0)  # does not ask for it

    def test_run_and_check(self):
        path, target = self.file(genset()), self.folder / "out"
        done = trivet("run", path, "-o", target)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("casing, gap left", done.stdout)
        results = json.loads((target / "results.json").read_text())
        rows = {row["name"]: row for row in results["envelope"]["quantities"]}
        self.assertEqual(set(rows), set(by_hand()))
        self.assertEqual(len((target / "envelope.csv").read_text().splitlines()), 1 + len(rows))
        self.assertIn("Load cases", (target / "report.html").read_text())
        check = trivet("check", path).stdout
        self.assertIn("mount at rest", check)
        self.assertIn(f"trivet verdict {path}", check)
        mounts = answer("check", path)["mounts"]
        self.assertEqual(len(mounts), len(CASES) * len(PLACES))
        hand = by_hand()
        for mount in mounts:
            self.near(mount["compression"], hand[f"{mount['element']}, compression"][mount["case"]], 1e4)


M, K, C = 40.0, 2.5e5, 400.0
OSCILLATOR = f"""trivet = 1
gravity = [0, 0, -{G}]
[bodies.m]
mass = {M}
free = ["z"]
[elements.s]
type = "bushing"
on = "m"
at = [0, 0, 0]
translation = [1, 1, {K}]
damping = {{translation = [1e-3, 1e-3, {C}]}}
[clearances.floor]
between = ["m", "ground"]
direction = "-z"
gap = "6 mm"
"""
FORCE = '[excitations.f]\ntype = "harmonic"\non = "m"\nat = [0, 0, 0]\nforce = [0, 0, 30]\n'
STEP = '[excitations.s]\ntype = "time"\non = "m"\nat = [0, 0, 0]\nforce = [0, 0, -1]\nhistory = {step = {amplitude = 50}}\n'
RATIO = C / (2 * math.sqrt(K * M))
SAG, PEAK = M * G / K, 30 / K / (2 * RATIO * math.sqrt(1 - RATIO**2))
OVERSHOOT = 50 / K * (1 + math.exp(-math.pi * RATIO / math.sqrt(1 - RATIO**2)))


class Clearances(InTemporaryFolder):
    def judged(self, text):
        (result,) = answer("verdict", self.file(text))["cases"][0]["requirements"]
        return result

    def near(self, found, expected):
        self.assertLessEqual(abs(found / expected - 1), CLOSE, (found, expected))

    def test_rest_harmonic_and_transient_motion_add(self):
        self.near(self.judged(OSCILLATOR)["value"], SAG)
        harmonic = self.judged(OSCILLATOR + FORCE)
        self.near(harmonic["value"], SAG + PEAK)
        self.near(harmonic["margin"], 6e-3 / (SAG + PEAK))
        self.near(harmonic["angular_frequency"], math.sqrt(K / M * (1 - 2 * RATIO**2)))
        both = self.judged(OSCILLATOR + FORCE + STEP + "[analyses]\ntransient = {}\n")
        self.near(both["value"], SAG + PEAK + OVERSHOOT)
        self.assertEqual([word in both["detail"] for word in ("at rest", "harmonic", "transient", "left")], [True] * 4)
        self.assertIn("not counted: time histories", self.judged(OSCILLATOR + FORCE + STEP)["detail"])

    def test_only_the_band_of_the_requirements_counts(self):
        low = self.judged(OSCILLATOR + FORCE + '[requirements]\nband = ["0 Hz", "5 Hz"]\n')
        w = 10 * math.pi
        self.near(low["value"], SAG + 30 / math.hypot(K - M * w * w, C * w))

    def test_motion_away_opens_the_gap(self):
        above = OSCILLATOR.replace('direction = "-z"', 'direction = "z"')
        self.near(self.judged(above)["value"], -SAG)
        self.assertIsNone(self.judged(above)["margin"])
        self.near(self.judged(above + FORCE)["value"], PEAK - SAG)
        # The transient counts only where it closes the gap: the force acts downwards and never lifts the mass.
        self.near(self.judged(above + FORCE + STEP + "[analyses]\ntransient = {}\n")["value"], PEAK - SAG)

    def test_an_undamped_resonance_leaves_no_gap(self):
        undamped = OSCILLATOR.replace(f"damping = {{translation = [1e-3, 1e-3, {C}]}}\n", "")
        found = self.judged(undamped + FORCE)
        self.assertEqual((found["value"], found["margin"], found["met"]), (None, 0, False))
        self.assertIn("unbounded", found["detail"])

    def test_a_governing_clearance_names_its_cause(self):
        case = answer("verdict", self.file(OSCILLATOR.replace("6 mm", "1.6 mm") + FORCE))["cases"][0]
        self.assertIn("floor.approach", case["cause"])

    def test_optimum_between_a_clearance_and_a_natural_frequency(self):
        # Stiffness s K: gap s K / (m g) grows with s, the factor below a window of natural frequencies falls with s.
        window = 2 * math.sqrt(K / M) / (2 * math.pi)
        text = (
            OSCILLATOR.replace("6 mm", "1 mm")
            + f'[requirements]\nnatural_frequencies = {{avoid = [["{window} Hz", "{9 * window} Hz"]]}}\n'
            + '[parameters.stiffness]\npath = "elements.s.scale"\nfrom = 0.2\nto = 5\nspacing = "logarithmic"\n'
            + '[analyses]\noptimize = {}\n'
        )
        found = answer("optimize", self.file(text))
        scale = (2 * SAG / 1e-3) ** (2 / 3)
        self.assertAlmostEqual(found["parameters"][0]["optimum"] / scale, 1, 5)  # residual of the search
        self.assertAlmostEqual(found["after"] / (1e-3 * scale / SAG), 1, 5)
        self.assertIn("clearance", [one["requirement"] for one in found["differenced"]])


# A machine on a frame, both turned; the frame stands on the ground.
ANGLE = 0.4
TWO_BODIES = f"""trivet = 1
gravity = [0, 0, -{G}]
[bodies.frame]
mass = 300
inertia = {{about = "center_of_mass", xx = 20, yy = 30, zz = 40}}
points.flange = [0.3, 0.1, 0.2]
[bodies.machine]
mass = 150
center_of_mass = [0.05, -0.02, 0.1]
inertia = {{about = "center_of_mass", xx = 6, yy = 8, zz = 9}}
position = [0.1, 0.2, 0.5]
orientation = {{axis = "z", angle = {ANGLE}}}
points.flange = [0.2, -0.1, -0.1]
"""
for name_, at_ in {
    "a": [0.5, 0.3, -0.2],
    "b": [0.5, -0.3, -0.2],
    "c": [-0.5, 0.3, -0.2],
    "d": [-0.5, -0.3, -0.2],
}.items():
    TWO_BODIES += f'[elements.{name_}]\ntype = "bushing"\non = "frame"\nat = {at_}\ntranslation = [2e5, 3e5, 4e5]\ndamping = {{loss_factor = 0.1}}\n'
for name_, at_ in {"e": [0.2, 0.2, -0.1], "f": [0.2, -0.2, -0.1], "g": [-0.3, 0, -0.1]}.items():
    TWO_BODIES += f'[elements.{name_}]\ntype = "bushing"\non = "machine"\nfrom = "frame"\nat = {at_}\ntranslation = [9e5, 8e5, 7e5]\nrotation = [200, 300, 400]\ndamping = {{loss_factor = 0.2}}\n'
TWO_BODIES += """[excitations.f]
type = "harmonic"
on = "machine"
at = [0.05, 0.1, 0.2]
force = [10, -20, 30]
moment = [1, 2, 3]
"""
AXIS = (1.0, 2.0, -2.0)
AT = (0.15, 0.05, 0.4)
TURN = 0.7  # of the axes of the section about y
OBSERVED = f"""[relative.coupling]
of = "machine.flange"
to = "frame.flange"
axis = {list(AXIS)}
[sections.joint]
elements = ["e", "f", "g"]
at = {list(AT)}
axes = {{axis = "y", angle = {TURN}}}
"""


def about_z(v, angle):
    c, s = math.cos(angle), math.sin(angle)
    return [c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]]


def in_section(v):
    """Components in axes turned about y."""
    c, s = math.cos(TURN), math.sin(TURN)
    return [c * v[0] - s * v[2], v[1], s * v[0] + c * v[2]]


def across(axis):
    """e1, e2, e3 of docs/conventions.md."""
    e3 = [a / math.sqrt(dot(axis, axis)) for a in axis]
    e1 = [1 - e3[0] * e3[0], -e3[0] * e3[1], -e3[0] * e3[2]]
    e1 = [a / math.sqrt(dot(e1, e1)) for a in e1]
    return e1, cross(e3, e1), e3


class Observations(InTemporaryFolder):
    def near(self, found, expected, scale):
        self.assertLessEqual(abs(found - expected), CLOSE * scale, (found, expected))

    def response(self, more=""):
        names = ["machine", "machine.flange", "frame.flange", "coupling", "joint"]
        asked = f'[analyses.response]\nof = {json.dumps(names)}\nat = ["3 Hz", "11 Hz", "40 Hz"]\n'
        found = answer("response", self.file(TWO_BODIES + OBSERVED + asked + more))
        curves = {r["name"]: [complex(*z) for z in r["complex"]] for r in found["results"]}
        return found["angular_frequency"], curves

    def test_relative_motion_is_the_difference_of_two_points(self):
        frequencies, curves = self.response()
        components = ("radial_1", "radial_2", "axial"), ("angular_1", "angular_2", "torsion")
        for i in range(len(frequencies)):
            for names, letters in zip(components, (("x", "y", "z"), ("rx", "ry", "rz")), strict=True):
                machine = about_z([curves[f"machine.flange.{c}"][i] for c in letters], ANGLE)
                frame = [curves[f"frame.flange.{c}"][i] for c in letters]
                difference = [m - f for m, f in zip(machine, frame, strict=True)]
                scale = max(map(abs, machine + frame))
                for name, axis in zip(names, across(AXIS), strict=True):
                    self.near(curves[f"coupling.{name}"][i], dot(axis, difference), scale)

    def test_relative_to_the_ground_is_the_motion_relative_to_it(self):
        base = '[excitations.shake]\ntype = "base"\ntranslation = [1e-3, 2e-3, 3e-3]\nrotation = [1e-3, 0, 2e-3]\nat = [1, 2, 3]\n'
        more = (
            '[relative.joint]\nof = "ground"\nto = "machine.flange"\naxis = "z"\n[analyses.response]\nat = ["9 Hz"]\n'
        )
        asked = 'of = ["machine.flange.relative", "joint"]\n'
        found = answer("response", self.file(TWO_BODIES + base + more + asked))
        curves = {r["name"]: complex(*r["complex"][0]) for r in found["results"]}
        machine = about_z([curves[f"machine.flange.relative.{c}"] for c in "xyz"], ANGLE)
        scale = max(map(abs, machine))
        for name, value in zip(("radial_1", "radial_2", "axial"), machine, strict=True):
            self.near(curves[f"joint.{name}"], -value, scale)  # the ground less the machine

    def test_section_carries_the_inertia_and_the_loads_above_it(self):
        frequencies, curves = self.response()
        for i, w in enumerate(frequencies):
            q = [curves[f"machine.{c}"][i] for c in ("x", "y", "z", "rx", "ry", "rz")]
            centre, force_at = [0.05, -0.02, 0.1], [0.05, 0.1, 0.2]
            at_centre = [t + c for t, c in zip(q[:3], cross(q[3:], centre), strict=True)]
            inertia = [150 * w * w * u for u in at_centre]
            turning = [w * w * j * a for j, a in zip((6, 8, 9), q[3:], strict=True)]
            # The joint passes on to the frame what acts on the machine, its inertia included; body axes.
            force = [a + b for a, b in zip(inertia, (10, -20, 30), strict=True)]
            arms = [cross(centre, inertia), cross(force_at, (10, -20, 30)), turning, (1, 2, 3)]
            moment = [sum(parts) for parts in zip(*arms, strict=True)]
            force, moment = about_z(force, ANGLE), about_z(moment, ANGLE)
            arm = [0.1 - AT[0], 0.2 - AT[1], 0.5 - AT[2]]  # of the pole
            moment = [m + c for m, c in zip(moment, cross(arm, force), strict=True)]
            for kind, values in (("force", in_section(force)), ("moment", in_section(moment))):
                for c, value in zip("xyz", values, strict=True):
                    self.near(curves[f"joint.{kind}.{c}"][i], value, max(map(abs, values)))

    def test_section_at_rest_carries_the_weight_above_it(self):
        asked = '[analyses.static]\nof = ["joint", "coupling", "machine.flange", "frame.flange"]\n'
        found = answer("static", self.file(TWO_BODIES + OBSERVED + asked))
        values = {r["name"]: r["value"] for r in found["results"]}
        weight = [0, 0, -150 * G]
        centre = [a + b for a, b in zip((0.1, 0.2, 0.5), about_z((0.05, -0.02, 0.1), ANGLE), strict=True)]
        moment = cross([c - a for c, a in zip(centre, AT, strict=True)], weight)
        for kind, hand in (("force", in_section(weight)), ("moment", in_section(moment))):
            for c, value in zip("xyz", hand, strict=True):
                self.near(values[f"joint.{kind}.{c}"], value, max(map(abs, hand)))
        machine = about_z([values[f"machine.flange.{c}"] for c in "xyz"], ANGLE)
        difference = [m - values[f"frame.flange.{c}"] for m, c in zip(machine, "xyz", strict=True)]
        for name, axis in zip(("radial_1", "radial_2", "axial"), across(AXIS), strict=True):
            self.near(values[f"coupling.{name}"], dot(axis, difference), max(map(abs, difference)))

    def test_they_are_results_everywhere(self):
        more = (
            '[excitations.road]\ntype = "random"\nbase = true\ntranslation = [0, 0, 1]\nquantity = "acceleration"\n'
            'psd = {rows = [[1, 1e-3], [50, 1e-3]]}\n'
            '[requirements]\nlimits = {"coupling.radial_1" = "1 mm", "joint.force.z" = "1 kN"}\n'
            'no_peak = "coupling.axial"\nrms = {"coupling.torsion" = "1 deg", "coupling.axial" = "1 m/s2"}\n'
            'static = {"joint.moment.x" = "500 N m"}\n'
            '[analyses]\npeaks = {of = ["coupling", "joint"]}\nrandom = {of = ["coupling", "joint"], quantity = "acceleration", weighting = "Wk"}\n'
        )
        path = self.file(TWO_BODIES + OBSERVED + more)
        verdict = answer("verdict", path)["cases"][0]
        self.assertEqual((len(verdict["requirements"]), verdict["not_judged"]), (6, 0))
        peaks = {p["name"] for p in answer("peaks", path)["peaks"]}
        self.assertIn("joint.force.z", peaks)
        self.assertIn("coupling.axial", peaks)
        weighted = {r["name"]: r["weighted_rms"] for r in answer("random", path)["results"]}
        self.assertEqual({n for n, rms in weighted.items() if rms}, {n for n in weighted if n.startswith("coupling")})
        felt = path.read_text().replace('weighting = "Wk"', 'weighting = "seat"')
        found = answer("random", self.file(felt, "felt.toml"))["results"]
        self.assertEqual({r["weighted_rms"] for r in found}, {None})  # a person does not sit on a relative motion
        explained = trivet("explain", path, "--of", "coupling.radial_2")
        self.assertIn("coupling.radial_2", explained.stdout, explained.stderr)
        target = self.folder / "out"
        done = trivet("run", path, "-o", target)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_maps_and_searches_know_them(self):
        ends = "from = 0.5\nto = 2\n"
        limits = 'band = ["1 Hz", "30 Hz"]\nlimits = {"coupling.radial_1" = "1 mm"}\n'
        model = TWO_BODIES + OBSERVED

        def margin(*settings):
            """What the verdict on this design states."""
            settings = [part for path, value in settings for part in ("--set", f"{path}={value!r}")]
            found = answer("verdict", self.file(model + "[requirements]\n" + limits), *settings)
            return found["cases"][0]["requirements"][0]["margin"]

        axes = "".join(
            f'[analyses.map.{axis}]\nparameter = "elements.{element}.scale"\npoints = 3\n{ends}'
            for axis, element in (("x", "e"), ("y", "a"))
        )
        best = answer("map", self.file(model + "[analyses.map]\n" + limits + axes))["best"]
        expected = margin(("elements.e.scale", best["x"]), ("elements.a.scale", best["y"]))
        self.assertLessEqual(abs(best["margin"] - expected), SINGLE * expected)
        search = (
            f'[requirements]\n{limits}[parameters.p]\npath = "elements.e.scale"\n{ends}'
            '[analyses.optimize]\nminimize = ["coupling.radial_1"]\nstarts = 2\n'
        )
        found = answer("optimize", self.file(model + search))
        self.assertLessEqual(found["after"], found["before"])
        expected = margin(("elements.e.scale", found["parameters"][0]["optimum"]))
        self.near(found["minimized"][0]["after"], 1e-3 / expected, 1e-3 / expected)

    def test_time_history(self):
        more = (
            '[excitations.hit]\ntype = "time"\non = "machine"\nat = [0, 0, 0]\nforce = [0, 0, 1]\n'
            'history = {half_sine = {amplitude = "1 kN", duration = "20 ms"}}\n'
            '[analyses.transient]\nof = ["machine.flange", "frame.flange", "coupling.axial"]\nto = 0.2\n'
        )
        viscous = re.sub(r"damping = .*\n", 'damping = {proportional = "2 ms"}\n', TWO_BODIES)
        found = answer("transient", self.file(viscous + OBSERVED.replace(str(list(AXIS)), '"z"') + more))
        curves = {r["name"]: r["value"] for r in found["results"]}
        scale = max(map(abs, curves["machine.flange.z"]))
        self.assertGreater(scale, 0)
        for machine, frame, axial in zip(
            curves["machine.flange.z"], curves["frame.flange.z"], curves["coupling.axial"], strict=True
        ):
            self.near(axial, machine - frame, scale)

    def test_a_motion_across_the_axis_has_two_components(self):
        done = trivet("response", self.file(TWO_BODIES + OBSERVED + '[analyses.response]\nof = "coupling.radial"\n'))
        self.assertEqual(done.returncode, 2)
        self.assertIn('"coupling.radial_1", "coupling.radial_2"', done.stderr)
        self.assertIn("ellipse", done.stderr)


if __name__ == "__main__":
    unittest.main()
