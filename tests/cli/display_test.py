# SPDX-License-Identifier: BSD-3-Clause
"""[display]: units and level of tables and pictures; data files stay in SI."""
import json
import math
import re

from trivet_test import SOURCE, InTemporaryFolder, result_of, trivet

MACHINE = """trivet = 1
gravity = [0, 0, -9.81]
[bodies.machine]
mass = 40
inertia = {about = "center_of_mass", xx = 2, yy = 2, zz = 2}
free = ["z", "ry"]
[elements.mount]
type = "bushing"
on = "machine"
at = [0.05, 0, 0]
translation = [2e5, 2e5, 2.5e5]
rotation = [5e3, 5e3, 5e3]
damping = {proportional = "1.2 ms"}
[excitations.push]
type = "harmonic"
on = "machine"
at = [0.1, 0, 0]
force = [0, 0, 30]
[excitations.road]
type = "random"
base = true
translation = [0, 0, 1]
psd = {road = "C", speed = "80 km/h"}
[excitations.shock]
type = "time"
base = true
quantity = "acceleration"
translation = [0, 0, 1]
history = {half_sine = {amplitude = "5 g", duration = "11 ms"}}
[limits]
"machine.z" = "1 mm"
[requirements]
limits = {"ground.force.z" = "60 N"}
static = {"machine.z" = "3 mm"}
[analyses]
modes = {}
response = {of = ["machine", "ground.force.z"], band = ["2 Hz", "40 Hz"], spacing = "linear", points = 20}
peaks = {}
static = {}
random = {}
transient = {to = "1 s"}
"""
DISPLAY = """[display]
length = "in"
force = "lbf"
angle = "deg"
frequency = "rpm"
level = "peak_to_peak"
"""
INCH, POUND, RPM = 0.0254, 4.4482216152605, 2 * math.pi / 60


def table(text, first):
    """Rows of the table whose header begins with this word, by heading."""
    lines = text.splitlines()
    start = next(i for i, line in enumerate(lines) if line.strip().startswith(first))
    split = lambda line: re.split(r" {2,}", line.strip())
    rows = []
    for line in lines[start + 1 :]:
        if len(split(lines[start])) - len(split(line)) not in (0, 1):  # the last cell, a remark, may be empty
            break
        rows.append(dict(zip(split(lines[start]), split(line), strict=False)))
    return rows


def without_words(text):
    """JSON without what it says to a reader in the words of the tables: that follows [display]."""
    return re.sub(r'"shown_(?:requirement|value)": "[^"]*"', "", text)


class Display(InTemporaryFolder):
    def setUp(self):
        super().setUp()
        self.si = self.file(MACHINE, "si.toml")
        self.shown = self.file(MACHINE + DISPLAY, "shown.toml")

    def near(self, cell, value, digits=5):
        self.assertAlmostEqual(float(cell.split()[0]) / value, 1, delta=10 ** (1 - digits))

    def test_numbers_on_the_screen_are_the_si_numbers_times_their_factors(self):
        shown = trivet("response", self.shown).stdout
        self.assertIn("Amplitude and phase (a lag is negative)", shown)
        data = result_of("response", self.si)
        size = lambda name, i: math.hypot(*next(c for c in data["results"] if c["name"] == name)["complex"][i])
        for i, row in enumerate(table(shown, "f [rpm]")):
            self.near(row["f [rpm]"], data["angular_frequency"][i] / RPM)
            self.near(row["|machine.z| [in p-p]"], 2 * size("machine.z", i) / INCH)
            self.near(row["|machine.ry| [deg p-p]"], 2 * math.degrees(size("machine.ry", i)))
        peak, row = result_of("peaks", self.si)["peaks"][0], table(trivet("peaks", self.shown).stdout, "curve")[0]
        self.near(row["amplitude"], 2 * peak["amplitude"] / INCH)
        self.near(row["f [rpm]"], peak["angular_frequency"] / RPM)
        self.assertTrue(row["amplitude"].endswith(" in p-p"))

    def test_values_at_rest_in_time_and_rms_have_no_level(self):
        shown = trivet("static", self.shown).stdout
        units = {
            "m": ("in", 1 / INCH),
            "N": ("lbf", 1 / POUND),
            "rad": ("deg", 180 / math.pi),
            "N m": ("lbf in", 1 / (POUND * INCH)),
        }
        for value in result_of("static", self.si)["results"]:
            first = "forces of" if value["unit"].startswith("N") else "body or point"
            place, component = re.fullmatch(r"(.*?)\.((?:force\.|moment\.)?\w+)", value["name"]).groups()
            row = next(row for row in table(shown, first) if row[first] == place)
            unit, factor = units[value["unit"]]
            cell = row[f"{component} [{unit}]"]
            if abs(value["value"]) > 1e-6:
                self.near(cell, value["value"] * factor)
        for name, key, number in (
            ("random", "rms", lambda r: r["rms"]),
            ("transient", "largest", lambda r: r["largest"]["value"]),
        ):
            first = result_of(name, self.si)["results"][0]
            row = table(trivet(name, self.shown).stdout, "result")[0]
            self.assertEqual((first["unit"], row[key].split()[1]), ("m", "in"))
            self.near(row[key], number(first) / INCH)

    def test_the_stiffness_of_an_element_has_the_units_of_loads_and_motions(self):
        text = trivet("element", self.shown, "mount").stdout
        row = table(text, "end   load")[2]
        self.near(row["N u_z [in]"], 2.5e5 * INCH / POUND)
        row = table(text, "end   load")[4]
        self.assertEqual(row["load"], "M_y [lbf in]")
        self.near(row["N θ_y [deg]"], 5e3 / (POUND * INCH) * math.pi / 180)
        self.assertIn(f"{2.5e5 * INCH / POUND:.6g} lbf/in", text)

    def test_limits_are_at_the_level_of_what_they_limit(self):
        row = table(trivet("response", self.shown).stdout, "limit on")[0]
        self.near(row["allowed"], 2 * 0.001 / INCH)
        self.assertTrue(row["allowed"].endswith(" in p-p"))
        verdict = trivet("verdict", self.shown).stdout
        self.assertIn("ground.force.z ≤ 26.98 lbf p-p", verdict)
        self.assertIn("machine.z ≤ 0.1181 in ", verdict)
        self.assertEqual(
            [r["margin"] for r in result_of("verdict", self.shown)["cases"][0]["requirements"]],
            [r["margin"] for r in result_of("verdict", self.si)["cases"][0]["requirements"]],
        )

    def test_bands_of_requirements_are_in_its_frequency(self):
        required = """[requirements]
limits = {"ground.force.z" = {limit = "60 N", band = ["10 Hz", "20 Hz"]}}
natural_frequencies = {avoid = [["30 Hz", "35 Hz"]]}
isolation = {force = "push", at = ["40 Hz", "50 Hz"], least = "20 %"}
"""
        machine = MACHINE.split("[requirements]")[0] + required
        shown = trivet("verdict", self.file(machine + DISPLAY, "bands.toml")).stdout
        for words in ("in 600 … 1200 rpm", "no natural frequency in 1800 … 2100 rpm", "at 2400 rpm", "at 3000 rpm"):
            self.assertIn(words, shown)
        plain = trivet("verdict", self.file(machine, "hertz.toml")).stdout
        for words in ("in 10 … 20 Hz", "no natural frequency in 30 … 35 Hz", "≥ 20 % at 40 Hz"):
            self.assertIn(words, plain)

    def test_json_and_csv_stay_in_si(self):
        for analysis in ("modes", "response", "peaks", "static", "random", "transient", "verdict"):
            for form in ("--json", "--csv"):
                shown = trivet(analysis, self.shown, form).stdout.replace("shown.toml", "si.toml")
                self.assertTrue(shown)
                self.assertEqual(without_words(shown), without_words(trivet(analysis, self.si, form).stdout))
        folders = {}
        for path in (self.si, self.shown):
            trivet("run", path, "-o", self.folder / path.stem)
            folders[path] = {p.name: p.read_bytes() for p in sorted((self.folder / path.stem).rglob("*.csv"))}
        self.assertEqual(*folders.values())
        results = [json.loads((self.folder / path.stem / "results.json").read_text()) for path in (self.si, self.shown)]
        for one in results:
            del one["input"]
        shown = json.dumps(results[1]).replace("shown.toml", "si.toml")
        self.assertEqual(without_words(json.dumps(results[0])), without_words(shown))

    def test_the_report_and_its_figures_name_unit_and_level(self):
        trivet("run", self.shown, "-o", self.folder / "out")
        page = (self.folder / "out/report.html").read_text()
        for words in ("Amplitudes are peak-to-peak", "f [rpm]", "in\u00a0p-p", "those of [display]", "in²/Hz"):
            self.assertIn(words.replace("\u00a0", " "), page.replace("\u00a0", " "), words)
        self.assertNotIn("Everything is in SI units", page)
        drawing = json.loads(re.search(r'id="drawing">(.*?)</script>', page, re.DOTALL)[1])
        self.assertAlmostEqual(drawing["units"]["m"]["factor"], 2 / INCH)
        self.assertEqual(drawing["units"]["m"]["multiples"], [[1, "in p-p"]])
        self.assertEqual(drawing["frequency"]["unit"], "rpm")
        figures = "".join(path.read_text() for path in (self.folder / "out").rglob("*.svg"))
        for label in ("displacement [in p-p]", "f [rpm]", "displacement [in]", "displacement density [in²/Hz]"):
            self.assertIn(label, figures)
        plain = trivet("run", self.si, "-o", self.folder / "plain")
        self.assertEqual(plain.returncode, 0, plain.stderr)
        page = (self.folder / "plain/report.html").read_text()
        for words in ("Everything is in SI units", "zero-to-peak", "ω [rad/s]"):
            self.assertIn(words, page)

    def test_cases_and_the_command_line_may_change_it(self):
        text = trivet("response", self.si, "--set", "display.length=mm", "--set", "display.level=rms").stdout
        self.assertIn("|machine.z| [mm rms]", text)
        self.assertIn("(a lag is negative)", text)
        cases = self.file(MACHINE + DISPLAY + "[cases.metric.display]\nlength = \"mm\"\n", "cases.toml")
        self.assertIn("|machine.z| [mm p-p]", trivet("response", cases, "--case", "metric").stdout)

    def test_the_default_written_out_changes_nothing(self):
        written = self.file(MACHINE + '[display]\nlength = "m"\nlevel = "amplitude"\n', "written.toml")
        for analysis in ("modes", "response", "peaks", "static", "random", "transient", "verdict", "suspension"):
            shown = trivet(analysis, written).stdout.replace(str(written), str(self.si))  # warnings name the file
            self.assertEqual(shown, trivet(analysis, self.si).stdout)

    def test_mistakes_name_place_and_remedy(self):
        done = trivet("check", SOURCE / "tests/bad/display_several_mistakes.toml")
        self.assertEqual(done.returncode, 2)
        self.assertIn('did you mean "peak_to_peak"?', done.stderr)
        self.assertIn('did you mean "frequency"?', done.stderr)
