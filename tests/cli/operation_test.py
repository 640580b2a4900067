# SPDX-License-Identifier: BSD-3-Clause
"""What happens at the speeds of a machine: amplitudes, forces, isolation and distance to resonance against the closed
forms of one mass on a spring, and where they are told."""
import json
import math
import os
import pathlib
import subprocess
import tempfile
import unittest

TRIVET = os.environ["TRIVET"]
FAN = pathlib.Path(os.environ["TRIVET_SOURCE"]) / "examples/fan/fan.toml"
RPM = math.pi / 30
MASS, STIFFNESS, DASHPOT = 40.0, 36000.0, 120.0  # ω₀ = 30 rad/s, ζ = 0.05
NATURAL = math.sqrt(STIFFNESS / MASS)
RATIO = DASHPOT / (2 * math.sqrt(STIFFNESS * MASS))
UNBALANCE = 0.02  # m e [kg m]
MACHINE = f"""trivet = 1
[bodies.m]
mass = {MASS}
free = ["z"]
[elements.s]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [0, 0, {STIFFNESS}]
damping = {{translation = [0, 0, {DASHPOT}]}}
"""
ROTOR = f"""[excitations.rotor]
type = "unbalance"
on = "m"
at = [0, 0, 0]
axis = "x"
mass_eccentricity = {UNBALANCE}
"""
ORDERS = """[excitations.shaft]
type = "orders"
on = "m"
at = [0, 0, 0]
table = [{order = 2, force = [0, 0, 50]}, {order = 3, force_per_speed2 = [0, 0, 0.05]}]
"""


def stiffness(omega):
    """Dynamic stiffness of the mass on its spring."""
    return complex(STIFFNESS - MASS * omega**2, DASHPOT * omega)


def transmissibility(omega):
    return abs(complex(STIFFNESS, DASHPOT * omega) / stiffness(omega))


def of_rotor(speed):
    """Amplitude under the unbalance."""
    return abs(UNBALANCE * speed**2 / stiffness(speed))


def of_orders(speed):
    """Amplitudes in the orders 2 and 3."""
    return abs(50 / stiffness(2 * speed)), abs(0.05 * speed**2 / stiffness(3 * speed))


class Operation(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file = pathlib.Path(folder.name) / "machine.toml"

    def trivet(self, text, *arguments, code=0):
        self.file.write_text(text)
        run = subprocess.run([TRIVET, arguments[0], self.file, *arguments[1:]], capture_output=True, text=True)
        self.assertEqual(run.returncode, code, run.stderr)
        return run

    def operation(self, text, *arguments):
        return json.loads(self.trivet(text, "operation", "--json", *arguments).stdout)

    def value(self, found, name, quantity="displacement", speed=0):
        rows = [row for row in found["values"] if row["name"] == name and row["quantity"] == quantity]
        return rows[speed]

    def near(self, found, expected, share=1e-9):
        self.assertLessEqual(abs(found - expected), share * abs(expected), (found, expected))

    def measured(self, speeds, bands=""):
        """The rotor on a spring that is known from 5 to 20 Hz; 120 rpm is 2 Hz."""
        (self.file.parent / "spring.csv").write_text(
            f"frequency_hz,k_z,k_z_loss\n5,{STIFFNESS},0.05\n10,{STIFFNESS},0.05\n20,{STIFFNESS},0.05\n".replace(
                "0.05", str(0.05 * STIFFNESS)
            )
        )
        spring = '[elements.s]\ntype = "table"\non = "m"\nat = [0, 0, 0]\nfile = "spring.csv"\n'
        body = MACHINE[: MACHINE.index("[elements.s]")]
        limits = 'limits = {"m.z" = "1 m"}\n'
        return body + spring + ROTOR + f"[operation]\nspeeds = {speeds}\n{bands}{limits}"

    def test_a_speed_that_cannot_be_computed_leaves_the_others(self):
        text = self.measured('["600 rpm", "120 rpm", ["600 rpm", "900 rpm"]]')
        done = self.trivet(text, "operation", "--json")
        found = json.loads(done.stdout)
        self.near(
            self.value(found, "m.z")["amplitude"],
            UNBALANCE
            * (2 * math.pi * 10) ** 2
            / abs(complex(STIFFNESS - MASS * (2 * math.pi * 10) ** 2, 0.05 * STIFFNESS)),
        )
        self.assertEqual(len(found["limits"]), 2)
        self.assertIn("120 rpm is not computed", " ".join(found["warnings"]))
        rows = json.loads(self.trivet(text, "verdict", "--json", code=1).stdout)["cases"][0]["requirements"]
        self.assertEqual([row["judged"] for row in rows], [True, False, True])
        self.assertIn("no stiffness at 2 Hz", rows[1]["reason"])
        alone = self.trivet(self.measured('["120 rpm"]'), "operation", code=1)
        self.assertIn("no stiffness at 2 Hz", alone.stderr)

    def test_a_range_that_begins_below_a_table_says_from_where_it_is_computed(self):
        bands = 'bands = "third-octave"\n'
        done = self.trivet(self.measured('[["120 rpm", "900 rpm"]]', bands), "operation", "--json")
        cut = json.loads(done.stdout)
        self.assertRegex(" ".join(cut["warnings"]), r"120 … 900 rpm is computed from 300\.?\d* rpm on")
        inside = self.operation(self.measured('[["300 rpm", "900 rpm"]]', bands))
        self.near(self.value(cut, "m.z")["amplitude"], self.value(inside, "m.z")["amplitude"])
        levels = [
            {row["nominal_hz"]: row["rms"] for row in one["bands"] if row["name"] == "m.z"} for one in (cut, inside)
        ]
        self.assertEqual(list(levels[0]), list(levels[1]))
        for band, level in levels[1].items():
            self.near(levels[0][band], level, 1e-6)
        self.assertNotIn("computed from", self.trivet(self.measured('[["330 rpm", "900 rpm"]]'), "operation").stderr)

    def test_one_mass_under_unbalance_has_the_closed_form(self):
        found = self.operation(MACHINE + ROTOR + '[operation]\nspeeds = ["980 rpm", "200 rpm"]\n')
        for i, rpm in enumerate((980, 200)):
            speed = rpm * RPM
            amplitude = of_rotor(speed)
            r = speed / NATURAL
            self.near(amplitude, UNBALANCE / MASS * r**2 / math.hypot(1 - r**2, 2 * RATIO * r))  # Den Hartog
            self.near(self.value(found, "m.z", speed=i)["amplitude"], amplitude)
            self.near(self.value(found, "m.z", speed=i)["rms"], amplitude / math.sqrt(2))
            self.near(self.value(found, "m.z", "velocity", i)["amplitude"], speed * amplitude)
            force = amplitude * abs(complex(STIFFNESS, DASHPOT * speed))
            for name in ("ground.force.z", "s.force.z"):
                self.near(self.value(found, name, "force", i)["amplitude"], force)
            (along_z,) = [
                row for row in found["isolation"] if row["direction"] == "along z" and abs(row["from"] - speed) < 1e-9
            ]
            self.near(along_z["transmissibility"], transmissibility(speed))
            self.near(along_z["exciting"], UNBALANCE * speed**2)
            self.near(along_z["transmitted"], force)
            self.near(along_z["isolation"], 1 - transmissibility(speed))
            self.near(along_z["isolation_db"], -20 * math.log10(transmissibility(speed)))
            mode = found["modes"][i]
            self.near(mode["ratio"], speed / NATURAL)
            self.near(mode["distance"], speed / NATURAL - 1)
        self.assertEqual(found["excitations"], ["rotor"])
        self.assertEqual(found["orders"], [1])

    def test_amplification_is_stated(self):
        text = self.trivet(MACHINE + ROTOR + '[operation]\nspeeds = ["300 rpm"]\n', "operation").stdout
        transmitted = transmissibility(300 * RPM)
        self.assertGreater(transmitted, 1)
        self.assertIn(f"AMPLIFIED: T = {transmitted:.4g}, isolation {100 * (1 - transmitted):.4g} %", text)

    def test_a_range_has_its_exact_peak(self):
        found = self.operation(
            MACHINE + ROTOR + '[operation]\nspeeds = [["200 rpm", "600 rpm"], ["350 rpm", "600 rpm"]]\n'
        )
        peak = self.value(found, "m.z")
        self.near(peak["at"], NATURAL / math.sqrt(1 - 2 * RATIO**2), 1e-8)
        self.near(peak["amplitude"], UNBALANCE / MASS / (2 * RATIO * math.sqrt(1 - RATIO**2)))
        beside = self.value(found, "m.z", speed=1)
        self.near(beside["at"], 350 * RPM)
        self.near(beside["amplitude"], of_rotor(350 * RPM))
        along_z = [row for row in found["isolation"] if row["direction"] == "along z"]
        across = [row["reason"] for row in found["isolation"] if row["direction"] == "along y"]
        self.assertTrue(across and all("not free along y" in reason for reason in across))
        worst = max(row["transmissibility"] for row in along_z if row["from"] < 300 * RPM)
        r2 = (math.sqrt(1 + 8 * RATIO**2) - 1) / (4 * RATIO**2)
        self.near(worst, transmissibility(NATURAL * math.sqrt(r2)))
        inside, beyond = found["modes"]
        self.assertTrue(inside["passes"])
        self.near(inside["at"], NATURAL)
        self.assertFalse(beyond["passes"])
        self.near(beyond["ratio"], 350 * RPM / NATURAL)

    def test_orders_sum_as_root_mean_square(self):
        speed = 100 * RPM
        found = self.operation(MACHINE + ORDERS + '[operation]\nspeeds = ["100 rpm"]\n')
        second, third = of_orders(speed)
        value = self.value(found, "m.z")
        self.near(value["rms"], math.hypot(second, third) / math.sqrt(2))
        self.near(value["bound"], second + third)
        self.assertEqual(value["order"], 2 if second > third else 3)
        velocity = self.value(found, "m.z", "velocity")
        self.near(velocity["rms"], math.hypot(2 * speed * second, 3 * speed * third) / math.sqrt(2))
        shares = {row["order"]: row["transmissibility"] for row in found["isolation"]}
        for order, ratio in shares.items():
            self.near(ratio, transmissibility(order * speed))

    def test_the_largest_sum_of_orders_in_a_range_is_that_of_a_fine_scan(self):
        # Heavy damping: the largest sum is at no peak of a single order.
        heavy = MACHINE.replace(f"0, {DASHPOT}", "0, 1200.0")

        def total(speed):
            def under(order, force):
                omega = order * speed
                return abs(force / complex(STIFFNESS - MASS * omega**2, 1200 * omega))

            return math.hypot(under(2, 50), under(3, 0.05 * speed**2)) / math.sqrt(2)

        found = self.value(self.operation(heavy + ORDERS + '[operation]\nspeeds = [["20 rpm", "400 rpm"]]\n'), "m.z")
        steps = 200_000
        scan = max(total((20 + 380 * i / steps) * RPM) for i in range(steps + 1))
        self.assertGreaterEqual(found["rms"], scan * (1 - 1e-12))
        self.near(found["rms"], scan, 1e-8)
        self.near(found["rms"], total(found["at"]))

    def test_unbalance_and_orders_of_one_act_together(self):
        together = ROTOR + ORDERS.replace("order = 2, force = [0, 0, 50]", "order = 1, force = [0, 0, 50]")
        found = self.operation(MACHINE + together + '[operation]\nspeeds = ["200 rpm"]\n')
        self.assertEqual(found["orders"], [1, 3])
        only = self.operation(MACHINE + together + '[operation]\nspeeds = ["200 rpm"]\nexcitations = ["rotor"]\n')
        self.near(self.value(only, "m.z")["amplitude"], of_rotor(200 * RPM))

    def test_forces_of_order_one_add_with_their_phases(self):
        push = '[excitations.push]\ntype = "harmonic"\non = "m"\nat = [0, 0, 0]\nforce = [0, 0, 50]\n'
        floor = '[excitations.floor]\ntype = "base"\ntranslation = [0, 0, "1 mm"]\n'
        found = self.operation(MACHINE + ROTOR + push + floor + '[operation]\nspeeds = ["400 rpm"]\n')
        speed = 400 * RPM
        # About x the unbalance turns from y to z: its vertical force lags by a quarter.
        exact = abs((50 - 1j * UNBALANCE * speed**2) / stiffness(speed))
        self.near(self.value(found, "m.z")["amplitude"], exact)
        self.assertEqual(found["excitations"], ["rotor", "push"])  # the floor does not follow the machine
        selected = '[operation]\nspeeds = ["400 rpm"]\nexcitations = ["floor"]\n'
        moved = self.operation(MACHINE + ROTOR + push + floor + selected)
        self.near(self.value(moved, "m.z")["amplitude"], 1e-3 * transmissibility(speed))

    def test_a_machine_that_stands_on_nothing_has_no_isolation(self):
        text = MACHINE.replace("[elements.s]", '[bodies.n]\nmass = 10\nfree = ["z"]\n[elements.s]\nfrom = "n"')
        found = self.operation(text + ROTOR + '[operation]\nspeeds = ["400 rpm"]\n')
        self.assertEqual(found["isolation"], [])

    def test_speeds_of_a_request_replace_those_of_the_file(self):
        found = self.operation(MACHINE + ROTOR, "--at", "980 rpm,1450 rpm")
        self.assertEqual(sorted({round(row["to"] / RPM) for row in found["values"]}), [980, 1450])
        self.near(self.value(found, "m.z", speed=1)["amplitude"], of_rotor(1450 * RPM))
        self.assertIn("above 0", self.trivet(MACHINE + ROTOR, "operation", "--at", "0 rpm", code=2).stderr)
        self.assertIn('speeds = ["980 rpm"]', self.trivet(MACHINE + ROTOR, "operation", code=2).stderr)

    def test_resonance_is_warned_of(self):
        near = self.trivet(MACHINE + ROTOR + '[operation]\nspeeds = ["250 rpm"]\n', "operation").stderr
        self.assertIn("250 rpm: order 1 is at 87.27 % of mode 1 (4.775 Hz)", near)
        through = self.trivet(MACHINE + ROTOR + '[operation]\nspeeds = [["200 rpm", "600 rpm"]]\n', "operation").stderr
        self.assertIn("200 … 600 rpm: order 1 passes through mode 1 at 286.5 rpm", through)
        far = self.trivet(MACHINE + ROTOR + '[operation]\nspeeds = ["980 rpm"]\n', "operation").stderr
        self.assertNotIn("resonance", far)

    def test_an_undamped_resonance_in_a_range_is_that_of_its_order(self):
        undamped = "".join(line for line in MACHINE.splitlines(True) if not line.startswith("damping"))
        orders = '[{order = 0.5, force = [0, 0, 1]}, {order = 1, force = [0, 0, 50]}, {order = 2, force = [0, 0, 0.1]}]'
        shaft = f'[excitations.shaft]\ntype = "orders"\non = "m"\nat = [0, 0, 0]\ntable = {orders}\n'
        limits = '[operation]\nspeeds = [["250 rpm", "350 rpm"]]\nlimits."m.z" = "1 mm"\n'
        found = json.loads(self.trivet(undamped + shaft + limits, "verdict", "--json").stdout)
        (row,) = found["cases"][0]["requirements"]
        self.assertAlmostEqual(row["angular_frequency"], NATURAL, delta=1e-9 * NATURAL)
        self.assertTrue(row["unbounded"])

    def test_limits_are_judged_in_every_case(self):
        amplitude = of_rotor(980 * RPM)
        text = (
            MACHINE
            + ROTOR
            + f'[operation]\nspeeds = ["980 rpm", ["200 rpm", "400 rpm"]]\nlimits."m.z" = "{2e3 * amplitude} mm"\n'
            + f"[cases.stiff]\nelements.s.translation = [0, 0, {4 * STIFFNESS}]\n"
        )
        found = json.loads(self.trivet(text, "verdict", "--json").stdout)
        at, over = found["cases"][0]["requirements"]
        self.assertEqual(at["kind"], "operation")
        self.assertIn("at 980 rpm", at["requirement"])
        self.near(at["margin"], 2)
        self.near(at["value"], amplitude)
        self.near(over["value"], UNBALANCE / MASS / (2 * RATIO * math.sqrt(1 - RATIO**2)))
        self.assertTrue(all(case["decides"] for case in found["cases"]))
        self.assertFalse(found["met"])
        said = self.trivet(text, "verdict").stdout
        self.assertIn("At 980 rpm: largest velocity", said)
        self.assertIn("At 200 … 400 rpm: largest velocity", said)

    def test_the_command_judges_its_limits(self):
        amplitude = of_rotor(980 * RPM)
        text = MACHINE + ROTOR + f'[operation]\nspeeds = ["980 rpm"]\nlimits."m.z" = "{0.8e3 * amplitude} mm"\n'
        over = self.trivet(text, "operation", "--strict", code=3)
        self.assertIn("1 limit violated", over.stderr)
        (row,) = [line for line in over.stdout.splitlines() if line.endswith("VIOLATED")]
        self.assertIn("125.0 %", row)
        self.assertIn(f"{0.8e6 * amplitude:.1f} µm 0-p", row)  # the limit
        self.assertIn(f"{1e6 * amplitude:.1f} µm 0-p", row)  # the value
        (limit,) = self.operation(text)["limits"]
        self.near(limit["share"], 1.25)
        self.near(limit["value"], amplitude)
        self.assertEqual((limit["quantity"], limit["met"], limit["unit"]), ("displacement", False, "m"))
        met = self.trivet(text, "operation", "--strict", "--at", "100 rpm", code=4)  # a warning alone
        self.assertTrue(any(line.endswith("met") for line in met.stdout.splitlines()), met.stdout)

    def test_maps_and_searches_judge_them(self):
        axes = "x = {parameter = 'elements.s.scale', from = 0.9, to = 1.1}, "
        axes += "y = {parameter = 'bodies.m.mass', from = 38, to = 42}, limits = {\"m.z\" = \"1 m\"}"
        parameter = "[parameters.stiffness]\npath = 'elements.s.scale'\nfrom = 0.5\nto = 2\n"
        text = MACHINE + ROTOR + f"[analyses]\nmap = {{{axes}}}\n" + parameter
        text += '[operation]\nspeeds = ["980 rpm"]\nlimits."m.z" = "LIMIT mm"\n'
        small, large = text.replace("LIMIT", "0.01"), text.replace("LIMIT", "5")
        self.assertIn("infeasible", self.trivet(small, "map", "--points", "5", "--strict", code=3).stderr)
        self.trivet(large, "map", "--points", "5", "--strict")
        self.trivet(small, "optimize", "--strict", code=3)
        best = json.loads(self.trivet(large, "optimize", "--json").stdout)
        self.assertEqual(best["cases"][0]["after"]["requirements"][0]["kind"], "operation")

    def test_a_range_from_rest_has_its_limit_there(self):
        floor = '[excitations.floor]\ntype = "base"\nquantity = "QUANTITY"\ntranslation = [0, 0, AMPLITUDE]\n'
        floor += '[operation]\nspeeds = [["0 rpm", "100 rpm"]]\nexcitations = ["floor"]\nlimits."m.z" = "1 mm"\n'
        velocity, acceleration = 1e-3, 2e-2
        given = MACHINE + floor.replace("QUANTITY", "velocity").replace("AMPLITUDE", str(velocity))
        found = self.operation(given)
        moved = self.value(found, "m.z")
        self.assertEqual((moved["amplitude"], moved["rms"], moved["at"]), (None, None, 0))  # v/Ω grows without bound
        self.assertIn("the ground, whose velocity or acceleration is given, moves without bound", moved["reason"])
        # Below its resonance the velocity of the mass, v T(Ω), is least at rest and largest at the other end.
        speed = 100 * RPM
        self.near(self.value(found, "m.z", "velocity")["amplitude"], velocity * transmissibility(speed))
        # The force of spring and dashpot, v M Ω T(Ω), vanishes at rest.
        self.near(
            self.value(found, "s.force.z", "force")["amplitude"], MASS * speed * velocity * transmissibility(speed)
        )
        self.assertIn("Unbounded: towards rest the ground", self.trivet(given, "operation").stdout)
        said = self.trivet(given, "verdict", "--strict", code=3).stdout
        self.assertIn("towards rest the ground", said)
        # Of a given acceleration the velocity grows too; far above the resonance it is largest at rest.
        given = MACHINE + floor.replace("QUANTITY", "acceleration").replace("AMPLITUDE", str(acceleration))
        self.assertIsNone(self.value(self.operation(given), "m.z", "velocity")["amplitude"])
        # A force that stays the same bends the spring as at rest: the limit is F/k, at 0.
        stiff = MACHINE.replace(f"mass = {MASS}", "mass = 1e-3").replace(f"0, {DASHPOT}", "0, 4e5")
        push = '[excitations.push]\ntype = "harmonic"\non = "m"\nat = [0, 0, 0]\nforce = [0, 0, 50]\n'
        found = self.operation(stiff + push + '[operation]\nspeeds = [["0 rpm", "900 rpm"]]\n')
        self.near(self.value(found, "m.z")["amplitude"], 50 / STIFFNESS)
        self.assertEqual(self.value(found, "m.z")["at"], 0)

    def test_the_largest_value_does_not_depend_on_where_the_search_begins(self):
        # At so low a speed the velocity of the mass is that of the ground, to the closed form.
        floor = '[excitations.floor]\ntype = "base"\nquantity = "velocity"\ntranslation = [0, 0, 1e-3]\n'
        heavy = MACHINE.replace(f"0, {DASHPOT}", "0, 1.0") + floor
        found = self.operation(heavy + '[operation]\nspeeds = [["0 rpm", "1 rpm"]]\nexcitations = ["floor"]\n')
        speed = 1 * RPM
        exact = 1e-3 * abs(complex(STIFFNESS, speed) / complex(STIFFNESS - MASS * speed**2, speed))
        self.near(self.value(found, "m.z", "velocity")["amplitude"], exact)

    def test_the_isolation_names_its_order(self):
        said = self.trivet(MACHINE + ORDERS + '[operation]\nspeeds = ["100 rpm"]\n', "operation").stdout
        shares = {order: transmissibility(order * 100 * RPM) for order in (2, 3)}
        worst = max(shares, key=shares.get)
        self.assertIn(f'isolation from "shaft" in order {worst} along z', " ".join(said.split()))
        alone = self.trivet(MACHINE + ROTOR + '[operation]\nspeeds = ["980 rpm"]\n', "operation").stdout
        self.assertIn('isolation from "rotor" along z', " ".join(alone.split()))

    def test_table_and_sentence_name_the_same_nearest_mode(self):
        # Ω = 10 rad/s between modes at 7 and 17 rad/s: 43 % above the first, 41 % below the second.
        two = MACHINE + '[bodies.n]\nmass = 1\nfree = ["z"]\n[elements.t]\ntype = "three_springs"\non = "n"\n'
        two += "at = [1, 0, 0]\ntranslation = [0, 0, 49]\ndamping = {translation = [0, 0, 1]}\n"
        two = two.replace(f"0, {STIFFNESS}]", f"0, {MASS * 17**2}]")
        push = '[excitations.KEY]\ntype = "harmonic"\non = "BODY"\nat = [0, 0, 0]\nforce = [0, 0, 1]\n'
        both = "".join(push.replace("KEY", "on " + body).replace("BODY", body) for body in "mn")
        both = both.replace("[excitations.on m]", '[excitations."on m"]').replace(
            "[excitations.on n]", '[excitations."on n"]'
        )
        text = two + both + f'[operation]\nspeeds = ["{10 / RPM} rpm"]\n'
        rows = self.operation(text)["modes"]
        nearest = min(rows, key=lambda row: abs(row["distance"]))
        said = " ".join(self.trivet(text, "operation").stdout.split())
        self.assertIn(f"nearest to resonance: mode {nearest['mode']} (", said)

    def test_every_mode_and_order_is_in_the_whole_table(self):
        # One mode and two orders far from it, on the screen and with --full as in JSON.
        text = MACHINE + '[bodies.n]\nmass = 1\nfree = ["z"]\n[elements.t]\ntype = "three_springs"\non = "n"\n'
        text += "at = [1, 0, 0]\ntranslation = [0, 0, 49]\n" + ORDERS + '[operation]\nspeeds = ["980 rpm"]\n'
        self.assertEqual(len(self.operation(text)["modes"]), 4)
        for arguments in ((), ("--full",)):
            said = self.trivet(text, "operation", *arguments).stdout
            rows = said.split("Distance from resonance")[1].splitlines()[2:6]
            self.assertEqual([row.split()[:1] + row.split()[2:3] for row in rows], [[m, k] for k in "23" for m in "12"])

    def test_of_many_distances_the_nearest_are_shown(self):
        orders = ", ".join(f"{{order = {k}, force = [0, 0, 1]}}" for k in range(1, 26))
        table = '[excitations.shaft]\ntype = "orders"\non = "m"\nat = [0, 0, 0]\ntable = [' + orders + "]\n"
        said = self.trivet(MACHINE + table + '[operation]\nspeeds = ["980 rpm"]\n', "operation").stdout
        self.assertIn("5 more rows, these are the 20 nearest", said)

    def test_a_motion_of_the_ground_that_nothing_uses_is_named(self):
        floor = '[excitations.floor]\ntype = "base"\ntranslation = [0, 0, "1 mm"]\n'
        text = MACHINE + ROTOR + floor + '[operation]\nspeeds = ["980 rpm"]\n'
        words = "excitations.floor: no analysis of this file uses it"
        self.assertIn(words, self.trivet(text, "check").stderr)
        selected = self.trivet(text + 'excitations = ["rotor", "floor"]\n', "check").stderr
        self.assertNotIn(words, selected)
        alone = self.trivet(MACHINE + floor + '[operation]\nspeeds = ["980 rpm"]\n', "operation", code=2).stderr
        self.assertIn('write excitations = ["floor"]', alone)

    def test_the_largest_displacement_of_a_range_has_its_own_speed(self):
        text = MACHINE + ROTOR + '[operation]\nspeeds = [["100 rpm", "2000 rpm"]]\n'
        done = self.trivet(text, "operation")
        head = next(line for line in done.stdout.splitlines() if "velocity at" in line)
        self.assertRegex(head, "velocity at.*displacement at")

    def test_a_sentence_has_the_level_of_its_table(self):
        """The largest force has one order, others have two: all are root mean squares."""
        text = MACHINE.replace('free = ["z"]', 'free = ["x", "z"]')
        text = text.replace(f"translation = [0, 0, {STIFFNESS}]", f"translation = [{STIFFNESS}, 0, {STIFFNESS}]")
        orders = '[excitations.shaft]\ntype = "orders"\non = "m"\nat = [0, 0, 0]\n'
        orders += "table = [{order = 1, force = [500, 0, 20]}, {order = 2, force = [0, 0, 50]}]\n"
        shown = self.trivet(text + orders + '[operation]\nspeeds = ["300 rpm"]\n', "operation").stdout
        self.assertIn("Forces on the ground, in total and of each mount, rms", shown)
        self.assertRegex(shown, r"largest force on the ground\s[0-9.]+\sk?N\s+rms\s+\(ground.force.x\)")

    def test_a_speed_named_twice_is_refused(self):
        text = MACHINE + ROTOR + '[operation]\nspeeds = ["980 rpm", ["600 rpm", "900 rpm"], "980 1/min"]\n'
        said = self.trivet(text, "operation", code=2).stderr
        self.assertIn('operation.speeds: "980 1/min"; this speed is named twice', said)

    def test_a_speed_without_unit_is_asked_for_in_rpm(self):
        said = self.trivet(MACHINE + ROTOR, "operation", "--at", "980", code=2).stderr
        self.assertIn('--at "980": a speed has a unit; write --at "980 rpm" or --at "980 rad/s"', said)

    def test_the_fan_has_its_numbers_in_summary_report_and_files(self):
        with tempfile.TemporaryDirectory() as folder:
            run = subprocess.run([TRIVET, "run", FAN, "-o", folder], capture_output=True, text=True, check=True)
            for words in ("At 980 rpm", "largest velocity", "largest force on the ground", "isolation from"):
                self.assertIn(words, run.stdout)
            results = json.loads((pathlib.Path(folder) / "results.json").read_text())["cases"][0]
            self.assertTrue(results["verdict"]["met"])
            modes = [mode["angular_frequency"] / (2 * math.pi) for mode in results["modes"]["modes"]]
            self.assertAlmostEqual(modes[0], 2.28, delta=0.01)
            self.assertAlmostEqual(modes[-1], 9.11, delta=0.01)
            page = (pathlib.Path(folder) / "report.html").read_text()
            self.assertIn("At the operating speed", page)

    def test_other_analyses_tell_single_frequencies_too(self):
        text = (
            MACHINE + ROTOR + '[analyses]\ntransmissibility = {base = "z"}\norders = {speed = ["100 rpm", "900 rpm"]}\n'
        )
        (at,) = json.loads(self.trivet(text, "transmissibility", "--json", "--at", "980 rpm").stdout)["at"]
        self.near(at["transmissibility"], transmissibility(980 * RPM))
        self.near(at["isolation"], 1 - transmissibility(980 * RPM))
        (at,) = json.loads(self.trivet(text, "orders", "--json", "--at", "980 rpm").stdout)["at"]
        self.near(at["amplitude"], of_rotor(980 * RPM))
        at = json.loads(self.trivet(text, "power", "--json", "--at", "980 rpm").stdout)["at"]
        self.assertEqual([row["mount"] for row in at], ["s", "all mounts"])
        speed = 980 * RPM
        self.near(at[0]["fed"], DASHPOT * (speed * of_rotor(speed)) ** 2 / 2)  # all of it is dissipated
        self.assertNotIn("at", json.loads(self.trivet(text, "orders", "--json").stdout))


if __name__ == "__main__":
    unittest.main()
