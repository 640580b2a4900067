# SPDX-License-Identifier: BSD-3-Clause
"""Relative motions and section forces against calculations by hand."""
import json
import math
import re
import unittest

from load_cases_test import cross, dot
from trivet_test import InTemporaryFolder, result_of, trivet

CLOSE = 1e-9  # relative: statics of six coordinates, and peaks with their nine digits
SINGLE = 1e-7  # relative: maps store margins in single precision
G = 9.80665

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

    def response(self, more="", top=""):
        names = ["machine", "machine.flange", "frame.flange", "coupling", "joint"]
        request = f'[analyses.response]\nof = {json.dumps(names)}\nat = ["3 Hz", "11 Hz", "40 Hz"]\n'
        found = result_of("response", self.file(top + TWO_BODIES + OBSERVED + request + more))
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
        request = 'of = ["machine.flange.relative", "joint"]\n'
        found = result_of("response", self.file(TWO_BODIES + base + more + request))
        curves = {r["name"]: complex(*r["complex"][0]) for r in found["results"]}
        machine = about_z([curves[f"machine.flange.relative.{c}"] for c in "xyz"], ANGLE)
        scale = max(map(abs, machine))
        for name, value in zip(("radial_1", "radial_2", "axial"), machine, strict=True):
            self.near(curves[f"joint.{name}"], -value, scale)  # the ground less the machine

    def test_section_carries_the_inertia_and_the_loads_above_it(self):
        # To first order: otherwise the section also carries the moment of the weight by the displacement.
        frequencies, curves = self.response(top="second_order = false\n")
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
        request = '[analyses.static]\nof = ["joint", "coupling", "machine.flange", "frame.flange"]\n'
        found = result_of("static", self.file(TWO_BODIES + OBSERVED + request))
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
        verdict = result_of("verdict", path)["cases"][0]
        self.assertEqual((len(verdict["requirements"]), verdict["not_judged"]), (6, 0))
        peaks = {p["name"] for p in result_of("peaks", path)["peaks"]}
        self.assertIn("joint.force.z", peaks)
        self.assertIn("coupling.axial", peaks)
        weighted = {r["name"]: r["weighted_rms"] for r in result_of("random", path)["results"]}
        self.assertEqual({n for n, rms in weighted.items() if rms}, {n for n in weighted if n.startswith("coupling")})
        felt = path.read_text().replace('weighting = "Wk"', 'weighting = "seat"')
        found = result_of("random", self.file(felt, "felt.toml"))["results"]
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
            found = result_of("verdict", self.file(model + "[requirements]\n" + limits), *settings)
            return found["cases"][0]["requirements"][0]["margin"]

        axes = "".join(
            f'[analyses.map.{axis}]\nparameter = "elements.{element}.scale"\npoints = 3\n{ends}'
            for axis, element in (("x", "e"), ("y", "a"))
        )
        best = result_of("map", self.file(model + "[analyses.map]\n" + limits + axes))["best"]
        expected = margin(("elements.e.scale", best["x"]), ("elements.a.scale", best["y"]))
        self.assertLessEqual(abs(best["margin"] - expected), SINGLE * expected)
        search = (
            f'[requirements]\n{limits}[parameters.p]\npath = "elements.e.scale"\n{ends}'
            '[analyses.optimize]\nminimize = ["coupling.radial_1"]\nstarts = 2\n'
        )
        found = result_of("optimize", self.file(model + search))
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
        found = result_of("transient", self.file(viscous + OBSERVED.replace(str(list(AXIS)), '"z"') + more))
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
