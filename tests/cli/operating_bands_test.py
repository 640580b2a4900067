# SPDX-License-Identifier: BSD-3-Clause
"""Levels in octaves and third octaves at the speeds of a machine: the tones in each band against the closed forms of one
mass on a spring, and limit lines over them."""
import csv
import json
import math
import os
import pathlib
import subprocess
import tempfile
import unittest

from operation_test import DASHPOT, MACHINE, MASS, ORDERS, ROTOR, STIFFNESS, UNBALANCE

TRIVET = os.environ["TRIVET"]


def rms(force, hertz):
    """Velocity of the mass under a harmonic force, root mean square."""
    omega = 2 * math.pi * hertz
    return omega * force / abs(complex(STIFFNESS - MASS * omega**2, DASHPOT * omega)) / math.sqrt(2)


def orders_at(hertz):
    """Frequencies and velocities of the orders 2 and 3 at a shaft speed."""
    return {2 * hertz: rms(50, 2 * hertz), 3 * hertz: rms(0.05 * (2 * math.pi * hertz) ** 2, 3 * hertz)}


def edges(midband, width):
    """Edges [Hz] of the band with this exact midband frequency."""
    half = 10 ** (0.05 if width == "third-octave" else 0.15)
    return midband / half, midband * half


class OperatingBands(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file = pathlib.Path(folder.name) / "machine.toml"

    def trivet(self, text, *arguments, code=0):
        self.file.write_text(text)
        words = [TRIVET, arguments[0], self.file, *arguments[1:]]
        if arguments[0] == "run":
            words += ["-o", self.file.parent / "results"]
        run = subprocess.run(words, capture_output=True, text=True)
        self.assertEqual(run.returncode, code, run.stderr)
        return run

    def levels(self, text, *arguments, quantity="velocity", name="m.z"):
        """Levels of a result by nominal midband frequency."""
        rows = json.loads(self.trivet(text, "operation", "--json", *arguments).stdout)["bands"]
        return {row["nominal_hz"]: row["rms"] for row in rows if (row["name"], row["quantity"]) == (name, quantity)}

    def near(self, found, expected, share=1e-9):
        self.assertLessEqual(abs(found - expected), share * abs(expected), (found, expected))

    def test_each_tone_is_in_its_third_octave(self):
        found = self.levels(MACHINE + ORDERS + '[operation]\nspeeds = ["300 rpm"]\nbands = "third-octave"\n')
        second, third = orders_at(5).values()  # 10 Hz and 15 Hz
        self.assertEqual(list(found), [10, 16])
        self.near(found[10], second)
        self.near(found[16], third)

    def test_tones_in_one_octave_add_as_squares(self):
        text = MACHINE + ORDERS + '[operation]\nspeeds = ["360 rpm"]\nbands = "octave"\n'
        found = self.levels(text)  # 12 Hz and 18 Hz, both in 11.2 … 22.4 Hz
        self.assertEqual(list(found), [16])
        self.near(found[16], math.hypot(*orders_at(6).values()))
        rows = json.loads(self.trivet(text, "operation", "--json").stdout)["values"]
        (total,) = [row["rms"] for row in rows if row["name"] == "m.z" and row["quantity"] == "velocity"]
        self.near(found[16], total)
        force = self.levels(text, quantity="force", name="ground.force.z")
        self.assertEqual(list(force), [16])

    def test_a_tone_on_an_edge_is_in_the_upper_band(self):
        edge = 60 * edges(10, "third-octave")[1]  # rpm
        for rpm, band in ((edge, 12.5), (edge * (1 - 1e-6), 10), (edge * (1 + 1e-6), 12.5)):
            found = self.levels(MACHINE + ROTOR, "--at", f"{rpm!r} rpm", "--bands", "third-octave")
            self.assertEqual(list(found), [band], rpm)
            self.near(found[band], rms(UNBALANCE * (rpm * math.pi / 30) ** 2, rpm / 60))

    def test_the_largest_level_over_a_range_is_that_of_a_fine_scan(self):
        for width in ("third-octave", "octave"):
            found = self.levels(
                MACHINE + ORDERS + f'[operation]\nspeeds = [["100 rpm", "170 rpm"]]\nbands = "{width}"\n'
            )
            step = 1 if width == "third-octave" else 3
            bands = {10 ** (n / 10): 0.0 for n in range(0, 13, step)}
            limits = [(midband, *edges(midband, width)) for midband in bands]
            # beside a grid, the speeds just below and above each edge
            speeds = [(100 + 70 * i / 40_000) / 60 for i in range(40_001)]
            speeds += [
                edge / k * (1 + by) for _, *pair in limits for edge in pair for k in (2, 3) for by in (-1e-9, 1e-9)
            ]
            for speed in speeds:
                if not 100 / 60 <= speed <= 170 / 60:
                    continue
                tones = orders_at(speed)
                for midband, low, high in limits:
                    level = math.hypot(*(value for hertz, value in tones.items() if low <= hertz < high))
                    bands[midband] = max(bands[midband], level)
            expected = [level for level in bands.values() if level > 0]
            self.assertEqual(len(found), len(expected), (found, bands))
            for level, scanned in zip(found.values(), expected):
                self.near(level, scanned, 1e-6)

    def test_a_line_over_bands_bounds_the_orders_at_each_speed(self):
        level = rms(UNBALANCE * (2 * math.pi * 10) ** 2, 10)
        line = (
            '[limit_lines.floor]\nof = "m.z"\nbands = "third-octave"\n'
            f'rows = [["5 Hz", "{2 * level} m/s"], ["80 Hz", "{2 * level} m/s"]]\n'
        )
        operation = '[operation]\nspeeds = ["600 rpm", "60000 rpm", ["590 rpm", "600 rpm"]]\n'
        text = MACHINE + ROTOR + line + operation + 'bands = "third-octave"\n'
        found = json.loads(self.trivet(text, "verdict", "--json").stdout)
        at, beyond, over = found["cases"][0]["requirements"]
        self.assertEqual(at["requirement"], 'm.z within "floor" at 600 rpm')
        self.assertEqual(at["kind"], "band_line")
        self.near(at["margin"], 2)
        self.near(at["value"], 0.5)
        self.near(at["angular_frequency"], 2 * math.pi * 10)
        self.assertEqual(beyond["detail"], "no order in 5 … 80 Hz")
        self.assertEqual(beyond["value"], 0)
        self.assertGreater(over["value"], 0.5)  # velocity falls with the speed beyond the resonance
        self.assertTrue(found["met"])
        rows = json.loads(self.trivet(text, "operation", "--json").stdout)["bands"]
        (judged,) = [row for row in rows if row["line"] == "floor" and row["from"] == row["to"]]
        self.near(judged["share"], 0.5)
        self.near(judged["limit"], 2 * level)
        lower = text.replace(f"{2 * level} m/s", f"{0.5 * level} m/s")
        self.assertFalse(json.loads(self.trivet(lower, "verdict", "--json").stdout)["met"])
        self.assertIn("VIOLATED", self.trivet(lower, "operation").stdout)
        by_default = json.loads(self.trivet(MACHINE + ROTOR + line + operation, "verdict", "--json").stdout)
        self.assertEqual(by_default["cases"], found["cases"])
        others = MACHINE + ROTOR + line + operation + 'bands = "octave"\n'
        self.assertIn('bands = "third-octave" to [operation]', self.trivet(others, "verdict", code=2).stderr)
        message = self.trivet(MACHINE + ROTOR + line, "verdict", code=2).stderr
        self.assertIn("or [operation] with the speeds of the machine", message)

    def test_bands_outside_of_the_line_are_counted(self):
        text = MACHINE + ORDERS + '[operation]\nspeeds = ["300 rpm"]\n[limit_lines.floor]\nof = "m.z"\n'
        text += 'bands = "third-octave"\nrows = [["5 Hz", "1 m/s"], ["12 Hz", "1 m/s"]]\n'  # tones at 10 and 15 Hz
        words = "1 of 2 bands with orders are outside the line"
        (judged,) = json.loads(self.trivet(text, "verdict", "--json").stdout)["cases"][0]["requirements"]
        self.assertEqual(judged["detail"], words)
        self.assertIn(words, self.trivet(text, "run", "--full").stdout)
        (judged,) = json.loads(self.trivet(text.replace("12 Hz", "80 Hz"), "verdict", "--json").stdout)["cases"][0][
            "requirements"
        ]
        self.assertEqual(judged["detail"], "")

    def test_a_line_of_the_file_is_judged_in_the_case_that_has_the_speeds(self):
        level = rms(UNBALANCE * (2 * math.pi * 10) ** 2, 10)
        text = (
            MACHINE + ROTOR + '[limit_lines.floor]\nof = "m.z"\nbands = "third-octave"\n'
            f'rows = [["5 Hz", "{2 * level} m/s"], ["80 Hz", "{2 * level} m/s"]]\n'
            '[cases.running]\noperation = {speeds = "600 rpm", bands = "third-octave"}\n'
        )
        base, running = json.loads(self.trivet(text, "verdict", "--json").stdout)["cases"]
        self.assertEqual(base["requirements"], [])
        (judged,) = running["requirements"]
        self.near(judged["margin"], 2)
        nowhere = text[: text.index("[cases")]
        self.assertIn("no random excitation in the model", self.trivet(nowhere, "verdict", code=2).stderr)

    def test_the_sum_of_tones_and_random_vibration_is_judged(self):
        density = 2e-3  # of the velocity of the ground [(m/s)²/Hz]
        noise = (
            '[excitations.floor]\ntype = "random"\nbase = true\ntranslation = [0, 0, 1]\nquantity = "velocity"\n'
            f'psd = {{flat = {density}, band = ["1 Hz", "100 Hz"]}}\n'
        )

        def moved(hertz):
            """Velocity of the mass over that of the ground, squared."""
            omega = 2 * math.pi * hertz
            passed = complex(STIFFNESS, DASHPOT * omega)
            return abs(passed / (passed - MASS * omega**2)) ** 2

        low, high = edges(10, "third-octave")
        count = 4000  # Simpson's rule
        step = (high - low) / count
        weights = [1 if i in (0, count) else 4 if i % 2 else 2 for i in range(count + 1)]
        shaken = math.sqrt(density * step / 3 * sum(w * moved(low + i * step) for i, w in enumerate(weights)))
        tone = rms(UNBALANCE * (2 * math.pi * 10) ** 2, 10)
        text = MACHINE + ROTOR + noise + '[operation]\nspeeds = ["600 rpm"]\nbands = "third-octave"\n'
        text += '[limit_lines.quiet]\nof = "m.z"\nline = "workshop"\n'
        requirements = json.loads(self.trivet(text, "verdict", "--json").stdout)["cases"][0]["requirements"]
        self.assertEqual(
            sorted(one["requirement"] for one in requirements), ['m.z within "quiet"', 'm.z within "quiet" at 600 rpm']
        )
        (judged,) = [one for one in requirements if one["requirement"].endswith("at 600 rpm")]
        self.near(judged["value"], math.hypot(tone, shaken) / 800e-6, 1e-8)
        self.assertEqual(judged["detail"], "with the random vibration")
        rows = json.loads(self.trivet(text, "operation", "--json").stdout)["bands"]
        (row,) = [row for row in rows if row["line"]]
        self.near(row["rms"], tone)
        self.near(row["random"], shaken, 1e-8)
        self.near(row["share"], judged["value"])
        # each part alone is below a limit that the sum is above
        limit = math.hypot(tone, shaken) / 1.01
        self.assertLess(max(tone, shaken), limit)
        own = f'[limit_lines.quiet]\nof = "m.z"\nbands = "third-octave"\nrows = [["10 Hz", "{limit} m/s"], ["11 Hz", "{limit} m/s"]]\n'
        text = text[: text.index("[limit_lines")] + own
        self.assertIn("1 requirement violated", self.trivet(text, "run", "--strict", code=3).stderr)
        self.assertIn("1 limit violated", self.trivet(text, "operation", "--strict", code=3).stderr)
        lines = self.trivet(text, "limit_lines", "--strict", code=3).stdout
        self.assertIn("VIOLATED with the tones at 600 rpm; random vibration alone is below", lines)
        met = self.trivet(text.replace(f"{limit} m/s", f"{2 * limit} m/s"), "limit_lines").stdout
        self.assertIn("met, with tones too", met)

    def test_lines_that_no_requirement_judges_count(self):
        level = rms(UNBALANCE * (2 * math.pi * 10) ** 2, 10)
        text = MACHINE + ROTOR + '[operation]\nspeeds = ["600 rpm", ["590 rpm", "595 rpm"]]\nbands = "third-octave"\n'
        text += '[requirements]\nlimit_lines = ["high"]\n'
        for name, share in (("high", 2), ("low", 0.5)):
            bound = f"{share * level} m/s"
            text += f'[limit_lines.{name}]\nof = "m.z"\nbands = "third-octave"\n'
            text += f'rows = [["5 Hz", "{bound}"], ["80 Hz", "{bound}"]]\n'
        done = self.trivet(text, "run", "--strict", code=3)
        self.assertTrue(done.stdout.startswith("VIOLATED: 2 of 2 limit lines"), done.stdout)
        self.assertIn("2 limits violated", done.stderr)
        page = (self.file.parent / "results" / "report.html").read_text()
        self.assertIn("VIOLATED: 2 of 2 limit lines", page)
        named = text.replace('["high"]', '["high", "low"]')
        self.assertIn("2 requirements violated", self.trivet(named, "run", "--strict", code=3).stderr)
        self.assertIn("VIOLATED", self.trivet(text, "operation", "--strict", code=3).stdout)
        self.trivet(text.replace(f"{0.5 * level} m/s", f"{3 * level} m/s"), "operation", "--strict", code=4)

    def test_a_range_that_ends_on_an_edge_reaches_the_upper_band(self):
        edge = 60 * edges(10, "third-octave")[1]  # rpm
        text = MACHINE + ROTOR + f'[operation]\nspeeds = [["540 rpm", "{edge!r} rpm"]]\nbands = "third-octave"\n'
        found = self.levels(text)
        self.assertEqual(list(found), [10, 12.5])
        self.near(found[12.5], rms(UNBALANCE * (edge * math.pi / 30) ** 2, edge / 60))
        both = self.levels(text.replace(ROTOR, ORDERS).replace("540", "300").replace(repr(edge), repr(edge / 2)))
        self.assertEqual(list(both), [10, 12.5, 16])
        self.near(both[12.5], rms(50, edge / 60))

    def test_lines_over_other_bands_are_reported(self):
        noise = (
            '[excitations.floor]\ntype = "random"\nbase = true\ntranslation = [0, 0, 1]\nquantity = "velocity"\n'
            'psd = {flat = 1e-16, band = ["1 Hz", "100 Hz"]}\n'
        )
        text = MACHINE + ROTOR + noise + '[limit_lines.quiet]\nof = "m.z"\nline = "VC-C"\n'
        operation = '[operation]\nspeeds = ["600 rpm"]\n'
        said = self.trivet(text + operation + 'bands = "octave"\n', "run", "--strict", code=1).stdout
        self.assertIn("limit_lines.quiet.line: not judged at the operating speeds", said)
        judged = self.trivet(text + operation + 'bands = "octave"\n', "verdict", code=1).stdout
        self.assertIn("NOT JUDGED", judged)
        self.assertIn("[operation] has octave bands, the line third-octave bands", judged)
        for bands in ("", 'bands = "third-octave"\n'):
            right = self.trivet(text + operation + bands, "run").stdout
            self.assertNotIn("not judged at the operating speeds", right)

    def test_tables_state_line_margin_and_level(self):
        text = MACHINE + ROTOR + '[operation]\nspeeds = ["600 rpm", "60000 rpm"]\nbands = "third-octave"\n'
        text += 'limits."m.z" = "1 m 0-p"\n[limit_lines.quiet]\nof = "m.z"\nbands = "third-octave"\n'
        text += 'rows = [["5 Hz", "1 m/s"], ["80 Hz", "1 m/s"]]\n'
        table = list(csv.DictReader(self.trivet(text, "verdict", "--csv").stdout.splitlines()))
        self.assertEqual(list(table[0])[-1], "level")
        self.assertEqual({row["kind"]: row["level"] for row in table}, {"operation": "0-p", "band_line": ""})
        self.trivet(text, "run")
        page = (self.file.parent / "results" / "report.html").read_text()
        cells = r"<td[^>]*>{}</td>\s*"
        of_speed = [r"m\.z", r"within &quot;quiet&quot; at 60000 rpm", "[^<]*", "[^<]*", "∞"]
        self.assertRegex(page, "".join(cells.format(one) for one in of_speed))


if __name__ == "__main__":
    unittest.main()
