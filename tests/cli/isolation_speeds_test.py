# SPDX-License-Identifier: BSD-3-Clause
"""At which speeds an isolation without `at` is judged, against closed forms."""
import json
import math

from isolation_test import DIGITS, NATURAL, OSCILLATOR, rpm, transmitted
from trivet_test import InTemporaryFolder, trivet

ISOLATION = '[requirements]\nisolation = {least = "50 %"}\n'


class IsolationSpeeds(InTemporaryFolder):
    def requirements(self, text):
        return json.loads(trivet("verdict", self.file(text), "--json").stdout)["cases"][0]["requirements"]

    def test_an_isolation_holds_wherever_the_machine_runs(self):
        speeds = [1.2 * NATURAL * 30 / math.pi, 3 * NATURAL * 30 / math.pi]
        single = f'[operation]\nspeeds = ["{speeds[0]!r} rpm", "{speeds[1]!r} rpm"]\n'
        slow, fast = self.requirements(OSCILLATOR + single + ISOLATION)
        for one, speed in ((slow, speeds[0]), (fast, speeds[1])):
            self.assertAlmostEqual(one["value"], transmitted(rpm(speed)), delta=10**-DIGITS)
        self.assertFalse(slow["met"])
        self.assertTrue(fast["met"])
        over = f'[operation]\nspeeds = [["{speeds[0]!r} rpm", "{speeds[1]!r} rpm"]]\n'
        (whole,) = self.requirements(OSCILLATOR + over + ISOLATION)
        self.assertAlmostEqual(
            whole["value"], transmitted(rpm(speeds[0])), delta=10**-DIGITS
        )  # T falls with the speed

    def test_an_own_speed_remains(self):
        text = OSCILLATOR + '[operation]\nspeeds = ["100 rpm"]\n' + ISOLATION.replace("{", '{at = "40 Hz", ')
        (one,) = self.requirements(text)
        self.assertAlmostEqual(one["value"], transmitted(80 * math.pi), delta=10**-DIGITS)

    def test_a_speed_of_one_force_alone_is_its_service_speed(self):
        unbalance = '[excitations.rotor]\ntype = "unbalance"\non = "m"\nat = [0, 0, 0]\naxis = "x"\n'
        unbalance += 'grade = 6.3\nrotor_mass = "10 kg"\nservice_speed = "3000 rpm"\n'
        text = OSCILLATOR + unbalance + '[operation]\nspeeds = ["100 rpm"]\nexcitations = ["f"]\n'
        found = self.requirements(text + '[requirements]\nisolation = {least = "50 %", force = ["rotor"]}\n')
        along_z = next(one for one in found if "along z" in one["requirement"])
        self.assertAlmostEqual(along_z["value"], transmitted(rpm(3000)), delta=10**-DIGITS)
