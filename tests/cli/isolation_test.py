# SPDX-License-Identifier: BSD-3-Clause
"""Isolation as a requirement, an objective and a ranking, against closed forms and the verdicts of all combinations."""
import itertools
import math
import unittest

from trivet_test import InTemporaryFolder, result_of, trivet

DIGITS = 9  # the program states nine
M, K, C = 40.0, 2.5e5, 400.0
NATURAL = math.sqrt(K / M)

# A mass on a spring and a damper that moves along z only.
OSCILLATOR = f"""trivet = 1
gravity = [0, 0, -9.80665]
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


def transmitted(w, m=M, k=K, c=C):
    """|T| of one mass, of a force and of a motion of the ground."""
    return abs(complex(k, c * w) / complex(k - m * w * w, c * w))


def rpm(speed):
    return speed * 2 * math.pi / 60


class Isolation(InTemporaryFolder):
    def rows(self, text, requirements):
        found = result_of("verdict", self.file(text + "[requirements]\n" + requirements + "\n"))
        return found["cases"][0]["requirements"], found["cases"][0]["warnings"]

    def test_orders_are_not_counted_and_that_is_said(self):
        shaft = '[excitations.shaft]\ntype = "orders"\non = "m"\nat = [0, 0, 0]\n'
        shaft += "table = [{order = 2, force = [0, 0, 50]}]\n"
        wanted = 'isolation = {at = "1480 rpm", least = "80 %"'
        words = 'requirements.isolation: engine orders ("shaft") not counted'
        _, warnings = self.rows(OSCILLATOR + shaft, wanted + "}")
        self.assertEqual(sum(words in warning for warning in warnings), 1, warnings)
        self.assertIn('add a limit on "ground.force.z" to [operation.limits]', str(warnings))
        self.assertIn('write force = ["f"]', str(warnings))
        _, named = self.rows(OSCILLATOR + shaft, wanted + ', force = ["f"]}')
        self.assertNotIn("not counted", str(named))
        text = OSCILLATOR + shaft + "[requirements]\n" + wanted + ', force = ["shaft"]}\n'
        said = trivet("verdict", self.file(text)).stderr
        self.assertIn('requirements.isolation.force: "shaft"; this excitation is of type "orders"', said)

    def test_transmissibility_at_speeds_over_a_band_and_of_a_moving_ground(self):
        rows, warnings = self.rows(
            OSCILLATOR,
            """isolation = [
  {at = ["1480 rpm", "30 Hz"], least = "80 %"},
  {band = ["5 Hz", "30 Hz"], least = "14 dB", force = "f"},
  {at = "1480 rpm", least = 0, base = "z", of = ["m"]},
]""",
        )
        self.assertEqual([row["kind"] for row in rows], 4 * ["isolation"])
        ratio = C / (2 * math.sqrt(K * M))  # the highest |T|, Den Hartog
        peak = NATURAL * math.sqrt((math.sqrt(1 + 8 * ratio**2) - 1) / (4 * ratio**2))
        expected = [
            (0.2, transmitted(rpm(1480)), rpm(1480)),
            (0.2, transmitted(60 * math.pi), 60 * math.pi),
            (10 ** (-14 / 20), transmitted(peak), peak),
            (1, transmitted(rpm(1480)), rpm(1480)),
        ]
        for row, (allowed, value, at) in zip(rows, expected):
            self.assertAlmostEqual(row["allowed"], allowed, DIGITS)
            self.assertAlmostEqual(row["value"] / value, 1, DIGITS)
            self.assertAlmostEqual(row["margin"] * value / allowed, 1, DIGITS)
            self.assertAlmostEqual(row["angular_frequency"] / at, 1, 7)  # the place of a flat maximum has fewer digits
            self.assertEqual(row["met"], value <= allowed)
        self.assertEqual(warnings, [])
        text = trivet(
            "verdict",
            self.file(OSCILLATOR + '[requirements]\nisolation = {at = "10 Hz", least = "80 %"}\n'),
        ).stdout
        amplified = transmitted(20 * math.pi)
        self.assertIn(f"amplified: T = {amplified:.4g}, isolation {-20 * math.log10(amplified):.3g} dB", text)

    def test_the_level_of_an_isolation_has_one_sign_everywhere(self):
        isolates, amplifies = transmitted(60 * math.pi), transmitted(20 * math.pi)
        levels = [f"{-20 * math.log10(t):.3g} dB" for t in (isolates, amplifies)]
        self.assertEqual([level.startswith("-") for level in levels], [False, True])
        required = OSCILLATOR + '[requirements]\nisolation = {at = "30 Hz", least = "3 dB"}\n'
        verdict = trivet("verdict", self.file(required)).stdout
        self.assertIn(f"(T = {isolates:.4g}, {levels[0]})", verdict)
        for hertz, level in zip((30, 10), levels):
            running = OSCILLATOR + f'[operation]\nspeeds = ["{hertz} Hz"]\n'
            self.assertIn(f"%, {level}", trivet("operation", self.file(running)).stdout)
        silent = '[analyses.transmissibility]\nforce = "f"\nband = ["10 Hz", "10.0001 Hz"]\n'
        _, warnings = self.rows(OSCILLATOR + silent, 'limits = {"m.z" = "9 mm"}')
        self.assertTrue(any(f"isolation {levels[1]}" in w for w in warnings), warnings)

    def test_an_unbalance_is_isolated_along_both_axes_of_its_circle(self):
        stiff = OSCILLATOR.replace('free = ["z"]', 'free = ["y", "z"]').replace("[1, 1,", "[1, 1e5,")
        stiff = stiff.replace("[1e-3, 1e-3,", "[1e-3, 300,").replace(
            'type = "harmonic"',
            'type = "unbalance"\naxis = "x"\nservice_speed = "1480 rpm"\nmass_eccentricity = 0.01',
        )
        rows, _ = self.rows(stiff.replace("force = [0, 0, 30]\n", ""), 'isolation = {least = "60 %"}')
        w = rpm(1480)  # the default: the service speed
        for row, (k, c) in zip(rows, ((1e5, 300), (K, C)), strict=True):
            self.assertAlmostEqual(row["value"] / transmitted(w, M, k, c), 1, DIGITS)
        self.assertIn("along y", rows[0]["requirement"])
        self.assertIn("along z", rows[1]["requirement"])

    def test_a_limit_has_its_own_band_and_excitations(self):
        two = OSCILLATOR + '[excitations.g]\ntype = "harmonic"\non = "m"\nat = [0, 0, 0]\nforce = [0, 0, 7]\n'
        rows, _ = self.rows(
            two,
            """band = ["2 Hz", "4 Hz"]
excitations = ["g"]
[requirements.limits]
"m.z" = [{limit = "1 mm", band = ["30 Hz", "40 Hz"], excitations = ["f"]}, "2 mm", {limit = "3 mm/s", band = ["20 Hz", "25 Hz"]}]
""",
        )

        def amplitude(hertz, force):
            w = 2 * math.pi * hertz
            return force / abs(complex(K - M * w * w, C * w))

        expected = (amplitude(30, 30), amplitude(4, 7), 40 * math.pi * amplitude(20, 7))
        for row, value in zip(rows, expected, strict=True):
            self.assertAlmostEqual(row["value"] / value, 1, DIGITS)

    def test_a_limit_over_speeds_is_one_for_each_order(self):
        crank = """[excitations.crank]
type = "orders"
on = "m"
at = [0, 0, 0]
table = [{order = 2, force_per_speed2 = [0, 0, 0.02]}, {order = 0.5, force = [0, 0, 40]}]
"""
        base = OSCILLATOR.split("[excitations")[0] + crank
        rows, _ = self.rows(
            base,
            'limits = {"m.z" = {limit = "9 mm/s", speed = ["300 rpm", "600 rpm"]}}',
        )
        ratio = C / (2 * math.sqrt(K * M))

        def velocity(force, w):
            return force * w / abs(complex(K - M * w * w, C * w))

        slow = velocity(40, 0.5 * rpm(600))  # far below the resonance, at the highest speed
        fast = max(  # order 2: 20 Hz is above the resonance, whose peak in m e ω² · ω is that of a cubic
            velocity(0.02 * (w / 2) ** 2, w) for w in (NATURAL * (0.95 + 1e-5 * i) for i in range(15000))
        )
        self.assertLess(ratio, 0.2)
        for row, expected, digits in zip(rows, (slow, fast), (DIGITS, 7), strict=True):
            self.assertAlmostEqual(row["value"] / expected, 1, digits)
        self.assertIn("in order 2 of 300 … 600 rpm", rows[1]["requirement"])

    def test_amplification_where_a_machine_runs_is_a_warning(self):
        amplified = OSCILLATOR + '[analyses.transmissibility]\nforce = "f"\nband = ["12 Hz", "13 Hz"]\n'
        limit = 'limits = {"m.z" = "9 mm"}'
        _, warnings = self.rows(amplified, limit)
        self.assertEqual(len([w for w in warnings if "is amplified" in w]), 1)
        for speaks in (
            limit.replace("}", ', "ground.force.z" = "900 N"}'),
            limit + "\nisolation = {at = 80, least = 0}",
        ):
            _, quiet = self.rows(amplified, speaks)
            self.assertFalse([w for w in quiet if "is amplified" in w])
        # A wide band is a run-up, a speed above the crossover isolates.
        for band in ('["1 Hz", "13 Hz"]', '["20 Hz", "25 Hz"]'):
            _, quiet = self.rows(amplified.replace('["12 Hz", "13 Hz"]', band), limit)
            self.assertFalse([w for w in quiet if "is amplified" in w])
        table = trivet("transmissibility", self.file(amplified)).stdout  # over the band, not over all frequencies
        self.assertIn("highest |T| in the band", table)
        above = result_of(
            "transmissibility",
            self.file(amplified.replace('["12 Hz", "13 Hz"]', '["20 Hz", "25 Hz"]')),
        )
        self.assertAlmostEqual(
            above["results"][0]["highest_in_band"] / transmitted(40 * math.pi),
            1,
            DIGITS,
        )

    def test_mounts_that_cancel_in_the_total_force_are_a_warning(self):
        w, arm, lever = rpm(1480), 0.5, 0.3
        inertia = K * arm**2 / w**2  # pitch in resonance at the speed, heave far below it
        machine = f"""trivet = 1
[bodies.m]
mass = {M}
inertia = {{about = "center_of_mass", xx = 9, yy = {inertia}, zz = 9}}
free = ["z", "ry"]
[excitations.f]
type = "harmonic"
on = "m"
at = [{lever}, 0, 0]
force = [0, 0, 100]
[requirements]
isolation = {{at = "1480 rpm", least = "60 %"}}
"""
        names = ("a", "b", "c", "d")
        for name, x in zip(names, (arm, arm, -arm, -arm), strict=True):
            machine += f"""[elements.{name}]
type = "bushing"
on = "m"
at = [{x}, 0, 0]
translation = [1, 1, {K / 4}]
damping = {{translation = [1e-9, 1e-9, {C / 40}]}}
"""

        # Forces of the four mounts over that of the excitation: heave and pitch by hand.
        stiff = complex(K, C / 10 * w)
        heave, pitch = 1 / (stiff - M * w * w), lever / (stiff * arm**2 - inertia * w * w)
        single = [abs(stiff / 4 * (heave + x * pitch)) for x in (arm, arm, -arm, -arm)]

        def sums(text):
            found = result_of("verdict", self.file(text))
            texts = [w for w in found["cases"][0]["warnings"] if "single mounts add up" in w]
            return [float(w.split("add up to ")[1].split(" times")[0]) for w in texts], texts

        self.assertGreater(sum(single), 5)
        (stated,), (words,) = sums(machine)
        self.assertAlmostEqual(stated / sum(single), 1, 2)  # three digits are stated
        self.assertIn(f"alone transmits {max(single):.3g}", words)
        self.assertIn(f"is {transmitted(w, c=C / 10):.3g} of it in total", words)
        self.assertIn('limits = {"a.force.z"', words)
        # A run shows it too, and --strict counts it.
        out = self.folder / "out"
        self.assertEqual(trivet("run", self.file(machine), "--output", out, "--strict").returncode, 4)
        self.assertIn("single mounts add up", (out / "report.html").read_text())
        # A band meets the resonance within it; a force in the middle excites no pitch.
        band = machine.replace('at = "1480 rpm"', 'band = ["23 Hz", "40 Hz"]')
        self.assertAlmostEqual(sums(band)[0][0] / sum(single), 1, 2)
        self.assertEqual(sums(machine.replace(f"at = [{lever}, 0, 0]", "at = [0, 0, 0]"))[0], [])
        # Who limits the worst mount in this direction knows; other limits are not enough.
        for limited, count in ((["a.force.z"], 0), (["c.force.z"], 1), (["a.force.x"], 1)):
            limits = ", ".join(f'"{name}" = "5 N"' for name in limited)
            judged = machine.replace("[requirements]\n", f"[requirements]\nlimits = {{{limits}}}\n")
            self.assertEqual(len(sums(judged)[0]), count)
        self.assertEqual(
            sums(machine.replace("force = [0, 0, 100]", "moment = [0, 100, 0]"))[0],
            [],
            "amplified in total",
        )

    def test_moments_of_mounts_that_sway_are_a_warning(self):
        # Sway in resonance on mounts below the centre of mass: they twist the ground singly, which cancels in the sum.
        inertia, sway, lift, below, half = 8.0, 1e5, 6e4, 0.1, 0.5
        w = 0.98 * math.sqrt(4 * sway / M)
        damper = 20.0
        machine = f"""trivet = 1
[bodies.m]
mass = {M}
inertia = {{about = "center_of_mass", xx = {inertia}, yy = {inertia}, zz = {inertia}}}
free = ["x", "ry"]
[excitations.f]
type = "harmonic"
on = "m"
at = [0, 0, 0]
moment = [0, 7, 0]
[requirements]
isolation = {{at = {w!r}, least = "20 %"}}
"""
        corners = [(x, y) for x in (half, -half) for y in (half, -half)]
        for i, (x, y) in enumerate(corners):
            machine += f"""[elements.mount{i}]
type = "bushing"
on = "m"
at = [{x}, {y}, {-below}]
translation = [{sway}, 1, {lift}]
damping = {{translation = [{damper}, 1e-9, {damper}]}}
"""

        def moments(w):
            """The total moment about y, and the sum of the moments of the mounts, for a moment of 1."""
            x, z = complex(sway, damper * w), complex(lift, damper * w)
            shift, both, turn = (
                4 * x - M * w * w,
                -4 * x * below,
                4 * (x * below**2 + z * half**2) - inertia * w * w,
            )
            angle = shift / (shift * turn - both**2)
            side = x * (-both / shift * angle - below * angle)
            single = [(at[1] * z * -at[0] * angle, at[0] ** 2 * z * angle, -at[1] * side) for at in corners]
            total = abs(4 * (z * half**2 * angle - below * side))
            axes = [math.sqrt((sum(abs(m) ** 2 for m in one) + abs(sum(m * m for m in one))) / 2) for one in single]
            return total, sum(axes)

        total, single = moments(w)
        self.assertLess(total, 0.8)
        self.assertGreater(single, 2 * moments(1e-6)[1])
        found = result_of("verdict", self.file(machine))["cases"][0]
        self.assertTrue(found["met"])
        (words,) = [one for one in found["warnings"] if "single mounts" in one]
        self.assertIn(f"is {total:.3g} of it in total, but the moments", words)
        self.assertIn(f"add up to {single:.3g} times it", words)

    def test_optimize_isolates_as_far_as_the_sag_allows(self):
        text = (
            OSCILLATOR
            + """[parameters.k]
path = "elements.s.translation.z"
from = 5e4
to = 1e6
spacing = "logarithmic"
[requirements]
isolation = {at = "1480 rpm", least = "50 %"}
static = {"m.z" = "2 mm"}
[analyses.optimize]
minimize = "isolation"
starts = 2
"""
        )
        softest = M * 9.80665 / 2e-3  # the stiffness of a sag of 2 mm
        found = result_of("optimize", self.file(text))
        self.assertTrue(found["feasible"])
        self.assertAlmostEqual(found["parameters"][0]["optimum"] / softest, 1, 6)
        self.assertAlmostEqual(found["after"] / (transmitted(rpm(1480), k=softest) / 0.5), 1, 6)
        # The largest least margin balances both: (1 − 50 %) / T = 2 mm / sag.
        balanced = result_of("optimize", self.file(text.replace('minimize = "isolation"\n', "")))
        k = balanced["parameters"][0]["optimum"]
        self.assertAlmostEqual(0.5 / transmitted(rpm(1480), k=k) / (2e-3 * k / (M * 9.80665)), 1, 6)

    def test_a_map_judges_isolation_and_limits_with_their_own_band(self):
        text = (
            OSCILLATOR
            + """[parameters.stiffness]
path = "elements.s.translation.z"
from = 5e4
to = 5e5
[parameters.damper]
path = "elements.s.damping.translation.z"
from = 50
to = 2000
[requirements]
isolation = {at = "1480 rpm", least = "80 %"}
limits = {"m.z" = {limit = "0.04 mm", band = ["30 Hz", "40 Hz"]}}
[analyses.map]
x = {parameter = "stiffness", points = 4}
y = {parameter = "damper", points = 3}
"""
        )
        found = result_of("map", self.file(text))
        self.assertEqual(sorted(rule["kind"] for rule in found["rules"]), ["amplitude", "isolation"])
        w = 60 * math.pi  # all natural frequencies are below 30 Hz
        places = [(k, c) for c in (50, 1025, 2000) for k in (5e4, 2e5, 3.5e5, 5e5)]
        for (k, c), stored in zip(places, found["grid"]["margin"], strict=True):
            amplitude = 30 / abs(complex(k - M * w * w, c * w))
            margin = min(0.2 / transmitted(rpm(1480), M, k, c), 0.04e-3 / amplitude)
            self.assertAlmostEqual(stored / margin, 1, 6)  # a map stores margins in single precision


# Vertical and pitching motion on one mount in front and one behind.
MACHINE = """trivet = 1
gravity = [0, 0, -9.80665]
[bodies.m]
mass = 600
center_of_mass = [-0.3, 0, 0.4]
inertia = {about = "center_of_mass", xx = 40, yy = 90, zz = 90}
free = ["z", "ry"]
[elements.front]
type = "catalogue:soft"
catalogue = "maker.toml"
on = "m"
at = [0.8, 0, 0]
axis = "z"
[elements.rear]
type = "catalogue:soft"
catalogue = "maker.toml"
on = "m"
at = [-0.7, 0, 0]
axis = "z"
[excitations.run]
type = "harmonic"
on = "m"
at = [0.2, 0, 0]
force = [0, 0, 120]
[parameters.ahead]
path = "elements.front.type"
catalogue = "maker.toml"
[parameters.behind]
path = "elements.rear.type"
catalogue = "maker.toml"
[requirements]
mount_load = "catalogue"
"""
MOUNTS = {  # stiffness, load range, price, mass
    "soft": (2e5, (200, 4000), 21.0, 1.5),
    "medium": (3e5, (200, 4500), 22.5, 1.0),
    "firm": (8e5, (200, 5000), 17.0, 1.25),
    "hard": (1.3e6, (200, 8000), 41.0, 2.0),
}
CATALOGUE = "catalogue = 1\ntitle = 'maker'\nsource = 'made up'\n" + "".join(
    f"""[mounts.{name}]
maker = "none"
translation = [1e6, 1e6, {k}]
loss_factor = 0.1
static_load = [{load[0]}, {load[1]}]
mass = {mass}
price = "{price} EUR"
"""
    for name, (k, load, price, mass) in MOUNTS.items()
)
ISOLATION = 'isolation = {at = "1480 rpm", least = "70 %"}\n'


class RankedMounts(InTemporaryFolder):
    def setUp(self):
        super().setUp()
        self.file(CATALOGUE, "maker.toml")

    def test_a_load_range_alone_chooses_the_stiffest_mounts_with_a_warning(self):
        # Between the two natural frequencies on the stiffest mounts, near the lower one.
        operation = '[analyses.transmissibility]\nforce = "run"\nband = ["10 Hz", "11 Hz"]\n'
        places = "[parameters.ahead]" + MACHINE.partition("[parameters.ahead]")[2].partition("[requirements]")[0]
        both = """[parameters.mount]
path = ["elements.front.type", "elements.rear.type"]
catalogue = "maker.toml"
"""
        machine = MACHINE.replace(places, both)
        found = result_of("select", self.file(machine + operation))
        self.assertEqual(found["best"][0]["mounts"], {"mount": "hard"})
        self.assertGreater(found["best"][0]["transmissibility"], 1)
        self.assertTrue(any("is amplified" in w for w in found["warnings"]))
        shown = trivet("select", self.file(machine + operation)).stdout
        level = -20 * math.log10(found["best"][0]["transmissibility"])
        self.assertIn(f"({level:.3g} dB) AMPLIFIES", shown)
        self.assertIn('transmits: largest force on the ground over "run", 10 … 11 Hz', shown)
        with_isolation = result_of("select", self.file(machine + ISOLATION + operation))
        self.assertFalse(any("is amplified" in w for w in with_isolation["warnings"]))

    def test_the_cheapest_the_lightest_and_the_best_isolating_that_hold(self):
        project = self.file(MACHINE + ISOLATION)
        judged = {}
        for pair in itertools.product(MOUNTS, MOUNTS):
            settings = [
                word
                for at, name in zip(("front", "rear"), pair)
                for word in ("--set", f'elements.{at}.type = "catalogue:{name}"')
            ]
            rows = result_of("verdict", project, *settings)["cases"][0]["requirements"]
            isolation = next(row["value"] for row in rows if row["kind"] == "isolation")
            judged[pair] = (min(row["margin"] for row in rows), isolation)
        holding = [pair for pair, (margin, _) in judged.items() if margin >= 1]
        self.assertGreater(len(holding), 2)
        self.assertLess(len(holding), len(judged))
        keys = {
            "price": lambda pair: sum(MOUNTS[name][2] for name in pair),
            "mass": lambda pair: sum(MOUNTS[name][3] for name in pair),
            "isolation": lambda pair: judged[pair][1],
        }
        for by, key in keys.items():
            expected = sorted(holding, key=lambda pair: (round(key(pair), 8), -judged[pair][0]))
            found = result_of("select", project, "--by", by, "--most", "16")
            self.assertEqual(found["by"], by)
            self.assertEqual(
                [(d["mounts"]["ahead"], d["mounts"]["behind"]) for d in found["best"]],
                expected,
            )
            first = result_of("select", project, "--by", by, "--most", "1")
            self.assertEqual(first["best"][0]["mounts"], found["best"][0]["mounts"])
        self.assertIn("Cheapest combination", trivet("select", project, "--by", "price").stdout)

    def test_orders_need_what_they_rank_by(self):
        for text, by, words in (
            (MACHINE, "isolation", "no isolation is required"),
            (MACHINE + ISOLATION, "weight", "--by"),
        ):
            done = trivet("select", self.file(text), "--by", by)
            self.assertEqual(done.returncode, 2, done.stdout)
            self.assertIn(words, done.stderr)
        self.file(CATALOGUE.replace('price = "17.0 EUR"\n', ""), "maker.toml")
        done = trivet("select", self.file(MACHINE + ISOLATION), "--by", "price")
        self.assertIn('the catalogue gives no price of "firm"', done.stderr)


if __name__ == "__main__":
    unittest.main()
