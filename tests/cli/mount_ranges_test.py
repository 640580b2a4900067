# SPDX-License-Identifier: BSD-3-Clause
"""Load ranges and deflection limits of catalogue mounts against hand calculations, and the warning of every command."""
import itertools
import json
import math
import re
import unittest

from trivet_test import InTemporaryFolder, result_of, trivet

DIGITS = 9  # the program states nine for peaks; equilibrium has more
G = 9.80665
M, K = 200.0, 4e5

# Right-handed axes of a skew mount, exact in decimals: e1, e2, e3.
AXES = ((0.36, 0.48, -0.8), (-0.8, 0.6, 0), (0.48, 0.64, 0.6))
PUSH = (-90.0, 70.0, 40.0)
# One mount carries a body that only translates, so equilibrium alone gives its load: end K is pushed against an axis by
# the part of the weight and of the force that points against it.
FORCE = (PUSH[0], PUSH[1], PUSH[2] - M * G)
LOADS = dict(zip("xyz", (-sum(e * f for e, f in zip(axis, FORCE)) for axis in AXES)))
SKEW = f"""trivet = 1
gravity = [0, 0, -{G}]
[bodies.m]
mass = {M}
free = ["x", "y", "z"]
[elements.a]
type = "catalogue:M 1"
catalogue = "own.toml"
on = "m"
at = [0, 0, 0]
orientation = {{matrix = [{", ".join(str([axis[i] for axis in AXES]) for i in range(3))}]}}
[excitations.push]
type = "constant"
on = "m"
at = [0, 0, 0]
force = {list(PUSH)}
"""
REQUIRED = '[requirements]\nmount_load = "catalogue"\n'

STRAIGHT = f"""trivet = 1
gravity = [0, 0, -{G}]
[bodies.m]
mass = {M}
free = ["z"]
[elements.a]
type = "catalogue:M 1"
catalogue = "own.toml"
on = "m"
at = [0, 0, 0]
axis = "z"
"""


class MountRanges(InTemporaryFolder):
    def catalogue(self, keys, name="M 1"):
        self.file(
            f'catalogue = 1\n[mounts."{name}"]\nmaker = "none"\ntranslation = [1e5, 2e5, {K}]\n{keys}\n', "own.toml"
        )

    def judged(self, text):
        found = result_of("verdict", self.file(text))
        return {r["requirement"]: r for r in found["cases"][0]["requirements"]}, found["met"]

    def test_loads_of_a_skew_mount_in_three_directions(self):
        self.catalogue("load = {x = [-1700, 900], y = [-200, 200], z = [100, 1500]}")
        results, met = self.judged(SKEW + REQUIRED)
        for words, axis, margin in (
            ("a carries 100 … 1500 N", "z", min(1500 / LOADS["z"], LOADS["z"] / 100)),
            ("a carries -1700 … 900 N along x", "x", 1700 / -LOADS["x"]),
            ("a carries -200 … 200 N along y", "y", 200 / abs(LOADS["y"])),
        ):
            self.assertAlmostEqual(results[words]["value"] / LOADS[axis], 1, DIGITS)
            self.assertAlmostEqual(results[words]["margin"] / margin, 1, DIGITS)
        self.assertTrue(met)
        self.catalogue("load = {x = [-1500, 1700], y = [-200, 200], z = [100, 1500]}")
        results, met = self.judged(SKEW + REQUIRED)
        self.assertAlmostEqual(results["a carries -1500 … 1700 N along x"]["margin"], 1500 / -LOADS["x"], DIGITS)
        self.assertFalse(met)

    def test_the_utilisation_of_a_mount_at_rest_is_its_largest_share_of_a_range(self):
        for keys, share in (
            ("load = {x = [-1700, 900], y = [-200, 200], z = [100, 1500]}", max(LOADS["z"] / 1500, -LOADS["x"] / 1700)),
            ("load = {z = [100, 2500]}", LOADS["z"] / 2500),
        ):
            self.catalogue(keys)
            (mount,) = result_of("check", self.file(SKEW))["mounts"]
            self.assertAlmostEqual(mount["utilisation"], share, DIGITS)
        self.catalogue("")
        self.assertIsNone(result_of("check", self.file(SKEW))["mounts"][0]["utilisation"])

    def test_a_range_that_has_no_zero(self):
        self.catalogue("load = {z = [-900, -100]}")
        hung = STRAIGHT.replace('axis = "z"', 'axis = "-z"').replace(f"mass = {M}", "mass = 50")
        margin = min(900 / (50 * G), 50 * G / 100)
        self.assertAlmostEqual(self.judged(hung + REQUIRED)[0]["a carries -900 … -100 N"]["margin"], margin, DIGITS)
        standing = hung.replace('"-z"', '"z"')
        self.assertEqual(self.judged(standing + REQUIRED)[0]["a carries -900 … -100 N"]["margin"], 0)

    def test_static_load_is_the_range_along_z(self):
        self.catalogue("static_load = [0, 2500]\nload = {x = [-1, 1]}")
        results, met = self.judged(STRAIGHT + REQUIRED)
        self.assertEqual(sorted(results), ["a carries -1 … 1 N along x", "a carries 0 … 2500 N"])
        self.assertTrue(met)

    def test_a_load_without_a_range_is_not_judged(self):
        self.catalogue("load = {x = [-1700, 900], z = [100, 1500]}")
        path = self.file(SKEW + REQUIRED)
        done = trivet("verdict", path)
        self.assertEqual(done.returncode, 1)
        self.assertIn("1 not judged", done.stdout)
        judged = json.loads(trivet("verdict", path, "--json").stdout)["cases"][0]["requirements"]
        unknown = next(r for r in judged if r["requirement"] == "a carries its load along y")
        self.assertEqual((unknown["judged"], unknown["met"], unknown["value"]), (False, False, None))
        self.assertIn(f"{abs(LOADS['y']):.3g} N along y", unknown["reason"].replace("-", ""))
        # Below 1 % of the load of the mount no range is needed.
        self.catalogue("static_load = [0, 3000]")
        push = '[excitations.push]\ntype = "constant"\non = "m"\nat = [0, 0, 0]\nforce = [{}, 0, 0]\n'
        text = STRAIGHT.replace('["z"]', '["x", "z"]') + REQUIRED
        self.assertTrue(self.judged(text + push.format(0.0099 * M * G))[1])
        self.assertEqual(trivet("verdict", self.file(text + push.format(0.0102 * M * G))).returncode, 1)

    def test_creep_counts_in_the_static_deflection(self):
        self.catalogue('static_load = [0, 2500]\nstatic_deflection_limit = "6 mm"\ncreep = 1.3')
        deflects = self.judged(STRAIGHT + REQUIRED)[0]["a deflects ≤ 6 mm"]
        self.assertAlmostEqual(deflects["value"] / (1.3 * M * G / K), 1, DIGITS)
        self.assertAlmostEqual(deflects["margin"], 6e-3 / (1.3 * M * G / K), DIGITS)
        self.assertIn("creep factor 1.3", deflects["detail"])
        run = trivet("run", self.file(STRAIGHT + REQUIRED), "--output", self.folder / "out")
        self.assertIn(" mm, with its creep factor 1.3", run.stdout)
        self.catalogue(
            'load = {x = [-1700, 900], y = [-200, 200], z = [100, 1500]}\nstatic_deflection_limit = "4 mm"\ncreep = 1.3'
        )
        deflects = self.judged(SKEW + REQUIRED)[0]["a deflects ≤ 4 mm"]
        self.assertAlmostEqual(deflects["value"] / (1.3 * LOADS["z"] / K), 1, DIGITS)

    def test_creep_of_rubber_counts_in_its_own_deflection_only(self):
        disc = STRAIGHT.split("[elements.a]")[0] + (
            '[elements.a]\ntype = "rubber_disc"\non = "m"\nat = [0, 0, 0]\naxis = "z"\ndiameter = "80 mm"\n'
            'thickness = "30 mm"\nmaterial = {hardness = 55%s}\n[requirements]\n'
            'static = {"a.deflection.z" = "5 mm", "m.z" = "5 mm"}\n'
        )
        at_once, _ = self.judged(disc % "")
        after, _ = self.judged(disc % ", creep = 1.25")
        own, body = "at rest a.deflection.z ≤ 5 mm", "at rest m.z ≤ 5 mm"
        self.assertAlmostEqual(at_once[own]["value"] / at_once[body]["value"], 1, DIGITS)
        self.assertAlmostEqual(after[own]["value"] / at_once[own]["value"], 1.25, DIGITS)
        self.assertAlmostEqual(after[body]["value"] / at_once[body]["value"], 1, DIGITS)
        half = disc % ", creep = 1.25"
        path = self.file(half)
        changed = result_of("verdict", path, "--set", "elements.a.material.creep = 1.5")
        self.assertAlmostEqual(changed["cases"][0]["requirements"][0]["value"] / at_once[own]["value"], 1.5, DIGITS)

    def test_harmonic_deflection_over_the_band(self):
        self.catalogue('static_load = [0, 2500]\nloss_factor = 0.1\ndynamic_deflection_limit = "0.2 mm"')
        force = '[excitations.f]\ntype = "harmonic"\non = "m"\nat = [0, 0, 0]\nforce = [0, 0, 60]\n'
        required = REQUIRED + 'band = ["12 Hz", "20 Hz"]\n'
        found = self.judged(STRAIGHT + force + required)[0]["a vibrates by ≤ 200 µm 0-p"]
        w = 24 * math.pi  # above resonance: the lower end of the band
        largest = 60 / abs(K * (1 + 0.1j) - M * w * w)
        self.assertEqual(found["kind"], "mount_dynamic_deflection")
        self.assertAlmostEqual(found["value"] / largest, 1, DIGITS)
        self.assertAlmostEqual(found["margin"], 2e-4 / largest, DIGITS)
        self.assertAlmostEqual(found["angular_frequency"] / w, 1, DIGITS)
        peak = self.judged(STRAIGHT + force + REQUIRED)[0]["a vibrates by ≤ 200 µm 0-p"]
        self.assertAlmostEqual(peak["value"] / (60 / (0.1 * K)), 1, DIGITS)
        results, met = self.judged(STRAIGHT + REQUIRED)
        self.assertTrue(met)
        self.assertIn(
            "its dynamic deflection limit is not judged: no harmonic", results["a carries 0 … 2500 N"]["detail"]
        )

    def test_deflection_of_a_shock(self):
        self.catalogue('static_load = [0, 2500]\nshock_deflection_limit = "0.4 mm"')
        step = '[excitations.s]\ntype = "time"\non = "m"\nat = [0, 0, 0]\nforce = [0, 0, 1]\nhistory = {step = {amplitude = 70}}\n'
        found = self.judged(STRAIGHT + step + REQUIRED)[0]["a deflects over the transient by ≤ 400 µm"]
        self.assertEqual(found["kind"], "mount_shock_deflection")
        self.assertAlmostEqual(found["value"] / (2 * 70 / K), 1, DIGITS)
        self.assertAlmostEqual(found["margin"], 4e-4 / (2 * 70 / K), DIGITS)
        results, met = self.judged(STRAIGHT + REQUIRED)
        self.assertTrue(met)
        self.assertIn("its shock deflection limit is not judged", results["a carries 0 … 2500 N"]["detail"])

    def test_every_command_warns_of_the_load_that_the_verdict_judges(self):
        self.catalogue("load = {x = [-1500, 900], y = [-200, 200], z = [100, 1000]}")
        path = self.file(SKEW + '[analyses]\nmodes = {}\nstatic = {of = ["m"]}\n' + REQUIRED)
        for command in (["check"], ["modes"], ["static"], ["verdict"], ["run", "-o", self.folder / "out"], ["element"]):
            with self.subTest(command=command[0]):
                options = command[1:] + (["a"] if command[0] == "element" else [])
                done = trivet(command[0], path, *options)
                shown = done.stdout + done.stderr
                self.assertEqual(shown.count('suspicion "rated load"'), 1, shown)
                self.assertIn(f"{LOADS['z'] / 1000:.5g} kN along z, {LOADS['x'] / 1000:.5g} kN along x", shown)
                self.assertIn('its mount "M 1" carries 0.1 … 1 kN along z, -1.5 … 0.9 kN along x', shown)
        verdict = result_of("verdict", path)["cases"][0]["requirements"]
        outside = {r["requirement"]: r["value"] for r in verdict if not r["met"]}
        self.assertEqual(len(outside), 2)
        self.assertAlmostEqual(outside["a carries 100 … 1000 N"] / LOADS["z"], 1, DIGITS)
        accepted = SKEW.replace("[elements.a]", '[elements.a]\naccept = {"rated load" = "checked with the maker"}')
        self.assertEqual(trivet("check", self.file(accepted)).stderr, "")

    def test_warnings_name_each_mount_and_what_to_do(self):
        def warning(text):
            done = trivet("check", self.file(text))
            self.assertEqual(done.returncode, 0, done.stderr)
            return done.stderr

        self.catalogue(f"static_load = [0, {M * G * (1 - 1e-8)}]")
        self.assertIn("use a larger mount", warning(STRAIGHT))
        self.catalogue(f"static_load = [0, {M * G * (1 - 1e-10)}]")  # on its limit: nine digits
        self.assertEqual(warning(STRAIGHT), "")
        self.catalogue("static_load = [2500, 5000]")
        self.assertIn("use a smaller mount", warning(STRAIGHT))
        self.catalogue("static_load = [0, 5000]")
        upside_down = warning(STRAIGHT.replace('axis = "z"', 'axis = "-z"'))
        self.assertIn(f"-{M * G / 1000:.5g} kN along z (tension)", upside_down)
        self.assertIn("turn its axis", upside_down)
        in_cases = warning(STRAIGHT + "[cases.full]\nbodies.m.mass = 900\n[cases.as_full]\nbodies.m.mass = 900\n")
        self.assertIn(f'{900 * G / 1000:.5g} kN along z in case "full"', in_cases)
        self.assertEqual(in_cases.count("suspicion"), 1)  # the same load
        self.catalogue("static_load = [0, 1000]")
        in_cases = warning(STRAIGHT + "[cases.full]\nbodies.m.mass = 900\n[cases.hot]\nelements.a.scale = 0.7\n")
        self.assertIn(f"{M * G / 1000:.5g} kN along z;", in_cases)
        self.assertIn(f'{900 * G / 1000:.5g} kN along z in case "full";', in_cases)
        self.assertEqual(in_cases.count("suspicion"), 2)

    def test_an_unloaded_mount_is_not_in_tension(self):
        self.catalogue("static_load = [0, 5000]")
        weight = [-G * e for e in AXES[2]]
        text = SKEW.split("[excitations")[0].replace(f"[0, 0, -{G}]", str(weight)) + (
            f'[elements.stop]\ntype = "catalogue:M 1"\ncatalogue = "own.toml"\non = "m"\nat = [0, 0, 0]\n'
            f"axis = {list(AXES[0])}\n"
        )
        self.assertEqual(trivet("check", self.file(text)).stderr, "")

    def test_facts_of_a_mount(self):
        self.catalogue(
            'load = {y = [-5, 6], z = [0, 2500]}\ntemperature = ["-30 °C", "353.15 K"]\nheight = "45 mm"\ncreep = 1.2\n'
            'shock_deflection_limit = "9 mm"'
        )
        text = trivet("element", self.file(STRAIGHT), "a").stdout
        for fact in ("-5 … 6 N along e2", "-30 … 80 °C", "45 mm", "1.2 times the static", "9 mm"):
            self.assertIn(fact, text)

    def test_prices_of_two_currencies_and_without_one(self):
        mounts = "".join(
            f'[mounts.{name}]\nmaker = "m"\ntranslation = [1e5, 1e5, 1e5]\n{price}\n'
            for name, price in (("euro", 'price = "9 EUR"'), ("dollar", 'price = "USD 9.5"'), ("free", ""))
        )
        self.file("catalogue = 1\n" + mounts, "own.toml")
        text = STRAIGHT.split("[elements.a]")[0]
        for name, mount in (("a", "euro"), ("b", "dollar"), ("c", "free"), ("d", "dollar")):
            text += f'[elements.{name}]\ntype = "catalogue:{mount}"\ncatalogue = "own.toml"\non = "m"\nat = [0, 0, 0]\n'
        done = trivet("verdict", self.file(text + '[requirements]\nprice = "90 EUR"\n'))
        self.assertEqual(done.returncode, 2)
        self.assertIn('no price in the catalogue for "free" (c)', done.stderr)
        self.assertIn('the limit is in EUR, not the price of "dollar" (b, d)', done.stderr)


# Two skew pairs of mounts: the machine translates, and leans on all four.
NAMES = ("soft", "firm", "hard")
STIFFNESS = {"soft": (1e5, 2e5, 3e5), "firm": (2e5, 3e5, 6e5), "hard": (5e5, 4e5, 9e5)}
CATALOGUE = "catalogue = 1\n" + "".join(
    f'[mounts.{name}]\nmaker = "none"\ntranslation = {list(STIFFNESS[name])}\ncreep = {1.1 + 0.1 * i}\n'
    f"load = {{x = [{-300 - 80 * i}, {400 + 60 * i}], y = [-500, 500], z = [{20 * i}, {700 + 300 * i}]}}\n"
    f'static_deflection_limit = "{4 - i} mm"\n'
    for i, name in enumerate(NAMES)
)


class Selection(InTemporaryFolder):
    def test_every_combination_of_skew_mounts_has_the_margin_of_its_verdict(self):
        self.file(CATALOGUE, "own.toml")
        text = f'trivet = 1\ngravity = [0, 0, -{G}]\n[bodies.m]\nmass = 150\nfree = ["x", "y", "z"]\n'
        for name, axis in (("left", [0.3, 0.4, 1.2]), ("right", [-0.5, 0.2, 1])):
            text += f'[elements.{name}]\ntype = "catalogue:soft"\ncatalogue = "own.toml"\non = "m"\nat = [0, 0, 0]\naxis = {axis}\n'
            text += f'[parameters.{name}]\npath = "elements.{name}.type"\ncatalogue = "own.toml"\n'
        project = self.file(text + REQUIRED)
        found = result_of("select", project, "--most", "9")
        self.assertEqual((found["without_bounds"], len(found["best"])), ("", 9))
        margins, shares = {}, {}
        for mounts in itertools.product(NAMES, NAMES):
            settings = [f'elements.{e}.type = "catalogue:{m}"' for e, m in zip(("left", "right"), mounts)]
            judged = result_of("verdict", project, "--set", settings[0], "--set", settings[1])["cases"][0][
                "requirements"
            ]
            margins[mounts] = min(r["margin"] for r in judged)
            loads = [r for r in judged if r["kind"] == "mount_load"]
            self.assertEqual(len(loads), 6)
            ends = [re.search(r"carries (\S+) … (\S+) N", r["requirement"]).groups() for r in loads]
            shares[mounts] = max(r["value"] / float(e[r["value"] > 0]) for r, e in zip(loads, ends))
        self.assertGreater(len(set(margins.values())), 6)
        for design in found["best"]:
            mounts = (design["mounts"]["left"], design["mounts"]["right"])
            self.assertAlmostEqual(design["margin"] / margins[mounts], 1, DIGITS)
            self.assertAlmostEqual(design["load"] / shares[mounts], 1, DIGITS)
        first = result_of("select", project, "--most", "1")
        self.assertEqual(first["best"][0]["mounts"], found["best"][0]["mounts"])
        self.assertLess(first["judged"], 9)


if __name__ == "__main__":
    unittest.main()
