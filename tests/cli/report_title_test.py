# SPDX-License-Identifier: BSD-3-Clause
"""Title block, short form, mounts and the input file of the report."""
import hashlib
import html
import json
import math
import os
import re
import subprocess
import unittest

from report_page_test import MACHINE, SCRIPTS, SOURCE, TRIVET, Folder

from trivet_test import HANGS_AFTER

TITLES = """
[report]
project = "Hull <4711>"
client = "North Yard"
machine = "Fan & base"
revision = "B"
author = "M. Jensen"
"""
ORDERS = """
[excitations.rotor]
type = "orders"
on = "mass"
at = [0, 0, 0]
table = [{order = 1, force = [0, 0, 5]}, {order = 2, force = [0, 0, 3]}]
"""
RUN_UP = 'orders = {speed = ["60 rpm", "600 rpm"]}'


def parts(page):
    """{"Client": "North Yard", …} of the title block."""
    block = re.search('<dl class="title-block">(.*?)</dl>', page, re.DOTALL).group(1)
    return {name: html.unescape(value) for name, value in re.findall("<dt>(.*?)</dt><dd>(.*?)</dd>", block)}


class Title(Folder):
    def run_of(self, text, *options):
        project, out = self.folder / "machine.toml", self.folder / "out"
        project.write_bytes(text.encode())
        command = [TRIVET, "run", str(project), "-o", str(out), *options]
        environment = {**os.environ, "SOURCE_DATE_EPOCH": "86400"}
        done = subprocess.run(command, capture_output=True, text=True, timeout=HANGS_AFTER, env=environment)
        return done, (out / "report.html").read_bytes().decode() if done.returncode == 0 else ""

    def test_the_title_block_has_the_texts_of_the_file(self):
        done, page = self.run_of(MACHINE.replace("LIMIT", "1 m") + TITLES)
        self.assertEqual(done.returncode, 0, done.stderr)
        found = parts(page)
        self.assertEqual(found["Project"], "Hull <4711>")
        self.assertEqual(found["Client"], "North Yard")
        self.assertEqual(found["Machine"], "Fan & base")
        self.assertEqual((found["Revision"], found["Author"]), ("B", "M. Jensen"))
        self.assertEqual((found["Date"], found["Input"]), ("1970-01-02", "machine.toml"))
        self.assertEqual(found["SHA-256"], hashlib.sha256((self.folder / "machine.toml").read_bytes()).hexdigest())

    def test_the_command_line_changes_the_title_block_and_a_case_cannot(self):
        text = MACHINE.replace("LIMIT", "1 m") + TITLES
        _, page = self.run_of(text, "--set", "report.revision=C")
        self.assertEqual(parts(page)["Revision"], "C")
        done, _ = self.run_of(text + '[cases.soft]\nreport.revision = "D"\n')
        self.assertEqual(done.returncode, 2)
        self.assertIn("cases.soft.report: cannot be changed", done.stderr)

    def test_the_date_is_as_written(self):
        text = MACHINE.replace("LIMIT", "1 m") + TITLES + 'date = "29 November 2026"\n'
        self.assertEqual(parts(self.run_of(text)[1])["Date"], "29 November 2026")

    def test_unknown_keys_and_forms_are_errors(self):
        done, _ = self.run_of(MACHINE.replace("LIMIT", "1 m") + '[report]\ncustomer = "x"\nform = "brief"\n')
        self.assertEqual(done.returncode, 2)
        self.assertIn("report.customer", done.stderr)
        self.assertIn("one of full, short is expected here", done.stderr)

    def test_the_input_file_is_in_the_appendix_as_it_was_read(self):
        text = MACHINE.replace("LIMIT", "1 m") + '# <b>&amp; "ö" {{level}} {{tables}}\r\n\n# end  '
        done, page = self.run_of(text)
        self.assertEqual(done.returncode, 0, done.stderr)
        shown = re.search(r'<pre class="input-text"[^>]*>\n(.*?)</pre>', page, re.DOTALL).group(1)
        self.assertEqual(html.unescape(shown), text)
        self.assertIn("Cases: stiff, strict.", page)

    def test_the_short_form_has_no_scripts_and_only_the_first_parts(self):
        text = MACHINE.replace("LIMIT", "1 m")
        for given, options in ((text, ("--report", "short")), (text + '[report]\nform = "short"\n', ())):
            _, page = self.run_of(given, *options)
            self.assertNotIn("<script", page)
            self.assertNotIn("{{", page)
            self.assertNotIn("<details>", page)  # paper shows only parts that are open
            headings = re.findall("<h2>(.*?)</h2>", page)
            self.assertEqual(
                headings[1:],
                [
                    "Requirements",
                    "Cases",
                    "Machine and mounts of the base model",
                    "Undamped modes of the base model",
                    "Conventions",
                    "Signatures",
                ],
            )
        _, page = self.run_of(text + '[report]\nform = "short"\n', "--report", "full")
        self.assertIn("Appendix: input file", page)

    def test_a_single_case_has_no_overview_beside_its_charts(self):
        text = MACHINE.replace("LIMIT", "1 m")
        self.assertIn('id="overview"', SCRIPTS.sub("", self.run_of(text)[1]))
        single = SCRIPTS.sub("", self.run_of(text[: text.index("[cases.stiff]")])[1])
        self.assertNotIn('id="overview"', single)
        self.assertNotIn("data-select", single[single.index('id="cases"') :])


class OperatingSpeeds(Folder):
    def page_of(self, text, *options):
        project, out = self.folder / "fan.toml", self.folder / "out"
        project.write_text(text)
        command = [TRIVET, "run", str(project), "-o", str(out), *options]
        subprocess.run(command, check=True, capture_output=True, timeout=HANGS_AFTER)
        return SCRIPTS.sub("", (out / "report.html").read_text())

    def test_both_forms_have_them_before_the_machine(self):
        text = (SOURCE / "examples/fan/fan.toml").read_text()
        for options in ((), ("--report", "short")):
            page = self.page_of(text, *options)
            headings = re.findall("<h2>(.*?)</h2>", page)
            self.assertEqual(headings[1:4], ["Requirements", "Operating speeds", "Machine and mounts"])
            first_page = page[page.index("<h2>Operating speeds</h2>") : page.index("<h2>Machine and mounts</h2>")]
            self.assertRegex(
                first_page,
                r"At 980 rpm: largest velocity [0-9.]+ mm/s rms .*; largest force on the ground [0-9.]+ N 0-p .*; "
                r"isolation from .*; nearest to resonance: mode 7 \(9\.11[0-9]* Hz\), order 1 at [0-9.]+ % of it",
            )
            self.assertIn("<h2>At the operating speed</h2>", page)
            self.assertIn("Forces on the ground, in total and of each mount", page)
        self.assertEqual(page.count("largest velocity"), 1)  # the short form

    def test_each_case_has_its_own(self):
        text = (SOURCE / "examples/fan/fan.toml").read_text()
        page = self.page_of(text + '\n[cases.fast]\noperation.speeds = ["1450 rpm"]\n', "--report", "short")
        self.assertIn("Base model. At 980 rpm: ", page)
        self.assertIn("fast. At 1450 rpm: ", page)
        self.assertIn("<h2>At the operating speed, base model</h2>", page)


class Inputs(Folder):
    def page_of(self, text, *options):
        project, out = self.folder / "fan.toml", self.folder / "out"
        project.write_text(text)
        command = [TRIVET, "run", str(project), "-o", str(out), *options]
        subprocess.run(command, check=True, capture_output=True, timeout=HANGS_AFTER)
        return SCRIPTS.sub("", (out / "report.html").read_text())

    def test_only_tables_with_the_numbers_of_the_file_are_marked_as_its_repetition(self):
        text = (SOURCE / "examples/fan/fan.toml").read_text()
        self.assertEqual(self.page_of(text).count("<div data-in-file>"), 2)  # elements and foundations
        self.assertEqual(
            self.page_of(text, "--set", "bodies.fan.points.bearing=[0,0,1]").count("<div data-in-file>"), 0
        )
        page = self.page_of(text + '\n[cases.soft]\nelements."front left".scale = 0.5\n')
        self.assertEqual(page.count("<div data-in-file>"), 2)  # of the base model alone

    def test_laws_and_what_they_assume_are_listed_once(self):
        page = self.page_of((SOURCE / "examples/fan/fan.toml").read_text())
        table = page[page.index("Laws of the elements and what they assume") : page.index("<h3>Excitations</h3>")]
        self.assertEqual(table.count("<tr"), 3)  # headings, bushing, loss factor
        self.assertIn("six springs along and about its axes", table)
        self.assertIn("K(1 + iη), the same at every frequency", table)

    def test_weight_and_damping_with_a_flexible_foundation(self):
        page = self.page_of((SOURCE / "examples/fan/fan.toml").read_text())
        self.assertIn(
            "not that of flexible foundations. It acts in static results, and its forces at rest change", page
        )
        self.assertIn("Damping of the system: only that of the elements and of the flexible foundations.", page)


class NamedFiles(Folder):
    """Files that a project names are part of its input."""

    def page(self):
        out = self.folder / "out"
        command = [TRIVET, "run", str(self.folder / "microscope.toml"), "-o", str(out)]
        subprocess.run(command, check=True, capture_output=True, timeout=HANGS_AFTER)
        self.results = json.loads((out / "results.json").read_text())
        return SCRIPTS.sub("", (out / "report.html").read_text())

    def copy(self):
        for name in ("microscope.toml", "floor.csv"):
            (self.folder / name).write_bytes((SOURCE / "examples/microscope" / name).read_bytes())

    def test_the_hash_is_that_of_the_project_and_of_the_files_that_it_names(self):
        self.copy()
        page = self.page()
        project, floor = (
            hashlib.sha256((self.folder / name).read_bytes()).hexdigest() for name in ("microscope.toml", "floor.csv")
        )
        whole = hashlib.sha256(f"{project}\n{floor}\n".encode()).hexdigest()
        self.assertEqual(parts(page)["SHA-256"], whole)
        self.assertEqual(parts(page)["Input"], "microscope.toml with 1 file that it names")
        self.assertIn(f"<td>floor.csv</td><td>{floor}</td>", page)
        self.assertEqual(
            self.results["input"],
            {"file": "microscope.toml", "sha256": whole, "files": [{"file": "floor.csv", "sha256": floor}]},
        )
        floor_file = self.folder / "floor.csv"
        floor_file.write_text(floor_file.read_text().replace("7.2", "7.3"))
        self.assertNotEqual(parts(self.page())["SHA-256"], whole)

    def test_the_report_lists_measured_levels_as_they_were_given(self):
        self.copy()
        page = html.unescape(self.page())
        self.assertIn("<td>third-octave band of 10 Hz</td><td>7.2 µm/s rms</td>", page)
        self.assertIn("<td>third-octave band of 1.25 Hz</td><td>450 nm/s rms</td>", page)  # of the floor along y


class Levels(Folder):
    def test_all_of_a_run_up_is_rms(self):
        text = MACHINE.replace("LIMIT", "1 m").replace("[analyses]", ORDERS + "[analyses]\n" + RUN_UP, 1)
        project, out = self.folder / "machine.toml", self.folder / "out"
        project.write_text(text)
        subprocess.run(
            [TRIVET, "run", str(project), "-o", str(out)], check=True, capture_output=True, timeout=HANGS_AFTER
        )
        page = html.unescape(SCRIPTS.sub("", (out / "report.html").read_text())).replace("\u00a0", " ")
        section = re.search('<section class="answer orders">.*?</section>', page, re.DOTALL).group()
        self.assertNotIn("0-p", section)
        self.assertNotIn("zero-to-peak", section)
        self.assertIn(">displacement [mm rms]<", section)
        orders = json.loads((out / "results.json").read_text())["cases"][0]["orders"]
        highest = max(c["amplitude"] for c in orders["critical_speeds"])
        self.assertIn(f"{1e3 * highest / math.sqrt(2):.3f} mm", section)


class FirstPage(Folder):
    def test_cases_on_a_map_have_their_first_findings_there_and_all_of_them_with_the_map(self):
        out = self.folder / "out"
        command = [TRIVET, "run", str(SOURCE / "examples/paper/map.toml"), "-o", str(out)]
        self.assertEqual(subprocess.run(command, capture_output=True, timeout=HANGS_AFTER).returncode, 0)
        page = html.unescape(SCRIPTS.sub("", (out / "report.html").read_text()))
        first = page[: page.index('<section class="machine">')]
        bullets = re.findall("<li>(?:Case .*?|The .*?)</li>", first)
        self.assertTrue(bullets)
        for bullet in bullets:
            self.assertLess(len(re.sub("<.*?>", "", bullet)), 400, bullet)
        self.assertRegex(first, r"and \d+ more, listed with the map")
        self.assertNotRegex(page, r"e\+\d+ %")
        bounds = re.findall(r"reaches \S+ \S+ .*?, allowed ([^;<,]*)", page)
        self.assertTrue(bounds)
        for allowed in bounds:
            self.assertRegex(allowed, r"^\S+ [mµ]?(m|rad)\b")

    def test_the_requirements_do_not_scroll_in_a_box(self):
        style = (SOURCE / "src/trivet/report/page.css").read_text()
        self.assertRegex(style, r"\.judgements \.scroll\.tall[^{]*\{ max-height: none")


class Mounts(Folder):
    def rows(self, example):
        out = self.folder / "out"
        command = [TRIVET, "run", str(SOURCE / "examples" / example), "-o", str(out)]
        subprocess.run(command, check=True, capture_output=True, timeout=HANGS_AFTER)
        self.results = json.loads((out / "results.json").read_text())
        page = SCRIPTS.sub("", (out / "report.html").read_text())
        section = re.search('<section class="machine">.*?</table>', page, re.DOTALL).group()
        return [
            [
                html.unescape(re.sub("<.*?>", "", cell)).replace("\u00a0", " ")
                for cell in re.findall("<t[hd].*?</t[hd]>", row)
            ]
            for row in section.split("<tr")[1:]
        ]

    def test_equal_mounts_are_one_row_with_the_numbers_of_the_file(self):
        heads, *rows = self.rows("genset/genset.toml")
        self.assertEqual(len(rows), 1)
        row = dict(zip(heads, rows[0]))
        self.assertTrue(row["mounts"].startswith("6 × front left, front right"), row)
        stiffness = {head[:3]: value for head, value in row.items() if head.startswith("k ")}
        self.assertEqual(
            {axis: float(k.split()[0]) for axis, k in stiffness.items()}, {"k x": 1.6, "k y": 1.2, "k z": 3.4}
        )
        self.assertEqual(float(row["loss factor z at 10 Hz"]), 0.12)
        # 4200 kg on six mounts: the mean of the least and largest compression is near 6.86 kN.
        least, largest = (float(number) for number in re.findall(r"[\d.]+", row["compression at rest"]))
        self.assertTrue(least < 4200 * 9.80665 / 6 / 1000 < largest, row)

    def test_rubber_has_its_static_stiffness_and_that_in_vibration(self):
        """The static one goes with load and deflection at rest: 4 kg on 981 N/m sink by 40 mm."""
        project = self.folder / "rubber.toml"
        project.write_text(
            'trivet = 1\ngravity = [0, 0, -9.81]\n[bodies.m]\nmass = 4\nfree = ["z"]\n'
            '[elements.rubber]\ntype = "bushing"\non = "m"\nat = [0, 0, 0]\ntranslation = [981, 981, 981]\n'
            "stiffening = 1.5\n[analyses]\nmodes = {}\n"
        )
        heads, row = self.rows(project)
        row = dict(zip(heads, row))
        self.assertEqual([row[head] for head in heads if head.startswith("k z")], ["0.9810", "1.472"], row)
        self.assertEqual(row["compression at rest"], "39.24 N")
        self.assertEqual(row["deflection at rest"], "-40 mm")


if __name__ == "__main__":
    unittest.main()
