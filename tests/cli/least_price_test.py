# SPDX-License-Identifier: BSD-3-Clause
"""The cheapest mounts with which every requirement is met, against the optimum of the numbers for every combination."""
import unittest

from select_test import CATALOGUE, MACHINE, PRICES, REQUIREMENTS, with_mounts
from trivet_test import InTemporaryFolder, result_of, trivet

DIGITS = 9
PLACE = '[parameters."place ahead"]\npath = "elements.front.at.x"\nfrom = 0.5\nto = 1.1\n'
WITHOUT_PRICE = REQUIREMENTS.replace('price = "60 EUR"\n', "")
NUMBERS = MACHINE[: MACHINE.index("[parameters.ahead]")] + PLACE + WITHOUT_PRICE + "[analyses.optimize]\nstarts = 2\n"
TRIED = ("medium", "firm")
CHOICES = "choices = [" + ", ".join(f'"catalogue:{name}"' for name in TRIED) + "]"
REQUESTED = '[analyses.optimize]\nstarts = 2\nminimize = "price"\n'


class LeastPrice(InTemporaryFolder):
    def setUp(self):
        super().setUp()
        self.file(CATALOGUE, "maker.toml")

    def test_cheapest_of_four_combinations(self):
        numbers = self.file(NUMBERS)
        each = {}
        for mounts in [(ahead, behind) for ahead in TRIED for behind in TRIED]:
            each[mounts] = result_of("optimize", numbers, *with_mounts(*mounts))
        price = {mounts: sum(PRICES[mount] for mount in mounts) for mounts in each}
        best = min((m for m in each if each[m]["feasible"]), key=lambda m: (price[m], -each[m]["after"]))
        self.assertGreater(price[best], min(price.values()))  # the cheapest of all do not meet the requirements
        text = MACHINE.replace('catalogue = "maker.toml"\n[parameters.behind]', CHOICES + "\n[parameters.behind]")
        text = text.replace('elements.rear.type"\ncatalogue = "maker.toml"\n', f'elements.rear.type"\n{CHOICES}\n')
        self.assertEqual(text.count(CHOICES), 2)
        project = self.file(text + PLACE + WITHOUT_PRICE + REQUESTED)
        found = result_of("optimize", project)
        self.assertEqual(found["mounts"]["chosen"], {"ahead": best[0], "behind": best[1]})
        self.assertAlmostEqual(found["mounts"]["price"], price[best], DIGITS)
        self.assertAlmostEqual(found["mounts"]["price_before"], 2 * PRICES["soft"], DIGITS)
        self.assertEqual((found["objective"], found["mounts"]["currency"]), ("price", "EUR"))
        self.assertEqual((found["mounts"]["some_met"], found["mounts"]["optimized"]), (True, 4))
        self.assertAlmostEqual(found["after"] / each[best]["after"], 1, 6)
        said = trivet("optimize", project).stdout
        self.assertTrue(said.startswith("Cheapest mounts found, and with these the largest least margin"))
        self.assertIn(f"Price of all mounts: 40 EUR → {price[best]:.6g} EUR. The numbers of 4 of 4", said)

    def test_all_of_one_price_are_compared_and_dearer_ones_are_left(self):
        equal = CATALOGUE
        for name in PRICES:
            equal = equal.replace(f'price = "{PRICES[name]} EUR"', 'price = "10 EUR"')
        two = equal[equal.index("[mounts.soft]") : equal.index("[mounts.firm]")].replace("[mounts.", "[mounts.other_")
        text = MACHINE + PLACE + WITHOUT_PRICE
        self.file(equal + two, "maker.toml")
        found = result_of("optimize", self.file(text + REQUESTED))
        self.assertEqual((found["mounts"]["combinations"], found["mounts"]["optimized"]), (36, 36))
        margin = result_of("optimize", self.file(text + REQUESTED.replace('minimize = "price"\n', "")))
        self.assertAlmostEqual(found["after"] / margin["after"], 1, DIGITS)
        self.file(equal + two.replace('"10 EUR"', '"20 EUR"'), "maker.toml")
        found = result_of("optimize", self.file(text + REQUESTED))
        self.assertEqual(found["mounts"]["optimized"], 32)  # 16 of 20 EUR and 16 of 30 EUR, but none of 40 EUR
        self.assertEqual(found["mounts"]["price"], 20)

    def test_none_meets_every_requirement(self):
        text = MACHINE + PLACE + WITHOUT_PRICE.replace("0.6 mm", "1 um") + REQUESTED
        found = result_of("optimize", self.file(text + "combinations = 3\n"))
        self.assertEqual((found["feasible"], found["mounts"]["some_met"]), (False, False))
        said = trivet("optimize", self.file(text + "combinations = 3\n")).stdout
        self.assertIn("No mounts that were tried meet every requirement. Largest least margin instead", said)
        self.assertIn("3 of 16 combinations were optimised, the cheapest first; dearer ones were not tried", said)

    def test_mounts_without_a_price_or_in_another_currency(self):
        project = self.file(MACHINE + PLACE + WITHOUT_PRICE + REQUESTED)
        without = CATALOGUE.replace('price = "30.0 EUR"', 'price = "33 USD"').replace('price = "41.0 EUR"\n', "")
        self.file(without, "maker.toml")
        refused = trivet("optimize", project)
        self.assertEqual(refused.returncode, 2)
        self.assertIn('minimize = "price": no price in EUR of "firm", "hard"', refused.stderr)


if __name__ == "__main__":
    unittest.main()
