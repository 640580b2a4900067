# SPDX-License-Identifier: BSD-3-Clause
"""Third octaves as excitation, result and limit line, in every form."""
import csv
import json
import math
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

from trivet_test import HANGS_AFTER

TRIVET = os.environ["TRIVET"]
SOURCE = pathlib.Path(os.environ["TRIVET_SOURCE"])
EXAMPLE = SOURCE / "examples/microscope/microscope.toml"
ROUND_OFF = 1e-9

# One mass of 100 kg on a spring along z, 9 Hz, over a moving ground.
ONE_MASS = """trivet = 1
[bodies.mass]
mass = 100
inertia = {about = "pole", xx = 0, yy = 0, zz = 0}
free = ["z"]
[elements.spring]
type = "matrix"
on = "mass"
at = [0, 0, 0]
stiffness = [[0,0,0,0,0,0],[0,0,0,0,0,0],[0,0,319775.5,0,0,0],[0,0,0,0,0,0],[0,0,0,0,0,0],[0,0,0,0,0,0]]
damping = {proportional = 0.002}
"""
GROUND = """[excitations.floor]
type = "random"
base = true
translation = [0, 0, 1]
psd = {psd}
"""


def run(*arguments, text=None):
    """The answer of the program to a project, given as text or by the arguments."""
    with tempfile.TemporaryDirectory() as folder:
        if text is not None:
            file = pathlib.Path(folder) / "project.toml"
            file.write_text(text, encoding="utf-8")
            arguments = (arguments[0], str(file), *arguments[1:])
        return subprocess.run([TRIVET, *arguments], capture_output=True, text=True, timeout=HANGS_AFTER)


def result(*arguments, text=None):
    answer = run(*arguments, "--json", text=text)
    return json.loads(answer.stdout)


def only_case(document):
    return document["cases"][0] if "cases" in document else document


class BandsTest(unittest.TestCase):
    def test_levels_of_the_ground_come_back_whatever_they_measure(self):
        """The floor itself, as the motion of a mass on a spring that is stiff against the band."""
        levels = [("8 Hz", 2.0), ("10 Hz", 3.5), ("12.5 Hz", 0.4)]
        exact = [10 ** (n / 10) for n in (9, 10, 11)]
        for unit, order in (("µm", 0), ("µm/s rms", 1), ("µm/s²", 2)):
            rows = ", ".join(f'["{hertz}", "{level} {unit}"]' for hertz, level in levels)
            psd = '{bands = "third-octave", levels = [' + rows + "]}"
            quantity = ["displacement", "velocity", "acceleration"][order]
            stiff = ONE_MASS.replace("319775.5", "3e13").replace("0.002", "1e-12")
            text = (
                stiff
                + GROUND.replace("{psd}", psd)
                + f'[analyses]\nrandom = {{of = ["mass.z"], quantity = "{quantity}", bands = "third-octave"}}\n'
            )
            bands = only_case(result("random", text=text))["bands"]
            self.assertEqual([band["midband"] for band in bands], [hertz for hertz, _ in levels])
            for band, (_, level), midband in zip(bands, levels, exact):
                self.assertAlmostEqual(band["rms"][0] / (1e-6 * level), 1, delta=1e-7)
                self.assertAlmostEqual(band["from"] * band["to"] / (2 * math.pi * midband) ** 2, 1, delta=ROUND_OFF)

    def test_bands_add_up_to_the_total_in_every_form(self):
        document = only_case(result("random", str(EXAMPLE)))
        for place, total in enumerate(document["results"]):
            squares = sum(band["rms"][place] ** 2 for band in document["bands"])
            self.assertAlmostEqual(math.sqrt(squares) / total["rms"], 1, delta=1e-7)
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run(
                [TRIVET, "run", str(EXAMPLE), "-o", folder + "/out"], capture_output=True, timeout=HANGS_AFTER
            )
            tables = sorted(pathlib.Path(folder).rglob("*bands.csv"))
            self.assertTrue(tables)
            with open(tables[0], encoding="utf-8") as file:
                rows = list(csv.DictReader(file))
            self.assertEqual(len(rows), len(document["bands"]))
            for row, band in zip(rows, document["bands"]):
                self.assertAlmostEqual(
                    float(row["table.objective.z [m/s]"]), band["rms"][2], delta=1e-9 * band["rms"][2]
                )
        self.assertIn("31.5 Hz", run("random", str(EXAMPLE)).stdout)

    def test_the_verdict_is_whether_the_line_is_met(self):
        met = run("verdict", "--strict", str(EXAMPLE))
        self.assertEqual(met.returncode, 0, met.stdout + met.stderr)
        self.assertIn("meets its requirements", met.stdout)
        self.assertRegex(met.stdout, r"2\.5\d+ µm/s rms of 3\.12 µm/s rms")
        limit = '\n[limit_lines.strict]\nof = "table.objective.z"\nline = "VC-G"\n'
        text = EXAMPLE.read_text(encoding="utf-8").replace("floor.csv", str(EXAMPLE.parent / "floor.csv"))
        text = text.replace('limit_lines = ["', 'limit_lines = ["strict", "').replace(
            "[requirements]", limit + "\n[requirements]"
        )
        broken = run("verdict", "--strict", text=text)
        self.assertEqual(broken.returncode, 3, broken.stdout)
        self.assertIn("strict", broken.stdout)

    def test_a_line_is_read_at_the_nominal_frequency_of_every_band(self):
        """Over a floor that is the motion: margins are limit over level, also where the exact midband is beside the line."""
        rows = ", ".join(f'["{f} Hz", "10 µm/s rms"]' for f in (3.15, 4, 5, 6.3, 8, 10))
        stiff = ONE_MASS.replace("319775.5", "3e13").replace("0.002", "1e-12")
        text = stiff + GROUND.replace("{psd}", '{bands = "third-octave", levels = [' + rows + "]}")
        text += (
            '[limit_lines.a]\nof = "mass.z"\nline = "VC-A"\n[limit_lines.own]\nof = "mass.z"\nbands = "third-octave"\n'
        )
        text += 'rows = [["4 Hz", "9 µm/s"], ["5 Hz", "9 µm/s"], ["5 Hz", "20 µm/s"], ["10 Hz", "20 µm/s"]]\n'
        named, own = only_case(result("limit_lines", text=text))
        self.assertEqual(named["bands"], "third-octave")
        self.assertIn("SPIE", named["source"])
        self.assertAlmostEqual(named["least_margin"], 5, delta=1e-6)
        edges = [2 * math.pi * 10 ** (n / 20) for n in (11, 21)]  # of 4 and of 10 Hz: the line begins at 4 Hz
        for found, edge in zip(named["compared"], edges):
            self.assertAlmostEqual(found / edge, 1, delta=ROUND_OFF)
        self.assertAlmostEqual(own["least_margin"], 0.9, delta=1e-7)
        (exceeded,) = own["exceeded"]
        self.assertAlmostEqual(exceeded[0] / edges[0], 1, delta=ROUND_OFF)
        self.assertAlmostEqual(exceeded[1] / (2 * math.pi * 10 ** (15 / 20)), 1, delta=ROUND_OFF)  # 4 and 5 Hz
        self.assertFalse(own["kept"])

    def test_named_lines_are_those_of_schema_and_document(self):
        line = json.loads(run("schema").stdout)["properties"]["limit_lines"]["additionalProperties"]["properties"][
            "line"
        ]
        psd = '{bands = "third-octave", levels = [["8 Hz", "1 µm/s"]]}'
        text = ONE_MASS + GROUND.replace("{psd}", psd) + '[limit_lines.a]\nof = "mass.z"\nline = "VC-Z"\n'
        refused = run("check", text=text).stderr.partition("named lines are ")[2]
        self.assertEqual(re.findall(r'"(.*?)"', refused.partition(";")[0]), line["enum"])
        document = (SOURCE / "docs/random.md").read_text(encoding="utf-8")
        for name in line["enum"]:
            self.assertIn(f"`{name}`", document)

    def test_bands_below_a_tenth_of_a_hertz_are_judged(self):
        """A density that begins at 0 Hz; the floor moves the mass as it is."""
        stiff = ONE_MASS.replace("319775.5", "3e13").replace("0.002", "1e-12")
        text = stiff + GROUND.replace("{psd}", '{rows = [[0, 1e-12], [1, 1e-12]], interpolation = "linear"}')
        text += '[limit_lines.slow]\nof = "mass.z"\nbands = "octave"\nquantity = "displacement"\nrows = [["0.03 Hz", 1e-12], ["0.07 Hz", 1e-12]]\n'
        (slow,) = only_case(result("limit_lines", text=text))
        width = 10 ** (3 / 20) - 10 ** (-3 / 20)
        midband = 10 ** (-12 / 10)  # 0.063 Hz; the band below has 0.0316 Hz
        level = math.sqrt(1e-12 * midband * width)
        self.assertAlmostEqual(slow["least_margin"] / (1e-12 / level), 1, delta=1e-6)

    def test_a_criterion_that_is_judged_in_part_says_so(self):
        levels = ", ".join(f'["{f} Hz", "1 µm/s rms"]' for f in (50, 63))
        text = ONE_MASS + GROUND.replace("{psd}", '{bands = "third-octave", levels = [' + levels + "]}")
        text += '[limit_lines.a]\nof = "mass.z"\nline = "VC-E"\n[requirements]\nlimit_lines = ["a"]\n'
        found = run("verdict", text=text)
        self.assertIn("judged in 50 … 63 Hz of 1 … 80 Hz", found.stdout)
        self.assertIn('suspicion "measured range"', found.stdout + found.stderr)

    def test_a_band_that_the_excitation_fills_in_part_says_how_much_of_it(self):
        """Constant density up to 60 % of the band of 50 Hz, and in the upper half of that of 25 Hz."""
        edges = {hertz: (10 ** (n / 10 - 0.05), 10 ** (n / 10 + 0.05)) for hertz, n in ((25, 14), (50, 17))}
        low = sum(edges[25]) / 2
        high = edges[50][0] + 0.6 * (edges[50][1] - edges[50][0])
        text = ONE_MASS + GROUND.replace("{psd}", f'{{flat = 1e-12, band = ["{low!r} Hz", "{high!r} Hz"]}}')
        text += '[limit_lines.a]\nof = "mass.z"\nline = "VC-E"\n[requirements]\nlimit_lines = ["a"]\n'
        ((judged,),) = [
            case["requirements"] for case in json.loads(run("verdict", "--json", text=text).stdout)["cases"]
        ]
        self.assertIn("excitation covers 50 % of the 25 Hz band, 60 % of the 50 Hz band", judged["detail"])

    def test_a_measured_history_has_the_level_of_its_tones_in_their_bands(self):
        """3 mm/s at 10 Hz and 1 mm/s at 25 Hz, peak values, for 64 s."""
        pi = math.pi
        rows = "time,value [mm/s]\n" + "".join(
            f"{i / 128},{3 * math.sin(2 * pi * 10 * i / 128) + math.cos(2 * pi * 25 * i / 128)}\n" for i in range(8192)
        )
        stiff = ONE_MASS.replace("319775.5", "3e13").replace("0.002", "1e-12")
        psd = '{history = {file = "floor.csv"}, resolution = "0.25 Hz"}\nquantity = "velocity"'
        text = (
            stiff
            + GROUND.replace("{psd}", psd)
            + '[analyses]\nrandom = {of = ["mass.z"], quantity = "velocity", bands = "third-octave"}'
        )
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "floor.csv").write_text(rows)
            project = pathlib.Path(folder) / "project.toml"
            project.write_text(text)
            found = only_case(result("random", str(project)))
        levels = {band["midband"]: band["rms"][0] for band in found["bands"]}
        self.assertAlmostEqual(levels["10 Hz"] / (3e-3 / math.sqrt(2)), 1, delta=1e-7)
        self.assertAlmostEqual(levels["25 Hz"] / (1e-3 / math.sqrt(2)), 1, delta=1e-7)
        self.assertLess(levels["16 Hz"], 1e-9)


if __name__ == "__main__":
    unittest.main()
