# SPDX-License-Identifier: BSD-3-Clause
"""Every analysis is a separate command with the same result as `run`."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

TRIVET = os.environ["TRIVET"]
EXAMPLES = sorted((pathlib.Path(os.environ["TRIVET_SOURCE"]) / "examples").glob("*/*.toml"))
WIDEST = 150  # characters of a line on the screen
TABLES = {"random": ["random", "densities"], "orders": ["orders", "critical_speeds"]}

MACHINE = """trivet = 1
[bodies.device]
mass = 40
inertia = {about = "center_of_mass", xx = 1, yy = 1.2, zz = 0.9}
[element_types.mount]
type = "bushing"
translation = [2e4, 2e4, 3e4]
damping = {proportional = 1e-3}
laws.z = {cubic = 1e8}
[tables.elements]
rows = [
  {name = "a", type = "mount", on = "device", at = [0.2, 0.2, 0]},
  {name = "b", type = "mount", on = "device", at = [0.2, -0.2, 0]},
  {name = "c", type = "mount", on = "device", at = [-0.2, 0.2, 0]},
  {name = "d", type = "mount", on = "device", at = [-0.2, -0.2, 0.01]},
]
[excitations.motor]
type = "harmonic"
on = "device"
at = [0, 0, 0.1]
force = [0, 3, 10]
[excitations.drop]
type = "time"
base = true
translation = [0, 0, 1]
quantity = "acceleration"
history = {half_sine = {amplitude = "10 g", duration = "11 ms"}}
[limit_lines.severity]
of = "device.z"
rows = [[2, 1e-3], [40, 1e-3]]
[measurements.shaker]
file = "shaker.csv"
force = "motor"
[operation]
speeds = ["600 rpm", ["300 rpm", "500 rpm"]]
[analyses]
response = {band = ["2 Hz", "40 Hz"]}
power = {band = ["2 Hz", "40 Hz"]}
shapes = {at = ["9 Hz"]}
steady = {band = ["2 Hz", "12 Hz"], harmonics = 3}
backbone = {up_to = "5 mm", harmonics = 3}
shock_spectrum = {band = ["5 Hz", "500 Hz"]}
earthquake = {direction = "x", rows = [[0.02, 3], [0.1, 9], [0.5, 9], [2, 2]]}
"""
MEASURED = "frequency [Hz],device.z re [m/N],device.z im [m/N]\n5,1e-5,-1e-6\n10,4e-5,-2e-5\n20,-2e-6,-1e-7\n"


def trivet(*arguments, code=0, **options):
    run = subprocess.run([TRIVET, *map(str, arguments)], capture_output=True, text=True, **options)
    assert run.returncode == code, (arguments, run.returncode, run.stderr)
    return run


def analyses():
    """All tables of [analyses] except the map, the search and the sample, the operation, the limit lines and the measurements;
    MACHINE or an example must contain each."""
    analyses = json.loads(trivet("schema").stdout)["properties"]["analyses"]["properties"]
    return [
        *(name for name in analyses if name not in ("map", "optimize", "sample", "box")),
        "operation",
        "limit_lines",
        "measurements",
    ]


ANALYSES = analyses()


class Analyses(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.machine = self.folder / "machine.toml"
        self.machine.write_text(MACHINE)
        (self.folder / "shaker.csv").write_text(MEASURED)

    def test_report_what_run_reports(self):
        met = set()
        for project in [*EXAMPLES, self.machine]:
            out = self.folder / project.parent.name / project.stem
            if "[bodies" not in project.read_text():
                continue
            trivet("run", project, "-o", out)
            base = json.loads((out / "results.json").read_text())["cases"][0]
            tables = next(path for path in out.iterdir() if path.name.startswith("00-"))
            for analysis in ANALYSES:
                if analysis not in base:
                    continue
                met.add(analysis)
                alone = json.loads(trivet(analysis, project, "--json").stdout)
                whole = base[analysis]
                if isinstance(whole, dict):
                    whole.pop("warnings"), alone.pop("warnings")  # a run also has those of the other analyses
                self.assertEqual(alone, whole, f"{analysis} of {project}")
                first = TABLES.get(analysis, [analysis])[0]
                self.assertEqual(
                    trivet(analysis, project, "--csv").stdout,
                    (tables / f"{first}.csv").read_text(),
                    f"{analysis} of {project}",
                )
        self.assertEqual(met, set(ANALYSES))

    def test_name_what_is_missing_in_the_file(self):
        bare = self.folder / "bare.toml"
        bare.write_text(MACHINE[: MACHINE.index("[limit_lines")])
        for analysis, words in (
            ("operation", "speed"),
            ("orders", "speed"),
            ("transmissibility", "force"),
            ("shapes", "at ="),
            ("shock_spectrum", "band"),
            ("earthquake", "direction"),
            ("limit_lines", "[limit_lines.NAME]"),
            ("measurements", "[measurements.NAME]"),
        ):
            said = trivet(analysis, bare, code=2).stderr
            self.assertIn(analysis + ": no", said)
            self.assertIn(words, said)
        self.assertIn("Mean power into the ground", trivet("power", bare).stdout)

    def test_end_with_a_text_or_a_message_for_every_example(self):
        for example in EXAMPLES:
            for analysis in ANALYSES:
                ran = subprocess.run([TRIVET, analysis, example], capture_output=True, text=True)
                self.assertIn(ran.returncode, (0, 1, 2), (analysis, example, ran.stderr))
                if ran.returncode != 0:
                    self.assertIn("error: ", ran.stderr, (analysis, example))

    def test_say_that_no_mount_is_on_the_ground(self):
        for example in EXAMPLES:
            if example.parent.name == "free_pair":
                self.assertIn("none, no element ends there", trivet("power", example).stdout)

    def test_fit_on_a_screen(self):
        for analysis in ANALYSES:
            if analysis in ("random", "transient", "orders", "transmissibility", "static"):
                continue
            text = trivet(analysis, self.machine, "--full", env={**os.environ, "COLUMNS": str(WIDEST)}).stdout
            for line in text.splitlines():
                if line.startswith("  "):
                    self.assertLessEqual(
                        len(line),
                        WIDEST + 100 * line.lstrip().startswith(("backward", "rows between", "searched")),
                        line,
                    )
        text = trivet("response", self.machine, "--full", env={**os.environ, "COLUMNS": str(WIDEST)}).stdout
        parts = text[text.index("Amplitude and phase") :].split("\n\n")  # after warnings and notes
        self.assertGreater(len(parts), 1)
        self.assertTrue(all("f [Hz]" in part for part in parts))


if __name__ == "__main__":
    unittest.main()
