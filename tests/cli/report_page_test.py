# SPDX-License-Identifier: BSD-3-Clause
"""Content of a report page after its script has run, in a browser if one is installed."""
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

from trivet_test import HANGS_AFTER

TRIVET = os.environ["TRIVET"]
SOURCE = pathlib.Path(os.environ.get("TRIVET_SOURCE", pathlib.Path(__file__).parents[2]))
BROWSER = os.environ.get("TRIVET_BROWSER") or shutil.which("chromium") or shutil.which("google-chrome")

MACHINE = """
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
[limits]
"mass.z" = "LIMIT"
[analyses]
modes = {}
peaks = {}
response = {band = [0, "40 rad/s"]}
[analyses.map]
x = {parameter = "elements.spring.scale", from = 0.5, to = 4, points = 5}
y = {parameter = "elements.spring.damping.proportional", from = 0.01, to = 0.3, points = 5}
[cases.stiff]
elements.spring.scale = 3
[cases.strict]
elements.spring.scale = 2
analyses.map.limits = {"mass.z" = "1 mm"}
"""
WITH_FORCES = MACHINE.replace('band = [0, "40 rad/s"]', 'band = [0, "40 rad/s"], of = ["coordinates", "ground"]')
# What a reader does not see.
SCRIPTS = re.compile("<script.*?</script>", re.DOTALL)


class Folder(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def report(self, limit="12 mm", text=MACHINE):
        """Path of a new report."""
        project, out = self.folder / "machine.toml", self.folder / f"out {limit}"
        project.write_text(text.replace("LIMIT", limit))
        subprocess.run(
            [TRIVET, "run", str(project), "-o", str(out)], check=True, capture_output=True, timeout=HANGS_AFTER
        )
        return out / "report.html"


class Page(Folder):
    """Text that is there without a browser."""

    def test_the_page_is_calm_only_if_limits_and_maps_are_met(self):
        text = MACHINE[: MACHINE.index("[cases.strict]")]
        kept, broken, own_map = (
            SCRIPTS.sub("", self.report(*given).read_text()) for given in (("1 m", text), ("12 mm", text), ("1 m",))
        )
        self.assertIn("No warnings; all checks of the data passed in all cases.", kept)
        self.assertIn('class="calm" role="note"><h2>✓ MET: 2 of 2 limits, 2 of 2 verdicts of a map</h2>', kept)
        for page in (broken, own_map):
            self.assertIn('<div class="alert" role="note"><h2>✗ VIOLATED:', page)
            self.assertNotIn('class="calm"', page)
            self.assertNotIn("✓ No warnings", page)

    def test_the_overview_reports_the_verdicts_of_the_map(self):
        overview = re.search('<section class="glance">.*?</table>', self.report().read_text(), re.DOTALL).group()
        self.assertIn("rules of the map", overview)
        verdicts = [re.findall("[✓✗] ([^<]*)<", row)[-1] for row in overview.split("<tr")[2:]]
        self.assertEqual(verdicts, ["VIOLATED", "met", "VIOLATED (own map)"])

    def test_a_response_at_few_frequencies_is_also_a_table(self):
        text = MACHINE.replace('band = [0, "40 rad/s"]', 'at = ["10 rad/s", "20 rad/s"]')
        self.assertIn(
            "<summary>Amplitude and phase (a lag is negative)</summary>",
            self.report(text=text).read_text(),
        )

    def test_the_scripts_have_no_colours_of_curves_and_short_lines(self):
        scripts = list((SOURCE / "web/src/report").rglob("*.[jt]s"))
        self.assertTrue(scripts)
        for script in scripts:
            text = script.read_text()
            self.assertLessEqual(max(map(len, text.splitlines())), 160, script)
            self.assertLess(len(text.splitlines()), 500, script)
            for colour in ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00"):
                self.assertNotIn(colour.lower(), text.lower(), script)


@unittest.skipUnless(BROWSER, "no browser")
class Browser(Folder):
    def seen(self, report, view=""):
        """The page after its scripts have run, in a window that is higher than the page."""
        arguments = [
            BROWSER,
            "--headless",
            "--no-sandbox",
            "--disable-gpu",
            "--disable-3d-apis",  # the machine in 3D is tested in tests/page
            "--disable-background-networking",
            "--enable-logging=stderr",
            "--window-size=1280,8000",
            "--virtual-time-budget=5000",
            f"--user-data-dir={self.folder}/profile",
            "--dump-dom",
            report.as_uri() + view,
        ]
        done = subprocess.run(arguments, check=True, capture_output=True, text=True, timeout=HANGS_AFTER)
        self.assertEqual(re.findall("CONSOLE.*", done.stderr), [], view)
        return SCRIPTS.sub("", done.stdout)

    def test_every_view_has_its_charts_and_no_error(self):
        report = self.report(text=WITH_FORCES)
        for view in (
            "",
            "#ylog&xlog&hz",
            "#case=1&zoom=5,20",
            "#xlog&zoom=14,16",
            "#hide=mass.z",
            "#compare=ground.force.z&ylog",
        ):
            page = self.seen(report, view)
            # Amplitude and phase of motion and of forces and moments on the ground, the comparison of the cases, and
            # the design under the point of the map of the base model.
            self.assertEqual(page.count("<canvas"), 7 if "case=1" in view else 8, view)
            self.assertRegex(page, "max [0-9.]+ mm", view)

    def test_the_selected_case_is_shown_and_the_others_are_hidden(self):
        page = self.seen(self.report(), "#case=2")
        self.assertEqual(page.count('<div data-case="2">'), 3)
        self.assertEqual(page.count('<div data-case="0" hidden="">'), 3)

    def test_marks_have_their_numbers(self):
        page = self.seen(self.report())
        for mark in (
            'class="peak"[^>]*title="peak of z: [0-9.]+ mm 0-p\n2.[0-9]+ Hz',
            'class="mode"[^>]*title="mode 1, 2.38732 Hz',
            "<b>limit z 12 mm 0-p</b>",
        ):
            self.assertTrue(re.search(mark, page), mark)


if __name__ == "__main__":
    unittest.main()
