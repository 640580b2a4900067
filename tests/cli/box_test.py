# SPDX-License-Identifier: BSD-3-Clause
"""Solution boxes: text, CSV, JSON, picture and messages of `trivet box`."""
import csv
import io
import json
import math
import re
import shlex
import unittest

from trivet_test import SOURCE, InTemporaryFolder, trivet

POWERTRAIN = SOURCE / "examples/powertrain/box.toml"
FEW = ("--set", "analyses.box.points=1000", "--set", "analyses.box.most=2")
WEDGE = (SOURCE / "tests/data/projects/wedge.toml").read_text()


class Box(InTemporaryFolder):
    def wedge(self, change=lambda text: text):
        target = self.folder / "wedge.toml"
        target.write_text(change(WEDGE))
        return target

    def test_text_has_the_verdict_the_ranges_in_units_of_the_file_and_what_stops_them(self):
        text = trivet("box", self.wedge()).stdout
        self.assertTrue(
            text.startswith("Box: within these ranges every design that was judged meets all 2 requirements.\n")
        )
        self.assertIn("NOT all within the box: rubber, casting", text)
        self.assertRegex(text, r"rubber +elements\.k1\.translation\.z +40 N/mm +34\.2\d+ N/mm +45\.55\d+ N/mm")
        self.assertRegex(text, r"rubber +-14\.36 % +0\.9577 +at rest m1\.z ≤ 3 mm")
        self.assertRegex(text, r"casting +-0\.463 kg +0\.926\d +no natural frequency in 11 … 1000 Hz")
        self.assertIn("All 4 corners and 2,000 designs inside were judged, 260 of them also by assembled models", text)

    def test_printed_ends_are_within_the_box(self):
        text = trivet("box", self.wedge()).stdout
        row = next(one for one in text.splitlines() if "elements.k1.translation.z" in one).split()
        number = json.loads(trivet("box", self.wedge(), "--json").stdout)["numbers"][0]
        printed = [float(row[row.index("N/mm", 3 + 2 * i) - 1]) for i in (1, 2)]
        self.assertGreaterEqual(1000 * printed[0], number["from"] * (1 - 1e-9))
        self.assertLessEqual(1000 * printed[1], number["to"] * (1 + 1e-9))

    def test_csv_and_json_have_the_same_numbers(self):
        found = json.loads(trivet("box", self.wedge(), "--json").stdout)
        rows = list(csv.DictReader(io.StringIO(trivet("box", self.wedge(), "--csv").stdout)))
        self.assertTrue(found["verified"])
        self.assertEqual(len(rows), 2)
        for row, one in zip(rows, found["numbers"]):
            self.assertEqual(row["number"], one["number"])
            self.assertEqual((float(row["from"]), float(row["to"])), (one["from"], one["to"]))
        self.assertEqual(float(rows[0]["lower_times"]), found["ends"][0]["times"])

    def test_each_stated_design_beyond_an_end_violates_and_the_end_itself_does_not(self):
        project = self.wedge()
        found = json.loads(trivet("box", project, "--json").stdout)
        ends = [one for one in found["ends"] if one["stop"] == "requirement"]
        self.assertEqual(len(ends), 4)

        def margin(settings):
            judged = json.loads(trivet("verdict", project, *settings, "--json").stdout)
            return judged["least_margin"]["margin"]

        for one in ends:
            self.assertLess(margin(shlex.split(one["settings"])), 1, one)
        for first in ("from", "to"):
            for second in ("from", "to"):
                corner = zip(found["numbers"], (first, second))
                settings = [part for number, end in corner for part in ("--set", f"{number['number']}={number[end]!r}")]
                self.assertGreaterEqual(margin(settings), 1)

    def test_cases_that_decide_bound_the_box(self):
        soft = self.wedge(
            lambda text: text.replace("[requirements]\n", '[requirements]\nhold_in = ["", "heavy"]\n')
            + "[cases.heavy]\nbodies.m1.mass = 11\n"
        )
        both = json.loads(trivet("box", soft, "--json").stdout)
        self.assertEqual({one["case"] for one in both["requirements"]}, {"", "heavy"})
        lower = both["ends"][0]
        self.assertEqual((lower["end"], lower["case"]), ("lower", "heavy"))
        # k (1 − 0.15 s) = (11 + 0.5 s) g / 3 mm
        self.assertTrue(math.isclose(lower["times"], (40000 - 11 * 3268.8833) / (6000 + 0.5 * 3268.8833), rel_tol=1e-5))
        alone = json.loads(trivet("box", soft, "--case", "heavy", "--json").stdout)
        self.assertEqual({one["case"] for one in alone["requirements"]}, {"heavy"})

    def test_a_design_without_the_requirements_has_no_box(self):
        tight = self.wedge(lambda text: text.replace("3 mm", "2 mm"))
        done = trivet("box", tight)
        self.assertEqual(done.returncode, 1)
        self.assertIn(
            'the design of the file violates or only just meets "at rest m1.z ≤ 2 mm" (margin 0.8158)', done.stderr
        )

    def test_messages(self):
        def without(first, last):
            return lambda text: text[: text.index(first)] + text[text.index(last) :]

        for change, said in (
            (without("[tolerances.rubber]", "[requirements]"), "no tolerances"),
            (without("[requirements]", "[analyses.box]"), "neither requirements nor limits"),
            (lambda text: text + "most = 0.2\n", "1 to 1000 times that of the tolerance"),
            (lambda text: text + "[cases.a.analyses.box]\npoints = 100\n", "one box holds for all cases"),
        ):
            done = trivet("box", self.wedge(change))
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(said, done.stderr)

    def test_its_page_has_the_picture(self):
        page = self.folder / "box.html"
        self.assertEqual(trivet("box", self.wedge(), "-o", page).returncode, 0)
        self.assertRegex(page.read_text(), "<figure><div [^>]*><svg")
        self.assertIn("what stops their ends", page.read_text())

    def test_labels_of_ends_are_below_their_bars(self):
        picture = self.folder / "box.svg"
        self.assertEqual(trivet("box", self.wedge(), "--picture", picture).returncode, 0)
        drawing = picture.read_text()
        bars = [
            float(y) + float(height)
            for y, height in re.findall(r'<rect[^>]* y="([\d.]+)"[^>]* height="([\d.]+)"[^>]*fill-opacity', drawing)
        ]
        labels = re.findall(r'<text[^>]* y="([\d.]+)"[^>]*font-size="10" text-anchor="(start|end)"[^>]*>', drawing)
        self.assertEqual(len(bars), 2)
        self.assertEqual(len(labels), 4)
        letters = 10  # height of their capitals at most
        for i, (y, _) in enumerate(labels):
            self.assertGreater(float(y) - letters, bars[i // 2])
        for lower, upper in (labels[:2], labels[2:]):  # towards the middle from both edges, each half of the width
            self.assertEqual((lower[1], upper[1]), ("start", "end"))

    def test_powertrain(self):
        picture = self.folder / "box.svg"
        found = json.loads(trivet("box", POWERTRAIN, *FEW, "--picture", picture, "--json").stdout)
        self.assertTrue(found["verified"])
        self.assertEqual((found["corners"], found["all_corners"], found["inside"]), (64, True, 1000))
        self.assertGreater(found["all_times"], 1.5)
        drawing = picture.read_text()
        for name in ("right mount", "left mount", "rear mount", "damping", "brackets"):
            self.assertIn(f">{name}<", drawing)


if __name__ == "__main__":
    unittest.main()
