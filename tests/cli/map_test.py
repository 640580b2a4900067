# SPDX-License-Identifier: BSD-3-Clause
"""`trivet map` as text, JSON, CSV and picture, and in the result folder of a run."""
import csv
import io
import json
import os
import pathlib
import re
import resource
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree

from trivet_test import HANGS_AFTER

TRIVET = os.environ["TRIVET"]
SOURCE = pathlib.Path(os.environ["TRIVET_SOURCE"])
PAPER = str(SOURCE / "examples/paper/map.toml")

ONE_MASS = """
trivet = 1
[bodies.mass]
mass = 4
free = ["z"]
[elements.spring]
type = "bushing"
on = "mass"
at = [0, 0, 0]
translation = [900, 900, 900]
damping = {proportional = 0.05}
[excitations.force]
type = "harmonic"
on = "mass"
at = [0, 0, 0]
force = [0, 0, 18]
[analyses]
modes = {}
[analyses.map]
x = {parameter = "elements.spring.scale", from = 0.5, to = 4, points = 9}
y = {parameter = "elements.spring.damping.proportional", from = "10 ms", to = "300 ms", points = 9}
limits = {"mass.z" = "30 mm"}
no_peak = "coordinates"
[cases.good]
elements.spring.scale = 2
elements.spring.damping.proportional = "90 ms"
"""


def run(*arguments, code=0):
    done = subprocess.run([TRIVET, *arguments], capture_output=True, text=True, timeout=HANGS_AFTER)
    assert done.returncode == code, (done.returncode, done.stdout, done.stderr)
    return done.stdout, done.stderr


class Map(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.project = str(self.folder / "one.toml")
        pathlib.Path(self.project).write_text(ONE_MASS)

    def without_limits(self):
        path = self.folder / "peaks.toml"
        path.write_text(ONE_MASS.replace('limits = {"mass.z" = "30 mm"}\n', ""))
        return str(path)

    def test_the_text_reports_region_best_design_and_cases(self):
        text = run("map", self.project, "--full")[0]
        for words in (
            "Map of 81 designs",
            "Feasible: ",
            "Best design: ",
            "no peak of mass.z",
            "good (2, 90 ms): meets every rule",
            "base model (1, 50 ms): VIOLATES",
            "poles and residues",
        ):
            self.assertIn(words, text)

    def test_json_and_csv_contain_the_same_designs(self):
        found = json.loads(run("map", self.project, "--json", "--points", "5x4")[0])
        rows = list(csv.reader(io.StringIO(run("map", self.project, "--csv", "--points", "5x4")[0])))
        self.assertEqual(
            rows[0],
            ["elements.spring.scale", "elements.spring.damping.proportional [ms]", "margin", "governing", "kept"],
        )
        self.assertEqual(len(rows), 21)
        for margin, governing, row in zip(found["grid"]["margin"], found["grid"]["governing"], rows[1:]):
            self.assertEqual(margin, None if row[2] == "inf" else float(row[2]))
            self.assertEqual(governing if governing == "none" else found["rules"][governing]["words"], row[3])
        self.assertEqual(found["kept"], sum(row[4] == "yes" for row in rows[1:]))

    def test_the_boundary_is_that_of_one_mass(self):
        found = json.loads(run("map", self.project, "--json")[0])
        points = [p for line in found["feasible"]["boundary"] for p in line]
        self.assertGreater(len(points), 8)
        for scale, milliseconds in points:
            zeta = 0.5e-3 * milliseconds * (225 * scale) ** 0.5
            rise = 1 / (2 * zeta * (1 - zeta * zeta) ** 0.5) if zeta < 0.5**0.5 else 1
            margin = min(0.03 * 900 * scale / 18 / rise, 1.01 / rise)
            self.assertAlmostEqual(margin, 1, delta=1e-4)

    def test_a_case_has_its_own_map(self):
        text = run("map", self.project, "--case", "good", "--points", "3")[0]
        self.assertIn("Map of 9 designs of case good", text)

    def refused_picture(self, target, words, **options):
        done = subprocess.run(
            [TRIVET, "map", self.project, "--points", "5", "--picture", str(target)],
            capture_output=True,
            text=True,
            timeout=HANGS_AFTER,
            **options,
        )
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn(words, done.stderr)

    def test_a_picture_overwrites_nothing_but_a_picture(self):
        drawing, note, old = self.folder / "drawing.svg", self.folder / "note.svg", self.folder / "old.svg"
        drawing.symlink_to(self.project)
        note.write_text("<html><svg></svg></html>")
        old.write_text('<?xml version="1.0"?>\n<svg xmlns="http://www.w3.org/2000/svg"/>')
        self.refused_picture(drawing, "this is the project file")
        self.refused_picture(note, "exists and is not an SVG picture; choose another name")
        self.assertEqual(
            (pathlib.Path(self.project).read_text(), note.read_text()), (ONE_MASS, "<html><svg></svg></html>")
        )
        run("map", self.project, "--points", "5", "--picture", str(old))
        self.assertIn("stiffness scale of spring", old.read_text())

    def test_a_picture_that_cannot_be_written_is_rejected_before_the_result(self):
        self.refused_picture(self.folder / "none" / "map.svg", "there is no folder")
        self.refused_picture("/proc/map.svg", "choose a folder with write permission")
        self.refused_picture("", '--picture: "": pictures are SVG; name a file that ends in .svg')

    def test_a_full_disk_keeps_the_old_picture_and_the_result(self):
        picture = self.folder / "map.svg"
        picture.write_text("<svg>old</svg>")
        limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))
        done = subprocess.run(
            [TRIVET, "map", self.project, "--picture", str(picture)],
            capture_output=True,
            text=True,
            timeout=HANGS_AFTER,
            preexec_fn=limit,
        )
        self.assertEqual(done.returncode, 1)
        self.assertIn("cannot write", done.stderr)
        self.assertIn("Best design", done.stdout)
        self.assertEqual(picture.read_text(), "<svg>old</svg>")
        self.assertEqual(sorted(os.listdir(self.folder)), ["map.svg", "one.toml"])

    def test_the_picture_is_well_formed_and_names_what_it_shows(self):
        picture = self.folder / "map.svg"
        run("map", self.project, "--picture", str(picture))
        svg = picture.read_text()
        xml.etree.ElementTree.fromstring(svg)
        for words in (
            "proportional damping δ of spring [ms]",
            "elements.spring.damping.proportional",
            "every rule is met",
            "margin = limit / value",
            "good",
            "mass.z ≤ 30 mm 0-p",
        ):
            self.assertIn(words, svg)

    def test_the_colours_of_the_rules_are_stated_and_those_of_the_picture(self):
        found = json.loads(run("map", self.project, "--json")[0])
        designs = {one["governing"]: found["grid"]["governing"].count(one["governing"]) for one in found["colours"]}
        self.assertEqual(sum(designs.values()), found["designs"])
        self.assertGreater(len(designs), 1)
        self.assertEqual(list(designs.values()), sorted(designs.values(), reverse=True))
        self.assertEqual(len({one["colour"] for one in found["colours"]}), len(designs))
        picture = self.folder / "map.svg"
        run("map", self.project, "--picture", str(picture))
        svg = picture.read_text()
        for one in found["colours"]:
            before = svg[: svg.index(">" + one["words"].replace("<", "&lt;") + "<")]
            samples = re.findall(r'width="22.00" height="13.00" fill="(#\w{6})"', before)
            self.assertEqual(samples[-1], one["colour"], one)

    def test_a_picture_is_named_svg_before_anything_is_computed(self):
        for name in ("map.png", "map", "map.svg.gz"):
            picture = self.folder / name
            for command in (("map", "no such project.toml"), ("element", "no such project.toml", "spring")):
                output, complaint = run(*command, "--picture", str(picture), code=2)
                self.assertEqual(output, "")
                self.assertIn(f"--picture: {picture}: pictures are SVG; name a file that ends in .svg", complaint)
                self.assertNotIn("no such project", complaint)
            self.assertFalse(picture.exists())

    def picture(self, *arguments):
        target = self.folder / "map.svg"
        run("map", self.project, "--picture", str(target), *arguments)
        return target.read_text()

    def test_a_picture_of_a_narrow_axis_counts_from_its_beginning(self):
        svg = self.picture("--set", "analyses.map.x.from=1", "--set", "analyses.map.x.to=1.0000000001")
        self.assertIn("stiffness scale of spring − 1<", svg)
        ticks = re.findall(r'y="[\d.]+" text-anchor="middle" fill="#333">([^<]*)<', svg)
        self.assertGreater(len(ticks), 3)
        self.assertEqual(len(ticks), len(set(ticks)))

    def test_a_picture_lists_the_warnings_of_its_map(self):
        inertia = ONE_MASS.replace(
            "mass = 4",
            'mass = 4\nallow_unphysical = true\ninertia = {about = "center_of_mass", xx = 50, yy = 2, zz = 2}',
        )
        pathlib.Path(self.project).write_text(inertia)
        words = (
            "Warning: bodies.mass: no real body has these numbers (allow_unphysical is set); every design is doubtful."
        )
        self.assertIn(words, self.picture())
        run("run", self.project, "-o", str(self.folder / "out"))
        self.assertIn(words, (self.folder / "out" / "00-base" / "map.svg").read_text())
        self.assertGreater(
            (self.folder / "out" / "report.html").read_text().count("every design is doubtful"), 2
        )  # picture, section, warnings

    def test_a_picture_names_no_case_on_the_boundary(self):
        """At the end of the boundary a label to the right of its point would be on the boundary."""
        pathlib.Path(self.project).write_text(
            ONE_MASS.replace("elements.spring.scale = 2", "elements.spring.scale = 0.6").replace('"90 ms"', '"200 ms"')
        )
        svg = self.picture()
        x, y = map(float, re.search(r'<text x="([0-9.]+)" y="([0-9.]+)"[^>]*>good<', svg).groups())
        lines = [
            [tuple(map(float, p.split(","))) for p in points.split()]
            for points in re.findall(r'points="([^"]*)" stroke="#000" stroke-width="2.4"', svg)
        ]
        steps = [
            ((1 - t) * a[0] + t * b[0], (1 - t) * a[1] + t * b[1])
            for line in lines
            for a, b in zip(line, line[1:])
            for t in (k / 50 for k in range(51))
        ]
        self.assertGreater(len(steps), 100)
        self.assertFalse([p for p in steps if x - 1 < p[0] < x + 25 and y - 10 < p[1] < y + 2])

    def test_the_picture_names_the_cases_that_it_does_not_show(self):
        pathlib.Path(self.project).write_text(
            ONE_MASS + '[cases.far]\nelements.spring.scale = 9\n[cases.heavy]\nbodies.mass.mass = 8\n'
        )
        picture = self.folder / "map.svg"
        run("map", self.project, "--picture", str(picture))
        svg = picture.read_text()
        self.assertIn("Outside the frame: far (9, 50 ms: meets every rule).", svg)
        self.assertIn("more than the two numbers: heavy (violates a rule).", svg)

    def test_the_picture_shows_the_nearest_design_if_none_is_feasible(self):
        picture = self.folder / "map.svg"
        text = run(
            "map", self.project, "--set", "analyses.map.limits={\"mass.z\"=\"1 mm\"}", "--picture", str(picture)
        )[0]
        self.assertIn("No design is feasible; the nearest: ", text)
        self.assertIn("nearest design: margin 0.2", picture.read_text())

    def test_the_headline_names_only_existing_rules(self):
        both = run("map", self.project)[0]
        peaks = run("map", self.without_limits())[0]
        amplitudes = run("map", self.project, "--set", "analyses.map.no_peak=[]")[0]
        self.assertTrue("amplitudes over" in both and "resonance peaks" in both)
        self.assertTrue("amplitudes over" not in peaks and "resonance peaks" in peaks)
        self.assertTrue("amplitudes over" in amplitudes and "resonance peaks" not in amplitudes)

    def test_picture_and_report_state_the_analysis(self):
        request = "amplitudes over all frequencies; resonance peaks at all frequencies, from 1 % above the adjacent minimum (rises below 1e-06 of the curve maximum are ignored)"
        out = self.folder / "out"
        self.assertIn(request, run("run", self.project, "-o", str(out), "--full")[0])
        self.assertIn("Criteria: " + request, (out / "00-base" / "map.svg").read_text())
        report = (out / "report.html").read_text()
        self.assertGreater(report.count("Criteria: " + request), 1)  # section and picture

    def test_text_and_report_name_axes_and_order_rules_alike(self):
        out = self.folder / "out"
        text = run("run", self.project, "-o", str(out), "--full")[0]
        report = (out / "report.html").read_text()
        best = re.search("Best design: .*", text).group()
        self.assertTrue(best.startswith("Best design: stiffness scale of spring = 4, "), best)
        self.assertIn(best, report)
        pathlib.Path(self.project).write_text(
            ONE_MASS.replace("30 mm", "1 m").replace("300 ms", "60 ms")
        )  # now peaks govern most designs
        text = run("run", self.project, "-o", str(self.folder / "wide"), "--full")[0]
        report = (self.folder / "wide" / "report.html").read_text()
        for page in (text, report):
            table = page[page.index("governs, feasible") :]
            self.assertLess(table.index("no peak of mass.z"), table.index("mass.z ≤ 1 m"))

    def test_nothing_moves_without_a_load(self):
        still = ("--set", "excitations.force.force=[0,0,0]", "--set", "analyses.map.no_peak=[]")
        self.assertIn("no rule limits them: no motion", run("map", self.project, *still)[0])
        svg = self.picture(*still)
        self.assertIn("no rule limits it: no motion", svg)

    def test_numbers_of_lines_have_a_background_above_all_lines(self):
        svg = self.picture()
        lines = [m.start() for m in re.finditer('stroke-dasharray="4,3"', svg[: svg.index("margin = limit / value")])][
            :-1
        ]  # the last is in the legend
        grounds = [m.start() for m in re.finditer('rx="3" fill="white"', svg)]
        self.assertGreater(len(grounds), 0)
        self.assertGreater(min(grounds), max(lines))

    def test_lines_below_one_lead_to_the_nearest_design(self):
        svg = self.picture("--set", "analyses.map.limits={\"mass.z\"=\"4 mm\"}")
        self.assertIn("nearest design: margin 0.8", svg)
        self.assertRegex(svg, 'font-size="10">0[.]5<')
        self.assertNotIn("clipPath", svg)  # no design is feasible

    def test_a_coarse_grid_is_called_coarse(self):
        self.assertIn("a feasible region narrower than 25 % of an axis", run("map", self.project, "--points", "5")[0])
        self.assertNotIn("coarse", run("map", self.project, "--points", "21")[0])

    def test_the_best_of_designs_without_bound_is_in_their_middle(self):
        found = json.loads(run("map", self.without_limits(), "--points", "41", "--json")[0])
        self.assertIsNone(found["best"]["margin"])
        self.assertGreater(found["best"]["without_bound"], 500)
        self.assertGreater(found["best"]["x"], 1.5)
        self.assertGreater(found["best"]["y"], 150)
        self.assertLess(found["best"]["y"], 280)
        self.assertEqual(found["grid"]["governing"].count("none"), found["best"]["without_bound"])

    def test_a_case_that_asks_for_another_map_has_it_in_the_run(self):
        pathlib.Path(self.project).write_text(ONE_MASS + '[cases.strict]\nanalyses.map.limits = {"mass.z" = "12 mm"}\n')
        out = self.folder / "out"
        text = run("run", self.project, "-o", str(out), "--full")[0]
        self.assertIn("Map of 81 designs of case strict", text)
        cases = {c["name"]: c for c in json.loads((out / "results.json").read_text())["cases"]}
        self.assertNotIn("map", cases["good"])
        self.assertEqual(cases["strict"]["map"]["rules"][0]["allowed"], 0.012)
        self.assertTrue((out / "02-strict" / "map.svg").exists())

    def test_a_run_contains_map_table_picture_and_section(self):
        out = self.folder / "out"
        text = run("run", self.project, "-o", str(out), "--full")[0]
        self.assertIn("Map of 81 designs", text)
        self.assertTrue((out / "00-base" / "map.csv").exists())
        xml.etree.ElementTree.parse(out / "00-base" / "map.svg")
        results = json.loads((out / "results.json").read_text())
        self.assertEqual(results["cases"][0]["map"]["designs"], 81)
        self.assertNotIn("map", results["cases"][1])
        self.assertIn("Map of designs", (out / "report.html").read_text())

    def test_the_same_input_gives_the_same_bytes(self):
        self.assertEqual(run("map", self.project, "--json")[0], run("map", self.project, "--json")[0])

    def test_what_cannot_be_mapped_is_reported(self):
        self.assertIn("add map = ", run("map", str(SOURCE / "examples/paper/corrected.toml"), code=2)[1])
        for points in ("1", "0x5", "axb", "5x", "100000x100000", "-3x4"):
            self.assertIn("--points", run("map", self.project, "--points", points, code=2)[1])
        self.assertIn(
            "as in 200x150, or one number for both, each 2 or more",
            run("map", self.project, "--points", "0x0", code=2)[1],
        )
        impossible = (
            "--set",
            "analyses.map.x.parameter=\"bodies.mass.mass\"",
            "--set",
            "analyses.map.x.from=-4",
            "--set",
            "analyses.map.x.to=-1",
        )
        self.assertIn("none of the 81 designs", run("map", self.project, *impossible, code=1)[1])

    def test_no_figure_of_the_paper_is_feasible_for_the_corrected_body(self):
        found = json.loads(run("map", PAPER, "--json", "--points", "3x3")[0])
        figures = {m["case"]: m for m in found["marks"]}
        for name in ("Figure 3", "Figure 4", "Figure 5", "Figure 6", "Figure 7", "Figure 8"):
            self.assertFalse(figures[name]["kept"], name)
            self.assertTrue(figures[name]["of_this_model"], name)
        rise = {rule["words"]: rule["value"] for rule in figures["Figure 7"]["rules"]}
        self.assertGreater(rise["no peak of aggregate.rz"], 0.9)  # the paper: a slight rise of θz only


if __name__ == "__main__":
    unittest.main()
