# SPDX-License-Identifier: BSD-3-Clause
"""Tables that fit the screen, summaries, marked lines of the project file, and the front door of the command line."""
import os

from trivet_test import PRINTED, SOURCE, InTemporaryFolder, trivet

GENSET = SOURCE / "examples/genset/genset.toml"


class Terminal(InTemporaryFolder):
    def test_a_summary_and_all_rows(self):
        short, full = trivet("peaks", GENSET).stdout, trivet("peaks", GENSET, "--full").stdout
        self.assertIn("… 20 more rows, these are the 20 highest: --full", short)
        self.assertEqual(len(full.splitlines()) - len(short.splitlines()), 20 - 1)

    def test_lines_fit_the_width(self):
        done = trivet("response", GENSET, env={**os.environ, "COLUMNS": "60"}).stdout
        table = done.split("\n  …")[0].splitlines()
        self.assertLessEqual(max(map(len, table)), 60)
        self.assertIn("for which the screen is too narrow: --full", done)

    def test_warnings_are_on_standard_error(self):
        done = trivet("modes", PRINTED)
        self.assertNotIn("warning", done.stdout)
        self.assertIn("warning", done.stderr)

    def test_the_wrong_value_is_marked(self):
        wrong = self.file('trivet = 1\n[bodies.a]\nfree = ["z"]\nmass = "3 mm" # text\n')
        self.assertIn('  4 | mass = "3 mm" # text\n    |        ^^^^^^\n', trivet("check", wrong).stderr)

    def test_new_never_replaces(self):
        path = self.folder / "machine.toml"
        self.assertEqual(trivet("new", path).returncode, 0)
        path.write_text("mine")
        self.assertEqual(trivet("new", path).returncode, 2)
        self.assertEqual(path.read_text(), "mine")

    def test_standard_input_and_folders(self):
        piped = trivet("modes", "-", "--json", input=trivet("new").stdout)
        self.assertEqual(piped.returncode, 0, piped.stderr)
        self.assertIn("genset.toml", trivet("modes", GENSET.parent).stderr)
