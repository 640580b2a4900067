# SPDX-License-Identifier: BSD-3-Clause
"""Every example runs and leaves a report; the same input gives the same bytes."""
import json
import unittest

from trivet_test import EXAMPLES, PAPER, InTemporaryFolder, trivet


class Examples(InTemporaryFolder):
    def test_all_run_and_leave_a_report(self):
        self.assertGreaterEqual(len(EXAMPLES), 6)
        for number, example in enumerate(EXAMPLES):
            with self.subTest(example=example.name):
                target = self.folder / str(number)
                done = trivet("run", example, "-o", target)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertIn("report.html", done.stdout)
                self.assertNotIn("DISAGREES", done.stdout)
                results = json.loads((target / "results.json").read_text())
                self.assertEqual(results["format"], "trivet-results")
                self.assertIn(results["input"]["sha256"], (target / "report.html").read_text())
                self.assertTrue(list(target.glob("*/*.svg")))

    def test_the_same_input_gives_the_same_bytes(self):
        for name in "ab":
            trivet("run", PAPER, "-o", self.folder / name)
        for path in sorted((self.folder / "a").rglob("*")):
            if path.is_file():
                self.assertEqual(
                    path.read_bytes(), (self.folder / "b" / path.relative_to(self.folder / "a")).read_bytes(), path
                )

    def test_the_starter_file_passes_its_check(self):
        starter = self.file(trivet("new").stdout)
        done = trivet("check", "--deep", starter)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("agree", done.stdout)


if __name__ == "__main__":
    unittest.main()
