# SPDX-License-Identifier: BSD-3-Clause
"""Tables that fit the screen, summaries, marked lines of the project file, and the front door of the command line."""
import fcntl
import os
import pty
import struct
import subprocess
import termios

from trivet_test import PRINTED, SOURCE, TRIVET, InTemporaryFolder, trivet

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
        self.assertIn("for which the screen is too narrow: --full", " ".join(done.split()))

    def test_frequencies_and_verdicts_stay_on_a_narrow_screen(self):
        narrow = {**os.environ, "COLUMNS": "80"}
        modes = trivet("modes", GENSET, env=narrow).stdout
        self.assertRegex(modes, r"\n  mode +f \[Hz\] +motion\n")
        self.assertIn("\n\n  mode   most strain energy in\n", modes)  # below the others
        drawn = trivet("map", SOURCE / "examples/paper/map.toml", "--points", "5", env=narrow).stdout
        self.assertIn("margin   verdict\n", drawn)
        self.assertRegex(drawn, r"\n\n  case +governed by\n")

    def test_explain_has_the_tables_of_one_peak(self):
        short, full = trivet("explain", GENSET).stdout, trivet("explain", GENSET, "--full").stdout
        self.assertEqual((short.count("  parameter,"), full.count("  parameter,")), (1, 10))
        self.assertEqual(short.count("Its height is most sensitive"), full.count("Its height is most sensitive"))
        self.assertIn("… the tables of 9 more peaks: --full\n", short)

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

    def test_check_and_map_in_full(self):
        short, full = trivet("check", GENSET).stdout, trivet("check", GENSET, "--full").stdout
        self.assertIn("… 21 checks of bodies and elements passed: --full", short)
        self.assertEqual(full.count("   ok\n"), 21)
        self.assertEqual(full.splitlines()[-8:], short.splitlines()[-8:])  # the mounts at rest
        drawn = (SOURCE / "examples/paper/map.toml", "--points", "11")
        short, full = trivet("map", *drawn).stdout, trivet("map", *drawn, "--full").stdout
        self.assertIn("aggregate.x reaches", full)
        self.assertNotIn("aggregate.x reaches", short)
        self.assertRegex(short, r"Figure 4 +1 +0.1 s +0.0714\d +aggregate.rz ≤ 20.5 mrad 0-p +VIOLATED\n")
        findings = sum(line.startswith("      ") for line in full.split("Cases on the map")[1].splitlines())
        self.assertIn(f"… {findings} findings on these cases", short)

    def on_terminal(self, columns, *words, **environment):
        """Standard output of a run whose standard output is a terminal of this width."""
        ours, theirs = pty.openpty()
        fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 40, columns, 0, 0))
        inherited = {key: value for key, value in os.environ.items() if key not in ("NO_COLOR", "COLUMNS")}
        run = subprocess.Popen(
            [TRIVET, *map(str, words)],
            stdout=theirs,
            stderr=subprocess.DEVNULL,
            env={**inherited, "TERM": "xterm", **environment},
        )
        os.close(theirs)
        text = b""
        while True:
            try:
                piece = os.read(ours, 4096)
            except OSError:  # the other end is closed
                break
            text += piece
            if not piece:
                break
        os.close(ours)
        self.assertEqual(run.wait(), 0)
        return text.decode().replace("\r\n", "\n")

    def test_colours_on_a_terminal(self):
        words = ("run", GENSET, "-o", self.folder / "out")
        self.assertIn("\x1b[31mVIOLATED\x1b[0m", self.on_terminal(100, *words))
        for plain in ({"NO_COLOR": "1"}, {"TERM": "dumb"}):
            self.assertNotIn("\x1b", self.on_terminal(100, *words, **plain))
        self.assertIn("\x1b", self.on_terminal(100, *words, NO_COLOR=""))
        self.assertNotIn("\x1b", trivet(*words).stdout)  # a pipe

    def test_every_line_fits_the_terminal(self):
        drawn = ("map", SOURCE / "examples/paper/map.toml", "--points", "11", "--full")
        for width in (60, 80, 120):
            for words in (drawn, ("verdict", GENSET), ("run", GENSET, "-o", self.folder / "out", "--full")):
                with self.subTest(width=width, command=words[0]):
                    lines = self.on_terminal(width, *words, NO_COLOR="1").splitlines()
                    self.assertLessEqual(max(map(len, lines)), width)
                    self.assertGreater(max(map(len, lines)), width - 25)
