# SPDX-License-Identifier: BSD-3-Clause
"""The best design and the front as parts of `trivet run`: results.json, report and pictures."""
import html
import json
import re
import unittest

from front_test import BAND, TWO
from trivet_test import InTemporaryFolder, result_of, trivet


MOVED_SPRING = """
trivet = 1
[bodies.plate]
mass = 20
inertia = {about = "center_of_mass", xx = 1, yy = 2, zz = 3}
center_of_mass = [0.05, 0, 0.1]
free = ["z", "ry"]
[element_types.spring]
type = "bushing"
translation = [9e4, 9e4, 9e4]
damping = {loss_factor = 0.1}
[elements]
left = {type = "spring", on = "plate", at = [-0.3, 0, 0]}
right = {type = "spring", on = "plate", at = [0.3, 0, 0]}
[excitations.force]
type = "harmonic"
on = "plate"
at = [0, 0, 0]
force = [0, 0, 1]
[parameters.place]
path = "elements.right.at.x"
from = "0.1 m"
to = "0.6 m"
[requirements]
limits = {"plate.ry" = 1e-4}
[analyses]
response = {band = ["1 Hz", "40 Hz"]}
optimize = {minimize = "plate.ry", starts = 2}
"""


class ReportOptimum(InTemporaryFolder):
    def run_of(self, text):
        project = self.file(text)
        done = trivet("run", project, "-o", self.folder / "out", "--full")
        self.assertEqual(done.returncode, 0, done.stderr)
        results = json.loads((self.folder / "out/results.json").read_text())
        cases = results["cases"] if "cases" in results else [results]
        return (
            project,
            cases,
            (self.folder / "out/report.html").read_text(),
            done.stdout,
        )

    def assert_is_result(self, case, project):
        found = result_of("optimize", project)
        self.assertTrue(found["warnings"])
        for warning in found.pop("warnings"):
            self.assertIn(warning, case["warnings"])
        self.assertEqual(case["optimize"], found)

    def test_best_design(self):
        text = TWO.replace('front = ["a.z", "b.z"]', 'minimize = "a.z"\nstarts = 2')
        text += BAND + '[requirements]\nlimits = {"b.z" = 3e-5}\n[cases.heavy]\nbodies.a.mass = 3\n'
        project, cases, page, screen = self.run_of(text)
        self.assert_is_result(cases[0], project)
        self.assertNotIn("optimize", cases[1])
        for words in (
            "Best design",
            "b.z ≤ ",
            "Requirement that limits the optimum",
            "gain if its bound is 1 % looser",
        ):
            self.assertIn(words.lower(), page.lower())
        self.assertIn("requirement that limits the optimum", screen)
        self.assert_page_has_words_of(screen, page)

    def test_a_design_with_other_places_is_drawn_over_the_given_one(self):
        _, _, page, _ = self.run_of(MOVED_SPRING)
        self.assertRegex(page, "(?s)>Best design</h2>.*<svg.*>given design</text>.*</section>")
        drawing = (self.folder / "out/00-base/best_design.svg").read_text()
        self.assertIn("#b5b5b5", drawing)  # the given spring, in grey
        self.assertIn(">given design</text>", drawing)

    def test_a_design_with_other_stiffnesses_alone_has_no_drawing(self):
        text = MOVED_SPRING.replace("elements.right.at.x", "elements.right.scale").replace('"0.1 m"', "0.5")
        _, _, page, _ = self.run_of(text.replace('"0.6 m"', "2"))
        self.assertIn(">Best design</h2>", page)
        self.assertNotIn("given design", page)
        self.assertFalse((self.folder / "out/00-base/best_design.svg").exists())

    def test_the_short_report_has_the_parameters_and_the_drawing_of_the_optimum(self):
        done = trivet("run", self.file(MOVED_SPRING), "-o", self.folder / "out", "--report", "short")
        self.assertEqual(done.returncode, 0, done.stderr)
        page = (self.folder / "out/report.html").read_text()
        self.assertRegex(page, "(?s)>Best design</h2>.*<svg.*>given design</text>.*</section>")
        best = json.loads((self.folder / "out/results.json").read_text())["cases"][0]["optimize"]["parameters"][0]
        shown = [float(number) for number in re.findall(r"<td[^>]*>([\d.]+)", page[page.index(">Best design</h2>") :])]
        self.assertTrue(any(abs(number - best["optimum"]) < 1e-3 * best["optimum"] for number in shown), best)

    def assert_page_has_words_of(self, screen, page):
        """Every number of the result on the screen is in its section of the page, perhaps with an SI prefix."""
        text = screen[re.search(r"^\S.* → .*\n  minimised", screen, re.M).start() :]
        text = text[: text.index("it proves no global optimum.") + 28]
        section = re.search(r">Best design</h2>(.*?)</section>", page, re.S).group(1)
        shown = html.unescape(re.sub(r"<[^>]+>", " ", section))
        numbers = [float(n) for n in re.findall(r"-?\d+\.?\d*(?:e[-+]?\d+)?", shown)]
        for line in text.splitlines():
            for number in re.findall(r"(?<![\w.-])-?\d+\.?\d*(?:e[-+]?\d+)?", line):
                value, three_digits = float(number), 5e-3
                same = [abs(n * p - value) <= three_digits * abs(value) for n in numbers for p in (1, 1e3, 1e6, 1e-3)]
                self.assertTrue(any(same), (line, number, shown))
        for word in (
            "natural frequency",
            "given",
            "optimum",
            "starts reached",
            "designs computed",
        ):
            self.assertIn(word, shown)

    def test_front(self):
        project, cases, page, screen = self.run_of(TWO + "points = 5\n" + BAND)
        self.assert_is_result(cases[0], project)
        self.assertTrue("Less of one result is more of another" in page)
        self.assertTrue(list((self.folder / "out").glob("*/*front*.svg")))
        self.assertIn("Knee: point", screen)

    def test_search_that_is_not_possible_is_reported(self):
        done = trivet(
            "run",
            self.file(TWO + BAND + '[requirements]\nlimits = {"b.z" = 1e-9}\n'),
            "-o",
            self.folder / "out",
        )
        self.assertEqual(done.returncode, 1)
        self.assertIn(
            "NOT COMPUTED: optimize: no design looked at meets every requirement",
            done.stdout,
        )


if __name__ == "__main__":
    unittest.main()
