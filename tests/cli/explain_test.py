# SPDX-License-Identifier: BSD-3-Clause
"""`trivet explain` and `trivet suspension` as text, JSON and CSV."""
import csv
import io
import json
import math
import os
import pathlib
import subprocess
import tempfile
import unittest

from trivet_test import HANGS_AFTER

TRIVET = os.environ["TRIVET"]
SOURCE = pathlib.Path(os.environ["TRIVET_SOURCE"])
PAPER = str(SOURCE / "examples/paper/corrected.toml")
BOGIE = str(SOURCE / "examples/bogie/loaded_frame.toml")


def run(*arguments, code=0):
    done = subprocess.run([TRIVET, *arguments], capture_output=True, text=True, timeout=HANGS_AFTER)
    assert done.returncode == code, (done.returncode, done.stdout, done.stderr)
    return done.stdout, done.stderr


class Explain(unittest.TestCase):
    def test_shares_above_100_percent_are_explained_at_the_number(self):
        with tempfile.TemporaryDirectory() as folder:
            starter = pathlib.Path(folder) / "machine.toml"
            starter.write_text(run("new")[0])
            verdict = run("verdict", str(starter))[0]
            self.assertRegex(verdict, r"contributes 10\d % of it \(above 100 %: others move against it\)")
            shown = run("explain", str(starter))[0]
            self.assertIn("therefore add up to more than 100 %", " ".join(shown.split()))

    def test_shares_and_sensitivities_of_the_paper_agree_with_a_changed_model(self):
        peak = json.loads(run("explain", PAPER, "--of", "aggregate.x", "--most", "1", "--json")[0])["peaks"][0]
        shares = peak["shares"]
        self.assertAlmostEqual(sum(m["share"] for m in shares["modes"]) + shares["beyond_modes"], 1, places=9)
        self.assertAlmostEqual(
            sum(e["stored"] for e in shares["elements"]) + shares["geometric_stiffness"], 1, places=9
        )
        slopes = {s["parameter"]: s for s in peak["sensitivities"]}
        changed = {}
        for sign in (1, -1):
            # by the keys of the file, and by the path of explain
            by_name = json.loads(
                run("peaks", PAPER, "--json", "--set", f"bodies.aggregate.mass_about_center={1 + sign * 1e-4}")[0]
            )["peaks"]
            found = json.loads(
                run(
                    "peaks",
                    PAPER,
                    "--json",
                    "--set",
                    f"bodies.aggregate.mass={205.176 * (1 + sign * 1e-4)}",
                    # the file gives the inertia about the pole: keep that about the centre of mass
                    *sum((["--set", s] for s in inertia_about_pole(1 + sign * 1e-4)), []),
                )[0]
            )["peaks"]
            for one, other in zip(by_name, found, strict=True):
                self.assertAlmostEqual(one["amplitude"] / other["amplitude"], 1, places=9)
            changed[sign] = next(
                p
                for p in found
                if p["name"] == "aggregate.x" and abs(p["angular_frequency"] / peak["angular_frequency"] - 1) < 0.01
            )
        for name, key in (("height", "amplitude"), ("frequency", "angular_frequency")):
            difference = (changed[1][key] - changed[-1][key]) / (2e-4 * peak[key])
            self.assertAlmostEqual(
                slopes["bodies.aggregate.mass_about_center"][name], difference, delta=1e-5 * abs(difference)
            )

    def test_slopes_are_relative_to_the_number_in_the_file(self):
        # Against differences of files with another number; none of the numbers is the default.
        given = {"scale": 2.0, "stiffness_factor.z": 1.5, "damping_factor": 3.0, "moved.x": 0.004}
        text = """trivet = 1
[bodies.m]
mass = 250
center_of_mass = [0.02, 0, 0.2]
inertia = {about = "center_of_mass", xx = 8, yy = 12, zz = 13}
[element_types.foot]
type = "bushing"
translation = [2e5, 2e5, 4e5]
rotation = [200, 200, 200]
damping = {loss_factor = 0.1}
[tables.elements]
rows = [
  {name = "a", type = "foot", on = "m", at = [-0.4, 0.25, 0], KEYS},
  {name = "b", type = "foot", on = "m", at = [-0.4, -0.25, 0]},
  {name = "c", type = "foot", on = "m", at = [0.4, 0.25, 0]},
  {name = "d", type = "foot", on = "m", at = [0.4, -0.25, 0]},
]
[excitations.f]
type = "harmonic"
on = "m"
at = [0, 0, 0.2]
force = [0, 0, 100]
[analyses]
peaks = {of = ["m.z"]}
"""
        keys = ", ".join(f"{key} = {value}" for key, value in given.items())
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "factors.toml"
            path.write_text(text.replace("KEYS", keys))
            peak = json.loads(run("explain", str(path), "--of", "m.z", "--most", "1", "--json")[0])["peaks"][0]
            slopes = {s["parameter"]: s for s in peak["sensitivities"]}
            for key, value in given.items():
                slope = slopes["elements.a." + key]
                step = 1e-4 if slope["change"].endswith("%") else 1e-5  # relative, or 10 µm
                height = {}
                for sign in (1, -1):
                    other = value * (1 + sign * step) if slope["change"].endswith("%") else value + sign * step
                    found = run("peaks", str(path), "--json", "--set", f"elements.a.{key}={other:.12g}")[0]
                    near = min(
                        json.loads(found)["peaks"],
                        key=lambda p: abs(p["angular_frequency"] / peak["angular_frequency"] - 1),
                    )
                    height[sign] = math.log(near["amplitude"])
                difference = (height[1] - height[-1]) / (2 * step)
                # Nine digits of the amplitudes over the step, and its square.
                self.assertAlmostEqual(slope["height"], difference, delta=1e-4 * abs(difference) + 2e-5, msg=key)
                self.assertGreater(abs(difference), 1e-3, key)

    def test_the_sentence_names_mode_element_direction_and_the_effect_of_ten_percent(self):
        text = " ".join(run("explain", BOGIE, "--of", "frame.z")[0].split())
        for words in (
            "frame.z:",
            "Mode 3",
            '% of the strain energy is in "spring',
            "axial stiffness",
            "+10 % on",
            "recomputed",
        ):
            self.assertIn(words, text)

    def test_the_trial_changes_a_peak_whose_energy_is_elsewhere(self):
        # At the peak along x the load moves the machine along y far more, near the lowest mode.
        mounts = "".join(
            f"""[elements.m{i}]
type = "bushing"
on = "fan"
at = [{x}, {y}, 0]
translation = [150e3, 149e3, 300e3]
rotation = [50, 50, 30]
damping = {{loss_factor = 0.08}}
"""
            for i, (x, y) in enumerate(((0.5, 0.4), (0.5, -0.4), (-0.5, 0.4), (-0.5, -0.4)))
        )
        text = f"""trivet = 1
[bodies.fan]
mass = 420
center_of_mass = [0.02, 0, 0.35]
inertia = {{about = "center_of_mass", xx = 38, yy = 62, zz = 58}}
{mounts}[excitations.push]
type = "harmonic"
on = "fan"
at = [0, 0, 0.35]
force = [1, 100, 0]
[analyses]
peaks = {{of = ["fan.x"]}}
"""
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "fan.toml"
            path.write_text(text)
            for peak in json.loads(run("explain", str(path), "--json")[0])["peaks"]:
                trial = peak["trial"]
                effect = {
                    s["parameter"]: max(abs(s["frequency"] or 0), abs(s["height"] or 0)) for s in peak["sensitivities"]
                }
                strongest = max(
                    value for name, value in effect.items() if ".stiffness_factor." in name or name.endswith(".scale")
                )
                self.assertGreater(effect[trial["parameter"]], 0.01 * strongest, peak["sentence"])

    def test_an_undamped_peak_has_a_frequency_to_change_but_no_height(self):
        result = json.loads(
            run("explain", PAPER, "--set", "elements.suspension.damping.proportional=0", "--most", "2", "--json")[0]
        )
        for peak in result["peaks"]:
            self.assertTrue(peak["unbounded"])
            self.assertIsNone(peak["amplitude"])
            scale = next(s for s in peak["sensitivities"] if s["parameter"] == "elements.suspension.scale")
            self.assertIsNone(scale["height"])
            self.assertAlmostEqual(scale["frequency"], 0.5, places=9)  # ω ~ √K
            self.assertIn("no height", peak["notes"][0])

    def test_a_peak_that_is_round_off_of_a_symmetry_is_left_out(self):
        result = json.loads(
            run("explain", str(SOURCE / "examples/rubber_mounts/compressor.toml"), "--json", "--most", "50")[0]
        )
        self.assertTrue(result["peaks"])
        self.assertFalse([p["name"] for p in result["peaks"] if p["amplitude"] < 1e-12])

    def test_csv_has_a_row_for_each_peak_and_parameter(self):
        rows = list(csv.DictReader(io.StringIO(run("explain", PAPER, "--most", "2", "--csv")[0])))
        self.assertEqual(len(rows), 2 * 21)
        self.assertTrue(all(float(row["relative height change"]) for row in rows))

    def test_a_spring_that_weight_relieves_stores_all_of_the_energy(self):
        # An inverted pendulum: the spring stores k φ²/2, of which the weight gives back m g h φ²/2.
        stiffness, weight = 258.5, 20 * 10 * 1.0
        pendulum = f"""trivet = 1
gravity = [0, 0, -10]
[bodies.m]
mass = 20
center_of_mass = [0, 0, 1]
inertia = {{about = "center_of_mass", xx = 1, yy = 1, zz = 1}}
free = ["ry"]
[elements.a]
type = "bushing"
on = "m"
at = [0, 0, 0]
translation = [0, 0, 0]
rotation = [0, {stiffness}, 0]
damping = {{translation = [0, 0, 0], rotation = [0, 0.4, 0]}}
[excitations.f]
type = "harmonic"
on = "m"
at = [0, 0, 1]
force = [1, 0, 0]
"""
        with tempfile.TemporaryDirectory() as folder:
            path = str(pathlib.Path(folder) / "pendulum.toml")
            pathlib.Path(path).write_text(pendulum)
            (peak,) = json.loads(run("explain", path, "--of", "m.ry", "--json")[0])["peaks"]
            text = run("explain", path, "--of", "m.ry")[0]
        (element,) = peak["shares"]["elements"]  # of the sum
        self.assertAlmostEqual(element["stored"], stiffness / (stiffness - weight), places=9)
        self.assertIn('100 % of the strain energy is in "a", 100 % in its stiffness about y', peak["sentence"])
        self.assertIn(f"{100 * weight / stiffness:.3g} % of what is stored is given back", peak["sentence"])
        rows = {line.split()[0]: line for line in text.splitlines() if line.startswith(("  a ", "  geometric"))}
        self.assertRegex(rows["a"], r"a +100\.0 %")
        self.assertIn(f"-{100 * weight / stiffness:.1f} %", rows["geometric"])

    def test_an_unknown_result_is_wrong_input(self):
        self.assertIn("nonsense", run("explain", PAPER, "--of", "nonsense", code=2)[1])

    def test_without_an_excitation_there_is_nothing_to_explain(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "still.toml"
            path.write_text(
                'trivet = 1\n[bodies.m]\nmass = 1\nfree = ["x"]\n[elements.k]\ntype = "three_springs"\non = "m"\nat = [0, 0, 0]\ntranslation = [1, 0, 0]\n'
            )
            self.assertIn("excitation", run("explain", str(path), code=1)[1])


def inertia_about_pole(factor):
    """The paper's inertia about the pole for another mass, with the inertia about the centre of mass unchanged."""
    x, y, z = -0.624, -0.502, -0.226
    more = 205.176 * (factor - 1)
    values = {
        "xx": 66.289 + more * (y * y + z * z),
        "yy": 91.643 + more * (x * x + z * z),
        "zz": 135.853 + more * (x * x + y * y),
        "xy": 65.194 + more * x * y,
        "xz": 28.935 + more * x * z,
        "yz": 23.973 + more * y * z,
    }
    return [f"bodies.aggregate.inertia.{name}={value!r}" for name, value in values.items()]


class Suspension(unittest.TestCase):
    def test_numbers_of_the_bogie(self):
        result = json.loads(run("suspension", BOGIE, "--torque", "x", "--excitation", "10Hz", "--json")[0])
        frame = result["bodies"][0]
        self.assertAlmostEqual(frame["elastic"]["center"][2], -0.166, delta=1e-3)
        self.assertEqual(len(frame["roll_axes"]), 1)
        self.assertEqual([m["purest"] for m in frame["modes"]], ["y", "x", "z", "rx", "rz", "ry"])
        for mode in frame["modes"]:
            self.assertAlmostEqual(sum(mode["kinetic_energy_share"]) + mode["in_elements"], 1, places=9)
        for row in result["frequency_separation"]:
            self.assertAlmostEqual(row["excitation_ratio"][0] * row["angular_frequency"], 62.83185307, places=6)

    def test_text_and_csv(self):
        text = run("suspension", PAPER)[0]
        for words in ("elastic centre", "torque roll axis", "torsional stiffness", "decoupled", "Frequency separation"):
            self.assertIn(words, text)
        self.assertEqual(len(run("suspension", PAPER, "--csv")[0].splitlines()), 7)

    def test_a_moment_needs_a_direction(self):
        for wrong in ("0,0,0", "1,2", "up", "1,2,nan"):
            self.assertIn("--torque", run("suspension", PAPER, "--torque", wrong, code=2)[1])


if __name__ == "__main__":
    unittest.main()
