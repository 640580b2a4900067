# SPDX-License-Identifier: BSD-3-Clause
"""`trivet select` against hand calculations and against the verdict of every combination."""
import itertools
import math
import shlex
import unittest

from trivet_test import SOURCE, InTemporaryFolder, result_of, trivet

DIGITS = 9  # the program states nine for peaks; statics and natural frequencies have more
G = 9.80665

# Vertical and pitching motion on one mount in front and one behind: the loads follow from equilibrium alone.
MACHINE = f"""trivet = 1
gravity = [0, 0, -{G}]
[bodies.m]
mass = 600
center_of_mass = [-0.3, 0, 0.4]
inertia = {{about = "center_of_mass", xx = 40, yy = 90, zz = 90}}
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
[excitations.f]
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
"""
NAMES = ["soft", "medium", "firm", "hard"]
STIFFNESS = {"soft": 3e5, "medium": 5e5, "firm": 8e5, "hard": 1.3e6}
PRICES = {"soft": 20.0, "medium": 22.5, "firm": 30.0, "hard": 41.0}
MASSES = {"soft": 1.0, "medium": 1.5, "firm": 1.25, "hard": 2.0}
LOADS = {"soft": (500, 2500), "medium": (1000, 3500), "firm": (2000, 5000), "hard": (3000, 8000)}
CATALOGUE = "catalogue = 1\ntitle = 'maker'\nsource = 'made up'\n" + "".join(
    f"""[mounts.{name}]
maker = "none"
translation = [1e6, 1e6, {STIFFNESS[name]}]
loss_factor = 0.1
static_load = [{LOADS[name][0]}, {LOADS[name][1]}]
static_deflection_limit = "7 mm"
mass = {MASSES[name]}
price = "{PRICES[name]} EUR"
"""
    for name in NAMES
)
REQUIREMENTS = """[requirements]
band = ["2 Hz", "40 Hz"]
limits = {"m.z" = "0.6 mm"}
natural_frequencies = {avoid = [["7.5 Hz", "8.5 Hz"]]}
mount_load = "catalogue"
price = "60 EUR"
"""
# Equilibrium: the centre of mass is 0.3 m behind the pole.
FRONT = 600 * G * (-0.3 + 0.7) / 1.5
REAR = 600 * G - FRONT


def with_mounts(ahead, behind):
    """The settings that put two mounts at their places."""
    places = (("front", ahead), ("rear", behind))
    return [word for at, name in places for word in ("--set", f'elements.{at}.type = "catalogue:{name}"')]


class Select(InTemporaryFolder):
    def setUp(self):
        super().setUp()
        self.file(CATALOGUE, "maker.toml")

    def selected(self, text, *options):
        return result_of("select", self.file(text), *options)

    def refused(self, text):
        result = trivet("select", self.file(text))
        self.assertEqual(result.returncode, 2, result.stdout)
        return result.stderr

    def test_every_combination_has_the_margin_of_its_verdict(self):
        project = self.file(MACHINE + REQUIREMENTS)
        found = result_of("select", project, "--most", "16")
        self.assertEqual(found["combinations"], 16)
        self.assertEqual(len(found["best"]), 16)
        margins = {}
        for ahead, behind in itertools.product(NAMES, NAMES):
            judged = result_of("verdict", project, *with_mounts(ahead, behind))
            margins[ahead, behind] = min(r["margin"] for r in judged["cases"][0]["requirements"])
        ranked = [(d["mounts"]["ahead"], d["mounts"]["behind"]) for d in found["best"]]
        self.assertEqual(len(set(ranked)), 16)
        for design, mounts in zip(found["best"], ranked):
            self.assertAlmostEqual(design["margin"] / margins[mounts], 1, DIGITS)
            self.assertEqual(design["met"], margins[mounts] >= 1)
        by_margin = [round(margins[mounts], DIGITS) for mounts in ranked]  # equal ones keep the order of the catalogue
        self.assertEqual(by_margin, sorted(by_margin, reverse=True))
        # Few combinations are computed completely if only the first is requested, and it is the same.
        first = result_of("select", project, "--most", "1")
        self.assertEqual(first["best"][0]["mounts"], found["best"][0]["mounts"])
        self.assertLess(first["judged"], 16)

    def test_loads_sums_and_natural_frequencies_by_hand(self):
        # The matrices below have no stiffness of the weight.
        found = self.selected("second_order = false\n" + MACHINE + REQUIREMENTS, "--most", "16")
        yy = 90 + 600 * (0.3**2 + 0.4**2)  # about the pole
        for design in found["best"]:
            ahead, behind = design["mounts"]["ahead"], design["mounts"]["behind"]
            self.assertAlmostEqual(design["load"], max(FRONT / LOADS[ahead][1], REAR / LOADS[behind][1]), DIGITS)
            sag = max(FRONT / STIFFNESS[ahead], REAR / STIFFNESS[behind])
            self.assertAlmostEqual(design["deflection"] / sag, 1, DIGITS)
            self.assertAlmostEqual(design["price"], PRICES[ahead] + PRICES[behind], DIGITS)
            self.assertEqual(design["currency"], "EUR")
            self.assertAlmostEqual(design["mass"], MASSES[ahead] + MASSES[behind], DIGITS)
            a, b = STIFFNESS[ahead], STIFFNESS[behind]
            # z and ry of the pole: K = [[a + b, −(0.8 a − 0.7 b)], …], A = [[m, −m x], [−m x, yy]]
            k11, k12, k22 = a + b, -(0.8 * a - 0.7 * b), 0.64 * a + 0.49 * b
            m11, m12, m22 = 600, 600 * 0.3, yy
            two, one, none = m11 * m22 - m12 * m12, -(m11 * k22 + m22 * k11 - 2 * m12 * k12), k11 * k22 - k12 * k12
            root = math.sqrt(one * one - 4 * two * none)
            for key, square in (
                ("lowest_angular_frequency", (-one - root) / (2 * two)),
                ("highest_angular_frequency", (-one + root) / (2 * two)),
            ):
                self.assertAlmostEqual(design[key] / math.sqrt(square), 1, DIGITS)

    def test_mounts_differ_in_front_and_behind(self):
        best = self.selected(MACHINE + '[requirements]\nmount_load = "catalogue"\n')["best"][0]

        def margin(load, name):
            low, high = LOADS[name]
            return min(high / load, load / low, 0.007 * STIFFNESS[name] / load)

        ahead = max(NAMES, key=lambda name: margin(FRONT, name))
        behind = max(NAMES, key=lambda name: margin(REAR, name))
        self.assertNotEqual(ahead, behind)
        self.assertEqual(best["mounts"], {"ahead": ahead, "behind": behind})
        self.assertAlmostEqual(best["margin"] / min(margin(FRONT, ahead), margin(REAR, behind)), 1, DIGITS)

    def test_tests_that_combinations_fail_are_counted(self):
        found = self.selected(MACHINE + REQUIREMENTS)
        counts = {one["test"]: one["combinations"] for one in found["failed"]}
        price = load = 0
        for ahead, behind in itertools.product(NAMES, NAMES):
            if PRICES[ahead] + PRICES[behind] > 60:
                price += 1
            elif not (LOADS[ahead][0] <= FRONT <= LOADS[ahead][1] and LOADS[behind][0] <= REAR <= LOADS[behind][1]):
                load += 1
        self.assertEqual(counts["price"], price)
        self.assertEqual(counts["mount_load"], load)
        left = self.selected(MACHINE + REQUIREMENTS, "--most", "16")
        self.assertEqual(sum(counts.values()), sum(not design["met"] for design in left["best"]))

    def test_tables_are_those_of_all_combinations(self):
        # A place more, turned mounts, losses, and requirements of amplitudes and peaks: 64 combinations.
        middle = MACHINE[MACHINE.index("[elements.rear]") : MACHINE.index("[excitations.f]")]
        middle = middle.replace("rear", "middle").replace("[-0.7, 0, 0]", "[0.1, 0.2, 0.1]")
        middle = middle.replace('axis = "z"', "axis = [0.1, 0.2, 1]")
        text = MACHINE.replace("[excitations.f]", middle + "[excitations.f]").replace(
            '["z", "ry"]', '["z", "rx", "ry"]'
        )
        text += '[parameters.between]\npath = "elements.middle.type"\ncatalogue = "maker.toml"\n'
        text += """[requirements]
band = ["2 Hz", "40 Hz"]
limits = {"m.z" = "0.12 mm", "front.force.z" = "60 N", "ground.force.z" = "150 N"}
no_peak = "m.rx"
peak_tolerance = 40
natural_frequencies = {avoid = [["12 Hz", "12.5 Hz"]]}
"""
        every, first = self.selected(text, "--most", "64"), self.selected(text, "--most", "1")
        self.assertEqual(every["judged"], 64)
        self.assertLess(first["judged"], 24)
        self.assertGreaterEqual(first["curves"], first["judged"])
        self.assertEqual(first["without_curves"], "")
        self.assertEqual(first["best"], every["best"][:1])
        margins = [design["margin"] for design in every["best"]]
        self.assertGreater(len(set(design["governing"] for design in every["best"])), 2)
        for choice in first["choices"]:
            for option in choice["mounts"]:
                of_all = max(d["margin"] for d in every["best"] if d["mounts"][choice["name"]] == option["mount"])
                self.assertEqual(option["best"]["margin"], of_all)
        failed = sum(one["combinations"] for one in first["failed"])
        self.assertEqual(failed, sum(margin < 1 for margin in margins))

    def test_largest_transmissibility_in_its_band(self):
        text = (
            MACHINE.replace('free = ["z", "ry"]', 'free = ["z"]').replace("[-0.3, 0, 0.4]", "[0, 0, 0]")
            + '[requirements]\nmount_load = "catalogue"\n'
        )
        text += '[analyses]\ntransmissibility = {force = "f", band = ["20 Hz", "25 Hz"]}\n'
        for design in self.selected(text, "--most", "16")["best"]:
            k = sum(STIFFNESS[name] for name in design["mounts"].values())
            w = 40 * math.pi  # above resonance: the lower end
            self.assertAlmostEqual(
                design["transmissibility"] / abs(k * (1 + 0.1j) / (k * (1 + 0.1j) - 600 * w * w)), 1, DIGITS
            )

    def test_a_case_counts_in_which_the_design_has_to_hold(self):
        text = MACHINE + '[requirements]\nmount_load = "catalogue"\nhold_in = ["", "loaded"]\n'
        text += "[cases.loaded]\nbodies.m.mass = 900\n"
        best = self.selected(text, "--most", "16")["best"]
        for design in best:
            margins = []
            for load, name in ((FRONT, design["mounts"]["ahead"]), (REAR, design["mounts"]["behind"])):
                low, high = LOADS[name]
                margins += [high / (1.5 * load), load / low, 0.007 * STIFFNESS[name] / (1.5 * load)]
            self.assertAlmostEqual(design["margin"] / min(margins), 1, DIGITS)

    def test_settings_of_the_first_choice_give_its_margin(self):
        project = self.file(MACHINE + REQUIREMENTS)
        text = trivet("select", project)
        self.assertEqual(text.returncode, 0, text.stderr)
        lines = [line.strip() for line in text.stdout.splitlines() if line.startswith("--set '")]
        self.assertGreaterEqual(len(lines), 2)
        settings = [word for line in lines for word in ("--set", line[len("--set '") : -1])]
        judged = result_of("verdict", project, *settings)
        margin = min(r["margin"] for r in judged["cases"][0]["requirements"])
        self.assertAlmostEqual(result_of("select", project)["best"][0]["margin"] / margin, 1, DIGITS)

    def test_settings_of_names_with_quotes(self):
        name = "M 1\" 40 ShA's"
        self.file(CATALOGUE.replace("[mounts.hard]", '[mounts."M 1\\" 40 ShA\'s"]'), "maker.toml")
        text = trivet(
            "select",
            self.file(MACHINE + '[requirements]\nmount_load = "catalogue"\nprice = "1000 EUR"\n'),
            "--set",
            'elements.front.type = "catalogue:M 1\\" 40 ShA\'s"',
        )
        self.assertEqual(text.returncode, 0, text.stderr)
        settings = [
            word for line in text.stdout.splitlines() if line.startswith("--set '") for word in shlex.split(line)
        ]
        self.assertEqual(trivet("verdict", self.folder / "project.toml", *settings).returncode, 0)
        self.assertIn(name, text.stdout)

    def test_given_mount_that_is_not_judged(self):
        # The machine leans on its mounts: those without a range along x are not judged, and the others are ranked.
        text = MACHINE.replace("gravity = [0, 0,", "gravity = [1.5, 0,").replace(
            'free = ["z", "ry"]', 'free = ["x", "z", "ry"]'
        )
        with_x = CATALOGUE
        for name in ("firm", "hard"):
            at = with_x.index(f"[mounts.{name}]")
            with_x = with_x[:at] + with_x[at:].replace(
                f"static_load = [{LOADS[name][0]}, {LOADS[name][1]}]",
                f"load = {{x = [-2000, 2000], z = [{LOADS[name][0]}, {LOADS[name][1]}]}}",
                1,
            )
        self.file(with_x, "maker.toml")
        found = self.selected(text + '[requirements]\nmount_load = "catalogue"\n', "--most", "16")
        self.assertIn("has no range", found["given"]["reason"])
        judged = [d["mounts"] for d in found["best"] if not d["reason"]]
        self.assertEqual(len(judged), 4)
        self.assertTrue(all(set(m.values()) <= {"firm", "hard"} for m in judged))

    def test_what_cannot_be_selected(self):
        without = MACHINE.split("[parameters.ahead]")[0] + REQUIREMENTS
        self.assertIn("choices of mounts: the file has none", self.refused(without))
        self.assertIn("neither requirements nor limits", self.refused(MACHINE))
        case = MACHINE + '[requirements]\nmount_load = "catalogue"\nhold_in = ["", "other"]\n'
        case += '[cases.other]\nelements.front.type = "catalogue:hard"\n'
        self.assertIn('the case "other" sets the mount of "front"', self.refused(case))
        elsewhere = MACHINE + '[cases.other.requirements]\nmount_load = "catalogue"\nhold_in = [""]\n'
        self.assertIn("no case in which the requirements hold has any", self.refused(elsewhere))

    def test_mounts_without_a_price_are_named(self):
        self.file(CATALOGUE.replace('price = "30.0 EUR"\n', "").replace('"41.0 EUR"', '"41 USD"'), "maker.toml")
        message = self.refused(MACHINE + REQUIREMENTS)
        self.assertIn('no price in "EUR" of "firm", "hard"', message)

    def test_no_combination_meets_the_requirements(self):
        project = self.file(MACHINE + REQUIREMENTS.replace("60 EUR", "10 EUR"))
        self.assertIn("NO combination", trivet("select", project).stdout)
        self.assertEqual(trivet("select", project, "--strict").returncode, 3)

    def test_exchange_where_there_are_too_many_combinations(self):
        # Two equal machines that do not touch: the best of both is twice the best of one, which is proven.
        def machine(name, shift):
            text = MACHINE[MACHINE.index("[bodies.m]") : MACHINE.index("[excitations.f]")]
            text = text.replace("bodies.m]", f"bodies.{name}]\nposition = [{shift}, 0, 0]").replace('"m"', f'"{name}"')
            text = text.replace("catalogue:soft", "catalogue:m9").replace("maker.toml", "many.toml")
            text = text.replace("elements.front", f"elements.{name}front").replace(
                "elements.rear", f"elements.{name}rear"
            )
            middle = text[text.index(f"[elements.{name}rear]") :].replace(f"{name}rear", f"{name}middle")
            text += middle.replace("at = [-0.7, 0, 0]", "at = [0.1, 0, 0]")
            for place in ("front", "middle", "rear"):
                text += f"[parameters.{name}{place}]\npath = 'elements.{name}{place}.type'\ncatalogue = 'many.toml'\n"
            return text

        many = "catalogue = 1\ntitle = 'many'\nsource = 'made up'\n"
        for k in range(36):
            stiffness = 3e5 * 1.06**k
            many += f"[mounts.m{k}]\nmaker = 'none'\ntranslation = [1e6, 1e6, {stiffness}]\nloss_factor = 0.1\n"
            many += f"static_load = [{0.0015 * stiffness}, {0.0075 * stiffness}]\n"
        self.file(many, "many.toml")
        # The stiffness, also that of the forces at rest, is a sum over the mounts, and so bounds lead the exchange.
        head = f"trivet = 1\ngravity = [0, 0, -{G}]\n"
        required = '[requirements]\nmount_load = "catalogue"\nnatural_frequencies = {avoid = [["5 Hz", "6 Hz"]]}\n'
        one = self.selected(head + machine("a", 0) + required, "--most", "1")
        both = self.selected(head + machine("a", 0) + machine("b", 5) + required, "--most", "3")
        self.assertEqual(one["combinations"], 36**3)
        self.assertEqual(both["all_combinations"], 36**6)
        self.assertLess(both["combinations"], 36**5)
        self.assertAlmostEqual(both["best"][0]["margin"] / one["best"][0]["margin"], 1, DIGITS)
        self.assertEqual(len(both["choices"]), 6)
        self.assertTrue(all(len(choice["mounts"]) == 36 for choice in both["choices"]))

    def test_loads_across_mounts_without_a_range_are_not_judged(self):
        inclined = MACHINE.replace('axis = "z"\n[excitations', 'axis = [0.3, 0, 1]\n[excitations').replace(
            'free = ["z", "ry"]', 'free = ["x", "z", "ry"]'
        )
        done = trivet("select", self.file(inclined + '[requirements]\nmount_load = "catalogue"\n'))
        self.assertEqual(done.returncode, 1)
        self.assertIn("no combination of mounts can be judged", done.stderr)

    def test_genset_of_the_examples(self):
        found = result_of("select", str(SOURCE / "examples/genset/mounts.toml"))
        self.assertEqual(found["combinations"], 12**3)
        best = found["best"][0]
        self.assertTrue(best["met"])
        self.assertNotEqual(best["mounts"]["front"], best["mounts"]["rear"])


if __name__ == "__main__":
    unittest.main()
