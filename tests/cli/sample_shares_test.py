# SPDX-License-Identifier: BSD-3-Clause
"""The picture of the shares of the variance of `trivet sample --shares`: its bars are the numbers of JSON."""
import json
import re
import unittest

from trivet_test import SOURCE, InTemporaryFolder, trivet

ROBUST = SOURCE / "examples/paper/robust.toml"
RECT = re.compile(r'<rect x="([\d.]+)" y="([\d.]+)" width="([\d.]+)" height="([\d.]+)" fill="(#\w+|none)"')
ALONE, TOGETHER, ROUNDED = "#0072B2", "#74b3d8", 0.011


class SampleShares(InTemporaryFolder):
    def project(self, *changes):
        text = ROBUST.read_text().replace('correlation = {with = "core", value = 0.5}\n', "")
        text = text.replace("designs = 100_000", "designs = 5000")
        for old, new in changes:
            self.assertIn(old, text)
            text = text.replace(old, new)
        target = self.folder / "project.toml"
        target.write_text(text)
        return target

    def drawn(self, project):
        picture = self.folder / "shares.svg"
        done = trivet("sample", project, "--shares", "--picture", picture, "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)["shares"], picture.read_text()

    def test_bars_have_the_lengths_of_the_shares_in_their_order(self):
        shares, svg = self.drawn(self.project())
        rects = [tuple(map(float, one[:4])) + (one[4],) for one in RECT.findall(svg)]
        bars = [one for one in rects if one[4] in (ALONE, TOGETHER) and one[1] > 60]  # below the key
        frames = [one for one in rects if one[4] == "none" and one[2] == 470]
        hundred = [float(x) for x in re.findall(r'<text x="([\d.]+)" [^>]*>100 %</text>', svg)]
        listed = shares["list"]
        requirements = list(dict.fromkeys(one["requirement"] for one in listed))
        self.assertEqual(len(frames), len(requirements))
        self.assertEqual(len(hundred), len(requirements))
        units = [end - frame[0] for end, frame in zip(hundred, frames)]  # each panel has its own axis
        expected = []
        for one in listed:
            for name, colour in (("first", ALONE), ("total", TOGETHER)):
                if one[name + "_from"] > 0:
                    unit = units[requirements.index(one["requirement"])]
                    expected.append((max(one[name] * unit, 1), colour))
        self.assertGreater(len(expected), 5)
        self.assertEqual(len(bars), len(expected))
        for bar, (width, colour) in zip(bars, expected):
            self.assertAlmostEqual(bar[2], width, delta=ROUNDED)
            self.assertEqual(bar[4], colour)

    def test_a_share_that_may_be_zero_has_no_bar(self):
        shares, svg = self.drawn(self.project())
        zero = [one for one in shares["list"] for name in ("first", "total") if one[name + "_from"] <= 0]
        self.assertTrue(zero)
        self.assertEqual(len(re.findall(r">cannot be told from 0, ≤ ", svg)), len(zero))
        hollow = [one for one in re.findall(r'<rect [^>]*fill="none"[^>]*dasharray', svg)]
        self.assertEqual(len(hollow), len(zero) + 1)  # one in the key
        self.assertNotRegex(svg, r"(?<![\w.])-\d|nan")

    def test_the_page_has_the_picture(self):
        page = self.folder / "result.html"
        done = trivet("sample", self.project(), "--shares", "-o", page)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(page.read_text(), r'<figure><div class="scroll"[^>]*><svg')
        self.assertIn("Which tolerance scatters which value", page.read_text())

    def test_of_many_numbers_the_largest_are_drawn(self):
        text = ROBUST.read_text()
        start, end = text.index("[tolerances.rubber]"), text.index("[requirements]")
        paths = ["elements.suspension.scale", "elements.suspension.damping.proportional", "bodies.aggregate.mass"]
        paths += [f"bodies.aggregate.center_of_mass.{axis}" for axis in "xyz"]
        paths += [f"bodies.aggregate.inertia.{axis}" for axis in ("xx", "yy", "zz")]
        paths += [f"excitations.force.{kind}.{axis}" for kind in ("force", "moment") for axis in "xyz"]
        tolerances = f'[tolerances.all]\npath = {json.dumps(paths)}\nhalf_width = "1 %"\n'
        project = self.folder / "many.toml"
        project.write_text(text[:start].replace("100_000", "5000") + tolerances + text[end:])
        shares, svg = self.drawn(project)
        first = shares["list"][0]["requirement"]
        listed = [one for one in shares["list"] if one["requirement"] == first]
        self.assertEqual(len(listed), 15)
        top = svg[: svg.index(" % each</text>")]
        for one in listed[:12]:
            self.assertIn(f'>{one["number"][4:]}</text>', top)
        for one in listed[12:]:
            self.assertNotIn(f'>{one["number"][4:]}</text>', top)
        rest = float(re.search(r"and 3 more, with others ≤ ([\d.]+)$", top).group(1)) / 100
        largest = max(one["total_to"] for one in listed[12:])
        self.assertTrue(largest <= rest <= 1.11 * largest + 1e-6, (largest, rest))

    def test_a_part_of_a_study_leaves_the_picture_to_the_last_one(self):
        picture, study = self.folder / "shares.svg", self.folder / "study"
        for part in (1, 2):
            self.assertFalse(picture.exists())
            words = ("--shares", "--picture", picture, "-o", study, "--part", f"{part}/2")
            done = trivet("sample", self.project(), *words)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual("--picture: the shares of the variance are computed when" in done.stderr, part == 1)
        self.assertIn("Which tolerance scatters which value", picture.read_text())

    def test_the_name_of_a_tolerance_is_not_divided(self):
        name, heading = '"gap at rest"', "[tolerances.casting]"
        _, svg = self.drawn(self.project((heading, f"[tolerances.{name}]")))
        self.assertIn(">gap at rest</text>", svg)

    def test_without_shares_there_is_no_picture_of_them(self):
        text = ROBUST.read_text().replace("100_000", "100")
        self.assertIn("bands = [", text)  # another picture is no answer
        project = self.file(text)
        done = trivet("sample", project, "--shares", "--picture", self.folder / "shares.svg")
        self.assertEqual(done.returncode, 1)
        self.assertIn("--picture: there are no shares of the variance: 100 designs are too few: 160 are", done.stderr)
        self.assertIn("No shares of the variance: ", done.stdout)
        self.assertFalse((self.folder / "shares.svg").exists())


if __name__ == "__main__":
    unittest.main()
