# SPDX-License-Identifier: BSD-3-Clause
"""Kept designs of `trivet sample`: their numbers and margins in JSON, in CSV, and as lines of the picture."""
import csv
import io
import json
import math
import re
import unittest

from trivet_test import SOURCE, InTemporaryFolder, trivet

ROBUST = SOURCE / "examples/paper/robust.toml"
BY_KERNELS = 1e-8  # of the margins, which kernels compute in the sample
PIXEL = 0.02  # rounding of the picture
AXIS = re.compile(
    r'<line x1="([\d.]+)" y1="([\d.]+)" x2="([\d.]+)" y2="[\d.]+" class="design-axis"[^>]* data-name="([^"]*)" '
    r'data-unit="([^"]*)" data-from="([^"]+)" data-to="([^"]+)" data-end="([^"]+)"( data-logarithmic="")?'
)
TEXT = re.compile(r'<text x="([\d.]+)" y="([\d.]+)" ([^>]*)>([^<]*)</text>')


def shortened(text):
    return text.replace("designs = 100_000", "designs = 3000")


class KeptDesigns(InTemporaryFolder):
    def project(self, text=None):
        return self.file(text or shortened(ROBUST.read_text()))

    def sample(self, project, *words):
        done = trivet("sample", project, "--json", *words)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def picture(self, project, *words):
        page = self.folder / "page.html"
        done = trivet("sample", project, "-o", page, *words)
        self.assertEqual(done.returncode, 0, done.stderr)
        return next(svg for svg in re.findall(r"<svg.*?</svg>", page.read_text(), re.S) if "design-axis" in svg)

    def lines(self, svg):
        """Points of the lines by their verdict, of the first and of later designs."""
        groups = re.findall(r'<g data-verdict="(\w+)"( data-further="")?[^>]*>(.*?)</g>', svg, re.S)
        points = lambda text: [tuple(map(float, one.split(","))) for one in text.split()]
        return {
            (verdict, bool(further)): [points(one) for one in re.findall(r'points="([^"]*)"', lines)]
            for verdict, further, lines in groups
        }

    def test_margins_are_those_of_the_design_that_set_builds(self):
        project = self.project()
        found = self.sample(project)
        paths = [one["path"] for one in found["kept_numbers"]]
        self.assertEqual(len(paths), 4)
        reasons = {}
        for one in found["kept"]:
            reasons.setdefault(one["kept_as"], []).append(one)
        extremes = {one["extreme"]: one for one in found["kept"] if one["extreme"]}
        self.assertEqual(set(extremes), {"least margin", "largest margin"})
        self.assertEqual(extremes["least margin"]["margin"], found["worst_margin"])
        some = [reasons[kind][i] for kind in reasons for i in (0, -1)] + list(extremes.values())
        self.assertLessEqual(set(reasons), {"first", "failing", "extreme"})
        self.assertEqual(len(reasons["first"]), 400)
        for one in some:
            settings = [f"{path}={number!r}" for path, number in zip(paths, one["numbers"])]
            words = [word for setting in settings for word in ("--set", setting)]
            verdict = json.loads(trivet("verdict", project, "--json", *words).stdout)["cases"][0]
            names = [requirement["requirement"] for requirement in found["cases"][0]["requirements"]]
            margins = {result["requirement"]: result["margin"] for result in verdict["requirements"]}
            for name, margin in zip(names, one["margins"]):
                expected = margins[name]
                if margin is None:
                    self.assertIsNone(expected)
                else:
                    self.assertAlmostEqual(margin / expected, 1, delta=BY_KERNELS)
            self.assertEqual(one["verdict"] == "met", verdict["met"])
            least = min(zip([math.inf if m is None else m for m in one["margins"]], names))
            self.assertEqual((one["margin"], one["governing"]), least)

    def test_the_table_has_the_numbers_of_json(self):
        project, study = self.project(), self.folder / "study"
        found = self.sample(project, "-o", study)
        rows = list(csv.DictReader(io.StringIO((study / "designs.csv").read_text())))
        self.assertEqual(len(rows), len(found["kept"]))
        numbers = [one["path"] + (f' [{one["unit"]}]' if one["unit"] else "") for one in found["kept_numbers"]]
        self.assertIn("bodies.aggregate.mass [kg]", numbers)
        margins = ["margin: " + one["requirement"] for one in found["cases"][0]["requirements"]]
        for row, one in zip(rows, found["kept"]):
            self.assertEqual(int(row["design"]), one["design"])
            for key in ("kept_as", "extreme", "verdict", "governing"):
                self.assertEqual(row[key], one[key])
            self.assertEqual([float(row[name]) for name in numbers], one["numbers"])
            self.assertEqual([None if row[name] == "inf" else float(row[name]) for name in margins], one["margins"])

    def test_lines_have_the_values_of_the_designs(self):
        project = self.project()
        found, svg = self.sample(project), self.picture(project)
        axes = AXIS.findall(svg)
        kept, lines = found["kept"], self.lines(svg)
        for verdict in ("met", "violated"):
            for further in (False, True):
                designs = [one for one in kept if one["verdict"] == verdict and (one["design"] >= 400) == further]
                drawn = lines.get((verdict, further), [])
                self.assertEqual(len(drawn), len(designs), (verdict, further))
                for points, design in zip(drawn, designs):
                    self.assertEqual([y for _, y in points], [float(axis[1]) for axis in axes])
                    for (x, _), axis in zip(points, axes):
                        self.assertAlmostEqual(x, self.place(axis, design, found), delta=PIXEL)
        self.assertEqual(sum(map(len, lines.values())), len(kept))
        self.assertGreater(len(lines["violated", True]), 90)

    def place(self, axis, design, found):
        left, _, right, name, unit, low, high, end, logarithmic = axis
        low, high = float(low), float(high)
        drawn = [one["drawn"] for one in found["kept_numbers"]]
        if name in drawn:
            value = design["numbers"][drawn.index(name)] / {"mm": 1e-3}.get(unit, 1)
        else:
            subjects = [one["requirement"].split(" ≤")[0] for one in found["cases"][0]["requirements"]]
            value = design["margins"][subjects.index(name.split(" ≤")[0])]
        if value is None:
            return float(right)
        share = math.log(value / low) / math.log(high / low) if logarithmic else (value - low) / (high - low)
        return float(left) + (float(right) - float(left)) * float(end) * share

    def test_axes_have_names_units_and_ends_and_texts_do_not_overlap(self):
        for svg in (self.picture(self.project()), self.picture(self.many(), "--shares")):
            texts = [(float(x), float(y), style, text) for x, y, style, text in TEXT.findall(svg)]
            boxes = []
            for x, y, style, text in texts:
                size = float(re.search(r'font-size="([\d.]+)"', style + ' font-size="11"').group(1))
                width = 0.55 * size * len(text)
                left = x - {"middle": width / 2, "end": width}.get(
                    (re.search(r'text-anchor="(\w+)"', style) or [0, "start"])[1], 0
                )
                boxes.append((left, y - 0.75 * size, left + width, y + 0.2 * size, text))
            for i, a in enumerate(boxes):
                self.assertGreater(a[0], 0, a[4])
                for b in boxes[:i]:
                    apart = a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] or b[3] <= a[1]
                    self.assertTrue(apart, (a[4], b[4]))
            words = [text for *_, text in texts]
            for *_, name, unit, low, high, end, logarithmic in AXIS.findall(svg):
                for number in (low, high):
                    self.assertTrue(any(self.is_rounded(text, float(number)) for text in words), (name, number))
            self.assertIn("Margins: red is the limit 1, more is met", words)

    def is_rounded(self, text, number):
        return re.fullmatch(r"-?[\d.e+-]+", text) and math.isclose(float(text), number, rel_tol=1e-3)

    def many(self):
        """15 numbers that differ from machine to machine."""
        text = shortened(ROBUST.read_text())
        start, end = text.index("[tolerances.rubber]"), text.index("[requirements]")
        paths = ["elements.suspension.scale", "elements.suspension.damping.proportional", "bodies.aggregate.mass"]
        paths += [f"bodies.aggregate.center_of_mass.{axis}" for axis in "xyz"]
        paths += [f"bodies.aggregate.inertia.{axis}" for axis in ("xx", "yy", "zz")]
        paths += [f"excitations.force.{kind}.{axis}" for kind in ("force", "moment") for axis in "xyz"]
        tolerances = f'[tolerances.all]\npath = {json.dumps(paths)}\nhalf_width = "1 %"\n'
        return self.project(text[:start] + tolerances + text[end:])

    def test_of_many_numbers_those_with_the_largest_shares_have_axes(self):
        project = self.many()
        found, svg = self.sample(project, "--shares"), self.picture(project, "--shares")
        largest = {}
        for one in found["shares"]["list"]:
            largest[one["number"]] = max(largest.get(one["number"], 0), one["total"])
        order = sorted(largest, key=lambda number: -largest[number])
        details = [text for _, _, style, text in TEXT.findall(svg) if 'fill="#555"' in style]
        paths = [text for text in details if text.split(".")[0] in ("elements", "bodies", "excitations")]
        self.assertEqual(paths, [number.removeprefix("all at ") for number in order[:8]])
        words = " ".join(text for *_, text in TEXT.findall(svg))
        self.assertRegex(words, r"Left out: 7 drawn numbers with at most [\d.]+ % each: ")
        self.assertIn("in the order of their largest share of the variance of a value", words)
        for number in order[8:]:
            self.assertIn(number.removeprefix("all at "), words)

    def test_the_report_has_the_picture_and_its_script(self):
        out = self.folder / "out"
        self.assertEqual(trivet("run", self.project(), "-o", out).returncode, 0)
        page = (out / "report.html").read_text()
        script = (SOURCE / "web/dist/report_lines.js").read_text()
        self.assertIn('class="design-axis"', page)
        self.assertIn(script, page)
        self.assertIn('class="design-axis"', (out / "00-base/designs.svg").read_text())
        self.assertIn("design,kept_as,extreme,verdict", (out / "00-base/designs.csv").read_text())
        self.assertEqual(trivet("run", self.project(), "-o", out, "--report", "short").returncode, 0)
        self.assertNotIn(script, (out / "report.html").read_text())

    def test_exports_have_the_designs_as_arrays(self):
        tables = self.folder / "tables"
        done = trivet("export", self.project(), "--to", "csv", "--what", "sample", "-o", tables)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual((tables / "designs.csv").read_text().splitlines()[1].split(",")[:4], ["0", "first", "", "met"])


if __name__ == "__main__":
    unittest.main()
