# SPDX-License-Identifier: BSD-3-Clause
"""`trivet modes --shapes-of N`: what follows a slider of several bodies is small, and the same numbers as without it."""
import csv
import io
import unittest

from trivet_test import SOURCE, result_of, trivet

TEN_BODIES = SOURCE / "benchmarks/ten_bodies.toml"
GENSET = SOURCE / "examples/genset/genset.toml"  # on a flexible deck: it has feet
DRAWN = ("shape", "shape_at_center_of_mass", "kinetic_energy_share", "principal_kinetic_energy_share")
DRAWN += ("element_kinetic_energy_share", "strain_energy_share", "screws", "feet")
MOST_BYTES = 62e3


class ShapesOf(unittest.TestCase):
    def test_only_the_wanted_mode_has_a_shape(self):
        for file, number in ((TEN_BODIES, 17), (GENSET, 1)):
            all_modes, one = result_of("modes", file), result_of("modes", file, "--shapes-of", number)
            self.assertEqual(one.keys(), all_modes.keys())
            for full, found in zip(all_modes["modes"], one["modes"], strict=True):
                if full["number"] != number:
                    full |= {key: None for key in DRAWN if key in full}
                self.assertEqual(found, full)

    def test_a_step_of_a_slider_is_small(self):
        self.assertLess(len(trivet("modes", TEN_BODIES, "--shapes-of", 60, "--json").stdout.encode()), MOST_BYTES)

    def test_energies_of_bodies_are_those_of_their_coordinates(self):
        for mode in result_of("modes", TEN_BODIES)["modes"]:
            shares, bodies = mode["kinetic_energy_share"], mode["body_kinetic_energy_share"]
            for i, share in enumerate(bodies):
                self.assertAlmostEqual(share, sum(shares[6 * i : 6 * i + 6]), 12)
            self.assertAlmostEqual(sum(bodies), 1, 12)

    def test_other_forms(self):
        rows = list(csv.DictReader(io.StringIO(trivet("modes", TEN_BODIES, "--shapes-of", 2, "--csv").stdout)))
        shapes = [[value for key, value in row.items() if key.startswith("shape ")] for row in rows]
        self.assertEqual([any(shape) for shape in shapes], [row["mode"] == "2" for row in rows])
        self.assertEqual(trivet("modes", GENSET, "--shapes-of", 2).stdout, trivet("modes", GENSET).stdout)
        done = trivet("modes", GENSET, "--shapes-of", 100)
        self.assertEqual(done.returncode, 2)
        self.assertIn("--shapes-of 100: the machine has ", done.stderr)


if __name__ == "__main__":
    unittest.main()
