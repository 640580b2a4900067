# SPDX-License-Identifier: BSD-3-Clause
"""The figure of measured band levels: its steps are the levels of the file, its lines the limits in the same bands."""
import csv
import math
import re
import subprocess
import unittest

from report_page_test import SOURCE, TRIVET, Folder

from trivet_test import HANGS_AFTER

EXAMPLE = SOURCE / "examples/microscope"
PIXEL = 0.002  # of the logarithm of a level: places have two decimals, 90 pixels are a decade


def text_places(svg, anchor):
    """Numbers of an axis and where they are: [(number, x, y)]."""
    found = re.findall(rf'<text x="([\d.]+)" y="([\d.]+)"[^>]*text-anchor="{anchor}"[^>]*>([\d.]+)</text>', svg)
    return [(float(text), float(x), float(y)) for x, y, text in found]


def logarithms(places):
    """Pixel → log10 of the value, from two numbers of the axis."""
    (first, p), (last, q) = places[0], places[-1]
    slope = (math.log10(last) - math.log10(first)) / (q - p)
    return lambda pixel: math.log10(first) + slope * (pixel - p)


class BandLevels(Folder):
    def figures(self, text):
        for name in ("microscope.toml", "floor.csv"):
            (self.folder / name).write_bytes((EXAMPLE / name).read_bytes())
        (self.folder / "microscope.toml").write_text(text)
        out = self.folder / "out"
        run = [TRIVET, "run", str(self.folder / "microscope.toml"), "-o", str(out)]
        subprocess.run(run, check=True, capture_output=True, timeout=HANGS_AFTER)
        return out

    def test_the_steps_are_the_measured_levels_and_the_line_their_limit(self):
        out = self.figures((EXAMPLE / "microscope.toml").read_text())
        svg = next((out / "00-base").glob("levels-*.svg")).read_text()
        self.assertIn("velocity [µm/s rms]", svg)
        numbers = text_places(svg, "end")
        height = logarithms([(value, y - 4) for value, _, y in numbers])
        lines = [
            [tuple(map(float, point.split(","))) for point in points.split()]
            for points in re.findall(r'<polyline fill="none" points="([^"]+)"', svg)
        ]
        with open(EXAMPLE / "floor.csv", newline="") as file:
            rows = list(csv.reader(line for line in file if not line.startswith("#")))[1:]
        for axis, line in zip((1, 2, 3), lines, strict=False):
            drawn = sorted({round(y, 2) for _, y in line})
            for level in {float(row[axis]) for row in rows}:
                self.assertLess(min(abs(height(y) - math.log10(level)) for y in drawn), PIXEL, (axis, level))
        limit = {round(10 ** height(y), 2) for _, y in lines[3]}
        self.assertEqual(len(limit), 1)
        self.assertAlmostEqual(limit.pop(), 3.12, delta=0.1)  # VC-E
        key = re.search(r">limit of:<.*", svg, re.DOTALL)[0]
        for axis in "xyz":  # one line for equal limits
            self.assertIn(f">table.objective.{axis}<", key)
        self.assertEqual(svg.count(">limit of:<"), 1)
        self.assertIn("Measured levels of the excitation", (out / "report.html").read_text())

    def test_levels_of_another_quantity_have_no_limits_of_velocities(self):
        text = (EXAMPLE / "microscope.toml").read_text()
        levels = ((8, 2), (10, 3), (12.5, 0), (16, 1))
        rows = ", ".join(f'["{band} Hz", "{level} mm/s² rms"]' for band, level in levels)
        text = re.sub(r'psd = \{.*level = "z"\}', f'psd = {{bands = "third-octave", levels = [{rows}]}}', text)
        folder = self.figures(text) / "00-base"
        both = {path.name: path.read_text() for path in sorted(folder.glob("levels-*.svg"))}
        self.assertEqual(list(both), ["levels-01-floor_x.svg", "levels-02-floor_z.svg"])
        svg = both["levels-02-floor_z.svg"]
        self.assertIn("acceleration [mm/s² rms]", svg)
        self.assertNotIn("limit", svg)
        self.assertEqual(svg.count("<polyline"), 2)  # the band of 12.5 Hz is a gap
        self.assertIn(f"{math.sqrt(14):.4g} mm/s² rms in all bands", svg)


if __name__ == "__main__":
    unittest.main()
