# SPDX-License-Identifier: BSD-3-Clause
"""Bands of amplitudes of `trivet sample`: JSON, CSV, text, picture, page and study folder."""
import csv
import io
import json
import re
import unittest

from trivet_test import SOURCE, InTemporaryFolder, trivet

ROBUST = SOURCE / "examples/paper/robust.toml"
FEW = ("--set", "analyses.sample.designs=1000", "--set", 'analyses.sample.bands=["aggregate.z", "aggregate.rx"]')
NUMBERS = ("angular_frequency", "given", "least", "low", "median", "high", "largest")


# Velocities and forces in one selection; the force has a limit, and so has the velocity.
DRIVEN = (
    (SOURCE / "tests/data/projects/driven_mass.toml").read_text()
    + """[requirements]
limits = {"m.z" = "20 mm/s rms", "ground.force.z" = "300 N"}
[analyses]
response = {band = ["1 Hz", "30 Hz"], of = ["m.z", "ground.force.z"], quantity = "velocity"}
sample = {designs = 1000, bands = ["m.z", "ground.force.z"]}
[tolerances.t]
path = "elements.s.scale"
half_width = "10 %"
"""
)


class SampleBands(InTemporaryFolder):
    def test_json_and_csv_have_the_same_numbers_in_their_order(self):
        study = self.folder / "study"
        done = trivet("sample", ROBUST, *FEW, "-o", study, "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        bands = json.loads(done.stdout)["bands"][0]["results"]
        self.assertEqual([band["result"] for band in bands], ["aggregate.z", "aggregate.rx"])
        rows = list(csv.DictReader(io.StringIO((study / "bands.csv").read_text())))
        self.assertEqual(len(rows), sum(len(band["given"]) for band in bands))
        for band in bands:
            self.assertGreaterEqual(len(band["angular_frequency"]), 200)
            of = [row for row in rows if row["result"] == band["result"]]
            for k, row in enumerate(of):
                for name in NUMBERS:
                    column = "angular_frequency [rad/s]" if name == "angular_frequency" else name
                    self.assertEqual(float(row[column]), band[name][k])
                self.assertEqual(int(row["largest_design"]), band["largest_design"][k])
            for order in zip(*(band[name] for name in ("least", "low", "median", "high", "largest"))):
                self.assertEqual(list(order), sorted(order))
        self.assertAlmostEqual(bands[0]["limits"][0]["amplitude"], 8e-3)
        self.assertEqual(bands[1]["limits"], [])
        plain = trivet("sample", ROBUST, *FEW, "--json").stdout
        self.assertEqual((study / "result.json").read_text(), plain)

    def test_the_given_design_has_its_response(self):
        bands = json.loads(trivet("sample", ROBUST, *FEW, "--json").stdout)["bands"][0]["results"]
        at = bands[0]["angular_frequency"]
        response = ("--set", f"analyses.response={{at = {at}}}", "--csv")
        rows = list(csv.DictReader(io.StringIO(trivet("response", ROBUST, *response).stdout)))
        self.assertEqual(len(rows), len(at))
        for row, expected in zip(rows, bands[0]["given"]):
            self.assertAlmostEqual(
                abs(complex(float(row["aggregate.z re [m]"]), float(row["aggregate.z im [m]"]))) / expected, 1, 9
            )

    def test_text_shows_where_most_designs_are_highest(self):
        found = trivet("sample", ROBUST, *FEW).stdout
        self.assertRegex(
            found,
            r"Amplitudes of 1000 designs, each result at that of 2\d\d frequencies where the 95 % value is largest",
        )
        self.assertRegex(found, r"\n  aggregate\.z +\S+ +\S+ mm 0-p")

    def test_picture_and_page_show_the_bands(self):
        picture, page = self.folder / "bands.svg", self.folder / "result.html"
        done = trivet("sample", ROBUST, *FEW, "--picture", picture)
        self.assertEqual(done.returncode, 0, done.stderr)
        done = trivet("sample", ROBUST, *FEW, "-o", page)
        self.assertEqual(done.returncode, 0, done.stderr)
        for text in (picture.read_text(), page.read_text()):
            self.assertIn("5 … 95 % of the designs", text)
            self.assertIn("design of the file", text)
            self.assertIn("limit", text)
            self.assertNotIn("nan", text)

    def test_limits_on_forces_are_drawn_beside_velocities(self):
        project, picture = self.file(DRIVEN), self.folder / "bands.svg"
        found = json.loads(trivet("sample", project, "--json").stdout)
        velocity, force = found["bands"][0]["results"]
        self.assertAlmostEqual(velocity["limits"][0]["amplitude"], 0.02 * 2**0.5)
        self.assertEqual([one["amplitude"] for one in force["limits"]], [300])
        self.assertEqual(trivet("sample", project, "--picture", picture).returncode, 0)
        self.assertEqual(len(re.findall(r'<polyline [^>]*stroke="#D55E00"', picture.read_text())), 2)

    def test_a_picture_needs_bands(self):
        project = self.folder / "plain.toml"
        text = ROBUST.read_text()
        start = text.index(", bands = ")
        project.write_text(text[:start] + text[text.index("}", start) :])
        done = trivet("sample", project, "--picture", self.folder / "bands.svg")
        self.assertEqual(done.returncode, 2)
        self.assertIn("--picture: a picture shows bands; name their results", done.stderr)
        self.assertNotIn("bands", json.loads(trivet("sample", project, "--json").stdout))


if __name__ == "__main__":
    unittest.main()
