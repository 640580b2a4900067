# SPDX-License-Identifier: BSD-3-Clause
"""The design under the point of a map in a report: its verdict is that of the map, its curves are those of the program."""
import base64
import cmath
import json
import os
import pathlib
import re
import shutil
import struct
import subprocess
import tempfile
import unittest

from trivet_test import HANGS_AFTER

TRIVET = os.environ["TRIVET"]
SOURCE = pathlib.Path(os.environ.get("TRIVET_SOURCE", pathlib.Path(__file__).parents[2]))
BROWSER = os.environ.get("TRIVET_BROWSER") or shutil.which("chromium") or shutil.which("google-chrome")
SCRIPTS = re.compile("<script.*?</script>", re.DOTALL)
LARGEST_REPORT = 5_000_000  # bytes
WITHIN = 1e-4  # of the program's curves

BLOCK = """
trivet = 1
[bodies.block]
mass = 40
inertia = {about = "pole", xx = 2, yy = 3, zz = 4}
[elements.left]
type = "bushing"
on = "block"
at = [0.4, 0.1, -0.3]
translation = [3e4, 4e4, 6e4]
damping = DAMPING
[elements.right]
type = "bushing"
on = "block"
at = [-0.4, 0.2, -0.3]
translation = [5e4, 3e4, 7e4]
rotation = [400, 300, 500]
damping = {proportional = 0.004}
[excitations.drive]
EXCITATION
[analyses]
response = {RESPONSE}
[analyses.map]
x = {parameter = "elements.left.scale", from = 0.5, to = 4, points = 9, spacing = "logarithmic"}
y = {parameter = "bodies.block.mass", name = "mass", from = 30, to = 60, points = 5}
limits = {"block.z" = "100 mm"}
"""
FORCE = 'type = "harmonic"\non = "block"\nat = [0.1, 0, 0.2]\nforce = [10, 4, 7]'
UNBALANCE = 'type = "unbalance"\non = "block"\nat = [0.1, 0, 0.2]\naxis = "y"\nmass_eccentricity = "0.002 kg m"'
SHAKEN = 'type = "base"\ntranslation = [0, 0.3, 1]\nquantity = "acceleration"'


def block(damping="{proportional = 0.002}", excitation=FORCE, response="band = [0, 120]"):
    text = BLOCK.replace("DAMPING", damping).replace("EXCITATION", excitation).replace("RESPONSE", response)
    return text


def numbers(text, kind):
    data = base64.b64decode(text)
    return [value for (value,) in struct.iter_unpack("<" + kind, data)]


class Designs:
    """The stored designs of a map: the same formula as that of the page, written again."""

    def __init__(self, stored):
        self.stored, curves = stored, stored["curves"]
        self.names = [result["name"] for result in curves["results"]]
        self.parts = 1 if curves["real"] else 2
        self.denominators = self.complex(numbers(curves["denominators"], "d"))
        self.numerators = self.complex(numbers(curves["numerators"], "f" if curves["rounded"] else "d"))
        self.drawn = numbers(curves["drawn"], "B")
        self.margins = numbers(stored["margins"], "f")
        self.governing = numbers(stored["governing"], "B")

    def complex(self, values):
        return values if self.parts == 1 else [complex(*pair) for pair in zip(values[::2], values[1::2])]

    def at(self, design, omega):
        """Complex amplitudes of all curves."""
        curves, s = self.stored["curves"], 1j * omega
        pairs, powers = curves["pairs"], curves["powers"]
        terms, count = 2 * pairs + len(powers), len(self.names)
        den = self.denominators[design * 2 * pairs :][: 2 * pairs]
        num = self.numerators[design * len(curves["delays"]) * count * terms :]
        found = [0] * count
        for d, delay in enumerate(curves["delays"]):
            for c in range(count):
                own = num[(d * count + c) * terms :][:terms]
                value = sum(
                    (own[2 * k] + own[2 * k + 1] * s) / (den[2 * k] + den[2 * k + 1] * s + s * s) for k in range(pairs)
                )
                value += sum(own[2 * pairs + m] * s**power for m, power in enumerate(powers))
                found[c] += cmath.exp(-s * delay) * value
        return found


class Folder(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def write(self, text):
        project = self.folder / "machine.toml"
        project.write_text(text)
        return project

    def report(self, project):
        out = self.folder / "out"
        subprocess.run(
            [TRIVET, "run", str(project), "-o", str(out)], check=True, capture_output=True, timeout=HANGS_AFTER
        )
        return out / "report.html"

    def stored(self, report):
        found = re.search('<script type="application/json" id="designs">(.*?)</script>', report.read_text(), re.DOTALL)
        return json.loads(found.group(1))

    def command(self, *words):
        done = subprocess.run(
            [TRIVET, *map(str, words), "--json"], check=True, capture_output=True, timeout=HANGS_AFTER
        )
        return json.loads(done.stdout)


class StoredDesigns(Folder):
    def check_curves(self, project, designs):
        """Curves of designs at the corners, at the start and in the middle, against the command line."""
        x, y = designs.stored["x"], designs.stored["y"]
        nx, ny = len(x["values"]), len(y["values"])
        i, j = designs.stored["start"]
        omega = [2.5, 13.0, 31.7, 47.1, 66.0, 88.8, 119.0]
        worst = 0
        for column, row in ((0, 0), (nx - 1, 0), (0, ny - 1), (nx - 1, ny - 1), (i, j), (nx // 2, ny // 3)):
            settings = [f"{x['parameter']}={x['values'][column]!r}", f"{y['parameter']}={y['values'][row]!r}"]
            words = [word for setting in settings for word in ("--set", setting)]
            at = ",".join(f"{w} rad/s" for w in omega)
            results = self.command("response", project, *words, "--at", at)["results"]
            self.assertEqual([result["name"] for result in results], designs.names)
            node = row * nx + column
            self.assertEqual(designs.drawn[node], 1)
            found = [designs.at(node, w) for w in omega]
            for c, result in enumerate(results):
                truth = [complex(*value) for value in result["complex"]]
                top = max(map(abs, truth))
                for one, value in zip((values[c] for values in found), truth):
                    worst = max(worst, abs(one - value) / max(abs(value), 1e-6 * top))
        self.assertLess(worst, designs.stored["curves"]["error"] * 10 + 1e-8)
        self.assertLess(worst, WITHIN)

    def check_verdicts(self, project, designs):
        grid = self.command("map", project)["grid"]
        x, y = designs.stored["x"], designs.stored["y"]
        for row, up in enumerate(y["shares"]):
            for column, across in enumerate(x["shares"]):
                full = round(up * (y["points"] - 1)) * x["points"] + round(across * (x["points"] - 1))
                node = row * len(x["values"]) + column
                self.assertAlmostEqual(designs.margins[node] / grid["margin"][full], 1, 6)
                self.assertEqual(designs.governing[node], grid["governing"][full])

    def check(self, text):
        project = self.write(text)
        designs = Designs(self.stored(self.report(project))[0])
        self.check_curves(project, designs)
        self.check_verdicts(project, designs)
        return designs

    def test_viscous_damping(self):
        designs = self.check(block())
        self.assertTrue(designs.stored["curves"]["rounded"])
        self.assertEqual(len(designs.margins), 45)

    def test_loss_factors_and_forces_on_the_ground(self):
        self.check(block("{loss_factor = 0.1}", response='band = [0, 120], of = ["coordinates", "ground"]'))

    def test_a_rotating_unbalance_and_accelerations(self):
        self.check(block(excitation=UNBALANCE, response='band = [0, 120], quantity = "acceleration"'))

    def test_a_moving_ground_and_relative_motions(self):
        self.check(block(excitation=SHAKEN, response='band = [2, 120], of = ["block", "block.relative"]'))

    def test_a_force_that_arrives_with_a_delay(self):
        self.check(block(excitation=FORCE + '\ndelay = "20 ms"'))

    def test_the_map_of_the_paper_fits_a_mail(self):
        report = self.report(SOURCE / "examples/paper/map.toml")
        self.assertLess(report.stat().st_size, LARGEST_REPORT)
        designs = Designs(self.stored(report)[0])
        self.assertGreaterEqual(len(designs.drawn), 2000)
        self.assertEqual(set(designs.drawn), {1})
        self.check_curves(SOURCE / "examples/paper/map.toml", designs)

    def test_without_poles_the_verdicts_alone_are_stored(self):
        project = self.write(block('{fractional_zener = {ratio = 2, time = "10 ms", order = 0.5}}'))
        stored = self.stored(self.report(project))[0]
        self.assertNotIn("curves", stored)
        self.assertIn("depends on frequency", stored["reason"])
        self.assertEqual(len(numbers(stored["margins"], "f")), len(stored["x"]["values"]) * len(stored["y"]["values"]))

    def test_a_report_without_a_map_and_the_short_form_have_no_point(self):
        text = block()
        report = self.report(self.write(text[: text.index("[analyses.map]")]))
        self.assertNotIn('id="designs"', report.read_text())
        out = self.folder / "short"
        words = [TRIVET, "run", str(self.write(text)), "-o", str(out), "--report", "short"]
        subprocess.run(words, check=True, capture_output=True, timeout=HANGS_AFTER)
        self.assertNotIn('id="designs"', (out / "report.html").read_text())


@unittest.skipUnless(BROWSER, "no browser")
class Browser(Folder):
    def seen(self, report, view):
        arguments = [BROWSER, "--headless", "--no-sandbox", "--disable-gpu", "--disable-3d-apis"]
        arguments += ["--disable-background-networking"]
        arguments += ["--enable-logging=stderr", "--window-size=1280,8000", "--virtual-time-budget=5000"]
        arguments += [f"--user-data-dir={self.folder}/profile", "--dump-dom", report.as_uri() + view]
        done = subprocess.run(arguments, check=True, capture_output=True, text=True, timeout=HANGS_AFTER)
        self.assertEqual(re.findall("CONSOLE.*", done.stderr), [], view)
        return SCRIPTS.sub("", done.stdout)

    def test_the_design_in_the_address_is_shown_with_its_verdict_and_curves(self):
        report = self.report(self.write(block()))
        designs = Designs(self.stored(report)[0])
        for column, row in ((0, 0), (8, 4)):
            page = self.seen(report, f"#design={column},{row}")
            verdict = re.search('<p class="verdict" role="status">(.*?)</p>', page).group(1)
            for axis, place in (("x", column), ("y", row)):
                self.assertIn(designs.stored[axis]["words"][place], verdict)
            margin = designs.margins[row * 9 + column]
            self.assertIn("✓ met" if margin >= 1 else "✗ VIOLATED", verdict)
            self.assertIn(f"margin {margin:.4g}", verdict)
            view = page[page.index('class="design-curves"') : page.index('<p class="below hint">')]
            self.assertEqual(view.count("<canvas"), 2)  # translations and rotations
            self.assertIn('class="peak"', view)


if __name__ == "__main__":
    unittest.main()
