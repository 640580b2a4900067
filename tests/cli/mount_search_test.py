# SPDX-License-Identifier: BSD-3-Clause
"""`trivet optimize` over numbers and mounts against the optimum of the numbers for every combination of mounts."""
import itertools
import math
import unittest

from select_test import CATALOGUE, MACHINE, NAMES, REQUIREMENTS, with_mounts
from trivet_test import InTemporaryFolder, result_of, trivet

DIGITS = 9


class MountSearch(InTemporaryFolder):
    PLACE = """[parameters."place ahead"]
path = "elements.front.at.x"
from = 0.5
to = 1.1
"""
    SEARCH = "[analyses.optimize]\nstarts = 2\n"

    def setUp(self):
        super().setUp()
        self.file(CATALOGUE, "maker.toml")

    def optimum_of_each(self, numbers_only):
        project = self.file(numbers_only)
        found = {}
        for ahead, behind in itertools.product(NAMES, NAMES):
            found[ahead, behind] = result_of("optimize", project, *with_mounts(ahead, behind))
        return found

    def test_margin(self):
        text = MACHINE + self.PLACE + REQUIREMENTS + self.SEARCH
        numbers_only = text.replace(
            text[text.index("[parameters.ahead]") : text.index('[parameters."place')],
            "",
        )
        found = result_of("optimize", self.file(text))
        each = self.optimum_of_each(numbers_only)
        best = max(each, key=lambda mounts: each[mounts]["after"])
        self.assertEqual(found["mounts"]["chosen"], {"ahead": best[0], "behind": best[1]})
        self.assertAlmostEqual(found["after"] / each[best]["after"], 1, 6)
        self.assertEqual(found["mounts"]["combinations"], 16)
        self.assertAlmostEqual(found["before"] / each["soft", "soft"]["before"], 1, DIGITS)
        # The place that gives both mounts their share of the load lies elsewhere for other mounts.
        self.assertNotAlmostEqual(found["parameters"][0]["optimum"], 0.8, 3)

    def test_words_of_load_ranges_name_those_of_both_mounts(self):
        text = MACHINE + self.PLACE + REQUIREMENTS + self.SEARCH
        found = result_of("optimize", self.file(text))["cases"][0]
        carried = [
            tuple(
                next(r["requirement"] for r in found[side]["requirements"] if "front carries" in r["requirement"])
                for side in ("after", "before")
            )
        ][0]
        self.assertNotEqual(*carried)
        self.assertIn(f"{carried[0]} (given: {carried[1]})", trivet("optimize", self.file(text)).stdout)

    def test_smallest_force(self):
        text = MACHINE + self.PLACE + REQUIREMENTS.replace('"60 EUR"', '"75 EUR"')
        text = text.replace('limits = {"m.z" = "0.6 mm"}', 'limits = {"m.z" = "2 mm"}').replace(
            '["7.5 Hz", "8.5 Hz"]', '["0.1 Hz", "0.2 Hz"]'
        )
        text += '[analyses.optimize]\nstarts = 2\nminimize = ["ground.force.z"]\n'
        numbers_only = text.replace(
            text[text.index("[parameters.ahead]") : text.index('[parameters."place')],
            "",
        )
        found = result_of("optimize", self.file(text))
        each = {mounts: one for mounts, one in self.optimum_of_each(numbers_only).items() if one["feasible"]}
        self.assertGreater(len(each), 1)
        best = min(each, key=lambda mounts: each[mounts]["after"])
        self.assertEqual(found["mounts"]["chosen"], {"ahead": best[0], "behind": best[1]})
        self.assertAlmostEqual(found["after"] / each[best]["after"], 1, 5)

    def test_settings_give_the_margin(self):
        project = self.file(MACHINE + self.PLACE + REQUIREMENTS + self.SEARCH)
        text = trivet("optimize", project)
        self.assertEqual(text.returncode, 0, text.stderr)
        self.assertIn("Best found of 16 combinations of mounts", text.stdout)
        lines = [line.strip() for line in text.stdout.splitlines() if line.startswith("--set '")]
        settings = [word for line in lines for word in ("--set", line[len("--set '") : -1])]
        judged = result_of("verdict", project, *settings)
        margin = min(r["margin"] for r in judged["cases"][0]["requirements"])
        self.assertAlmostEqual(result_of("optimize", project)["after"] / margin, 1, 8)

    def test_written_file_has_the_margin(self):
        project = self.file(MACHINE + self.PLACE + REQUIREMENTS + self.SEARCH)
        written = self.folder / "best.toml"
        found = result_of("optimize", project, "--write", written)
        judged = result_of("verdict", written)
        margin = min(r["margin"] for r in judged["cases"][0]["requirements"])
        self.assertAlmostEqual(found["after"] / margin, 1, 8)
        self.assertIn(
            'type = "catalogue:' + found["mounts"]["chosen"]["behind"],
            written.read_text(),
        )

    def test_one_choice_of_two_may_take_part(self):
        text = MACHINE + self.PLACE + REQUIREMENTS
        text += '[analyses.optimize]\nstarts = 2\nparameters = ["place ahead", "behind"]\n'
        found = result_of("optimize", self.file(text))
        self.assertEqual(found["mounts"]["combinations"], 4)
        self.assertEqual(list(found["mounts"]["chosen"]), ["behind"])

    def test_few_of_many_equal_before_the_search_are_not_the_first_of_the_catalogue(
        self,
    ):
        # Amplitudes have no quick bound. The first four of 16 all have the softest mount behind.
        text = MACHINE + self.PLACE + '[requirements]\nband = ["0.1 Hz", "2 Hz"]\nlimits = {"m.z" = "1 mm"}\n'
        found = result_of(
            "optimize",
            self.file(text + "[analyses.optimize]\nstarts = 1\ncombinations = 1\n"),
        )
        self.assertEqual((found["mounts"]["considered"], found["mounts"]["optimized"]), (4, 1))
        self.assertNotEqual(found["mounts"]["chosen"]["behind"], "soft")

    def test_mounts_that_hold_nothing_with_the_given_numbers(self):
        # Four feet under a machine whose centre of mass is ahead of the front ones: the rear ones lift off. By levers
        # each front foot bears 0.65/(x + 0.4) of half the weight, each rear one the rest; the range ends at 0.6 m.
        weight, end = 120 * 9.81, 0.6
        front, rear = weight / 2 * 0.65 / (end + 0.4), weight / 2 * (end - 0.25) / (end + 0.4)
        range_of = {"A": (10, 900), "B": (10, 1200), "C": (-300, 400)}
        margin = {}
        for name, (least, most) in range_of.items():
            margin[name] = min(min(most / n, n / least if least > 0 else math.inf) for n in (front, rear))
        self.file(
            "catalogue = 1\n"
            + "".join(
                f"""[mounts.{name}]
price = "{price} EUR"
maker = "none"
translation = [2e5, 2e5, {stiffness}]
static_load = ["{range_of[name][0]} N", "{range_of[name][1]} N"]
"""
                for name, price, stiffness in (
                    ("A", 4, 3e5),
                    ("B", 10, 5e5),
                    ("C", 10, 5e5),
                )
            ),
            "feet.toml",
        )
        text = """trivet = 1
gravity = [0, 0, -9.81]
[bodies.m]
mass = 120
center_of_mass = [0.25, 0, 0.2]
inertia = {about = "center_of_mass", xx = 6, yy = 9, zz = 10}
[element_types.foot]
type = "catalogue:A"
catalogue = "feet.toml"
[tables.elements]
rows = [
  {name = "rear left", type = "foot", on = "m", at = [-0.4, 0.25, 0], axis = "z"},
  {name = "rear right", type = "foot", on = "m", at = [-0.4, -0.25, 0], axis = "z"},
  {name = "front left", type = "foot", on = "m", at = [0.2, 0.25, 0], axis = "z"},
  {name = "front right", type = "foot", on = "m", at = [0.2, -0.25, 0], axis = "z"},
]
[parameters.mount]
path = "element_types.foot.type"
catalogue = "feet.toml"
[parameters.front]
path = ['elements."front left".at.x', 'elements."front right".at.x']
from = 0.2
to = 0.6
[requirements]
mount_load = "catalogue"
[analyses.optimize]
starts = 2
"""
        few = text.replace(
            'path = "element_types.foot.type"\ncatalogue = "feet.toml"',
            'path = "element_types.foot.type"\nchoices = ["catalogue:A", "catalogue:B"]',
        )
        for problem, best in (
            (text, "B"),
            (text + 'minimize = "price"\n', "A"),
            (
                text + "combinations = 1\n",
                "B",
            ),  # of three the one with the best bound at other numbers
            (few, "B"),  # nothing holds with the given numbers
        ):
            found = result_of("optimize", self.file(problem))
            self.assertEqual(found["mounts"]["chosen"], {"mount": best}, problem[-60:])
            self.assertAlmostEqual(found["after"] / margin[best], 1, 6)
            self.assertAlmostEqual(found["parameters"][0]["optimum"], end, 6)
        refused = trivet("optimize", self.file(few.replace("to = 0.6", "to = 0.24")))
        self.assertEqual(refused.returncode, 1)
        for words in (
            "with mount = ",
            'the margin of "',
            "rear",
            "is 0 with all numbers that were tried",
        ):
            self.assertIn(words, refused.stderr)

    def test_mounts_alone_are_selected(self):
        result = trivet("optimize", self.file(MACHINE + REQUIREMENTS))
        self.assertEqual(result.returncode, 2)
        self.assertIn("trivet select judges every combination", result.stderr)


if __name__ == "__main__":
    unittest.main()
