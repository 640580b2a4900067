# SPDX-License-Identifier: BSD-3-Clause
"""Measured curves and mode shapes are compared with computed ones."""
import cmath
import json
import math
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

TRIVET = os.environ["TRIVET"]
ROUND_OFF_FRAC = 1e-10  # numbers of a universal file have 13 digits
ROUND_OFF_DB = 1e-9

MACHINE = """trivet = 1
[bodies.device]
mass = 40
inertia = {about = "center_of_mass", xx = 1, yy = 1.2, zz = 0.9}
points.seat = [0.2, 0.1, 0.1]
[element_types.mount]
type = "bushing"
translation = [2e4, 2e4, 3e4]
damping = {loss_factor = 0.08}
[tables.elements]
rows = [
  {name = "a", type = "mount", on = "device", at = [0.2, 0.2, 0]},
  {name = "b", type = "mount", on = "device", at = [0.2, -0.2, 0]},
  {name = "c", type = "mount", on = "device", at = [-0.2, 0.2, 0]},
  {name = "d", type = "mount", on = "device", at = [-0.2, -0.2, 0.01]},
]
[excitations.motor]
type = "harmonic"
on = "device"
at = [0.2, 0.1, 0.1]
force = [0, 0, 10]
[analyses]
modes = {}
response = {of = ["device", "device.seat"], band = ["1 Hz", "30 Hz"], spacing = "linear", points = 291}
"""
RIG = '\n[measurements.rig]\nfile = "m.uff"\nforce = "motor"\n'


def trivet(*arguments, code=0):
    run = subprocess.run([TRIVET, *map(str, arguments)], capture_output=True, text=True)
    assert run.returncode == code, (arguments, run.returncode, run.stdout, run.stderr)
    return run


def measured_function(
    node,
    direction,
    values,
    quantity=8,
    reference=(2, 3),
    hertz=None,
    kind=4,
    unit="NONE",
    abscissa=(18, "Frequency", "Hz"),
):
    """Set 58 of a function over evenly spaced frequencies [Hz]: from, step."""
    first, step = hertz or (2.0, 0.1)
    lines = ["    -1", "    58", "NONE", "NONE", "NONE", "NONE", "NONE"]
    lines.append(
        f"{kind:5d}{1:10d}{1:5d}{0:10d} {'NONE':<10s}{node:10d}{direction:4d} {'NONE':<10s}{reference[0]:10d}{reference[1]:4d}"
    )
    complex_values = kind != 6
    lines.append(f"{6 if complex_values else 4:10d}{len(values):10d}{1:10d}{first:13.5E}{step:13.5E}{0.0:13.5E}")
    lines.append(f"{abscissa[0]:10d}{0:5d}{0:5d}{0:5d} {abscissa[1]:<20s} {abscissa[2]:<20s}")
    lines.append(f"{quantity:10d}{0:5d}{0:5d}{0:5d} {'NONE':<20s} {unit:<20s}")
    lines.append(f"{13 if kind == 4 else 0:10d}{0:5d}{0:5d}{0:5d} {'NONE':<20s} {'NONE':<20s}")
    lines.append(f"{0:10d}{0:5d}{0:5d}{0:5d} {'NONE':<20s} {'NONE':<20s}")
    numbers = [part for v in values for part in ((v.real, v.imag) if complex_values else (v.real,))]
    for i in range(0, len(numbers), 4 if complex_values else 4):
        lines.append("".join(f"{number:20.11E}" for number in numbers[i : i + 4]))
    return "\n".join([*lines, "    -1\n"])


def uneven(function, hertz, values):
    """The same function with these points: single precision, three numbers each."""
    lines = function.splitlines()
    form = next(i for i, line in enumerate(lines) if line.startswith(f"{6:10d}"))
    lines[form] = f"{5:10d}{len(hertz):10d}{0:10d}{0:13.5E}{0:13.5E}{0:13.5E}"
    numbers = [f"{n:13.5E}" for f, v in zip(hertz, values) for n in (f, v.real, v.imag)]
    points = ["".join(numbers[i : i + 6]) for i in range(0, len(numbers), 6)]
    return "\n".join([*lines[: form + 5], *points, "    -1\n"])


def file_of_nodes(*nodes, systems=(0, 0)):
    lines = [f"{n:10d}{systems[0]:10d}{systems[1]:10d}{0:10d}{x:13.5E}{y:13.5E}{z:13.5E}" for n, x, y, z in nodes]
    return "\n".join(["    -1", "    15", *lines, "    -1\n"])


class Measurements(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.machine = self.folder / "machine.toml"
        self.machine.write_text(MACHINE)

    def export(self, to="universal"):
        trivet("export", self.machine, "--to", to, "-o", self.folder / "m.uff")

    def compared(self, text, *options):
        project = self.folder / "compared.toml"
        project.write_text(text)
        return json.loads(trivet("measurements", project, "--json", *options).stdout)[0]

    def refused(self, text, *words):
        project = self.folder / "refused.toml"
        project.write_text(text)
        said = " ".join(trivet("check", project, code=2).stderr.split())
        for word in words:
            self.assertIn(word, said)

    def responses(self, *options):
        """Frequencies [Hz] and complex receptances of the seat along z."""
        result = json.loads(trivet("response", self.machine, "--json", *options).stdout)
        curve = next(r for r in result["results"] if r["name"] == "device.seat.z")
        return (
            [w / (2 * math.pi) for w in result["angular_frequency"]],
            [complex(*z) / 10 for z in curve["complex"]],
        )

    def test_the_exported_response_agrees(self):
        self.export()
        found = self.compared(MACHINE + RIG)
        self.assertEqual(len([c for c in found["channels"] if not c["computed_vanishes"]]), len(found["channels"]))
        self.assertEqual({c["result"] for c in found["channels"]} >= {"device.z", "device.seat.rx"}, True)
        for channel in found["channels"]:
            self.assertAlmostEqual(channel["frac"], 1, delta=ROUND_OFF_FRAC)
            self.assertLess(abs(channel["largest_db"]), ROUND_OFF_DB)
            self.assertLess(channel["rms_db"], ROUND_OFF_DB)
            self.assertTrue(channel["peaks"])
            for peak in channel["peaks"]:
                difference = peak["measured"]["angular_frequency"] - peak["computed"]["angular_frequency"]
                self.assertLess(abs(difference), peak["resolution"])
                self.assertLess(abs(peak["height_db"]), 0.2)

    def test_the_exported_modes_agree(self):
        self.export()
        found = self.compared(MACHINE + RIG)
        self.assertEqual([m["mode"] for m in found["modes"]], [1, 2, 3, 4, 5, 6])
        for mode in found["modes"]:
            self.assertAlmostEqual(mode["mac"], 1, delta=1e-9)
            self.assertLess(abs(mode["frequency_difference"]), 1e-5)

    def test_a_binary_file_agrees_to_its_seven_digits(self):
        self.export("universal_binary")
        for channel in self.compared(MACHINE + RIG)["channels"]:
            self.assertAlmostEqual(channel["frac"], 1, delta=1e-9)

    def test_a_stiffer_machine_has_higher_peaks_by_the_root_of_the_stiffness(self):
        self.export()
        softer = MACHINE.replace("[2e4, 2e4, 3e4]", "[2.2e4, 2.2e4, 3.3e4]")
        found = self.compared(softer + RIG)
        expected = 1 / math.sqrt(1.1) - 1
        for mode in found["modes"]:
            self.assertAlmostEqual(mode["frequency_difference"], expected, delta=1e-5)
        seat = next(c for c in found["channels"] if c["result"] == "device.seat.z")
        self.assertLess(seat["frac"], 0.9)
        for peak in seat["peaks"]:
            tolerance = peak["resolution"] / peak["computed"]["angular_frequency"]
            self.assertAlmostEqual(peak["frequency_difference"], expected, delta=tolerance)

    def test_a_force_response_without_reference_is_a_spectrum(self):
        text = MACHINE + '[excitations.second]\ntype = "harmonic"\non = "device"\nat = [0, 0, 0]\nforce = [3, 0, 0]\n'
        self.machine.write_text(text)
        self.export()  # two forces: responses, not functions per force
        for channel in self.compared(text + RIG.replace('force = "motor"\n', ""))["channels"]:
            self.assertAlmostEqual(channel["frac"], 1, delta=ROUND_OFF_FRAC)

    def csv(self, heading, row, quantity=0):
        hertz, receptances = self.responses()
        rows = [row(f, h * (2j * math.pi * f) ** quantity) for f, h in zip(hertz, receptances)]
        (self.folder / "m.csv").write_text("\n".join([heading, *rows]) + "\n")
        return self.compared(MACHINE + RIG.replace("m.uff", "m.csv"))["channels"]

    def test_a_table_agrees_in_any_unit_and_quantity(self):
        name = "device.seat.z"
        cases = (
            (f"frequency [Hz],{name} re [m/N],{name} im [m/N]", lambda f, h: f"{f!r},{h.real!r},{h.imag!r}", 0),
            (
                f"frequency [Hz],{name} amplitude [(mm/s2)/N],{name} phase [deg]",
                lambda f, h: f"{f!r},{1e3 * abs(h)!r},{math.degrees(cmath.phase(h))!r}",
                2,
            ),
            (
                f"angular_frequency [rad/s],{name} re [um/s/kN],{name} im [um/s/kN]",
                lambda f, h: f"{2 * math.pi * f!r},{1e9 * h.real!r},{1e9 * h.imag!r}",
                1,
            ),
        )
        for heading, row, quantity in cases:
            [channel] = self.csv(heading, row, quantity)
            self.assertEqual(channel["result"], name)
            self.assertAlmostEqual(channel["frac"], 1, delta=ROUND_OFF_FRAC)
            self.assertLess(abs(channel["largest_db"]), 1e-7)  # JSON numbers of the response have nine digits

    def function_at_the_seat(self, direction=3, quantity=8, **more):
        hertz, values = self.responses()
        sign = -1 if direction < 0 else 1
        values = [sign * h * (2j * math.pi * f) ** {8: 0, 11: 1, 12: 2}.get(quantity, 0) for f, h in zip(hertz, values)]
        return measured_function(7, direction, values, quantity, (7, 3), (1.0, 0.1), **more)

    def test_nodes_have_the_place_of_their_position(self):
        for direction, quantity in ((3, 8), (-3, 8), (3, 12), (-3, 11)):
            text = file_of_nodes((7, 0.2, 0.1, 0.1004)) + self.function_at_the_seat(direction, quantity)
            (self.folder / "m.uff").write_text(text)
            [channel] = self.compared(MACHINE + RIG)["channels"]
            self.assertEqual(channel["result"], "device.seat.z")
            self.assertAlmostEqual(channel["frac"], 1, delta=1e-9)
            self.assertLess(abs(channel["largest_db"]), 1e-6)
            phases = [cmath.phase(complex(*m) / complex(*c)) for m, c in zip(channel["measured"], channel["computed"])]
            self.assertLess(max(map(abs, phases)), 1e-6)

    def test_directions_of_the_file_are_those_of_the_ground(self):
        turned = MACHINE.replace(
            "mass = 40", 'mass = 40\nposition = [1, 2, 3]\norientation = {axis = "z", angle = "90 deg"}'
        )
        self.machine.write_text(turned)  # the body's x is the ground's y, its y is −x
        result = json.loads(trivet("response", self.machine, "--json").stdout)
        curves = {r["name"]: [complex(*z) / 10 for z in r["complex"]] for r in result["results"]}
        over = {"reference": (5, 3), "hertz": (1.0, 0.1)}
        text = file_of_nodes((5, 0.9, 2.2, 3.1))
        text += measured_function(5, 1, [-v for v in curves["device.seat.y"]], **over)
        text += measured_function(5, 2, curves["device.seat.x"], **over)
        text += measured_function(5, 3, [-v for v in curves["device.seat.z"]], **over | {"reference": (5, -3)})
        (self.folder / "m.uff").write_text(text)
        channels = self.compared(turned + RIG)["channels"]
        self.assertEqual([c["result"] for c in channels], ["device.seat.y", "device.seat.x", "device.seat.z"])
        for channel in channels:
            self.assertAlmostEqual(channel["frac"], 1, delta=1e-9)
            for m, c in zip(channel["measured"], channel["computed"]):
                self.assertLess(abs(complex(*m) / complex(*c) - 1), 1e-6)

    def test_modes_of_a_turned_body_agree(self):
        turned = MACHINE.replace("mass = 40", 'mass = 40\norientation = {axis = "x", angle = "30 deg"}')
        self.machine.write_text(turned)
        self.export()
        for mode in self.compared(turned + RIG.replace('force = "motor"\n', ""))["modes"]:
            self.assertAlmostEqual(mode["mac"], 1, delta=1e-9)

    def test_nodes_and_channels_give_places(self):
        (self.folder / "m.uff").write_text(self.function_at_the_seat())
        for place in (
            'nodes = {"7" = "device.seat"}',
            'nodes = {"7" = "device.seat"}\nchannels = {"device.seat.z" = "7:+z"}',
        ):
            [channel] = self.compared(MACHINE + RIG + place + "\n")["channels"]
            self.assertAlmostEqual(channel["frac"], 1, delta=1e-9)

    def test_functions_per_other_forces_are_not_compared(self):
        nodes = file_of_nodes((7, 0.2, 0.1, 0.1), (8, 0.2, -0.2, 0))
        other = measured_function(7, 3, [1e-5] * 291, reference=(8, 3), hertz=(1.0, 0.1))
        (self.folder / "m.uff").write_text(nodes + other + self.function_at_the_seat())
        [channel] = self.compared(MACHINE + RIG)["channels"]
        self.assertAlmostEqual(channel["frac"], 1, delta=1e-9)
        (self.folder / "m.uff").write_text(nodes + other)
        self.refused(MACHINE + RIG, "7:+z over 8:+z", "force of motor at (0.2, 0.1, 0.1) m")

    def test_the_load_must_be_on_the_body_of_the_reference(self):
        """A second body at the same place, and a moment, which has no place on its own body."""
        frame = (
            MACHINE
            + '[bodies.frame]\nmass = 9\nposition = [0.2, 0.1, 0.1]\ninertia = {about = "pole", xx = 1, yy = 1, zz = 1}\n'
        )
        frame += '[elements.joint]\ntype = "mount"\non = "frame"\nat = [0, 0, 0]\n'
        frame += 'from = "device"\nfrom_at = [0.2, 0.1, 0.1]\n'
        moment = frame.replace("force = [0, 0, 10]", "moment = [0, 0, 10]")
        for project, reference, what in ((frame, (8, 3), "force"), (moment, (8, 6), "moment")):
            function = measured_function(7, 3, [1e-5] * 291, reference=reference, hertz=(1.0, 0.1))
            (self.folder / "m.uff").write_text(function)
            nodes = 'nodes = {"7" = "device.seat", "8" = "%s"}\n'
            other = f"8:+{'z' if what == 'force' else 'rz'} at frame"
            self.refused(project + RIG + nodes % "frame", other, f"{what} of motor", 'of "device"')
            place = "device.seat" if what == "force" else "device"
            self.assertEqual(len(self.compared(project + RIG + nodes % place)["channels"]), 1)

    def test_places_of_neither_side_are_listed(self):
        (self.folder / "m.uff").write_text(self.function_at_the_seat())
        self.refused(MACHINE + RIG, "the file has: 7:+z", "device, device.seat", 'nodes = {"3" = "BODY.POINT"}')

    def write_accelerance(self, unit, scale, units="", denominator="NONE"):
        """Accelerance of the seat in another unit: numbers divided by its SI value."""
        hertz, values = self.responses()
        values = [h * (2j * math.pi * f) ** 2 / scale for f, h in zip(hertz, values)]
        text = measured_function(7, 3, values, 12, (7, 3), (1.0, 0.1), unit=unit)
        if denominator != "NONE":
            axis = text.splitlines()[11]
            text = text.replace(axis, axis[:47] + f"{denominator:<20s}", 1)
        (self.folder / "m.uff").write_text(units + file_of_nodes((7, 0.2, 0.1, 0.1)) + text)

    def test_units_are_those_of_labels_set_164_and_the_project(self):
        g, pound = 9.80665, 4.4482216152605
        si = "    -1\n   164\n         1SI                          2\n  1.0D+00  1.0D+00  1.0D+00\n  273.15D+00\n    -1\n"
        of_project = 'unit = "g/N"\n'
        agreeing = (
            ("g", g, "", "NONE", ""),  # label
            ("g", g, "", "NONE", of_project),  # label and project
            ("NONE", g, "", "NONE", of_project),  # project
            ("in/s^2", 0.0254 / pound, "", "lbf", ""),  # labels of both axes
            ("g/N", g, "", "NONE", ""),  # one label for both
            ("m/s2", 1, si, "NONE", ""),  # set 164 and label
            ("g", g, si, "NONE", of_project),  # the project decides between set 164 and the label
            ("g", 1, si, "NONE", 'unit = "(m/s2)/N"\n'),
        )
        for unit, scale, units, denominator, key in agreeing:
            self.write_accelerance(unit, scale, units, denominator)
            [channel] = self.compared(MACHINE + RIG + key)["channels"]
            self.assertLess(abs(channel["largest_db"]), 1e-6, (unit, denominator, key))
        contradicting = (
            ("g", "", 'unit = "(m/s2)/N"\n', ('unit = "(m/s2)/N" of the project', 'label "g" of the numerator')),
            ("g", si, "", ("set 164", 'label "g" of the numerator', "state it: unit =")),
            ("NONE", si, of_project, ('unit = "g/N" of the project', "set 164")),
            ("m/s2", "", 'unit = "(mm/s)/N"\n', ('unit = "(mm/s)/N"', "the numerator has the type 12")),
            ("furlong", "", "", ('label "furlong" of the numerator is not a known unit',)),
        )
        for unit, units, key, words in contradicting:
            self.write_accelerance(unit, 1, units)
            self.refused(MACHINE + RIG + key, *words)

    def write_rig_with_rotation(self, z_label="NONE", rx_label="NONE", rx_scale=1.0, rx_quantity=12, units=""):
        """Accelerances of a place, in g and in rad/s2, both per the force along z."""
        result = json.loads(trivet("response", self.machine, "--json").stdout)
        functions = ""
        for name, direction, scale, unit, quantity in (
            ("device.seat.z", 3, 9.80665, z_label, 12),
            ("device.seat.rx", 4, rx_scale, rx_label, rx_quantity),
        ):
            curve = next(r for r in result["results"] if r["name"] == name)
            values = [
                -(w**2) * complex(*z) / 10 / scale for w, z in zip(result["angular_frequency"], curve["complex"])
            ]
            functions += measured_function(7, direction, values, quantity, (7, 3), (1.0, 0.1), unit=unit)
        (self.folder / "m.uff").write_text(units + file_of_nodes((7, 0.2, 0.1, 0.1)) + functions)

    def test_a_unit_is_for_the_functions_that_it_fits(self):
        """A key for accelerations along axes leaves those about axes to the file, or to a unit of their own."""
        only_z = '[measurements.rig.channels]\n"device.seat.z" = "7:+z"\n'
        degree = math.pi / 180
        both = 'unit = ["g/N", "(deg/s2)/N"]\n'
        agreeing = (
            ("NONE", 1.0, 12, 'unit = "g/N"\n', "unit = \"g/N\" of the project is not for 7:+rx"),
            ("rad/s^2", 1.0, 12, 'unit = "g/N"\n', None),
            ("NONE", degree, 12, both, None),
            ("NONE", degree, 0, both, None),  # the direction states that it is a rotation
            ("deg/s2", degree, 12, 'unit = "g/N"\n', None),
            ("furlong", 1.0, 12, 'unit = "g/N"\n' + only_z, None),  # not compared: no error
            ("NONE", 1.0, 11, 'unit = "g/N"\n' + only_z, None),
        )
        for label, scale, quantity, keys, warning in agreeing:
            with self.subTest(label=label, keys=keys):
                self.write_rig_with_rotation("NONE", label, scale, quantity)
                for channel in self.compared(MACHINE + RIG + keys)["channels"]:
                    self.assertLess(abs(channel["largest_db"]), 1e-6, channel["result"])
                said = self.said(MACHINE + RIG + keys)
                self.assertEqual("they are read in SI" in said, warning is not None, said)
                self.assertIn(warning or "", said)
        for label, quantity, keys, words in (
            ("furlong", 12, 'unit = "g/N"\n', 'label "furlong" of the numerator is not a known unit'),
            ("NONE", 11, both, 'unit = "(deg/s2)/N" of the project, but the numerator has the type 11'),
            ("NONE", 0, 'unit = "g/N"\n', 'unit = "g/N" of the project is not for 7:+rx'),
            ("NONE", 12, 'unit = ["g/N", "(m/s2)/N"]\n', "several units are of different quantities"),
            ("NONE", 12, 'unit = ["g/N", "N"]\n', 'unit = "N" of the project fits no function'),
        ):
            with self.subTest(refused=keys):
                self.write_rig_with_rotation("NONE", label, 1.0, quantity)
                self.refused(MACHINE + RIG + keys, words)

    def test_a_frequency_response_of_a_finite_element_program_agrees(self):
        """Set 2414, analysis type 5: one set per frequency, complex motions in double precision."""
        result = json.loads(trivet("response", self.machine, "--json").stdout)
        motions = [
            next(r for r in result["results"] if r["name"] == f"device.seat.{axis}")["complex"] for axis in "xyz"
        ]
        sets = ""
        for i in range(0, len(result["angular_frequency"]), 10):
            hertz = result["angular_frequency"][i] / (2 * math.pi)
            lines = ["    -1", "  2414", f"{1:10d}", "RESPONSE", f"{1:10d}", *["NONE"] * 5]
            lines.append("".join(f"{n:10d}" for n in (1, 5, 2, 8, 6, 3)))
            lines.append("".join(f"{n:10d}" for n in (0, 0, 0, 0, 1, 0, 0, i + 1)))
            lines.append(f"{0:10d}{0:10d}")
            lines.append("".join(f"{n:13.5E}" for n in (0, hertz, 0, 0, 0, 0)))
            lines.append("".join(f"{0:13.5E}" for _ in range(6)))
            lines.append(f"{7:10d}")
            numbers = [part for motion in motions for part in motion[i]]
            lines += ["".join(f"{n:20.11E}" for n in numbers[k : k + 4]) for k in (0, 4)]
            sets += "\n".join([*lines, "    -1\n"])
        (self.folder / "m.uff").write_text(file_of_nodes((7, 0.2, 0.1, 0.1)) + sets)
        channels = self.compared(MACHINE + '[measurements.fem]\nfile = "m.uff"\n')["channels"]
        self.assertEqual([c["result"] for c in channels], ["device.seat.x", "device.seat.y", "device.seat.z"])
        six_digits_of_a_frequency = 1e-3  # dB, at resonances with 8 % loss
        for channel in channels:
            self.assertLess(abs(channel["largest_db"]), six_digits_of_a_frequency)

    def test_exported_forces_and_moments_are_read_again(self):
        results = '["a.force.z", "a.moment.x", "a.moment.y", "ground.moment.x"]'
        text = MACHINE.replace('["device", "device.seat"]', results)
        # Mounts without rotational stiffness would have no moments.
        text = text.replace("damping = {", "rotation = [40, 50, 60]\ndamping = {")
        self.machine.write_text(text)
        self.export()
        axes = [line for line in (self.folder / "m.uff").read_text().splitlines() if line.startswith("         9    0")]
        self.assertEqual([line.split()[4:] for line in axes], [["Force", "N"]] + 3 * [["Moment", "N", "m"]])
        channels = self.compared(text + RIG)["channels"]
        self.assertEqual([c["result"] for c in channels], ["a.force.z", "a.moment.x", "a.moment.y", "ground.moment.x"])
        for channel in channels:
            self.assertLess(abs(channel["largest_db"]), ROUND_OFF_DB)

    def test_other_functions_are_named(self):
        place = file_of_nodes((7, 0.2, 0.1, 0.1)) + self.function_at_the_seat()
        time = self.function_at_the_seat(kind=1, abscissa=(17, "Time", "s"))
        (self.folder / "m.uff").write_text(place + time + time + self.function_at_the_seat(kind=9))
        said = self.said(MACHINE + RIG)
        self.assertIn("2 × time response (type 1) over an abscissa of type 17", said)
        self.assertIn("1 × power spectral density (type 9)", said)

    def test_directions_are_those_of_the_system_of_the_node(self):
        """Set 18: x of system 4 is z of the ground, its z is −x."""
        system = "    -1\n    18\n         4         0         0         8         1\nS\n  0. 0. 0. 0. 0. 1.\n -1. 0. 0.\n    -1\n"
        node = file_of_nodes((7, 0.2, 0.1, 0.1), systems=(0, 4))
        function = self.function_at_the_seat(1).replace("         7   3", "         7   1")  # response and reference
        (self.folder / "m.uff").write_text(node + system + function)
        [channel] = self.compared(MACHINE + RIG)["channels"]
        self.assertEqual(channel["result"], "device.seat.z")
        self.assertLess(abs(channel["largest_db"]), 1e-6)

    def test_an_unknown_unit_needs_the_key(self):
        text = file_of_nodes((7, 0.2, 0.1, 0.1)) + self.function_at_the_seat(quantity=0)
        (self.folder / "m.uff").write_text(text)
        self.refused(MACHINE + RIG, 'the unit of "7:+z" is not known', 'add unit = "m/s2"')
        [channel] = self.compared(MACHINE + RIG + 'unit = "m"\n')["channels"]
        self.assertAlmostEqual(channel["frac"], 1, delta=1e-9)
        self.refused(MACHINE + RIG + 'unit = "kg"\n', "a unit of a motion or a force")
        self.refused(MACHINE + RIG + 'unit = "rad"\n', "device.seat.z is measured in m")

    def said(self, text):
        project = self.folder / "said.toml"
        project.write_text(text)
        run = trivet("check", project)
        return " ".join((run.stdout + run.stderr).split())

    def test_an_abscissa_of_unknown_quantity_is_reported(self):
        place = file_of_nodes((7, 0.2, 0.1, 0.1))
        for abscissa, said in (((0, "NONE", "NONE"), True), ((0, "NONE", "Hz"), False), ((18, "x", "Hz"), False)):
            (self.folder / "m.uff").write_text(place + self.function_at_the_seat(abscissa=abscissa))
            self.assertEqual("unknown quantity, the first is 7:+z" in self.said(MACHINE + RIG), said, abscissa)
        (self.folder / "m.uff").write_text(place + self.function_at_the_seat(abscissa=(0, "Time", "s")))
        self.refused(MACHINE + RIG, "m.uff:6:", 'no quantity and the unit "s"')

    def test_frequencies_increase(self):
        place = file_of_nodes((7, 0.2, 0.1, 0.1))
        for quantity in (0, 18):
            function = self.function_at_the_seat(abscissa=(quantity, "NONE", "Hz"))
            for hertz in ([2, 4, 3], [2, 3, 3]):
                (self.folder / "m.uff").write_text(place + uneven(function, hertz, [1e-5 + 1e-6j] * 3))
                self.refused(MACHINE + RIG, "m.uff:", "at point 3 after", "frequencies increase")

    def test_nodes_in_coordinate_systems_are_reported(self):
        place = 'nodes = {"7" = "device.seat"}\n'
        for systems in ((1, 0), (0, 1)):
            nodes = file_of_nodes((7, 0.2, 0.1, 0.1), systems=systems)
            (self.folder / "m.uff").write_text(nodes + self.function_at_the_seat())
            self.refused(MACHINE + RIG, "the nodes 7 in a coordinate system not 0", "no place by its position")
            said = "displacements of the nodes 7 in a coordinate system not 0" in self.said(MACHINE + RIG + place)
            self.assertEqual(said, systems[1] != 0)

    def test_functions_per_force_need_the_force(self):
        self.export()
        self.refused(MACHINE + '[measurements.rig]\nfile = "m.uff"\n', "is per force", 'force = "EXCITATION"')
        self.refused(MACHINE + RIG.replace('"motor"', '"moter"'), 'did you mean "motor"?')

    def test_the_band_must_have_measured_frequencies(self):
        self.export()
        other = MACHINE.replace('["1 Hz", "30 Hz"]', '["40 Hz", "50 Hz"]')
        self.refused(other + RIG, "measured from 1 to 30 Hz", "40 to 50 Hz", "widen the band")
        half = MACHINE.replace('["1 Hz", "30 Hz"]', '["1 Hz", "10 Hz"]')
        [channel, *_] = self.compared(half + RIG)["channels"]
        self.assertLessEqual(max(channel["angular_frequency"]), 2 * math.pi * 10.0001)

    def test_a_response_is_needed(self):
        self.export()
        self.refused(re.sub("\nresponse = .*", "", MACHINE) + RIG, "no response to compare with")

    def test_a_file_that_is_cut_off_is_refused(self):
        self.export()
        whole = (self.folder / "m.uff").read_text()
        (self.folder / "m.uff").write_text(whole[: len(whole) - 400])
        self.refused(MACHINE + RIG, "m.uff", "cut off")

    def test_poor_coherence_is_a_warning(self):
        for coherence, poor in ((0.2, True), (0.95, False)):
            function = file_of_nodes((7, 0.2, 0.1, 0.1)) + self.function_at_the_seat()
            function += measured_function(7, 3, [coherence] * 291, 0, (7, 3), (1.0, 0.1), kind=6)
            (self.folder / "m.uff").write_text(function)
            project = self.folder / "coherent.toml"
            project.write_text(MACHINE + RIG + "coherence = true\n")
            said = trivet("check", project)
            self.assertEqual("coherence of device.seat.z below 0.5" in said.stdout + said.stderr, poor)
            channel = self.compared(MACHINE + RIG + "coherence = true\n")["channels"][0]
            self.assertAlmostEqual(channel["mean_coherence"], coherence)
        self.export()
        self.refused(MACHINE + RIG + "coherence = true\n", "no coherence")

    def table_with_coherence(self, *coherences):
        rows = [f"{i + 2},1e-5,-1e-6,{c}" for i, c in enumerate(coherences)]
        heading = "frequency [Hz],device.z re [m/N],device.z im [m/N],device.z coherence"
        (self.folder / "m.csv").write_text("\n".join([heading, *rows]) + "\n")
        return MACHINE + RIG.replace("m.uff", "m.csv") + "coherence = true\n"

    def test_a_coherence_is_between_0_and_1(self):
        for wrong in ("7", "-3", "1.01"):
            text = self.table_with_coherence("0.9", wrong, "0.9")
            self.refused(text, "m.csv:3:", f"device.z coherence = {wrong}", "between 0 and 1")
            self.compared(text.replace("coherence = true\n", ""))
        function = file_of_nodes((7, 0.2, 0.1, 0.1)) + self.function_at_the_seat()
        function += measured_function(7, 3, [1.5] * 291, 0, (7, 3), (1.0, 0.1), kind=6)
        (self.folder / "m.uff").write_text(function)
        self.refused(MACHINE + RIG + "coherence = true\n", "coherence 1.5 of function 7:+z", "between 0 and 1")

    def test_a_line_without_coherence_is_a_gap(self):
        text = self.table_with_coherence("0.8", "", "0.9")
        [channel] = self.compared(text)["channels"]
        self.assertEqual(len(channel["angular_frequency"]), 2)
        self.assertAlmostEqual(channel["mean_coherence"], 0.85)
        [channel] = self.compared(text.replace("coherence = true\n", ""))["channels"]
        self.assertEqual(len(channel["angular_frequency"]), 3)

    def test_a_peak_without_a_computed_one_has_no_number(self):
        """The computed curve has no peak: more than critical damping."""
        rows = "".join(f"{1 + i / 10},{(1, 3)[i == 5]}e-5,0\n" for i in range(11))
        (self.folder / "m.csv").write_text("frequency [Hz],device.z re [m/N],device.z im [m/N]\n" + rows)
        damped = MACHINE.replace("{loss_factor = 0.08}", "{translation = [4e3, 4e3, 4e3]}")
        self.machine.write_text(damped + RIG.replace("m.uff", "m.csv"))
        out = self.folder / "out"
        trivet("run", self.machine, "-o", out)
        page = (out / "report.html").read_text()
        self.assertTrue("no computed peak" in page)
        self.assertFalse("nan %" in page)

    def test_tables_with_mistakes_are_refused(self):
        for table, words in (
            ("time [s],device.z re [m/N],device.z im [m/N]\n1,1,1\n2,1,1\n", "first column"),
            ("frequency [Hz],device.z [m/N]\n1,1\n2,1\n", 'column "device.z [m/N]"'),
            ("frequency [Hz],device.z amplitude [m/N]\n1,1\n2,1\n", "an amplitude without a phase"),
            ("frequency [Hz],device.z re [m/N],device.z im [m/N]\n2,1,1\n1,1,1\n", "increase from row to row"),
            ("frequency [Hz],device.z re,device.z im\n2,1,1\n3,1,1\n", "is not known"),
            ("frequency [Hz],device.z re [N],device.z im [N]\n2,1,1\n3,1,1\n", "device.z is measured in m"),
        ):
            (self.folder / "m.csv").write_text(table)
            self.refused(MACHINE + RIG.replace("m.uff", "m.csv"), words)

    def test_a_run_writes_tables_and_pictures(self):
        self.export()
        self.machine.write_text(MACHINE + RIG)
        out = self.folder / "out"
        said = trivet("run", self.machine, "-o", out, "--full").stdout
        self.assertIn("Measurement rig (m.uff) minus computed", said)
        self.assertIn("FRAC", said)
        self.assertIn("MAC", said)
        case = next(path for path in out.iterdir() if path.name.startswith("00-"))
        for name, heading in (
            ("measurements", "measurement,result,source"),
            ("measured_curves", "measurement,result,unit,omega [rad/s]"),
            ("measured_peaks", "measurement,result,unit,measured at"),
            ("measured_modes", "measurement,measured mode"),
        ):
            self.assertIn(heading, (case / f"{name}.csv").read_text())
        page = (out / "report.html").read_text()
        self.assertIn("measured rig", page)
        self.assertIn("Measurements", page)
        [measurement] = json.loads((out / "results.json").read_text())["cases"][0]["measurements"]
        self.assertEqual(measurement["name"], "rig")

    def test_a_case_is_compared_with_its_own_response(self):
        self.export()
        self.machine.write_text(
            MACHINE + RIG + "\n[cases.stiff]\nelement_types.mount.translation = [2.2e4, 2.2e4, 3.3e4]\n"
        )
        out = self.folder / "out"
        trivet("run", self.machine, "-o", out)
        base, stiff = json.loads((out / "results.json").read_text())["cases"]
        self.assertAlmostEqual(base["measurements"][0]["channels"][0]["frac"], 1, delta=ROUND_OFF_FRAC)
        self.assertLess(stiff["measurements"][0]["channels"][0]["frac"], 0.99)


if __name__ == "__main__":
    unittest.main()
