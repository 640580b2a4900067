# SPDX-License-Identifier: BSD-3-Clause
"""Pages of a report that a browser prints, as A4 and Letter."""
import collections
import html.parser
import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

from trivet_test import HANGS_AFTER

TRIVET = os.environ["TRIVET"]
SOURCE = pathlib.Path(os.environ.get("TRIVET_SOURCE", pathlib.Path(__file__).parents[2]))
BROWSERS = ("chromium", "chromium-headless-shell", "google-chrome")
BROWSER = os.environ.get("TRIVET_BROWSER") or next(filter(None, map(shutil.which, BROWSERS)), None)

MM = 72 / 25.4  # points
SIDE, TOP, BOTTOM = 12 * MM, 14 * MM, 13 * MM  # margins in page.css
ROUNDING = 1.5  # points; a browser rounds the size of the paper to pixels
SIZES = {"A4": (210 * MM, 297 * MM), "Letter": (8.5 * 72, 11 * 72)}
LEAST_HEIGHT = 5.5  # of the box around a number in a table [points]
ONE_MASS = """
trivet = 1
title = 'TITLE'
[bodies.mass]
mass = 4
free = ["z"]
[elements.spring]
type = "bushing"
on = "mass"
at = [0, 0, 0]
translation = [900, 900, 900]
[analyses]
modes = {}
"""


def tokens(text):
    """Parts of a text that a line break does not divide."""
    return set(re.findall(r"\w+(?:\.\w+)*", text))


class Report(html.parser.HTMLParser):
    """What a page has: its tables as lists of rows, its headings, its cases, and the data of its charts."""

    def __init__(self, text):
        super().__init__()
        self.tables, self.headings, self.figures, self.cases, self.data = [], [], [], [], {}
        self.inside, self.script, self.elsewhere = collections.Counter(), None, False
        self.feed(re.sub('<div class="narrow">.*?</div>', "", text, flags=re.DOTALL))  # for narrow screens

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.inside[tag] += 1
        if tag == "script":
            self.script = attributes.get("id") if attributes.get("type") == "application/json" else None
        if tag == "div":  # what the input file has is printed there; long tables have no grey rows
            classes = attributes.get("class", "").split()
            self.elsewhere |= "data-in-file" in attributes
            self.tall = "tall" in classes
        if tag == "table":
            self.tables.append([])
        if tag == "tr":
            self.printed = not self.elsewhere and not (self.tall and attributes.get("class") == "minor")
            if self.printed:
                self.tables[-1].append("")
        if tag == "option" and not self.inside["form"] == 0:
            self.cases.append("")
        if tag in ("h2", "h3", "summary"):
            self.headings.append("")
        if tag == "svg":
            self.figures.append([])

    def handle_endtag(self, tag):
        self.inside[tag] -= 1
        if tag == "table":
            self.elsewhere = False

    def handle_data(self, data):
        if self.inside["script"]:
            if self.script:
                self.data[self.script] = json.loads(data)
        elif self.inside["svg"]:
            if self.inside["text"]:
                self.figures[-1].append(data)
        elif self.inside["table"] and self.inside["tr"]:
            if self.printed:
                self.tables[-1][-1] += data + " "
        elif self.inside["option"]:
            self.cases[-1] += data
        elif self.inside["h2"] or self.inside["h3"] or self.inside["summary"]:
            self.headings[-1] += data

    def axes(self):
        """Number of axes of amplitudes and of phases: one of each for each row of curves, one for each curve compared,
        and those of the figures."""
        cases = self.data["results"]["cases"]
        rows = [row for case in self.data["drawing"]["groups"] for group in case for row in group["rows"] if row]
        names = set()
        for case in cases:
            if case.get("response"):
                vanishing = {curve["name"] for curve in case.get("vanishing") or []}
                names |= {curve["name"] for curve in case["response"]["results"]} - vanishing
        compared = len(names) if len(cases) > 1 else 0
        return len(rows) + compared + self.drawn("amplitude ["), len(rows) + self.drawn("phase [°]")

    def drawn(self, label):
        return sum(label in text for figure in self.figures for text in figure)


Word = collections.namedtuple("Word", "left top right bottom text")


class Paper:
    """The pages of a PDF: the words of each."""

    def __init__(self, path):
        boxes = subprocess.run(["pdftotext", "-bbox", path, "-"], check=True, capture_output=True, text=True).stdout
        self.pages, self.sizes = [], []
        for page in boxes.split("<page ")[1:]:
            self.sizes.append(tuple(map(float, re.match('width="([0-9.]+)" height="([0-9.]+)"', page).groups())))
            box = '<word xMin="(.*?)" yMin="(.*?)" xMax="(.*?)" yMax="(.*?)">(.*?)</word>'
            self.pages.append(
                [
                    Word(*map(float, found[:4]), html.unescape(found[4]).replace("\u00ad", "-"))
                    for found in re.findall(box, page)
                ]
            )

    def body(self, page):
        """Words between the margins of a page."""
        bottom = self.sizes[page][1] - BOTTOM
        return [word for word in self.pages[page] if word.bottom > TOP and word.top < bottom]

    def margin(self, page, above):
        """Text above or below the body of a page."""
        bottom = self.sizes[page][1] - BOTTOM
        words = [word for word in self.pages[page] if (word.bottom <= TOP if above else word.top >= bottom)]
        return " ".join(word.text for word in sorted(words))  # from left to right

    def last_line(self, page):
        body = self.body(page)
        lowest = max(word.bottom for word in body)
        return " ".join(word.text for word in body if word.bottom > lowest - 2)

    def text(self, page):
        return " ".join(word.text for word in self.pages[page])


class PrintedReport(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if not BROWSER:
            raise AssertionError("no browser: install the Debian package chromium (scripts/packages tests)")
        if not shutil.which("pdftotext"):
            raise AssertionError("no pdftotext: install the Debian package poppler-utils (scripts/packages tests)")
        cls.folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))

    def report(self, project):
        """Path of the report of a project, computed once."""
        out = self.folder / project.stem
        if not out.exists():
            command = [TRIVET, "run", str(project), "-o", str(out)]
            subprocess.run(command, check=True, capture_output=True, timeout=HANGS_AFTER)
        return out / "report.html"

    def printed(self, report, size):
        """PDF of a report on a size of paper, as chosen in a browser, printed once."""
        page, pdf = report.with_name(f"{size}.html"), report.with_name(f"{size}.pdf")
        if pdf.exists():
            return Paper(pdf)
        chosen = f"<style>@page {{ size: {size}; }}</style></head>"
        page.write_text(report.read_text().replace("</head>", chosen, 1))
        arguments = [
            BROWSER,
            "--headless",
            "--no-sandbox",
            "--disable-gpu",
            "--disable-background-networking",
            "--enable-logging=stderr",
            f"--user-data-dir={self.folder}/profile",
            f"--print-to-pdf={pdf}",
            page.as_uri(),
        ]
        done = subprocess.run(arguments, check=True, capture_output=True, text=True, timeout=HANGS_AFTER)
        self.assertEqual(re.findall("CONSOLE.*", done.stderr), [])
        return Paper(pdf)

    def check_pages(self, paper, size, title, source):
        for number, (width, height) in enumerate(paper.sizes, 1):
            self.assertLess(abs(width - SIZES[size][0]) + abs(height - SIZES[size][1]), 2 * ROUNDING)
            page = number - 1
            self.assertEqual(paper.margin(page, above=True), f"{title} {source}", number)
            self.assertEqual(paper.margin(page, above=False), f"page {number} of {len(paper.pages)}", number)
            for word in paper.pages[page]:
                self.assertGreater(word.left, SIDE - ROUNDING, (number, word))
                self.assertLess(word.right, width - SIDE + ROUNDING, (number, word))
            for word in paper.body(page):
                self.assertGreater(word.top, TOP - ROUNDING, (number, word))
                self.assertLess(word.bottom, height - BOTTOM + ROUNDING, (number, word))
            if number < len(paper.pages):  # the last one may have the signatures only
                self.assertGreater(len(paper.body(page)), 15, f"page {number} is nearly empty")

    def check_content(self, paper, report):
        everything = " ".join(map(paper.text, range(len(paper.pages))))
        labels = [len(re.findall(label, everything)) for label in (r"amplitude \[", r"phase \[°\]")]
        self.assertEqual(tuple(labels), report.axes())
        for name in report.cases if len(report.cases) > 1 else []:
            self.assertIn(f"Case: {name} ", everything)
        headings = {" ".join(heading.split()) for heading in report.headings}
        for heading in headings - {"Comparison of cases", "Amplitude and phase characteristics"}:
            self.assertIn(heading, everything)
        for page in range(len(paper.pages)):
            self.assertNotIn(paper.last_line(page), headings, f"page {page + 1} ends with a heading")
        for control in ("Whole band", "log amplitude", "Move over a chart", "Interactive", "Zoom and axes"):
            self.assertNotIn(control, everything)
        for figure in report.figures:
            self.assertTrue(any(tokens(" ".join(figure)) <= tokens(paper.text(p)) for p in range(len(paper.pages))))

    def check_signatures(self, paper):
        last = paper.text(len(paper.pages) - 1)
        self.assertRegex(last, "Signatures name date signature Prepared Checked Approved")

    def check_rows(self, paper, report):
        """Every row is on one page, below the headings of its table."""
        pages = [tokens(paper.text(page)) for page in range(len(paper.pages))]
        for heads, *rows in filter(None, report.tables):
            for row in rows:
                self.assertTrue(any(tokens(heads + row) <= page for page in pages), heads + row)

    def check(self, example, title):
        project = SOURCE / "examples" / example
        path = self.report(project)
        report = Report(path.read_text())
        for size in SIZES:
            with self.subTest(size):
                paper = self.printed(path, size)
                self.check_pages(paper, size, title, project.name)
                self.check_content(paper, report)
                self.check_signatures(paper)
                self.check_rows(paper, report)

    def test_a_machine_with_many_curves_and_tall_figures(self):
        self.check("genset/genset.toml", "Generating set on six mounts on a ship's deck")

    def test_a_report_in_full_of_a_machine_with_many_results_has_at_most_eight_pages(self):
        report = self.report(SOURCE / "examples/genset/genset.toml")
        self.assertLessEqual(len(self.printed(report, "A4").pages), 8)
        self.assertLessEqual(len(self.printed(report, "Letter").pages), 9)

    def test_what_is_the_same_in_several_cases_is_printed_once(self):
        report = self.report(SOURCE / "examples/paper/corrected.toml")
        paper = self.printed(report, "A4")
        everything = " ".join(map(paper.text, range(len(paper.pages))))
        self.assertIn("Excitations: as in the case Base model.", everything)
        self.assertEqual(everything.count("free coordinates"), 1)

    def test_all_cases_with_their_curves(self):
        self.check("paper/corrected.toml", "Aggregate on three rubber-metal elements, corrected inertia")

    def test_a_map_with_long_texts_in_its_table(self):
        self.check("paper/map.toml", "Aggregate on three rubber-metal elements, map of stiffness and damping")

    def test_a_table_that_is_much_wider_than_the_paper_is_divided(self):
        project = SOURCE / "examples/frame/frame.toml"
        path = self.report(project)
        report = Report(path.read_text())
        for size in SIZES:
            with self.subTest(size):
                paper = self.printed(path, size)
                self.check_pages(paper, size, "Pump on a frame of beams", project.name)
                self.check_content(paper, report)
                self.check_signatures(paper)
                heights = [
                    word.bottom - word.top
                    for page in paper.pages
                    for word in page
                    if re.fullmatch(r"-?\d\.\d+e-\d\d", word.text)
                ]
                self.assertGreater(len(heights), 100)
                self.assertGreater(min(heights), LEAST_HEIGHT)

    def test_the_short_form_of_a_machine_with_many_results_is_at_most_four_pages(self):
        project, out = SOURCE / "examples/genset/genset.toml", self.folder / "short"
        command = [TRIVET, "run", str(project), "-o", str(out), "--report", "short"]
        subprocess.run(command, check=True, capture_output=True, timeout=HANGS_AFTER)
        for size in SIZES:
            with self.subTest(size):
                paper = self.printed(out / "report.html", size)
                self.check_pages(paper, size, "Generating set on six mounts on a ship's deck", project.name)
                self.check_signatures(paper)
                self.assertLessEqual(len(paper.pages), 4)
                everything = " ".join(map(paper.text, range(len(paper.pages))))
                for words in ("VIOLATED", "6 × front left", "Undamped modes", "displacement ["):
                    self.assertIn(words, everything)

    def test_no_page_is_shrunk_because_something_is_wider(self):
        """The title of a machine with several matrices of 12×12 is as high as that of one mass."""
        (self.folder / "plain.toml").write_text(ONE_MASS.replace("TITLE", "Bogie"))
        projects = (self.folder / "plain.toml", SOURCE / "examples/track/bogie.toml")
        titles = []
        for project in projects:
            words = self.printed(self.report(project), "A4").body(0)
            titles.append(max(word.bottom - word.top for word in words if word.text == "Bogie"))
        self.assertAlmostEqual(titles[1] / titles[0], 1, delta=0.02)

    def test_special_characters_of_a_title_are_printed(self):
        title = 'A "quoted" \\ <b>title</b>; } körper'
        project = self.folder / "special.toml"
        project.write_text(ONE_MASS.replace("TITLE", title))
        self.check_pages(self.printed(self.report(project), "A4"), "A4", title, "special.toml")

    def test_a_long_title_does_not_leave_the_paper(self):
        project = self.folder / "long.toml"
        project.write_text(ONE_MASS.replace("TITLE", "vibration of a machine " * 12))
        paper = self.printed(self.report(project), "Letter")
        for word in paper.pages[0]:
            self.assertGreater(min(word.left, word.top), 0, word)
            self.assertLess(word.right, SIZES["Letter"][0] - SIDE + ROUNDING, word)
        self.assertIn("long.toml", paper.margin(0, above=True))


if __name__ == "__main__":
    unittest.main()
