# SPDX-License-Identifier: BSD-3-Clause
"""Results in files whose ending chooses the form, pages that are shown, and units as data sheets write them."""
import csv
import io
import json
import os
import unittest

from trivet_test import SOURCE, InTemporaryFolder, result_of, trivet

GENSET = SOURCE / "examples/genset/genset.toml"
MOUNTS = SOURCE / "examples/genset/mounts.toml"


class Files(InTemporaryFolder):
    def test_the_ending_chooses_the_form(self):
        for ending, option in ((".json", "--json"), (".csv", "--csv")):
            path = self.folder / ("peaks" + ending)
            done = trivet("peaks", GENSET, "-o", path)
            self.assertEqual((done.returncode, done.stdout), (0, f"{path}: written\n"))
            self.assertEqual(path.read_text(), trivet("peaks", GENSET, option).stdout)
        page, text = self.folder / "peaks.html", self.folder / "peaks.txt"
        self.assertEqual(trivet("peaks", GENSET, "-o", page).returncode, 0)
        self.assertTrue(page.read_text().startswith("<!doctype html>"))
        self.assertIn("<td", page.read_text())
        self.assertEqual(trivet("peaks", GENSET, "--output", text).returncode, 0)
        self.assertIn("genset.z", text.read_text())
        self.assertEqual(sorted(os.listdir(self.folder)), ["peaks.csv", "peaks.html", "peaks.json", "peaks.txt"])

    def test_what_is_refused(self):
        project = self.file(GENSET.read_text())
        for words, reason in (
            (("peaks", project, "-o", "peaks.xml"), "peaks has .json, .csv, .html, .txt"),
            (("check", project, "-o", "check.html"), "check has .json, .txt"),
            (("peaks", project, "-o", self.folder / "none/peaks.csv"), "none"),
            (("peaks", project, "-o", project), ".toml: the ending chooses"),
            (("peaks", project, "-o", "a.csv", "--json"), "excludes"),
        ):
            done = trivet(*words, cwd=self.folder)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(reason, done.stderr)
        self.assertEqual(os.listdir(self.folder), ["project.toml"])

    def test_a_failed_command_keeps_the_earlier_file(self):
        path = self.folder / "random.json"
        path.write_text("mine")
        self.assertNotEqual(trivet("earthquake", GENSET, "-o", path).returncode, 0)
        self.assertEqual(path.read_text(), "mine")

    def test_open(self):
        shown, out = self.folder / "shown", self.folder / "out"
        browser = self.folder / "browser"
        browser.write_text(f'#!/bin/sh\nprintf %s "$1" > "{shown}"\n')
        browser.chmod(0o755)
        environment = {**os.environ, "BROWSER": str(browser)}
        done = trivet("run", GENSET, "-o", out, "--open", env=environment)
        self.assertEqual((done.returncode, shown.read_text()), (0, f"{out}/report.html"))
        page = self.folder / "modes.html"
        self.assertEqual(trivet("modes", GENSET, "-o", page, "--open", env=environment).returncode, 0)
        self.assertEqual(shown.read_text(), str(page))
        refused = trivet("modes", GENSET, "--open", env=environment)
        self.assertEqual(refused.returncode, 2)
        self.assertIn("--open shows a page: name one", refused.stderr)

    def test_open_without_a_browser(self):
        environment = {key: value for key, value in os.environ.items() if key != "BROWSER"}
        page = self.folder / "modes.html"
        done = trivet("modes", GENSET, "-o", page, "--open", env={**environment, "PATH": "/nonexistent"})
        self.assertEqual(done.returncode, 1)
        self.assertIn("xdg-open: No such file or directory; set BROWSER", done.stderr)
        self.assertTrue(page.exists())
        failing = trivet("modes", GENSET, "-o", page, "--open", env={**environment, "BROWSER": "false"})
        self.assertEqual(failing.returncode, 1)
        self.assertIn("false failed", failing.stderr)

    def test_select_as_csv(self):
        rows = list(csv.DictReader(io.StringIO(trivet("select", MOUNTS, "--most", "3", "--csv").stdout)))
        best = result_of("select", MOUNTS, "--most", "3")["best"]
        self.assertEqual([row["rank"] for row in rows], ["1", "2", "3", "given"])
        for row, one in zip(rows, best):
            for choice, mount in one["mounts"].items():
                self.assertEqual(row[choice], mount)
            self.assertAlmostEqual(float(row["margin"]), one["margin"], delta=1e-12 * abs(one["margin"]))


class Units(InTemporaryFolder):
    def test_speeds_of_data_sheets(self):
        speeds = [result_of("response", GENSET, "--at", f"980 {u}") for u in ("rpm", "1/min", "min⁻¹", "U/min")]
        self.assertAlmostEqual(speeds[0]["angular_frequency"][0], 980 * 2 * 3.14159265358979 / 60, places=9)
        for other in speeds[1:]:
            self.assertEqual(other, speeds[0])

    def test_both_micro_signs(self):
        found = []
        for sign in ("\u00b5", "\u03bc", "u"):
            text = GENSET.read_text() + f'[requirements]\nlimits = {{"genset.z" = "900 {sign}m"}}\n'
            found.append(trivet("verdict", self.file(text), "--json").stdout)
        self.assertEqual(json.loads(found[0])["cases"][0]["requirements"][0]["allowed"], 900e-6)
        self.assertEqual(found[1:], [found[0], found[0]])


if __name__ == "__main__":
    unittest.main()
