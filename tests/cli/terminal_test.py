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

    def test_standard_input_is_as_strict_as_a_file(self):
        """An error in requirements stops a verdict, not the modes."""
        wrong = trivet("new").stdout + '[requirements]\nlimits = {"nobody.z" = "1 mm"}\n'
        for path, given in ((self.file(wrong), ""), ("-", wrong)):
            self.assertEqual(trivet("modes", path, input=given).returncode, 0)
            self.assertEqual(trivet("verdict", path, input=given).returncode, 2)

    def test_a_value_is_marked_only_if_its_key_is_in_the_line_once(self):
        bodies = 'trivet = 1\nbodies = {a = {mass = 10, free = ["z"]}, b = {mass = -3, free = ["z"]}}\n'
        message = trivet("check", self.file(bodies)).stderr
        self.assertIn("bodies.b.mass", message)
        marked = message.partition("bodies.b.mass")[2].splitlines()[2]
        self.assertEqual(marked, "    | " + "^" * len(bodies.splitlines()[1]))
