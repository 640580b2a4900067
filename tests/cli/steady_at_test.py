# SPDX-License-Identifier: BSD-3-Clause
"""trivet steady --at: harmonics of all motions at one frequency; notes and warnings of several elements in one line."""

import cmath
import csv
import io
import json
import math
import os
import pathlib
import subprocess
import tempfile
import unittest

TRIVET = os.environ["TRIVET"]
SOURCE = pathlib.Path(os.environ.get("TRIVET_SOURCE", pathlib.Path(__file__).parents[2]))
MASS, STIFFNESS, DAMPING, FORCE = 40.0, 36000.0, 48.0, 60.0
MACHINE = f"""trivet = 1
[bodies.m]
mass = {MASS}
free = ["x"]
[elements.s]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [{STIFFNESS}, 0, 0]
damping = {{translation = [{DAMPING}, 0, 0]}}
laws.x = LAW
[excitations.F]
type = "harmonic"
on = "m"
at = [0, 0, 0]
force = [{FORCE}, 0, 0]
[analyses]
steady = {{of = ["m.x"], harmonics = 15, band = ["24 rad/s", "50 rad/s"]}}
"""
OPEN = "{gap_stop = {gap = 0.2, stiffness = 4e5}}"  # a linear machine
STOP = "{gap_stop = {gap = 0.006, stiffness = 4e5}}"


def run(law, *options, machine=MACHINE):
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "machine.toml"
        file.write_text(machine.replace("LAW", law))
        return subprocess.run([TRIVET, "steady", str(file), *options], capture_output=True, text=True)


class SteadyAt(unittest.TestCase):
    def test_a_machine_that_touches_nothing_has_the_linear_harmonic(self):
        omega = 2 * math.pi * 4.5
        exact = FORCE / complex(STIFFNESS - MASS * omega**2, DAMPING * omega)
        at = json.loads(run(OPEN, "--json", "--at", "4.5 Hz").stdout)["at"]
        self.assertEqual(len(at), 1)
        (motion,) = at[0]["motions"]
        self.assertTrue(motion["stable"])
        self.assertEqual(motion["orders"][:2], [1, 2])
        self.assertAlmostEqual(motion["results"][0]["amplitudes"][0] / abs(exact), 1, delta=1e-9)
        self.assertAlmostEqual(motion["results"][0]["phases"][0], cmath.phase(exact), delta=1e-9)
        self.assertLess(motion["results"][0]["amplitudes"][1], 1e-12)
        text = run(OPEN, "--at", "4.5 Hz").stdout
        self.assertIn("At 4.5 Hz: one motion is known", text)
        self.assertIn(f"{abs(exact) * 1e3:.4g} mm", text)
        self.assertIn(f"{math.degrees(cmath.phase(exact)):.1f}°", text)

    def test_beyond_a_stop_all_motions_are_listed_with_harmonics_that_add_up(self):
        found = run(STOP, "--csv", "--at", "36 rad/s,40 rad/s")
        rows = list(csv.DictReader(io.StringIO(found.stdout)))
        self.assertEqual({row["angular_frequency [rad/s]"] for row in rows}, {"36", "40"})
        at = json.loads(run(STOP, "--json", "--at", "36 rad/s,40 rad/s").stdout)["at"]
        self.assertEqual([len(one["motions"]) for one in at], [3, 3])  # between the folds
        self.assertEqual([motion["stable"] for motion in at[0]["motions"]].count(False), 1)
        for motion in at[0]["motions"]:
            (result,) = motion["results"]
            course = [
                result["mean"]
                + sum(
                    a * math.cos((k + 1) * phase + phi)
                    for k, (a, phi) in enumerate(zip(result["amplitudes"], result["phases"]))
                )
                for phase in (2 * math.pi * n / 4096 for n in range(4096))
            ]
            self.assertAlmostEqual(max(course) / result["largest"], 1, delta=1e-6)
            self.assertAlmostEqual(min(course) / result["smallest"], 1, delta=1e-6)

    def test_places_move_with_all_harmonics_as_the_results_say(self):
        # The body is turned about z by a quarter: its x and ry are the y and −rx of the ground.
        machine = (
            MACHINE.replace('free = ["x"]', 'free = ["x", "ry"]\ninertia = {about = "pole", xx = 2, yy = 2, zz = 2}')
            .replace(
                "[elements.s]",
                'orientation = {axis = "z", angle = "90 deg"}\npoints.tip = [0.1, 0.2, 0.3]\n[elements.s]',
            )
            .replace("at = [0, 0, 0]\ntranslation", "at = [0.2, 0, -0.1]\ntranslation")
            .replace(f"[{STIFFNESS}, 0, 0]", f"[{STIFFNESS}, 0, 5e4]")
            .replace('of = ["m.x"]', 'of = ["m.x", "m.ry", "m.tip.x", "m.tip.z"]')
        )
        found = run(STOP, "--json", "--at", "40 rad/s", machine=machine)
        self.assertEqual(found.returncode, 0, found.stderr)
        motions = json.loads(found.stdout)["at"][0]["motions"]
        self.assertGreater(len(motions), 0)
        for motion in motions:
            self.assertEqual([place["name"] for place in motion["places"]], ["m"])
            largest = max(max(result["amplitudes"]) for result in motion["results"])
            self.assertGreater(sorted(motion["results"][0]["amplitudes"])[-2], 1e-3 * largest)  # it touches the stop
            for k, six in enumerate(motion["places"][0]["harmonics"]):
                x, y, z, rx, ry, rz = (complex(*one) for one in six)
                wanted = [
                    result["mean"] if k == 0 else cmath.rect(result["amplitudes"][k - 1], result["phases"][k - 1])
                    for result in motion["results"]
                ]
                # The point is at [−0.2, 0.1, 0.3] along the axes of the ground, and moves by t + θ × r.
                tip_y, tip_z = y - 0.3 * rx, z + 0.1 * rx
                for one, other in zip(wanted, (y, -rx, tip_y, tip_z)):
                    self.assertAlmostEqual(abs(one - other) / largest, 0, delta=1e-9)
                self.assertLess(max(map(abs, (x, ry, rz))), 1e-12 * largest)

    def test_a_moving_ground_is_a_place_too(self):
        push = MACHINE[MACHINE.index("[excitations.F]") : MACHINE.index("[analyses]")]
        base = '[excitations.floor]\ntype = "base"\ntranslation = ["2 mm", 0, 0]\n'
        found = run(STOP, "--json", "--at", "40 rad/s", machine=MACHINE.replace(push, base))
        self.assertEqual(found.returncode, 0, found.stderr)
        for motion in json.loads(found.stdout)["at"][0]["motions"]:
            foot = next(place for place in motion["places"] if place["name"] == "s.foot")["harmonics"]
            for k, six in enumerate(foot):
                self.assertAlmostEqual(abs(complex(*six[0]) - (k == 1) * 2e-3), 0, delta=1e-15)
                self.assertEqual(max(abs(complex(*one)) for one in six[1:]), 0)

    def test_a_frequency_outside_the_band_is_an_error(self):
        found = run(OPEN, "--at", "40 Hz")
        self.assertNotEqual(found.returncode, 0)
        self.assertIn("outside the band", found.stderr)

    def test_speeds_of_a_shaft_are_orders(self):
        machine = MACHINE.replace('type = "harmonic"', 'type = "orders"').replace(
            f"force = [{FORCE}, 0, 0]", f"table = [{{order = 2, force = [{FORCE}, 0, 0]}}]"
        )
        found = run(OPEN, "--json", "--at", "150 rpm", machine=machine.replace("24 rad", "12 rad"))
        self.assertEqual(found.returncode, 0, found.stderr)
        omega = 2 * 2 * math.pi * 150 / 60
        exact = FORCE / complex(STIFFNESS - MASS * omega**2, DAMPING * omega)
        (motion,) = json.loads(found.stdout)["at"][0]["motions"]
        self.assertEqual(motion["orders"][0], 2)
        self.assertAlmostEqual(motion["results"][0]["amplitudes"][0] / abs(exact), 1, delta=1e-9)

    def test_orders_that_do_not_act_change_nothing(self):
        def under(table):
            machine = MACHINE.replace('type = "harmonic"', 'type = "orders"').replace(
                f"force = [{FORCE}, 0, 0]", f"table = [{table}]"
            )
            return run(OPEN, "--json", "--at", "150 rpm", machine=machine.replace("24 rad", "12 rad"))

        acts = f"{{order = 2, force = [{FORCE}, 0, 0]}}"
        omega = 2 * 2 * math.pi * 150 / 60
        exact = FORCE / abs(complex(STIFFNESS - MASS * omega**2, DAMPING * omega))
        for still in ("{order = 1, force = [0, 0, 0]}", "{order = 0.5, force = [0, 7, 0]}"):  # none; along a fixed axis
            found = under(f"{still}, {acts}")
            self.assertEqual(found.returncode, 0, found.stderr)
            (motion,) = json.loads(found.stdout)["at"][0]["motions"]
            amplitude = dict(zip(motion["orders"], motion["results"][0]["amplitudes"]))
            self.assertAlmostEqual(amplitude[2] / exact, 1, delta=1e-9)
            self.assertLess(max(one for order, one in amplitude.items() if order != 2), 1e-12)
        found = under("{order = 1, force = [0, 0, 0]}, {order = 2, force = [0, 7, 0]}")
        self.assertNotEqual(found.returncode, 0)
        self.assertIn("the excitation is zero", found.stderr)
        shaft = f'[excitations.shaft]\ntype = "orders"\non = "m"\nat = [0, 0, 0]\ntable = [{acts}]\n[analyses]'
        self.assertIn('"shaft" does not act', run(OPEN, machine=MACHINE.replace("[analyses]", shaft)).stderr)

    def test_the_second_verdict_is_that_of_all_motions_at_a_frequency(self):
        found = run(STOP, "--json", "--deep", "--at", "36 rad/s,40 rad/s")
        result = json.loads(found.stdout)
        self.assertEqual(result["winding"]["points"], len(result["points"]))
        self.assertEqual(result["winding"]["differs_at"], [])
        # Between two folds of a curve its outer motions are stable, and that between them is not.
        for one in result["at"]:
            by_size = sorted(one["motions"], key=lambda motion: motion["results"][0]["amplitudes"][0])
            self.assertEqual([motion["stable"] for motion in by_size], [True, False, True])
            self.assertFalse(any(motion.get("uncertain") for motion in by_size))

    def test_a_mean_of_round_off_is_shown_as_0(self):
        """The machine on its snubber is symmetric: it moves as far up as down."""
        done = subprocess.run(
            [TRIVET, "steady", SOURCE / "examples/snubber/slip_map.toml"], capture_output=True, text=True
        )
        _, *rows = done.stdout.split("mean there")[1].splitlines()
        self.assertEqual([row.split()[6] for row in rows[:3]], ["0", "0", "0"], rows[:3])


class Grouped(unittest.TestCase):
    def test_equal_notes_and_warnings_of_several_elements_are_one_line(self):
        element = MACHINE[MACHINE.index("[elements.s]") : MACHINE.index("[excitations.F]")]
        machine = MACHINE.replace(element, "".join(element.replace("elements.s", f"elements.{name}") for name in "abc"))
        text = run("{friction = {slip = 10, stiffness = 1e4}}", machine=machine).stdout
        notes = [line for line in text.splitlines() if "tangent stiffness" in line]
        self.assertEqual(len(notes), 1, text)
        self.assertIn("a, b, c", notes[0].replace(" and ", ", "))
        self.assertLessEqual(text.count("friction sticks all the time"), 1)


if __name__ == "__main__":
    unittest.main()
