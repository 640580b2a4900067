# SPDX-License-Identifier: BSD-3-Clause
"""Requirements on the steady motion of nonlinear machines."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

TRIVET = os.environ["TRIVET"]
MACHINE = """trivet = 1
[bodies.m]
mass = 40
free = ["x"]
[elements.s]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [36000, 0, 0]
damping = {translation = [48, 0, 0]}
laws.x = LAW
[excitations.F]
type = "harmonic"
on = "m"
at = [0, 0, 0]
force = [60, 0, 0]
[requirements]
band = ["24 rad/s", "50 rad/s"]
REQUIRED
[analyses]
steady = {of = ["m.x"], harmonics = 15}
"""


def verdict(law, required, *options, machine=MACHINE):
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "machine.toml"
        file.write_text(machine.replace("LAW", law).replace("REQUIRED", required))
        run = subprocess.run([TRIVET, "verdict", str(file), "--json", *options], capture_output=True, text=True)
        result = json.loads(run.stdout) if run.stdout else {}
        return run, result["cases"][0]["requirements"] if "cases" in result else None


STOP = "{gap_stop = {gap = 0.006, stiffness = 4e5}}"


class SteadyRequirements(unittest.TestCase):
    def test_a_stop_is_touched_and_the_motion_jumps(self):
        _, found = verdict(STOP, 'no_jump = true\nno_contact = true\nsteady = {"m.x" = 0.02}')
        of = {one["kind"]: one for one in found}
        self.assertGreaterEqual(of["no_jump"]["value"], 2)
        self.assertEqual(of["no_jump"]["margin"], 0)

    def test_open_stops_are_untouched(self):
        _, found = verdict("{gap_stop = {gap = 0.2, stiffness = 4e5}}", "no_jump = true\nno_contact = true")
        of = {one["kind"]: one for one in found}
        self.assertEqual(of["no_jump"]["value"], 0)
        self.assertAlmostEqual(of["no_contact"]["margin"], 0.2 / (60 / (48 * 30)), delta=0.02)

    def test_velocities_and_accelerations_by_their_unit(self):
        open_stop = "{gap_stop = {gap = 0.2, stiffness = 4e5}}"  # the machine is linear
        limits = 'steady = {"m.x" = ["0.1 m", "1 m/s", "10 m/s^2"]}'
        run, found = verdict(open_stop, limits)
        self.assertEqual(run.returncode, 0, run.stderr)
        amplitude = [
            max(o**n * 60 / abs(complex(36000 - 40 * o**2, 48 * o)) for o in (29.9 + i * 1e-4 for i in range(2000)))
            for n in range(3)
        ]
        by_unit = {one["unit"]: one["value"] for one in found}
        for unit, largest in zip(("m", "m/s", "m/s²"), amplitude):
            self.assertAlmostEqual(by_unit[unit] / largest, 1, delta=1e-3)  # of points beside the resonance

    def test_limits_are_those_of_displacements_whatever_the_curves_show(self):
        shown = MACHINE.replace("harmonics = 15", 'harmonics = 15, quantity = "acceleration"')
        values = [verdict(STOP, 'steady = {"m.x" = 0.02}', machine=one)[1][0]["value"] for one in (MACHINE, shown)]
        self.assertEqual(*values)

    def test_without_a_stable_motion_nothing_is_met(self):
        run, found = verdict("{polynomial = [-80000, 0, 1e9]}", 'steady = {"m.x" = 1}')
        self.assertEqual(run.returncode, 1)
        self.assertIsNone(found[0]["value"])
        self.assertIn("no periodic motion is known to be stable", found[0]["reason"])

    def test_a_known_motion_beyond_a_limit_violates_it_whatever_is_not_known(self):
        law = "{gap_stop = {gap = 0.001, stiffness = 1e6}}"  # period-doubled motions that are unstable: 4.39 to 4.71 Hz
        _, found = verdict(law, 'steady = {"m.x" = 0.02}')
        self.assertGreater(found[0]["value"], 0.03)
        self.assertLess(found[0]["margin"], 1)
        self.assertIn("known to be stable from 4.38", found[0]["detail"])
        run, found = verdict(law, 'steady = {"m.x" = 0.1}')
        self.assertIsNone(found[0]["value"])
        self.assertIn("known to be stable from 4.38", found[0]["reason"])
        self.assertEqual(run.returncode, 1)

    def test_a_curve_that_ends_early_hides_no_violation(self):
        law = "{gap_stop = {gap = 0.006, stiffness = 3e11}}"
        run, found = verdict(law, 'steady = {"m.x" = 0.001}')
        self.assertGreater(found[0]["value"], 0.001)
        self.assertLess(found[0]["margin"], 1)
        self.assertIn("steady motion: ", found[0]["detail"])
        run, found = verdict(law, 'steady = {"m.x" = 0.1}')
        self.assertIsNone(found[0]["value"])
        self.assertIn("steady motion: ", found[0]["reason"])
        self.assertEqual(run.returncode, 1)

    def test_a_curve_that_ends_before_its_jumps_is_no_proof_that_there_are_none(self):
        rows = "rows = [[-0.004, -40], [-0.002, -15], [0, 0], [0.002, 15], [0.004, 40]]"  # the resonance goes farther
        machine = MACHINE.replace("50 rad/s", "29 rad/s")
        run, found = verdict(f'{{curve = {{{rows}, beyond = "refuse"}}}}', "no_jump = true", machine=machine)
        self.assertIsNone(found[0]["value"])
        self.assertFalse(found[0]["judged"])
        self.assertIn("steady motion: ", found[0]["reason"])
        self.assertEqual(run.returncode, 1)

    def test_a_limit_that_is_met_says_which_motions_were_sought(self):
        _, found = verdict(STOP, 'steady = {"m.x" = 0.1}')
        self.assertGreater(found[0]["margin"], 1)
        self.assertIn("connected with the lower end", found[0]["detail"])

    def test_orders_of_a_shaft(self):
        under_orders = MACHINE.replace('type = "harmonic"', 'type = "orders"').replace(
            "force = [60, 0, 0]", "table = [{order = 1, force = [60, 0, 0]}]"
        )
        required = 'no_contact = true\nsteady = {"m.x" = 0.02}'
        _, harmonic = verdict(STOP, required)
        _, orders = verdict(STOP, required, machine=under_orders)
        for of_force, of_shaft in zip(harmonic, orders, strict=True):
            self.assertAlmostEqual(of_force["value"] / of_shaft["value"], 1, places=9)

    def test_machines_without_stops_or_laws_are_refused(self):
        run, _ = verdict("{cubic = 1e9}", "no_contact = true")
        self.assertEqual(run.returncode, 2)
        self.assertIn("a machine without stops", run.stderr)

    def test_a_ring_that_bears_at_rest_is_touched(self):
        ring = """[elements.ring]
type = "stop"
on = "m"
at = [0, 0, 0]
axis = "y"
ring = PLAY
stiffness = 8e4
[excitations.F]"""
        machine = MACHINE.replace("[excitations.F]", ring).replace("trivet = 1", "trivet = 1\ngravity = [9.81, 0, 0]")
        for play, bears in (("0.005", True), ("0.5", False)):
            _, found = verdict("{cubic = 1}", "no_contact = true", machine=machine.replace("PLAY", play))
            one = found[0]
            self.assertEqual(one["margin"] == 0, bears, one)
            self.assertEqual("closed at rest" in one.get("detail", ""), bears, one)

    def test_a_slider_loaded_up_to_its_slip_has_one_of_many_means(self):
        machine = MACHINE.replace("trivet = 1", "trivet = 1\ngravity = [9.81, 0, 0]").replace("60, 0, 0", "6, 0, 0")
        slider = "{friction = {slip = 60, stiffness = 3e4}}"
        machine = machine.replace('["24 rad/s", "50 rad/s"]', '["10 rad/s", "20 rad/s"]')
        _, found = verdict(slider, 'steady = {"m.x" = 1}', machine=machine)
        self.assertIn("sticks all the time", found[0]["detail"])

    def test_load_factor_needs_a_band(self):
        run, found = verdict(
            "{cubic = 1e6}",
            'steady = {"m.x" = 1}',
            "--set",
            'requirements.band=["0 Hz", "8 Hz"]',
            "--set",
            'analyses.steady={over = "load_factor", at = "5 Hz", load_factor = [0.1, 2]}',
        )
        self.assertIn("give them a band", found[0]["reason"] if found else run.stderr)


if __name__ == "__main__":
    unittest.main()
