# SPDX-License-Identifier: BSD-3-Clause
"""Designs within tolerances: text, CSV, JSON, measured batches and messages of `trivet sample`."""
import csv
import io
import json
import shlex
import unittest

from trivet_test import SOURCE, InTemporaryFolder, trivet

ROBUST = SOURCE / "examples/paper/robust.toml"
FEW = ("--set", "analyses.sample.designs=1000")

WEDGE = (SOURCE / "tests/data/projects/wedge.toml").read_text()


class Sample(InTemporaryFolder):
    def project(self, more):
        text = ROBUST.read_text()
        start, end = text.index("[tolerances.rubber]"), text.index("[requirements]")
        target = self.folder / "project.toml"
        target.write_text(text[:start] + more + text[end:])
        return target

    def test_text_begins_with_the_yield(self):
        lines = trivet("sample", ROBUST, *FEW).stdout.splitlines()
        self.assertRegex(
            lines[0], r"^Yield: 9\d\.\d+ % \(95 % confidence: .*\); 9\d\d of 1000 designs meet every requirement\."
        )
        self.assertRegex(lines[1], r"^Breaks first: no peak of aggregate\.y, in \d+(\.\d)? % of the designs")

    def test_csv_and_json_have_the_same_numbers(self):
        found = json.loads(trivet("sample", ROBUST, *FEW, "--json").stdout)
        rows = list(csv.DictReader(io.StringIO(trivet("sample", ROBUST, *FEW, "--csv").stdout)))
        listed = found["cases"][0]["requirements"]
        self.assertEqual(len(rows), len(listed))
        for row, one in zip(rows, listed):
            self.assertEqual(row["requirement"], one["requirement"])
            self.assertEqual(float(row["yield"]), one["yield"])
            self.assertEqual(int(row["met"]), one["met"])
            self.assertEqual(float(row["margin_least"]), one["margin_least"])
        self.assertEqual(found["cases"][0]["in_kernels"] + found["cases"][0]["one_by_one"], 1000)

    def test_the_worst_design_has_its_margin(self):
        found = json.loads(trivet("sample", ROBUST, *FEW, "--json").stdout)
        settings = [f"{path}={value!r}" for path, value in found["worst"]["numbers"].items()]
        judged = json.loads(trivet("verdict", ROBUST, "--json", *(x for s in settings for x in ("--set", s))).stdout)
        self.assertAlmostEqual(judged["least_margin"]["margin"] / found["worst_margin"], 1, 8)

    def test_strict_judges_the_wanted_yield_or_all_designs(self):
        def strict(*more):
            done = trivet("sample", ROBUST, *FEW, *more, "--strict")
            return done.returncode, done.stdout.splitlines()[0], done.stderr

        wide = (
            "--set",
            'requirements={limits={"aggregate.x"="0.2 m", "aggregate.y"="0.2 m", "aggregate.z"="0.2 m"}, no_peak=[]}',
        )
        self.assertEqual(strict()[0], 3)
        self.assertIn("1 sample with designs that violate a requirement", strict()[2])
        self.assertEqual(strict(*wide)[0], 0)
        # 0.05^(1/1000) = 99.7 %: without violations 1000 designs show no more.
        for yields, more, expected in (
            ("90 %", (), (0, ", wanted 90 %")),
            ("99 %", (), (3, ", NOT the wanted 99 %")),
            ("99.7 %", wide, (0, ", wanted 99.7 %")),
            ("99.71 %", wide, (1, ", NOT certainly the wanted 99.71 %")),
        ):
            code, first, error = strict("--set", f'analyses.sample.yield="{yields}"', *more)
            self.assertEqual(code, expected[0], error)
            self.assertIn(expected[1] + ";", first)
            self.assertEqual("1 yield below the wanted one" in error, code == 3)
            self.assertEqual("the designs do not decide on the wanted yield" in error, code == 1)
        study = ("-o", self.folder / "study", "--part", "1/2")
        self.assertEqual(strict(*study)[0], 0)  # a part of the designs has no verdict
        self.assertEqual(strict(*study[:3], "2/2")[0], 3)

    def test_numbers_of_designs_have_the_units_of_the_file(self):
        project = self.file(WEDGE + '[tolerances.whole]\npath = "elements.k1.scale"\nhalf_width = "10 %"\n')
        stiffness, mass, scale = json.loads(trivet("sample", project, *FEW, "--json").stdout)["worst"][
            "numbers"
        ].values()
        self.assertRegex(
            trivet("sample", project, *FEW).stdout,
            rf"Least margin .*: elements\.k1\.translation\.z = {stiffness / 1000:.5g} N/mm, "
            rf"bodies\.m1\.mass = {mass:.5g} kg, elements\.k1\.scale = {scale:.5g}\.\n",
        )

    def test_zero_is_no_word_on_a_machine_without_a_model(self):
        wide = WEDGE.replace('half_width = "0.5 kg"', 'standard_deviation = "6 kg"')
        reaches = 'of its numbers at "bodies.m1.mass" are'
        self.assertIn(reaches, trivet("sample", self.file(wide)).stderr)
        flat = wide.replace('free = ["z"]', "inertia = {xx = 1, yy = 1, zz = 3}")
        done = trivet("sample", self.file(flat))
        self.assertEqual(done.returncode, 2)
        self.assertIn("bodies.m1.inertia", done.stderr)
        self.assertNotIn(reaches, done.stderr)

    def test_the_case_with_the_least_margin_is_named(self):
        path = self.folder / "cases.toml"
        text = ROBUST.read_text().replace("[requirements]\n", '[requirements]\nhold_in = ["", "soft"]\n')
        path.write_text(text + "\n[cases.soft]\nelements.suspension.scale = 4\n")
        self.assertRegex(trivet("sample", path, *FEW).stdout, r"Least margin \S+ in case soft in design \d+")
        self.assertEqual(json.loads(trivet("sample", path, *FEW, "--json").stdout)["worst_case"], "soft")
        self.assertEqual(json.loads(trivet("sample", ROBUST, *FEW, "--json").stdout)["worst_case"], "")

    def test_values_are_at_the_level_of_the_limit_and_between_their_extremes(self):
        path = self.folder / "level.toml"
        path.write_text(
            ROBUST.read_text()
            .replace('"aggregate.x" = "11 mm"', '"aggregate.x" = "22 mm p-p"')
            .replace('level = "amplitude"\n', "")
        )
        (row,) = [one for one in trivet("sample", path, *FEW).stdout.splitlines() if "aggregate.x ≤" in one]
        self.assertRegex(row, r"≤ 22 mm p-p .* mm p-p .* mm p-p .* mm p-p")
        both = [
            json.loads(trivet("sample", one, *FEW, "--json").stdout)["cases"][0]["requirements"][0]
            for one in (path, ROBUST)
        ]
        self.assertEqual(both[0], both[1])
        self.assertEqual(both[0]["level"], "0-p")
        self.assertTrue(both[0]["requirement"].endswith("≤ 11 mm 0-p"))
        for one in json.loads(trivet("sample", ROBUST, *FEW, "--json").stdout)["cases"][0]["requirements"]:
            ends = [one[f"margin_{name}"] for name in ("least", "low", "median", "high", "largest")]
            self.assertEqual(ends, sorted(ends, key=lambda m: float("inf") if m is None else m))

    def test_the_worst_found_design_has_its_margin(self):
        settings = (*FEW, "--set", "analyses.sample.worst_case=true")
        found = json.loads(trivet("sample", ROBUST, *settings, "--json").stdout)
        rows = list(csv.DictReader(io.StringIO(trivet("sample", ROBUST, *settings, "--csv").stdout)))
        text = trivet("sample", ROBUST, *settings).stdout
        self.assertIn("there may be worse ones", text)
        self.assertIn("all 16 corners", text)
        for row, one in zip(rows, found["cases"][0]["requirements"]):
            self.assertLessEqual(one["worst_margin"], one["margin_least"] * (1 + 1e-9))
            self.assertEqual(float(row["worst_margin"]), one["worst_margin"])
            self.assertEqual(row["worst_settings"], one["worst_settings"])
            self.assertIn(one["worst_settings"], text)
            judged = json.loads(trivet("verdict", ROBUST, "--json", *shlex.split(one["worst_settings"])).stdout)
            again = next(r for r in judged["cases"][0]["requirements"] if r["requirement"] == one["requirement"])
            self.assertAlmostEqual(again["margin"] / one["worst_margin"], 1, 6)
        self.assertNotIn("a drawn design is worse", text)
        # Of 100,000 designs some are beyond the ends of the normal numbers.
        all_designs = trivet("sample", ROBUST, "--set", "analyses.sample.worst_case=true").stdout
        self.assertIn("Of these a drawn design is worse than the one found", all_designs)
        self.assertNotIn("worst_found", json.loads(trivet("sample", ROBUST, *FEW, "--json").stdout))

    def test_a_measured_batch_is_drawn_as_it_is(self):
        values = [6 * (0.8 + 0.02 * i) for i in range(20)]
        (self.folder / "batch.csv").write_text("scale\n" + "".join(f"{value}\n" for value in values))
        project = self.project('[tolerances.batch]\npath = "elements.suspension.scale"\nfile = "batch.csv"\n')
        found = json.loads(trivet("sample", project, "--set", "analyses.sample.designs=1600", "--json").stdout)
        # Each amplitude is that of a machine with one of the 20 numbers.
        first = found["cases"][0]["requirements"][0]
        self.assertEqual(first["subject"], "aggregate.x")
        for scale, at in ((values[0], "value_largest"), (values[-1], "value_least")):
            one = json.loads(
                trivet("verdict", project, "--json", "--set", f"elements.suspension.scale={scale!r}").stdout
            )
            judged = next(r for r in one["cases"][0]["requirements"] if r["subject"] == "aggregate.x")
            self.assertAlmostEqual(judged["value"] / first[at], 1, 8)
        met = sum(
            json.loads(trivet("verdict", project, "--json", "--set", f"elements.suspension.scale={v!r}").stdout)["met"]
            for v in values
        )
        # 100 points of a replicate meet each twentieth five times, but for those at their ends.
        self.assertAlmostEqual(found["yield"]["share"], met / 20, delta=0.01)

    def test_together_is_one_draw(self):
        project = self.project(
            '[tolerances.both]\npath = ["bodies.aggregate.mass", "elements.suspension.scale"]\nhalf_width = "10 %"\n'
        )
        apart = json.loads(trivet("sample", project, *FEW, "--json").stdout)
        text = project.read_text().replace("[tolerances.both]\n", "[tolerances.both]\ntogether = true\n")
        project.write_text(text)
        joined = json.loads(trivet("sample", project, *FEW, "--json").stdout)
        self.assertEqual((apart["drawn"], joined["drawn"]), (2, 1))
        mass, scale = joined["worst"]["numbers"].values()
        self.assertAlmostEqual(mass / 205.176, scale / 6, 12)

    def test_shares_name_what_scatters(self):
        project = self.project(
            '[tolerances.rubber]\npath = "elements.suspension.scale"\nhalf_width = "15 %"\n'
            '[tolerances.idle]\npath = "bodies.aggregate.mass"\nhalf_width = "0.001 %"\n'
        )
        found = json.loads(trivet("sample", project, *FEW, "--shares", "--json").stdout)["shares"]
        self.assertEqual((found["reason"], found["left_out"]), ("", 0))
        self.assertEqual(found["pairs"], 240)  # 16 replicates of 15, four designs each
        rows = {(row["requirement"], row["number"]): row for row in found["list"]}
        self.assertEqual(len(rows), 2 * 3)  # amplitudes have values, peaks have none
        self.assertGreater(rows["aggregate.x ≤ 11 mm", "rubber"]["total_from"], 0.9)
        self.assertLess(rows["aggregate.x ≤ 11 mm", "idle"]["total_to"], 0.01)
        text = trivet("sample", project, *FEW, "--shares").stdout
        self.assertRegex(text, r"aggregate\.x ≤ 11 mm 0-p +idle +cannot be told from 0, ≤ \d")
        self.assertNotIn("shares", json.loads(trivet("sample", project, *FEW, "--json").stdout))
        together = trivet("sample", ROBUST, *FEW, "--shares").stdout
        self.assertRegex(together, r"aggregate\.x ≤ 11 mm 0-p +casting, core \(correlated\) ")

    def test_one_case_alone(self):
        project = self.project('[tolerances.rubber]\npath = "elements.suspension.scale"\nhalf_width = "5 %"\n')
        project.write_text(project.read_text() + "[cases.soft.elements.suspension]\nscale = 3\n")
        found = json.loads(trivet("sample", project, *FEW, "--case", "soft", "--json").stdout)
        self.assertEqual([one["case"] for one in found["cases"]], ["soft"])
        self.assertEqual(found["yield"]["met"], 0)
        self.assertIn("NONE of 1000 designs", trivet("sample", project, *FEW, "--case", "soft").stdout)

    def test_messages(self):
        bare = self.project("")
        for settings, said in (
            (("--set", "analyses.sample.designs=10"), "a whole number from 100 to 1000000000"),
            ((), "no tolerances"),
        ):
            done = trivet("sample", bare, *settings)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(said, done.stderr)


if __name__ == "__main__":
    unittest.main()
