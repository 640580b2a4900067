# SPDX-License-Identifier: BSD-3-Clause
"""`trivet verdict` against closed forms and hand calculations."""
import json
import math
import tomllib
import unittest

from trivet_test import SOURCE, InTemporaryFolder, result_of, trivet

DIGITS = 9  # of closed forms; the program states nine for peaks
M, K, C, G = 40.0, 2.5e5, 400.0, 9.80665

# A mass on a spring and a damper that moves along z only.
OSCILLATOR = f"""trivet = 1
gravity = [0, 0, -{G}]
[bodies.m]
mass = {M}
free = ["z"]
[elements.s]
type = "bushing"
on = "m"
at = [0, 0, 0]
translation = [1, 1, {K}]
damping = {{translation = [1e-3, 1e-3, {C}]}}
[excitations.f]
type = "harmonic"
on = "m"
at = [0, 0, 0]
force = [0, 0, 30]
"""
NATURAL = math.sqrt(K / M)
RATIO = C / (2 * math.sqrt(K * M))


class Verdict(InTemporaryFolder):
    def judged(self, text, case=0):
        found = result_of("verdict", self.file(text))
        return {r["requirement"]: r for r in found["cases"][case]["requirements"]}, found

    def one(self, requirement, more=""):
        results, _ = self.judged(OSCILLATOR + more + "[requirements]\n" + requirement + "\n")
        self.assertEqual(len(results), 1)
        return next(iter(results.values()))

    def test_amplitude_is_the_resonance_peak(self):
        peak = 30 / K / (2 * RATIO * math.sqrt(1 - RATIO**2))
        found = self.one('limits = {"m.z" = "0.9 mm"}')
        self.assertAlmostEqual(found["value"] / peak, 1, DIGITS)
        self.assertAlmostEqual(found["margin"] * peak / 0.9e-3, 1, DIGITS)
        self.assertAlmostEqual(found["angular_frequency"] / (NATURAL * math.sqrt(1 - 2 * RATIO**2)), 1, DIGITS)
        self.assertFalse(found["met"])
        # The velocity is largest at the natural frequency itself: F / c.
        self.assertAlmostEqual(self.one('limits = {"m.z" = "80 mm/s"}')["margin"], 0.08 / (30 / C), DIGITS)

    def test_least_margin_is_of_the_cases_that_decide(self):
        """Of a resonance at its natural frequency: velocity F/c, so a case with another force has another margin."""
        limit = '[requirements]\nhold_in = [HOLD]\nlimits = {"m.z" = "80 mm/s"}\n'
        cases = "[cases.strong]\nexcitations.f.force = [0, 0, 45]\n[cases.weak]\nexcitations.f.force = [0, 0, 10]\n"
        for hold, name, force in (
            ('"", "strong", "weak"', "strong", 45),
            ('"", "weak"', "", 30),
            ('"weak"', "weak", 10),
        ):
            found = self.judged(OSCILLATOR + limit.replace("HOLD", hold) + cases)[1]["least_margin"]
            self.assertEqual((found["case"], found["requirement"]), (name, 0))
            self.assertAlmostEqual(found["margin"] / (0.08 / (force / C)), 1, DIGITS)

    def test_amplitude_in_a_band_below_the_peak(self):
        found = self.one('band = ["0 Hz", "5 Hz"]\nlimits = {"m.z" = "1 mm"}')
        w = 10 * math.pi
        self.assertAlmostEqual(found["value"], 30 / math.hypot(K - M * w * w, C * w), DIGITS)

    def test_peak(self):
        rise = (
            1 / (2 * RATIO * math.sqrt(1 - RATIO**2)) - 1
        )  # over the amplitude at rest; behind the peak it falls to 0
        found = self.one('no_peak = "m.z"\npeak_tolerance = 0.2')
        self.assertAlmostEqual(found["margin"], 1.2 / (1 + rise), DIGITS)
        aperiodic = OSCILLATOR.replace(str(C), str(2 * C / RATIO)) + '[requirements]\nno_peak = "m.z"\n'
        results, found = self.judged(aperiodic)
        self.assertTrue(found["met"])
        self.assertIsNone(results["no peak of m.z"]["margin"])  # nothing limits it

    def test_natural_frequency_and_windows(self):
        hertz = NATURAL / (2 * math.pi)  # 12.58 Hz
        for window, margin in (
            ((5, 10), hertz / 10),
            ((15, 20), 15 / hertz),
            ((12, 20), 12 / hertz),
            ((5, 13), hertz / 13),
        ):
            found = self.one(f'natural_frequencies = {{avoid = [["{window[0]} Hz", "{window[1]} Hz"]]}}')
            self.assertAlmostEqual(found["margin"], margin, DIGITS)
            self.assertEqual(found["met"], margin >= 1)

    def test_natural_frequency_within_nine_digits_of_a_window(self):
        hertz = NATURAL / (2 * math.pi)
        for inside, met in ((5e-10, True), (2e-9, False)):
            for window in ((5, hertz * (1 + inside)), (hertz * (1 - inside), 20)):
                found = self.one(f'natural_frequencies = {{avoid = [["{window[0]!r} Hz", "{window[1]!r} Hz"]]}}')
                self.assertEqual(found["met"], met)
                self.assertEqual(found["margin"] == 1, met)

    def test_damping_ratio(self):
        self.assertAlmostEqual(self.one("damping_ratio = 0.05")["margin"], RATIO / 0.05, DIGITS)
        undamped = OSCILLATOR.replace(f"[1e-3, 1e-3, {C}]", "[0, 0, 0]") + "[requirements]\ndamping_ratio = 0.05\n"
        results, found = self.judged(undamped)
        self.assertFalse(found["met"])
        self.assertAlmostEqual(next(iter(results.values()))["margin"], 0, DIGITS)

    def test_deflection_at_rest(self):
        found = self.one('static = {"m.z" = "2 mm"}')
        self.assertAlmostEqual(found["value"], M * G / K, DIGITS)
        self.assertAlmostEqual(found["margin"], 2e-3 * K / (M * G), DIGITS)

    def test_an_element_takes_the_share_of_the_limit_that_governs_it(self):
        limits = '[requirements]\nstatic = {"m.z" = "1 mm", "s.deflection.z" = "2 mm", "s.force.z" = "%d N"}\n'
        weight = M * G
        for most, governing, share in ((300, "s.force.z", weight / 300), (900, "s.deflection.z", weight / K / 2e-3)):
            found = result_of("verdict", self.file(OSCILLATOR + limits % most))["cases"][0]
            (element,) = found["elements"]
            self.assertEqual(element["element"], "s")
            self.assertEqual(found["requirements"][element["governing"]]["subject"], governing)
            self.assertAlmostEqual(element["share"], share, DIGITS)

    def test_largest_motion_after_a_step(self):
        step = '[excitations.s]\ntype = "time"\non = "m"\nat = [0, 0, 0]\nforce = [0, 0, 1]\nhistory = {step = {amplitude = 50}}\n'
        overshoot = 1 + math.exp(-math.pi * RATIO / math.sqrt(1 - RATIO**2))
        found = self.one('largest = {"m.z" = "0.5 mm"}', step)
        self.assertAlmostEqual(found["value"] / (50 / K * overshoot), 1, DIGITS)
        self.assertAlmostEqual(found["margin"] * found["value"], 0.5e-3, DIGITS)

    def test_rms_under_white_noise(self):
        # Σ² = π S₀ / (c k) for a density S₀ over −∞ … ∞; here one-sided over frequency, to 400 natural frequencies.
        top = 400 * NATURAL / (2 * math.pi)
        noise = f'[excitations.n]\ntype = "random"\non = "m"\nat = [0, 0, 0]\nforce = [0, 0, 1]\npsd = {{rows = [[0.001, 3], [{top}, 3]]}}\n'
        found = self.one('rms = {"m.z" = "1 mm"}', noise)
        exact = math.sqrt(3 / (4 * C * K))
        self.assertAlmostEqual(found["value"] / exact, 1, 4)  # the band ends: 1e-3 Hz and 400 natural frequencies
        self.assertEqual(found["detail"], "")
        felt = noise + '[analyses]\nrandom = {of = ["m.z"], quantity = "acceleration", weighting = "Wk"}\n'
        beside_weighting = self.one('rms = {"m.z" = "1 mm"}', felt)
        self.assertEqual((beside_weighting["value"], beside_weighting["detail"]), (found["value"], "unweighted"))

    def test_a_common_band_of_the_limits_is_stated_in_the_units_of_the_display(self):
        limits = OSCILLATOR + '[requirements]\nband = ["1450 rpm", "1500 rpm"]\nlimits = {"m.z" = %s}\n'
        common, own = limits % '"1 mm"', limits % '{limit = "1 mm", band = ["1 Hz", "2 Hz"]}'
        in_rpm = common + '[display]\nfrequency = "rpm"\n'
        for text, words in ((common, "; limits over 24.17 … 25 Hz\n"), (in_rpm, "; limits over 1450 … 1500 rpm\n")):
            self.assertIn(words, trivet("verdict", self.file(text)).stdout)
        self.assertNotIn("limits over", trivet("verdict", self.file(own)).stdout)
        self.assertEqual(trivet("run", self.file(common), "-o", self.folder / "out").returncode, 0)
        self.assertIn("; limits over 24.17 … 25 Hz", (self.folder / "out/report.html").read_text())

    def test_engine_orders_and_random_motion_that_limits_do_not_count(self):
        shaft = '[excitations.shaft]\ntype = "orders"\non = "m"\nat = [0, 0, 0]\ntable = [{order = 2, force = [0, 0, 50]}]\n'
        track = '[excitations.track]\ntype = "random"\non = "m"\nat = [0, 0, 0]\nforce = [0, 0, 1]\npsd = [[1, 3], [9, 3]]\n'
        speed = '{limit = "9 mm", speed = ["300 rpm", "600 rpm"]}'

        def words(more, of_m, rms=""):
            text = OSCILLATOR + more + "[requirements]\n" + rms + '[requirements.limits]\n"m.z" = ' + of_m + "\n"
            cases = result_of("verdict", self.file(text + "[cases.soft]\nelements.s.scale = 0.5\n"))["cases"]
            return [w for w in cases[0]["warnings"] if "harmonic excitations only" in w]

        (orders,), (random,) = words(shaft, '"1 mm"'), words(track, '"1 mm"')
        self.assertIn('requirements.limits: engine orders ("shaft") not counted for m.z; ', orders)
        self.assertIn('requirements.limits: random motion ("track") not counted for m.z; ', random)
        self.assertIn("add a limit with speed", orders)
        self.assertIn("add the rms", random)
        for where in (trivet("verdict", self.folder / "project.toml").stderr, self.run_of_file()):
            self.assertEqual(where.count('random motion ("track") not counted for m.z'), 1, where)
        self.assertIn("random motion (&quot;track&quot;) not counted", (self.folder / "out/report.html").read_text())
        self.assertNotIn("not counted", trivet("modes", self.folder / "project.toml").stdout)  # it judges nothing
        self.assertEqual(len(words(shaft + track, '"1 mm"')), 2)
        self.assertEqual(words("", '"1 mm"'), [])
        self.assertEqual(words(shaft, '["1 mm", ' + speed + "]"), [])
        self.assertEqual(words(track, '"1 mm"', 'rms = {"m.z" = "2 mm"}\n'), [])
        self.assertEqual(words(shaft + track, '{limit = "1 mm", excitations = ["f"]}'), [])  # its row names them
        of_file = '[analyses]\nresponse = {band = ["1 Hz", "9 Hz"], of = ["m.z"]}\n[limits]\n"m.z" = "1 mm"\n'
        self.file(OSCILLATOR + shaft + of_file)
        self.assertIn('limits: engine orders ("shaft") not counted for m.z', self.run_of_file())

    def run_of_file(self):
        done = trivet("run", self.folder / "project.toml", "-o", self.folder / "out")
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_separation_and_decoupling(self):
        two = OSCILLATOR.replace('free = ["z"]', 'free = ["x", "z"]').replace("[1, 1,", f"[{K / 1.44}, 1,")
        results, _ = self.judged(
            two + "[requirements]\nnatural_frequencies = {separation = 1.15}\ndecoupling = {m = 0.9}\n"
        )
        apart, pure = results["natural frequencies apart by 1.15"], results["m decoupled by 90 %"]
        self.assertAlmostEqual(apart["value"], 1.2, DIGITS)
        self.assertAlmostEqual(apart["margin"], 1.2 / 1.15, DIGITS)
        self.assertAlmostEqual(pure["value"], 1, DIGITS)

    def test_loads_of_catalogue_mounts(self):
        (self.folder / "own.toml").write_text(
            'catalogue = 1\ntitle = "t"\nsource = "s"\n[mounts.a]\nmaker = "m"\ntranslation = [1e5, 1e5, 2e5]\n'
            'static_load = [250, 400]\nstatic_deflection_limit = "2 mm"\n'
        )
        mounts = "".join(
            f'[elements.{name}]\ntype = "catalogue:a"\ncatalogue = "own.toml"\non = "m"\nat = [{x}, {y}, 0]\n'
            for name, x, y in (("a", 0.5, 0.3), ("b", 0.5, -0.3), ("c", -0.5, 0.3), ("d", -0.5, -0.3))
        )
        text = f"""trivet = 1
gravity = [0, 0, -{G}]
[bodies.m]
mass = 100
center_of_mass = [0.1, 0.03, 0.2]
inertia = {{about = "center_of_mass", xx = 5, yy = 5, zz = 5}}
{mounts}[requirements]
mount_load = "catalogue"
"""
        results, found = self.judged(text)
        self.assertFalse(found["met"])
        for name, x, y in (("a", 1, 1), ("b", 1, -1), ("c", -1, 1), ("d", -1, -1)):
            load = 100 * G / 4 * (1 + 0.1 / 0.5 * x + 0.03 / 0.3 * y)
            carries, deflects = results[f"{name} carries 250 … 400 N"], results[f"{name} deflects ≤ 2 mm"]
            self.assertAlmostEqual(carries["value"] / load, 1, DIGITS)
            self.assertAlmostEqual(carries["margin"], min(400 / load, load / 250), DIGITS)
            self.assertAlmostEqual(deflects["margin"], 2e-3 * 2e5 / load, DIGITS)
        upside_down = text.replace(f"-{G}]", f"{G}]")
        results, _ = self.judged(upside_down)
        self.assertEqual({r["margin"] for n, r in results.items() if "carries" in n}, {0})  # tension has no range
        own = self.folder / "own.toml"
        own.write_text(own.read_text().replace("[250, 400]", "[-300, 400]"))
        results, _ = self.judged(upside_down)
        load = 100 * G / 4 * 1.3
        self.assertAlmostEqual(results["a carries -300 … 400 N"]["margin"], 300 / load, DIGITS)

    def test_loads_of_inclined_mounts(self):
        (self.folder / "own.toml").write_text(
            'catalogue = 1\ntitle = "t"\nsource = "s"\n[mounts.a]\nmaker = "m"\ntranslation = [1e5, 1e5, 4e5]\n'
            "load = {y = [-3000, 300], z = [0, 2000]}\n"
        )
        c, s = math.sqrt(0.75), 0.5
        mount = '[elements.{}]\ntype = "catalogue:a"\ncatalogue = "own.toml"\non = "m"\nat = [0, {}, 0]\naxis = [0, {}, {}]\n'
        text = f'trivet = 1\ngravity = [0, 0, -{G}]\n[bodies.m]\nmass = 200\nfree = ["z"]\n'
        text += mount.format("left", 0.3, -s, c) + mount.format("right", -0.3, -s, -c)
        results, _ = self.judged(text + '[requirements]\nmount_load = "catalogue"\n')
        load = 4e5 * c * 200 * G / 2 / (4e5 * c * c + 1e5 * s * s)
        left, right = results["left carries 0 … 2000 N"], results["right carries 0 … 2000 N"]
        self.assertAlmostEqual(left["value"] / load, 1, DIGITS)
        self.assertAlmostEqual(right["value"] / load, -1, DIGITS)
        self.assertEqual(right["margin"], 0)
        self.assertIn("in tension", right["detail"])
        across = 1e5 * s * 200 * G / 2 / (4e5 * c * c + 1e5 * s * s)  # e2 of both leans to the same side
        for name in ("left", "right"):
            found = results[f"{name} carries -3000 … 300 N along y"]
            self.assertAlmostEqual(abs(found["value"]) / across, 1, DIGITS)
            self.assertAlmostEqual(found["margin"], (300 if found["value"] > 0 else 3000) / across, DIGITS)

    def test_cases_in_which_the_design_has_to_hold(self):
        text = (
            OSCILLATOR
            + '[requirements]\nstatic = {"m.z" = "2 mm"}\nhold_in = ["", "soft"]\n[cases.soft]\nelements.s.scale = 0.5\n'
        )
        path = self.file(text)
        found = result_of("verdict", path)
        self.assertEqual([c["met"] for c in found["cases"]], [True, False])
        self.assertFalse(found["met"])
        self.assertEqual(trivet("verdict", path).returncode, 0)
        strict = trivet("verdict", path, "--strict")
        self.assertEqual((strict.returncode, "1 requirement violated" in strict.stderr), (3, True))
        alone = self.file(text.replace('"", "soft"', '""'))
        self.assertTrue(result_of("verdict", alone)["met"])
        self.assertEqual(trivet("verdict", alone, "--strict").returncode, 0)

    def test_what_cannot_be_judged_has_its_reason(self):
        step = '[excitations.s]\ntype = "time"\non = "m"\nat = [0, 0, 0]\nforce = [0, 0, 1]\nhistory = {step = {amplitude = 50}}\n'
        lossy = OSCILLATOR.replace(f"{{translation = [1e-3, 1e-3, {C}]}}", "{loss_factor = 0.1}")
        path = self.file(lossy + step + '[requirements]\nlargest = {"m.z" = "1 mm"}\nlimits = {"m.z" = "9 mm"}\n')
        done = trivet("verdict", path, "--json")
        self.assertEqual(done.returncode, 1)
        largest = json.loads(done.stdout)["cases"][0]["requirements"][1]
        self.assertEqual((largest["judged"], largest["met"], "loss factor" in largest["reason"]), (False, False, True))
        self.assertIn("NOT JUDGED", trivet("verdict", path).stdout)

    def test_what_cannot_be_judged_leaves_the_rest_judged(self):
        # A loss factor has no motion over time: not judged by itself, and where the file requests the motion too.
        lossy = OSCILLATOR.replace("damping = {translation = [1e-3, 1e-3, 400.0]}", "damping = {loss_factor = 0.1}")
        lossy += '[excitations.blow]\ntype = "time"\non = "m"\nat = [0, 0, 0]\nforce = [0, 0, 1]\n'
        lossy += "history = {step = {amplitude = 1}}\n"
        required = '[requirements]\nlargest = {"m.z" = "3 mm"}\nstatic = {"m.z" = "2 mm"}\n'
        request = "[analyses.transient]\nto = 1\nstep = 0.01\n"
        for text in (lossy + required, lossy + required + request):
            path = self.file(text)
            for strict in ((), ("--strict",)):
                self.assertEqual(trivet("verdict", path, *strict).returncode, 1)
            (case,) = json.loads(trivet("verdict", path, "--json").stdout)["cases"]
            largest, rest = sorted(case["requirements"], key=lambda row: row["kind"])
            self.assertEqual((largest["judged"], largest["value"], case["not_judged"]), (False, None, 1))
            self.assertIn("loss factor", largest["reason"])
            self.assertAlmostEqual(rest["value"], M * G / K, DIGITS)
            self.assertTrue(rest["met"])
        # The analysis itself is wrong for such a machine: who requests its result hears so first.
        for command in ("transient", "check"):
            self.assertEqual(trivet(command, path).returncode, 2)
        self.assertEqual(trivet("run", path, "--output", self.folder / "out").returncode, 2)
        # A wrong number of the settings is wrong everywhere.
        self.assertEqual(trivet("verdict", self.file(text.replace("step = 0.01", "step = -1"))).returncode, 2)

    def test_limits_and_lines_of_the_file_are_requirements(self):
        lines = '[limit_lines.severity]\nof = "m.z"\nrows = [[1, 2e-3], [50, 2e-3]]\n'
        more = '[analyses.response]\nband = ["0 Hz", "5 Hz"]\n[limits]\n"m.z" = "1 mm"\n' + lines
        results, _ = self.judged(OSCILLATOR + more)
        self.assertEqual(len(results), 2)
        w = 10 * math.pi
        level = w * 30 / math.hypot(K - M * w * w, C * w) / math.sqrt(2)
        self.assertAlmostEqual(results['m.z within "severity"']["margin"], 2e-3 / level, DIGITS)
        results, _ = self.judged(OSCILLATOR + more + "[requirements]\ndamping_ratio = 0.01\n")
        self.assertEqual(len(results), 3)  # the line and the limit too

    def test_a_limit_states_the_place_of_its_number_and_where_it_is_judged(self):
        text = (
            OSCILLATOR
            + """
[excitations.rotor]
type = "unbalance"
on = "m"
at = [0, 0, 0]
axis = "x"
mass_eccentricity = 0.001
[analyses.response]
band = ["1 Hz", "30 Hz"]
[limits]
"m.z" = "1 mm p-p"
[operation]
speeds = ["600 rpm", ["700 rpm", "800 rpm"]]
limits = {"m.z" = "3 mm"}
[requirements]
damping_ratio = 0.01
static = {"m.z" = "4 mm"}
limits = {"m.z" = [{limit = "5 mm/s rms", band = ["2 Hz", "4 Hz"], excitations = ["f"]}, {limit = "6 mm/s2", speed = ["60 rpm", "90 rpm"]}]}
"""
        )

        def rounded(ends):
            return (
                [round(x, 6) for x in ends] if isinstance(ends, list) and ends and isinstance(ends[0], float) else ends
            )

        def ends(*both):
            return rounded(list(both))

        in_si = {"mm p-p": 1e-3 / 2, "mm": 1e-3, "mm/s rms": 1e-3 * math.sqrt(2), "mm/s2": 1e-3}
        _, found = self.judged(text)
        rpm, hertz = math.pi / 30, 2 * math.pi
        places = []
        for one in found["cases"][0]["requirements"]:
            if not one["place"]:
                self.assertEqual(one["kind"], "damping_ratio")
                continue
            number = tomllib.loads(text)
            for key in one["place"]:
                number = number[int(key) if isinstance(number, list) else key]
            value, unit = number.split(" ", 1)
            self.assertAlmostEqual(one["allowed"] / (float(value) * in_si[unit]), 1, DIGITS)
            scope = [one["band"], one["speed"], one["excitations"], one["order"]]
            places.append((".".join(one["place"]), [rounded(s) for s in scope]))

        self.assertEqual(
            sorted(places, key=str),
            sorted(
                [
                    ("limits.m.z", [ends(hertz, 30 * hertz), None, [], None]),
                    ("operation.limits.m.z", [None, ends(600 * rpm, 600 * rpm), [], None]),
                    ("operation.limits.m.z", [None, ends(700 * rpm, 800 * rpm), [], None]),
                    ("requirements.limits.m.z.0.limit", [ends(2 * hertz, 4 * hertz), None, ["f"], None]),
                    ("requirements.limits.m.z.1.limit", [ends(60 * rpm, 90 * rpm), None, [], 1.0]),
                    ("requirements.static.m.z", [None, None, [], None]),
                ],
                key=str,
            ),
        )

    def test_a_run_begins_with_the_verdict(self):
        target = self.folder / "out"
        done = trivet("run", SOURCE / "examples/compressor/requirements.toml", "-o", target)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(done.stdout.startswith("VIOLATED: 1 of 32 requirements"), done.stdout[:200])
        full = trivet("run", SOURCE / "examples/compressor/requirements.toml", "-o", self.folder / "full", "--full")
        self.assertIn("Base model: meets its requirements, 16 of 16", full.stdout)
        cases = json.loads((target / "results.json").read_text())["cases"]
        self.assertEqual([c["verdict"]["met"] for c in cases], [True, False, False])
        self.assertEqual([c["verdict"]["decides"] for c in cases], [True, True, False])
        self.assertIn("carries 0 … 872 N", (target / "report.html").read_text())
        self.assertIn("3 violated, not binding", (target / "report.html").read_text())
        self.assertIn("1 of 16 VIOLATED", (target / "report.html").read_text())


if __name__ == "__main__":
    unittest.main()
