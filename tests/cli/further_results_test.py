# SPDX-License-Identifier: BSD-3-Clause
"""Random, time, run-up and transmissibility analyses at the command line, for the examples and for small models."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

from trivet_test import HANGS_AFTER

TRIVET = os.environ["TRIVET"]
EXAMPLES = pathlib.Path(os.environ["TRIVET_SOURCE"]) / "examples"


def trivet(*arguments):
    return subprocess.run([TRIVET, *map(str, arguments)], capture_output=True, text=True, timeout=HANGS_AFTER)


def result_of(test, *arguments):
    done = trivet(*arguments, "--json")
    test.assertEqual(done.returncode, 0, done.stderr)
    return json.loads(done.stdout)


MASS = """trivet = 1
[bodies.mass]
mass = 10
free = ["z"]
[elements.spring]
type = "three_springs"
on = "mass"
at = [0, 0, 0]
translation = [0, 0, 4000]
damping = {proportional = 0.005}
"""


def model(folder, text):
    path = pathlib.Path(folder) / "model.toml"
    path.write_text(MASS + text)
    return path


class FurtherResults(unittest.TestCase):
    def test_deflections_of_preloaded_springs_name_what_they_are_measured_from(self):
        words = "from their preloaded state: 0 where the preload carries the load"
        self.assertIn(words, trivet("static", EXAMPLES / "bogie/loaded_frame.toml").stdout)
        with tempfile.TemporaryDirectory() as folder:
            trivet("run", EXAMPLES / "bogie/loaded_frame.toml", "-o", folder)
            page = (pathlib.Path(folder) / "report.html").read_text()
            machine = page[page.index('<section class="machine">') :]
            self.assertIn(words, machine[: machine.index("</section>")])
        self.assertNotIn("preloaded state", trivet("static", EXAMPLES / "fan/fan.toml").stdout)

    def test_shares_of_the_variance_beyond_0_and_100_percent_are_explained(self):
        words = "Excitations are coherent: one that cancels a part of another has a share"
        found = result_of(self, "random", EXAMPLES / "optical_table/table.toml")
        shares = [share for one in found["results"] for share in one["variance_share"]]
        self.assertLess(min(shares), 0)
        self.assertIn(words, trivet("random", EXAMPLES / "optical_table/table.toml").stdout)
        self.assertNotIn(words, trivet("random", EXAMPLES / "microscope/microscope.toml").stdout)

    def test_a_curve_of_motions_that_ends_early_is_shown_with_exit_code_1(self):
        with tempfile.TemporaryDirectory() as folder:
            path = model(
                folder,
                """laws.z = {friction = {slip = 4, breakaway = 4}}
[excitations.push]
type = "harmonic"
on = "mass"
at = [0, 0, 0]
force = [0, 0, 12]
[analyses]
steady = {of = ["mass.z"], band = ["4 rad/s", "18 rad/s"], harmonics = 15}
""",
            )
            shown, data = trivet("steady", path), trivet("steady", path, "--json")
            run = trivet("run", path, "-o", pathlib.Path(folder) / "results")
        self.assertEqual([shown.returncode, data.returncode, run.returncode], [1, 1, 1])
        self.assertIn("ends before the end of the band", shown.stderr)
        self.assertIn("connected with the one at ", shown.stdout)
        found = json.loads(data.stdout)
        self.assertIn("rests for a part of the period", found["ended"])
        self.assertGreater(found["begun_at"], 4)
        self.assertGreater(len(found["points"]), 5)

    def test_root_mean_square_is_the_area_under_the_density(self):
        result = result_of(self, "random", EXAMPLES / "optical_table/table.toml")
        hertz = [w / 6.283185307179586 for w in result["angular_frequency"]]
        for one in result["results"]:
            if one["vanishes"]:
                continue
            density = one["density_per_hz"]
            area = sum((density[i] + density[i + 1]) / 2 * (hertz[i + 1] - hertz[i]) for i in range(len(hertz) - 1))
            self.assertAlmostEqual(area / one["rms"] ** 2, 1, delta=0.02, msg=one["name"])  # straight lines
            self.assertAlmostEqual(sum(one["variance_share"]), 1, delta=1e-6)

    def test_step_doubles_the_static_deflection_of_an_undamped_mass(self):
        with tempfile.TemporaryDirectory() as folder:
            path = model(
                folder,
                """[excitations.push]
type = "time"
on = "mass"
at = [0, 0, 0]
force = [0, 0, 1]
history = {step = {amplitude = "40 N"}}
[analyses]
transient = {to = 1, step = 0.001}
""",
            )
            curve = result_of(self, "transient", path, "--set", "elements.spring.damping.proportional=0")["results"][0]
            self.assertAlmostEqual(curve["largest"]["value"], 2 * 40 / 4000, delta=1e-12)
            self.assertAlmostEqual(curve["largest"]["time"] * 20 / 3.141592653589793 % 2, 1, delta=1e-6)

    def test_a_loss_factor_in_time_is_rejected_with_an_alternative(self):
        with tempfile.TemporaryDirectory() as folder:
            path = model(
                folder,
                """[excitations.push]
type = "time"
on = "mass"
at = [0, 0, 0]
force = [0, 0, 1]
history = {step = {amplitude = 1}}
""",
            )
            refused = trivet("transient", path, "--set", "elements.spring.damping={loss_factor=0.1}")
            self.assertEqual(refused.returncode, 1)
            self.assertIn("loss factor", refused.stderr)
            self.assertIn("proportional", refused.stderr)

    def test_coarse_samples_have_a_warning_with_the_number(self):
        with tempfile.TemporaryDirectory() as folder:
            rows = ", ".join(f"[{0.1 * i}, {(i * 7) % 5 - 2}]" for i in range(40))
            path = model(
                folder,
                f"""[excitations.push]
type = "time"
on = "mass"
at = [0, 0, 0]
force = [0, 0, 1]
history = {{rows = [{rows}]}}
[analyses]
transient = {{to = 5, step = 0.01}}
""",
            )
            warned = trivet("transient", path)
            self.assertEqual(warned.returncode, 0, warned.stderr)
            self.assertIn("3.18", warned.stdout + warned.stderr)  # the natural frequency in Hz

    def test_critical_speeds_are_where_orders_meet_modes(self):
        result = result_of(self, "orders", EXAMPLES / "genset/genset.toml")
        self.assertGreater(len(result["critical_speeds"]), 5)
        for speed in result["critical_speeds"]:
            self.assertAlmostEqual(
                speed["speed"] * speed["order"], speed["angular_frequency"], delta=1e-9 * speed["angular_frequency"]
            )
        for point in result["campbell"]["interference"]:
            self.assertAlmostEqual(
                point["speed"] * point["order"], point["angular_frequency"], delta=1e-9 * point["angular_frequency"]
            )

    def test_transmissibility_of_one_mass_is_the_text_book_one(self):
        with tempfile.TemporaryDirectory() as folder:
            path = model(folder, "[analyses]\ntransmissibility = {base = \"z\", band = [1, 200]}\n")
            result = result_of(self, "transmissibility", path)
            curve = next(one for one in result["results"] if one["name"].startswith("mass"))
            for omega, (re, im) in zip(result["angular_frequency"], curve["complex"]):
                direct = complex(4000, 20 * omega) / complex(4000 - 10 * omega**2, 20 * omega)
                self.assertAlmostEqual(abs(complex(re, im) - direct), 0, delta=1e-10)
            self.assertAlmostEqual(curve["isolates_from"], 2**0.5 * 20, delta=1e-6)

    def test_a_free_system_under_a_constant_force_is_explained(self):
        with tempfile.TemporaryDirectory() as folder:
            path = model(
                folder,
                """[excitations.pull]
type = "constant"
on = "mass"
at = [0, 0, 0]
force = [0, 0, 1]
""",
            )
            path.write_text(path.read_text().replace("[0, 0, 4000]", "[4000, 0, 0]"))
            refused = trivet("static", path)
            self.assertEqual(refused.returncode, 1)
            self.assertIn("free to slide along z", refused.stderr)

    def test_a_seat_has_a_total_value_of_its_weighted_axes(self):
        """ISO 2631-1, 8.2.2.1: k = 1 along x, y, z of a seat, 0.63, 0.4 and 0.2 m/rad about them."""
        seat = dict(zip(("x", "y", "z", "rx", "ry", "rz"), (1, 1, 1, 0.63, 0.4, 0.2)))
        done = result_of(self, "random", EXAMPLES / "track/bogie.toml", "--set", "analyses.random.weighting=\"seat\"")
        axes = {one["name"]: one for one in done["results"]}
        weighted = {axis: axes["frame." + axis]["weighted_rms"] or 0 for axis in seat}
        total = sum((k * weighted[axis]) ** 2 for axis, k in seat.items()) ** 0.5
        self.assertAlmostEqual(done["vibration_total_values"]["frame"] / total, 1, delta=1e-12)
        self.assertEqual(done["vibration_total_axes"]["frame"], list(seat))
        translations = sum(weighted[axis] ** 2 for axis in "xyz") ** 0.5
        self.assertGreater(total, 1.0001 * translations)  # the rotations count

    def test_a_total_value_names_its_axes(self):
        request = (
            "random",
            EXAMPLES / "track/bogie.toml",
            "--set",
            "analyses.random.of=[\"frame.x\", \"frame.y\", \"frame.z\"]",
        )
        done = result_of(self, *request, "--set", "analyses.random.weighting=\"seat\"")
        self.assertEqual(done["vibration_total_axes"]["frame"], ["x", "y", "z"])
        self.assertRegex(
            trivet(*request, "--set", "analyses.random.weighting=\"seat\"").stdout,
            r"total value \[mm/s²\] +of\n +frame +[0-9.]+ +x, y, z\n",
        )
        feet = result_of(self, "random", EXAMPLES / "track/bogie.toml", "--set", "analyses.random.weighting=\"feet\"")
        self.assertEqual(feet["vibration_total_axes"]["frame"], ["x", "y", "z"])  # no factor for rotations

    def test_an_infinite_root_mean_square_is_reported_everywhere(self):
        with tempfile.TemporaryDirectory() as folder:
            path = model(
                folder,
                """[excitations.noise]
type = "random"
on = "mass"
at = [0, 0, 0]
force = [0, 0, 1]
psd = {flat = 1, band = ["1 Hz", "10 Hz"]}
[analyses]
random = {of = ["mass.z"], quantity = "acceleration", weighting = "Wk"}
""",
            )
            undamped = ("--set", "elements.spring.damping.proportional=0")
            one = result_of(self, "random", path, *undamped)["results"][0]
            self.assertEqual((one["rms"], one["estimated_error"]), (None, None))
            self.assertEqual(one["infinite"], ["rms", "rms_of_derivative", "weighted_rms"])
            self.assertIn("undamped", one["reason"])
            text = trivet("random", path, *undamped).stdout
            self.assertIn("∞", text)
            self.assertIn("no variance is finite", text)
            self.assertNotIn("0.0e+00", text)
            header, row = trivet("random", path, *undamped, "--csv").stdout.splitlines()
            cells = dict(zip(header.split(","), row.split(",")))
            self.assertEqual(
                [cells[name] for name in ("rms", "three_sigma", "rms_of_derivative [unit/s]", "weighted_rms")],
                ["inf"] * 4,
            )
            self.assertEqual(cells["zero_crossings [1/s]"], "")
            damped = result_of(self, "random", path)["results"][0]
            self.assertEqual(damped["infinite"], [])
            self.assertGreater(damped["rms"], 0)

    def test_a_growing_motion_has_no_root_mean_square_rather_than_an_infinite_one(self):
        with tempfile.TemporaryDirectory() as folder:
            path = model(
                folder,
                """[excitations.noise]
type = "random"
on = "mass"
at = [0, 0, 0]
force = [0, 0, 1]
psd = {flat = 1, band = ["1 Hz", "10 Hz"]}
[elements.push]
type = "matrix"
on = "mass"
at = [0, 0, 0]
symmetric = false
stiffness = [[0,0,0,0,0,0],[0,0,0,0,0,0],[0,0,-9000,0,0,0],[0,0,0,0,0,0],[0,0,0,0,0,0],[0,0,0,0,0,0]]
[analyses]
random = {of = ["mass.z"]}
""",
            )
            one = result_of(self, "random", path)["results"][0]
            self.assertEqual((one["rms"], one["infinite"], one["estimated_error"]), (None, [], None))
            self.assertIn("grows", one["reason"])
            self.assertNotIn("∞", trivet("random", path).stdout)

    def test_twice_the_motion_is_twice_the_shock_spectrum(self):
        with tempfile.TemporaryDirectory() as folder:
            highest = []
            for factor in (1, 2):
                path = model(
                    folder,
                    f"""[excitations.shock]
type = "time"
base = true
quantity = "acceleration"
translation = [0, 0, {factor}]
history = {{half_sine = {{amplitude = "20 g", duration = "11 ms"}}}}
[analyses]
shock_spectrum = {{band = ["5 Hz", "200 Hz"]}}
""",
                )
                target = pathlib.Path(folder) / f"out{factor}"
                self.assertEqual(trivet("run", path, "-o", target).returncode, 0)
                rows = json.loads((target / "results.json").read_text())["cases"][0]["shock_spectrum"]["spectra"][0][
                    "rows"
                ]
                highest.append(max(row["maximax"] for row in rows))
            self.assertAlmostEqual(highest[1] / highest[0], 2, delta=1e-9)

    def test_bands_on_both_sides_of_an_undamped_resonance_exclude_it(self):
        with tempfile.TemporaryDirectory() as folder:
            text = ""
            for name, band in (("low", (1, 2)), ("high", (5, 8))):
                text += f"""[excitations.{name}]
type = "random"
on = "mass"
at = [0, 0, 0]
force = [0, 0, 1]
psd = [[{band[0]}, 1], [{band[1]}, 1]]
"""
            path = model(folder, text)
            both = result_of(self, "random", path, "--set", "elements.spring.damping.proportional=0")["results"][0]
            self.assertIsNotNone(both["rms"], both["reason"])  # the resonance at 3.18 Hz is between the bands

    def test_run_writes_tables_figures_and_sections(self):
        with tempfile.TemporaryDirectory() as folder:
            target = pathlib.Path(folder) / "out"
            done = trivet("run", EXAMPLES / "transport_shock/device.toml", "-o", target)
            self.assertEqual(done.returncode, 0, done.stderr)
            names = {path.name for path in (target / "00-base").iterdir()}
            self.assertLessEqual({"transient.csv", "shock_spectrum.csv"}, names)
            self.assertTrue(any(name.startswith("transient-") and name.endswith(".svg") for name in names))
            page = (target / "report.html").read_text()
            for title in ("Time history", "Shock response spectrum"):
                self.assertIn(title, page)

    def test_every_example_of_this_kind_passes_its_checks(self):
        for example in ("genset/genset", "track/bogie", "optical_table/table", "transport_shock/device"):
            checked = trivet("check", EXAMPLES / (example + ".toml"), "--deep")
            self.assertEqual(checked.returncode, 0, checked.stdout + checked.stderr)


if __name__ == "__main__":
    unittest.main()
