# SPDX-License-Identifier: BSD-3-Clause
"""Content of a report page after its script has run, in a browser if one is installed."""
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

TRIVET = os.environ["TRIVET"]
BROWSER = shutil.which("chromium") or shutil.which("google-chrome")

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
response = {band = [0, 40]}
[analyses.map]
x = {parameter = "elements.spring.scale", from = 0.5, to = 4, points = 5}
y = {parameter = "elements.spring.damping.proportional", from = 0.01, to = 0.3, points = 5}
[cases.stiff]
elements.spring.scale = 3
[cases.strict]
elements.spring.scale = 2
analyses.map.limits = {"mass.z" = "1 mm"}
"""


@unittest.skipUnless(BROWSER, "no browser")
class ReportPage(unittest.TestCase):
    def page(self, limit):
        with tempfile.TemporaryDirectory() as folder:
            project, out = pathlib.Path(folder) / "machine.toml", pathlib.Path(folder) / "out"
            project.write_text(MACHINE.replace("LIMIT", limit))
            subprocess.run([TRIVET, "run", str(project), "-o", str(out)], check=True, capture_output=True, timeout=300)
            view = [BROWSER, "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={folder}/profile", "--dump-dom", (out / "report.html").as_uri()]
            page = subprocess.run(view, check=True, capture_output=True, text=True, timeout=300).stdout
            return re.sub("<script.*?</script>", "", page, flags=re.DOTALL)

    def test_the_page_is_calm_only_if_limits_are_met(self):
        kept, broken = self.page("1 m"), self.page("12 mm")
        self.assertRegex(kept, '<p class="calm">✓ No warnings; all checks of the data passed in all cases.</p>')
        self.assertNotIn("Limits are exceeded", kept)
        self.assertIn("Limits are exceeded: </span>Base model (1 of 1); see below.", broken)
        self.assertNotIn('class="calm"', broken)

    def test_the_overview_reports_the_verdicts_of_the_map(self):
        overview = re.search('<[^>]*id="cases".*?</table>', self.page("12 mm"), re.DOTALL).group()
        self.assertIn("rules of the map", overview)
        verdicts = [re.findall("[✓✗] ([^<]*)<", row)[-1] for row in overview.split("<tr")[2:]]
        self.assertEqual(verdicts, ["VIOLATED", "met", "VIOLATED (own map)"])


if __name__ == "__main__":
    unittest.main()
