# SPDX-License-Identifier: BSD-3-Clause
"""Limits at the speeds of a machine under several orders: rms by the rms, 0-p and p-p by the vibration in time, against
closed forms and a scan over time and speed."""
import cmath
import json
import math
import re

from operation_test import DASHPOT, MACHINE, MASS, RPM, STIFFNESS, stiffness
from trivet_test import InTemporaryFolder, trivet


def shaft(forces):
    """Orders with constant forces along z, given as complex numbers."""
    rows = ", ".join(
        f"{{order = {k!r}, force = [0, 0, {abs(f)!r}], phase = {cmath.phase(f)!r}}}" for k, f in forces.items()
    )
    return f'[excitations.shaft]\ntype = "orders"\non = "m"\nat = [0, 0, 0]\ntable = [{rows}]\n'


def amplitudes(forces, speed):
    return {k: f / stiffness(k * speed) for k, f in forces.items()}


def forces_for(motions, speed):
    """Forces that make these amplitudes at the speed."""
    return {k: y * stiffness(k * speed) for k, y in motions.items()}


def wave(motions, steps, turns=1):
    """y(t) over some turns of the shaft."""
    for n in range(steps):
        phase = 2 * math.pi * turns * n / steps
        yield sum((y * cmath.exp(1j * k * phase)).real for k, y in motions.items())


def table(printed, beginning):
    """Lines of a table with this beginning of its title, which is first."""
    (found,) = re.findall(rf"^{beginning}\b.*\n(?: .*\n)+", printed, re.MULTILINE)
    return found.splitlines()


class OperatingPeaks(InTemporaryFolder):
    def judged(self, text):
        done = trivet("verdict", self.file(text), "--json")
        self.assertTrue(done.stdout, done.stderr)
        return json.loads(done.stdout)["cases"][0]["requirements"]

    def test_a_limit_is_judged_at_its_level(self):
        """cos φ + cos 2φ has the rms 1, the peak 2 and the span 25/8."""
        speed = 400 * RPM
        unit = 1e-3
        forces = forces_for({1: unit, 2: unit}, speed)
        limits = ["1.01 mm rms", "1.5 mm 0-p", "3.2 mm p-p", "1.99 mm", "2.01 mm", "0.99 mm rms", "3.1 mm p-p"]
        expected = [1, 2, 25 / 8, 2, 2, 1, 25 / 8]
        levels = ["rms", "0-p", "p-p", "0-p", "0-p", "rms", "p-p"]
        for limit, value, level in zip(limits, expected, levels):
            text = MACHINE + shaft(forces) + f'[operation]\nspeeds = ["400 rpm"]\nlimits = {{"m.z" = "{limit}"}}\n'
            (one,) = self.judged(text)
            allowed = float(limit.split()[0])
            self.assertEqual(one["level"], level)
            self.assertAlmostEqual(one["allowed"] / unit, allowed, 12)
            self.assertAlmostEqual(one["value"] / unit, value, 8, limit)
            self.assertAlmostEqual(one["margin"], allowed / value, 8)
            self.assertEqual(one["met"], value <= allowed, limit)
            self.assertEqual(one["detail"], "")
            self.assertIn(f"{level}", one["shown_requirement"])
            self.assertTrue(one["shown_value"].endswith(level), one["shown_value"])
            own = json.loads(trivet("operation", self.file(text), "--json").stdout)["limits"][0]
            for key in ("value", "allowed", "met", "level"):
                self.assertEqual(own[key], one[key])
            strict = trivet("operation", self.file(text), "--strict")
            self.assertIn("VIOLATED" if value > allowed else "met", strict.stdout)

    def test_a_limit_that_the_rms_would_meet_is_violated(self):
        """Three orders in phase: √2 rms is √3, the peak 3."""
        speed = 400 * RPM
        forces = forces_for({1: 1e-3, 2: 1e-3, 3: 1e-3}, speed)
        text = MACHINE + shaft(forces) + '[operation]\nspeeds = ["400 rpm"]\nlimits = {"m.z" = "LIMIT mm"}\n'
        (below,) = self.judged(text.replace("LIMIT", "2.4"))
        self.assertFalse(below["met"])
        self.assertAlmostEqual(below["value"], 3e-3, 11)
        run = trivet("run", self.file(text.replace("LIMIT", "2.4")), "-o", self.folder / "out")
        self.assertIn("VIOLATED: 1 of 1", run.stdout)
        (above,) = self.judged(text.replace("LIMIT", "3.001"))
        self.assertTrue(above["met"])

    def test_two_limits_of_different_levels_both_count(self):
        forces = forces_for({1: 1e-3, 2: 1e-3}, 400 * RPM)
        text = MACHINE + shaft(forces)
        text += '[operation]\nspeeds = ["400 rpm"]\nlimits = {"m.z" = ["1.1 mm rms", "1.6 mm 0-p"]}\n'
        rms, peak = self.judged(text)
        self.assertTrue(rms["met"])
        self.assertFalse(peak["met"])
        self.assertIn("has no effect", trivet("check", self.file(text.replace("rms", "0-p"))).stderr)

    def test_orders_without_a_common_period_reach_their_sum(self):
        speed = 300 * RPM
        forces = forces_for({1: 1e-3, math.sqrt(2): -2e-3}, speed)
        text = MACHINE + shaft(forces) + '[operation]\nspeeds = ["300 rpm"]\nlimits = {"m.z" = "2.9 mm"}\n'
        (one,) = self.judged(text)
        self.assertAlmostEqual(one["value"], 3e-3, 11)

    def test_over_a_range_it_is_that_of_a_scan_over_speed_and_time(self):
        forces = {0.5: 60, 1: 40j, 2: 50 - 30j, 3: -45}
        limits = 'limits = {"m.z" = ["9 m", "9 m p-p"]}\n'
        for dashpot in (DASHPOT, 1500.0):
            machine = MACHINE.replace(f"0, {DASHPOT}", f"0, {dashpot}")

            def at(speed):
                return {
                    k: f / complex(STIFFNESS - MASS * (k * speed) ** 2, dashpot * k * speed) for k, f in forces.items()
                }

            peak, span = 0, 0
            for n in range(2001):
                values = list(wave(at((80 + 320 * n / 2000) * RPM), 200, 2))
                peak = max(peak, max(values), -min(values))
                span = max(span, max(values) - min(values))
            text = machine + shaft(forces) + '[operation]\nspeeds = [["80 rpm", "400 rpm"]]\n' + limits
            of_peak, of_span = json.loads(trivet("operation", self.file(text), "--json").stdout)["limits"]
            for found, scanned in ((of_peak, peak), (of_span, span)):
                self.assertGreaterEqual(found["value"], scanned * (1 - 1e-9))
                self.assertLess(found["value"], scanned * (1 + 2e-3))  # what the scan misses between its times
            values = list(wave(at(of_peak["at"]), 40_000, 2))
            self.assertAlmostEqual(of_peak["value"] / max(max(values), -min(values)), 1, 6)
            values = list(wave(at(of_span["at"]), 40_000, 2))
            self.assertAlmostEqual(of_span["value"] / (max(values) - min(values)), 1, 6)

    def test_an_undamped_mode_that_is_not_excited_does_not_matter(self):
        """Order 1 passes through the mode along x, which has no damping; the forces act along z."""
        free = MACHINE.replace('["z"]', '["x", "z"]').replace(
            "translation = [0, 0, 36", "translation = [20000, 0, 36", 1
        )
        limits = '[operation]\nspeeds = [["100 rpm", "500 rpm"]]\nlimits = {"m.z" = ["1 m", "1 m p-p"]}\n'
        forces = shaft({1: 50, 2: 50, 3: 40j})
        for alone, both in zip(self.judged(MACHINE + forces + limits), self.judged(free + forces + limits)):
            self.assertFalse(both["unbounded"])
            self.assertAlmostEqual(both["value"] / alone["value"], 1, 8)

    def test_a_speed_at_an_undamped_mode_that_no_order_reaches_has_values(self):
        """The same stiffness along x and z, a dashpot along z alone: there is no solution at this frequency, but a limit."""
        free = MACHINE.replace('["z"]', '["x", "z"]').replace("[0, 0, 36", "[36000, 0, 36", 1)
        forces = shaft({1: 50, 2: 50j})
        limits = 'limits = {"m.z" = ["5 m/s", "5 m/s p-p", "5 m/s rms", "1 m"]}\n'
        for speeds in ('[["20 rad/s", "40 rad/s"]]', '["30 rad/s"]'):
            text = forces + f"[operation]\nspeeds = {speeds}\n" + limits
            for alone, both in zip(self.judged(MACHINE + text), self.judged(free + text), strict=True):
                self.assertFalse(both["unbounded"], speeds)
                self.assertAlmostEqual(both["value"] / alone["value"], 1, 6, speeds)  # values 1e-7 beside the speed
        reached = free.replace("120.0]", "0]")
        for one in self.judged(reached + forces + '[operation]\nspeeds = ["30 rad/s"]\n' + limits):
            self.assertFalse(one["met"])

    def test_faint_gears_do_not_part_the_orders_of_the_shaft(self):
        """1.5, 3 and 4.5 with two gears have no common period of at most 2000 turns together, but without one gear."""
        speed = 400 * RPM
        shafts = {1.5: 1e-3, 3: 0.7e-3j, 4.5: -0.5e-3}
        limits = '[operation]\nspeeds = ["400 rpm"]\nlimits = {"m.z" = ["9 mm", "9 mm p-p"]}\n'
        values = [(max(map(abs, y)), max(y) - min(y)) for y in [list(wave(shafts, 20_000, 2))]][0]
        for gears, is_bound in (({37 / 23: 1e-12}, False), ({37 / 23: 1e-12, 37 / 15: 1e-12}, True)):
            text = MACHINE + shaft(forces_for(shafts | gears, speed)) + limits
            for one, value in zip(self.judged(text), values, strict=True):
                self.assertAlmostEqual(one["value"] / value, 1, 6)
                self.assertEqual("upper bound" in (one["detail"] or ""), is_bound)

    def test_tables_state_root_mean_squares_of_several_orders(self):
        forces = {1: 50, 2: 50}
        text = MACHINE + shaft(forces) + '[operation]\nspeeds = ["400 rpm", ["400 rpm", "500 rpm"]]\n'
        printed = trivet("operation", self.file(text + '[display]\nlevel = "amplitude"\n')).stdout
        motions = amplitudes(forces, 400 * RPM)  # above the resonance: the largest of the range, too
        displacement = math.sqrt(sum(abs(y) ** 2 for y in motions.values()) / 2)
        velocity = math.sqrt(sum(abs(k * 400 * RPM * y) ** 2 for k, y in motions.items()) / 2)
        force = math.sqrt(
            sum(abs(y * complex(STIFFNESS, DASHPOT * k * 400 * RPM)) ** 2 for k, y in motions.items()) / 2
        )
        for motion, on_ground in (("Motion", "Forces"), ("Largest motion", "Largest forces")):
            heading, of_motion = table(printed, motion)[1:3]
            self.assertIn("velocity, rms   displacement, rms", heading)
            self.assertEqual(
                of_motion.split()[1:5], [f"{1e3 * velocity:.4g}", "mm/s", f"{1e3 * displacement:.4g}", "mm"]
            )
            title, _, of_forces, _ = table(printed, on_ground)
            self.assertTrue(title.endswith(", rms"), title)
            self.assertEqual(of_forces.split(), ["ground", "0", "0", f"{force:.4g}"])
            for line in table(printed, motion) + table(printed, on_ground):
                self.assertNotRegex(line, "0-p|p-p")


if __name__ == "__main__":
    import unittest

    unittest.main()
