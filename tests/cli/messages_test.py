# SPDX-License-Identifier: BSD-3-Clause
"""Messages say what helps: every key that a table may have, the unit that holds, each problem once."""
import math
import unittest

from trivet_test import SOURCE, InTemporaryFolder, result_of, trivet

MACHINE = (SOURCE / "tests/data/projects/driven_mass.toml").read_text()
ENGINE = """[excitations.crank]
type = "orders"
on = "m"
at = [0, 0, 0]
[excitations.crank.engine]
layout = "inline"
cylinders = 1
crank = "x"
up = "z"
crank_radius = 0.05
rod_length = 0.2
oscillating_mass = 1
"""
TRACE = [(0, 1e5), (60, 3e5), (180, 1e5), (345, 4e5)]  # degrees, Pa; closed by the first one


class Messages(InTemporaryFolder):
    def said(self, text, code=2):
        done = trivet("check", self.file(text))
        self.assertEqual(done.returncode, code, done.stderr)
        return done.stderr

    def test_keys_that_are_read_only_where_they_are_given_are_known(self):
        for table, keys in (
            ('[analyses.response]\nof = ["m"]\nband = [1, 2]\n', ("excitations", "at")),
            ('[analyses.peaks]\nof = ["m"]\n', ("excitations",)),
            ('[requirements.isolation]\nleast = "80 %"\nband = [1, 2]\n', ("at", "base", "force")),
        ):
            said = self.said(MACHINE + table + "nonsense = 1\n")
            (known,) = [part for part in said.split("; ") if part.startswith("known here: ")]
            for key in keys:
                self.assertIn(key, known.removeprefix("known here: ").split(", "))
        said = self.said(MACHINE + '[analyses.response]\nof = ["m"]\nband = [1, 2]\nexcitation = ["f"]\n')
        self.assertIn('did you mean "excitations"?', said)

    def test_a_speed_in_quotes_needs_its_unit_and_a_misspelt_unit_has_its_spelling(self):
        drive = MACHINE + '[operation]\nspeeds = ["980", "980 rmp", "980 xyz"]\n'
        bare, misspelt, unknown = [line for line in self.said(drive).splitlines() if "error:" in line]
        self.assertIn("the unit is missing; a speed is in rpm, 1/min, Hz or rad/s", bare)
        self.assertIn('did you mean "980 rpm"?', misspelt)
        self.assertIn("a speed is in rpm, 1/min, Hz or rad/s", unknown)
        self.assertIn('speeds = ["980 rpm"', unknown)
        self.assertIn('did you mean "40 kg"?', self.said(MACHINE.replace("mass = 40", 'mass = "40 kgg"')))
        self.assertIn(
            'did you mean "1.5 mm"?', self.said(MACHINE.replace("at = [0, 0, 0]", 'at = ["1.5 nmm", 0, 0]', 1))
        )

    def test_a_motion_of_another_quantity_names_the_key_that_helps(self):
        floor = MACHINE + '[excitations.floor]\ntype = "random"\nbase = true\ntranslation = [0, 0, 1]\n'
        record = ", ".join(f"[{i / 100}, {(-1) ** i}]" for i in range(200))
        for psd in (
            f'{{history = {{rows = [{record}], unit = "mm/s"}}, resolution = "1 Hz"}}',
            '{flat = "1 (mm/s)2/Hz", band = ["1 Hz", "2 Hz"]}',
            '{rows = [["1 Hz", "1 (mm/s)2/Hz"], ["2 Hz", "1 (mm/s)2/Hz"]]}',
        ):
            with self.subTest(psd=psd[:20]):
                self.assertIn('add quantity = "velocity" if velocities are meant', self.said(floor + f"psd = {psd}\n"))
                self.said(floor + f'quantity = "velocity"\npsd = {psd}\n', code=0)
        base = MACHINE + '[excitations.floor]\ntype = "base"\ntranslation = ["0 m", "0 m", "1 mm/s"]\n'
        self.assertIn('add quantity = "velocity" if velocities are meant', self.said(base))
        limit = MACHINE + '[analyses]\nresponse = {band = [1, 2]}\n[limits]\n"m.z" = "0.5 mm/s rms"\n'
        self.assertIn('add quantity = "velocity" to response', self.said(limit))
        # A place is no motion of the ground.
        self.assertNotIn("add quantity", self.said(MACHINE.replace("at = [0, 0, 0]", 'at = ["1 mm/s", 0, 0]', 1)))

    def test_each_wrong_constant_of_a_mount_is_named(self):
        said = self.said(MACHINE.replace("[1, 1, 2.5e5]", '["144 N", 1, "-180 N/mm"]'))
        self.assertIn('"N" measures another quantity', said)
        self.assertIn('"-180 N/mm"; each constant must be ≥ 0', said)

    def test_a_misspelt_option_has_its_spelling(self):
        project = self.file(MACHINE)
        done = trivet("modes", "--cas", "x", project)
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stderr, 'error: "--cas" is not an option of modes; did you mean "--case"?\n')
        done = trivet("modes", project, "--wholly=1")
        self.assertEqual(done.stderr, 'error: "--wholly" is not an option of modes; trivet help modes lists them\n')

    def test_one_cylinder_fires_alone(self):
        for strokes in (2, 4):
            self.assertEqual(self.said(MACHINE + ENGINE + f"strokes = {strokes}\n", 0), "")
        three = ENGINE.replace("cylinders = 1", "cylinders = 3\nspacing = 0.1\nstrokes = 2")
        self.assertIn("firing_order = [1, 2, …]", self.said(MACHINE + three))

    def engine_with(self, rows, heading, more=""):
        self.file(heading + "\n" + "".join(f"{a},{p}\n" for a, p in rows), "trace.csv")
        return MACHINE + ENGINE + f'strokes = 2\npressure = {{file = "trace.csv", bore = 0.1{more}}}\n'

    def test_a_rounded_last_angle_closes_the_cycle(self):
        closed = TRACE + [(360, 1e5)]
        self.assertEqual(self.said(self.engine_with(closed, "crank_angle_deg,pressure"), 0), "")
        # The gas forces turn the engine about its crankshaft.
        analysis = '[analyses.orders]\nof = ["m.rx"]\nspeed = ["600 rpm", "900 rpm"]\n'

        def turning(text):
            inertia = 'free = ["rx"]\ninertia = {about = "center_of_mass", xx = 5, yy = 5, zz = 5}'
            text = text.replace("400]}", "400], rotation = [60, 1, 1]}").replace('free = ["z"]', inertia)
            return text.replace("2.5e5]", "2.5e5]\nrotation = [3e4, 1, 1]") + analysis

        exact = result_of("orders", self.file(turning(self.engine_with(closed, "crank_angle_deg,pressure"))))
        for digits in (2, 4):  # 6.28 rad and 6.2832 rad, which is 360.0004°
            radians = [(f"{math.radians(a):.{digits}f}", p) for a, p in closed]
            text = self.engine_with(radians, '"crank_angle [rad]",pressure')
            self.assertEqual(self.said(text, 0), "")
            rounded = result_of("orders", self.file(turning(text)))
            found, wanted = rounded["overall"][0], exact["overall"][0]
            # An angle is off by at most half a unit of its last digit, of steps of about a radian.
            for value, right in zip(found["rms"], wanted["rms"], strict=True):
                self.assertLess(abs(value - right), 10**-digits * wanted["highest_rms"])
        beyond = TRACE + [(365, 1e5)]
        self.assertIn("a cycle has 360°", self.said(self.engine_with(beyond, "crank_angle_deg,pressure")))

    def test_the_unit_of_a_pressure(self):
        self.assertIn(
            "pressure [bar]",
            self.said(self.engine_with([(a, p / 1e5) for a, p in TRACE], "crank_angle_deg,pressure"), 0),
        )
        in_bar = self.engine_with(TRACE, "crank_angle_deg,pressure", ', unit = "bar"')  # 4e10 Pa
        self.assertIn("the column seems to be in Pa", self.said(in_bar, 0))
        both = self.engine_with(TRACE, '"crank_angle_deg","pressure [Pa]"', ', unit = "bar"')
        self.assertIn("the unit in the heading holds", self.said(both, 0))

    def test_a_unit_beside_values_with_units(self):
        line = '[limit_lines.a]\nof = "m.z"\nunit = "in/s"\nrows = [[1, "4.5 mm/s"], [50, "4.5 mm/s"]]\n'
        line += '[analyses.response]\nof = ["m.z"]\nband = ["1 Hz", "9 Hz"]\n'
        self.assertIn("limit_lines.a.unit: beside rows with units of their own", self.said(MACHINE + line, 0))
        self.assertNotIn("limit_lines.a.unit", self.said(MACHINE + line.replace('"4.5 mm/s"', "4.5"), 0))
        noise = '[excitations.n]\ntype = "random"\non = "m"\nat = [0, 0, 0]\nforce = [0, 0, 1]\n'
        flat = 'psd = {flat = "4 N^2/Hz", band = ["1 Hz", "9 Hz"], unit = "lbf^2/Hz"}\n'
        self.assertIn("the unit of the value holds", self.said(MACHINE + noise + flat, 0))

    def test_a_column_with_another_name(self):
        self.file("frequency,limit\n1,1\n2,1\n", "line.csv")
        said = self.said(MACHINE + '[limit_lines.a]\nof = "m.z"\nfile = "line.csv"\n')
        self.assertIn('name the one that is meant: frequency_hz = "COLUMN"', said)
        self.assertNotIn("did you mean", said)

    def test_an_error_of_a_catalogue_is_reported_once(self):
        self.file(
            'catalogue = 1\ntitle = "t"\nsource = "s"\n[mounts.a]\nmaker = "m"\ntranslation = [1, 1, -5]\n', "c.toml"
        )
        mount = '[elements.{}]\ntype = "catalogue:a"\ncatalogue = "c.toml"\non = "m"\nat = [0, 0, 0]\naxis = "z"\n'
        said = self.said(MACHINE + "".join(mount.format(name) for name in ("e1", "e2", "e3")))
        self.assertEqual(said.count("error:"), 1, said)
        self.assertIn("mounts.a", said)

    def test_the_overview_counts_cases_that_decide(self):
        text = (
            MACHINE + '[requirements]\nhold_in = ["", "hard"]\nstatic = {"m.z" = "2 mm"}\nlimits = {"m.z" = "0.1 mm"}\n'
        )
        text += "[cases.hard]\nelements.s.translation.z = 4e5\n[cases.soft]\nelements.s.translation.z = 1e5\n"
        out = self.folder / "out"
        trivet("run", self.file(text), "--output", out)
        self.assertIn("VIOLATED: 2 of 4 requirements", (out / "report.html").read_text())


if __name__ == "__main__":
    unittest.main()
