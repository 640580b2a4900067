# SPDX-License-Identifier: BSD-3-Clause
"""Designs within tolerances as a part of `trivet run`: the same result as of `trivet sample`."""
import html
import json
import re
import unittest

from trivet_test import SOURCE, InTemporaryFolder, trivet

ROBUST = SOURCE / "examples/paper/robust.toml"


def section(page, title):
    return re.search(rf">{title}</h2>(.*?)</section>", page, re.S).group(1)


def words(text):
    return re.sub(r"\s+", " ", html.unescape(re.sub(r"<[^>]+>", " ", text)))


class ReportSample(InTemporaryFolder):
    def project(self, text=None, *changes):
        target = self.folder / "project.toml"
        text = text or ROBUST.read_text().replace("designs = 100_000", "designs = 2000, worst_case = true")
        for old, new in changes:
            self.assertIn(old, text)
            text = text.replace(old, new)
        target.write_text(text)
        return target

    def run_of(self, project, *options):
        done = trivet("run", project, "-o", self.folder / "out", *options)
        page = self.folder / "out/report.html"
        return done, json.loads((self.folder / "out/results.json").read_text()), page.read_text()

    def test_has_what_trivet_sample_prints(self):
        project = self.project()
        done, results, page = self.run_of(project)
        self.assertEqual(done.returncode, 0, done.stderr)
        found = json.loads(trivet("sample", project, "--shares", "--json").stdout)
        del found["warnings"]
        self.assertEqual(results["cases"][0]["sample"], found)
        head = trivet("sample", project).stdout.splitlines()[:2]
        self.assertRegex(head[0], r"^Yield: 9\d\.\d")
        notice = words(re.search(r"<h2>[^<]*ithin tolerances[^<]*</h2>(.*?)</div>", page, re.S).group(1))
        part = words(section(page, "Designs within tolerances"))
        for line in head:
            self.assertIn("  " + line, done.stdout)
            self.assertIn(line, notice)
            self.assertIn(line, part)
        for heading in ("breaks first", "least margin", "worst found", "drawn number", "5 … 95 % of the designs"):
            self.assertIn(heading, part)
        folder = self.folder / "out/00-base"
        self.assertEqual((folder / "sample.csv").read_text(), trivet("sample", project, "--csv").stdout)
        for name in ("bands.csv", "bands.svg", "shares.svg"):
            self.assertTrue((folder / name).exists(), name)

    def test_the_box_is_amber_if_any_design_drawn_or_searched_violates_a_requirement(self):
        wedge = (SOURCE / "tests/data/projects/wedge.toml").read_text()
        wedge = (
            wedge[: wedge.index("natural_frequencies")] + "[analyses]\nsample = {designs = 100, worst_case = true}\n"
        )
        amber = ("alert", "⚠ Not all designs within tolerances meet the requirements")
        # At the worst corner the sag is 10.5 kg·g/(34 N/mm) = 3.0286 mm.
        for allowed, all_met, expected in (
            ("2.6 mm", False, amber),
            ("3.0285 mm", True, amber),  # none of the drawn designs is so near to the corner
            ("3.03 mm", True, ("note", "Within tolerances")),
        ):
            _, results, page = self.run_of(self.project(wedge, ('"3 mm"', f'"{allowed}"')))
            self.assertEqual(results["cases"][0]["sample"]["yield"]["share"] == 1, all_met, allowed)
            box = re.search(r'<div class="(\w+)" role="note"><h2>([^<]*ithin tolerances[^<]*)</h2>', page)
            self.assertEqual(box.groups(), expected, allowed)

    def test_a_wanted_yield_is_a_verdict(self):
        for wanted, held, heading in (
            ("90 %", True, "✓ MET: 6 of 6 requirements, 1 of 1 yield"),
            ("99 %", False, "✗ VIOLATED: 1 of 1 yield"),
        ):
            project = self.project(None, ("designs = 2000", f'yield = "{wanted}", designs = 2000'))
            done, results, page = self.run_of(project, "--strict")
            found = results["cases"][0]["sample"]
            self.assertEqual((found["wanted"], found["held"]), (float(wanted[:2]) / 100, held))
            self.assertEqual(found["yield"]["from"] >= found["wanted"], held)
            self.assertEqual(done.returncode == 3, not held, done.stderr)
            self.assertIn(heading, words(page))
            self.assertEqual("⚠ The designs within tolerances do not show the wanted yield" in page, not held)
            self.assertNotIn("⚠ Not all designs", page)
            self.assertIn("6 of 6 met", done.stdout)  # requirements of the machine
            self.assertEqual("least margin: aggregate" in done.stdout, held)

    def test_a_yield_that_the_designs_do_not_decide_is_not_judged(self):
        # All designs meet this: 0.05^(1/1000) = 99.7 %. The least whole n with y^n <= 0.05 decides.
        for wanted, deciding in (("99.9 %", 2995), ("99.8 %", 1497)):
            text = ROBUST.read_text().replace("designs = 100_000", f'designs = 1000, yield = "{wanted}"')
            text = text.replace('no_peak = ["aggregate.x", "aggregate.y", "aggregate.z"]', "")
            project = self.project(text, *((f'"{mm} mm"', '"0.1 m"') for mm in (11, 10, 8)))
            done, results, page = self.run_of(project, "--strict")
            self.assertIsNone(results["cases"][0]["sample"]["held"])
            self.assertIn("? NOT JUDGED: 1 of 1 yield", words(page))
            self.assertIn(f"without violations {deciding} designs show it", words(page))
            self.assertEqual(done.returncode, 1)
            self.assertIn("the designs do not decide on the wanted yield", done.stderr)

    def test_an_interval_around_the_wanted_yield_says_how_many_designs_end_beside_it(self):
        def sample(designs, wanted):
            key = f"designs = {designs}" + (f", yield = {wanted}" if wanted else "")
            _, results, page = self.run_of(self.project(None, ("designs = 2000, worst_case = true", key)))
            return results["cases"][0]["sample"], words(page)

        wanted = sample(500, None)[0]["yield"]["share"] - 0.01
        found, page = sample(500, wanted)
        self.assertIsNone(found["held"])
        about = re.search(r"NOT certainly the wanted [\d.]+ %; about (\d+) designs decide if the share stays", page)
        half = found["yield"]["share"] - found["yield"]["from"]  # it shrinks as the root of their number
        self.assertAlmostEqual(int(about[1]) / (500 * (half / 0.01) ** 2), 1.05, delta=0.06)  # two digits, rounded up
        self.assertTrue(sample(2 * int(about[1]), wanted)[0]["held"])

    def test_the_short_report_states_the_yield(self):
        done, _, page = self.run_of(self.project(), "--report", "short")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(
            "Yield: ", words(re.search(r"<h2>[^<]*ithin tolerances[^<]*</h2>(.*?)</div>", page, re.S).group(1))
        )

    def test_a_large_sample_ends_after_the_first_designs(self):
        for more, most in (("", 100_000), ("damping_ratio = 1e-6\n", 1000)):  # a damping ratio has no kernel
            project = self.project(
                None,
                ("designs = 2000, worst_case = true", "designs = 1_000_000"),
                ("no_peak = [", more + "no_peak = ["),
            )
            done, results, page = self.run_of(project)
            self.assertEqual(done.returncode, 0, done.stderr)
            found = results["cases"][0]["sample"]
            self.assertEqual((found["designs"], found["first_of"]), (most, 1_000_000))
            sentence = f"These are the first {most} of 1000000 designs: trivet sample judges all of them."
            self.assertIn(sentence, done.stdout)
            self.assertEqual(words(page).count(sentence), 2)
            few = trivet("sample", project, "--shares", "--json", "--set", f"analyses.sample.designs={most}").stdout
            few = json.loads(few)
            for key, value in few.items():
                if key != "warnings":
                    self.assertEqual(found[key], value, key)

    def test_worst_designs_are_not_searched_by_assembled_models(self):
        project = self.project(
            None, ("designs = 2000", "designs = 200"), ("no_peak = [", "damping_ratio = 1e-6\nno_peak = [")
        )
        done, results, page = self.run_of(project)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("worst_found", results["cases"][0]["sample"])
        sentence = "The worst designs are not searched in a report if models are assembled one by one: trivet sample searches them."
        self.assertIn(sentence, done.stdout)
        self.assertEqual(words(page).count(sentence), 2)

    def test_without_the_table_nothing_is_sampled(self):
        project = self.project(None, ('sample = {designs = 2000, worst_case = true, bands = ["aggregate.y"]}\n', ""))
        done, results, page = self.run_of(project)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("sample", results["cases"][0])
        self.assertNotIn("ithin tolerances</h2>", page)

    def test_a_sample_that_is_not_possible_is_reported(self):
        text = ROBUST.read_text()
        text = text[: text.index("[requirements]")] + text[text.index("[display]") :]
        done, results, _ = self.run_of(self.project(text))
        self.assertEqual(done.returncode, 1)
        self.assertIn("NOT COMPUTED: sample: neither requirements nor limits", done.stdout)
        self.assertNotIn("sample", results["cases"][0])


if __name__ == "__main__":
    unittest.main()
