# SPDX-License-Identifier: BSD-3-Clause
"""Typical slips in every example are reported by their kind; plausible machines pass without a warning."""
import concurrent.futures
import copy
import json
import math
import os
import pathlib
import random
import re
import shutil
import subprocess
import tempfile
import tomllib
import unittest

from slips import G, SLIPS, ask_in_time, text, toml, written_out

from trivet_test import HANGS_AFTER

TRIVET = os.environ["TRIVET"]
SOURCE = pathlib.Path(os.environ["TRIVET_SOURCE"])
EXAMPLES = sorted((SOURCE / "examples").glob("*/*.toml"))
SAMPLES = sorted((SOURCE / "tests/samples").glob("*.toml"))
THREADS = 2


def written(folder, project):
    project = copy.deepcopy(project)
    if mounts := project.pop("+catalogue", None):
        (folder / "mounts.toml").write_text(text({"catalogue": 1, "mounts": mounts}))
    path = folder / "slipped.toml"
    path.write_text(text(project))
    return path


def check(path):
    return subprocess.run([TRIVET, "check", str(path)], capture_output=True, text=True, timeout=HANGS_AFTER)


def reported_kinds(done):
    return re.findall(r'suspicion "([^"]+)"', done.stderr)


class InTemporaryFolder(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder, True)

    def all_checked(self, projects):
        """[(name, project, folder of its files or None)] → finished checks, in order."""

        def one(numbered):
            number, (_, project, files) = numbered
            folder = self.folder / str(number)
            if files:
                shutil.copytree(files, folder)
            else:
                folder.mkdir()
            return check(written(folder, project))

        with concurrent.futures.ThreadPoolExecutor(THREADS) as threads:
            return list(threads.map(one, enumerate(projects)))


class SoundFiles(InTemporaryFolder):
    def test_examples_and_samples_have_no_suspicion(self):
        for path in EXAMPLES + SAMPLES:
            with self.subTest(path=path.name):
                done = check(path)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertEqual(reported_kinds(done), [], done.stderr)


class Slips(InTemporaryFolder):
    # Of all slips. Missed are those that no physics shows: products of inertia about the centre of mass with the wrong
    # sign, rotations per degree with mounts far apart, a stiff machine that becomes even stiffer.
    LEAST_SHARE = 0.93

    def test_are_named_by_their_kind_in_every_example(self):
        cases = []
        for example in EXAMPLES:
            project = written_out(tomllib.loads(example.read_text()))
            if not all("mass" in body for body in project["bodies"].values()):
                continue
            for name, (kind, slip) in SLIPS.items():
                changed = copy.deepcopy(project)
                if slip(changed) is not False:
                    cases.append((f"{name}: {example.parent.name}/{example.stem}", changed, example.parent, name, kind))
        done = self.all_checked([case[:3] for case in cases])
        table = {name: [0, 0, 0, []] for name in SLIPS}
        for (where, _, _, name, kind), result in zip(cases, done):
            reported = reported_kinds(result)
            row = table[name]
            row[0] += 1
            row[1] += kind in reported
            row[2] += len(set(reported)) > 1
            if kind not in reported:
                row[3].append(f"{where.split(': ')[1]} {reported or result.returncode}")
        print("\ncaught / injected (with a second kind)")
        for name, (injected, caught, doubled, missed) in table.items():
            print(f"  {name:34} {caught:3} / {injected:3} ({doubled})  {'; '.join(missed)}")
        caught, injected = sum(row[1] for row in table.values()), sum(row[0] for row in table.values())
        print(f"  all {caught} / {injected} = {100 * caught / injected:.1f} %")
        self.assertGreaterEqual(injected, 200)
        self.assertGreaterEqual(caught / injected, self.LEAST_SHARE)


def sound_machine(r):
    """A machine of 20 g … 200 t that stands, hangs or is on a wall, with usual ratios of dimensions, stiffnesses and
    damping."""
    m = 10 ** r.uniform(math.log10(0.02), math.log10(2e5))
    density = 10 ** r.uniform(math.log10(150), math.log10(5000))
    shape = sorted((r.uniform(0.5, 1.6) for _ in range(3)), reverse=True)
    edge = (m / density / math.prod(shape)) ** (1 / 3)
    a, b, c = (edge * s for s in shape)
    hx, hy, hz = (edge * r.uniform(0.75, 1.2) for edge in (a, b, c))  # the mass is not distributed evenly
    jx, jy, jz = (m / 12 * (y * y + z * z) for y, z in ((hy, hz), (hx, hz), (hx, hy)))
    pose = r.choice(["standing", "hung", "wall"])
    up = {"standing": c / 2, "hung": -c / 2, "wall": 0}[pose]
    centre = [r.uniform(-0.08, 0.08) * a, r.uniform(-0.08, 0.08) * b, up * r.uniform(0.6, 1.2)]
    hertz = 10 ** r.uniform(0, min(2, 2.4 - math.log10(m) / 4))
    hertz = max(hertz, min(100, 1.1 / math.sqrt(edge)))  # below, those that stand fall over
    count = r.choice([3, 4, 4, 4, 6, 8])
    k = m * (2 * math.pi * hertz) ** 2 / count
    k_lateral = k * r.uniform(0.2, 1)
    angles = [2 * math.pi * (i + 0.5) / count for i in range(count)]
    around = (
        [(math.copysign(a / 2, math.cos(t)), math.copysign(b / 2, math.sin(t))) for t in angles]
        if count == 4
        else [(0.5 * a * math.cos(t), 0.5 * b * math.sin(t)) for t in angles]
    )
    mounts = {}
    for i, (x, y) in enumerate(around):
        at, axis = [x, y, 0], "z"
        if pose == "wall":
            at, axis, centre_wall = [0, x, y], "x", [c / 2 * r.uniform(0.6, 1.2), 0, 0]
        e = {
            "type": "bushing",
            "on": "machine",
            "at": at,
            "axis": axis,
            "translation": [k_lateral, k_lateral, k * r.uniform(0.8, 1.25)],
            "damping": r.choice(
                [{"loss_factor": 0.1}, {"proportional": 0.06 / (2 * math.pi * hertz)}, {"loss_factor": 0.25}]
            ),
        }
        if r.random() < 0.5:
            radius = r.uniform(0.03, 0.1) * edge
            e["rotation"] = [k * radius**2] * 2 + [k_lateral * radius**2]
        mounts[f"mount {i + 1}"] = e
    if pose == "wall":
        centre = centre_wall
        jx, jz = jz, jx
    extra = random.Random(f"parts {m}")
    if pose == "standing" and extra.random() < 0.3:  # feet with a height, on a body with a position
        project_position = [extra.uniform(-2, 2), extra.uniform(-2, 2), 0.3 * edge]
        for e in mounts.values():
            e["from_at"] = [e["at"][0] + project_position[0], e["at"][1] + project_position[1], 0.2 * edge]
    else:
        project_position = [0, 0, 0]
    project = {
        "trivet": 1,
        "bodies": {
            "machine": {
                "mass": m,
                "center_of_mass": centre,
                "inertia": {"about": "center_of_mass", "xx": jx, "yy": jy, "zz": jz},
                "points": {"top": [0.3 * a, 0.2 * b, 2 * up]},
            }
        },
        "elements": mounts,
        "excitations": {"motor": {"type": "harmonic", "on": "machine", "at": centre, "force": [0, 0, 0.01 * m * G]}},
        "analyses": {"modes": {}, "response": {"band": [0, f"{4 * hertz} Hz"]}},
    }
    if r.random() < 0.7:
        project["gravity"] = [0, 0, -G]
    add_parts(project, extra, m, edge, hertz, k)
    project["bodies"]["machine"]["position"] = project_position
    return project


def add_parts(project, extra, m, edge, hertz, k):
    """Adds analyses and further parts of a file, with usual ratios."""
    mounts, analyses, excitations = project["elements"], project["analyses"], project["excitations"]
    if extra.random() < 0.3:
        project["limits"] = {"machine.z": 10 ** extra.uniform(-6, -1.5) * edge}
    if extra.random() < 0.3:
        duration = 10 ** extra.uniform(-1.3, 1) / hertz
        excitations["shock"] = {
            "type": "time",
            "on": "machine",
            "at": [0, 0, 0],
            "force": [0, 0, 1],
            "history": {"half_sine": {"amplitude": 0.1 * m * G, "duration": duration}},
        }
        ask_in_time(project, to=duration + 20 / hertz, step=min(duration, 1 / hertz) / 40)
    if extra.random() < 0.3:
        rpm = 10 ** extra.uniform(2.5, 4 - 0.15 * math.log10(m))
        excitations["rotor"] = {
            "type": "unbalance",
            "on": "machine",
            "at": [0, 0, 0],
            "axis": "x",
            "grade": extra.choice([0.4, 2.5, 6.3, 16, 40, 250]),
            "rotor_mass": m * extra.uniform(0.05, 0.5),
            "service_speed": f"{rpm} rpm",
        }
        if "limits" in project:  # they hold where the machine runs
            analyses["response"]["band"] = [0, f"{max(4 * hertz, 1.1 * rpm / 60)} Hz"]
    if extra.random() < 0.2:
        for e in mounts.values():
            e["damping"] = {"translation": [2 * extra.uniform(0.02, 0.4) * math.sqrt(k * m / len(mounts))] * 3}
    if extra.random() < 0.2:
        for e in mounts.values():
            e["scale"] = extra.choice([0.5, 0.8, 1.2, 2])
    if extra.random() < 0.2 and not any("from_at" in e for e in mounts.values()):
        floor = k * 10 ** extra.uniform(-0.3, 2)
        project["foundations"] = {"floor": {"type": "impedance", "translation": [floor, floor, floor]}}
        if "transient" not in analyses:
            project["foundations"]["floor"]["damping"] = {"loss_factor": 0.05}
        for e in mounts.values():
            e["foundation"] = "floor"


class SoundMachines(InTemporaryFolder):
    # Of 200; bounds of plausibility are wide, but a machine may be unusual without an error.
    MOST_WARNED = 2

    def test_pass_without_suspicion(self):
        r = random.Random(20260731)
        projects = [(str(i), sound_machine(r), None) for i in range(200)]
        done = self.all_checked(projects)
        self.assertEqual([d.stderr for d in done if d.returncode != 0], [])
        warned = [(project, d.stderr) for (_, project, _), d in zip(projects, done) if d.stderr]
        print(f"\nwarned of sound machines: {len(warned)} / {len(done)}")
        for project, message in warned:
            print(message, toml(project))
        self.assertLessEqual(len(warned), self.MOST_WARNED)


class Floors(InTemporaryFolder):
    """Without a band nothing else shows that 4 Hz became 100 Hz: the mounts are stiffer than the floor below them."""

    def setUp(self):
        super().setUp()
        self.fan = tomllib.loads((SOURCE / "examples/fan/fan.toml").read_text())
        self.fan["analyses"] = {"modes": {}}

    def kinds_with(self, stiffness):
        self.fan["element_types"]["spring"]["translation"] = [f"{one} N/mm" for one in stiffness]
        return reported_kinds(check(written(self.folder, self.fan)))

    def test_stiffness_in_another_unit_is_suspicious_over_the_modes_of_a_floor(self):
        self.assertEqual(self.kinds_with([144, 144, 180]), [])
        self.assertEqual(self.kinds_with([144000, 144000, 180000]), ["stiffness"])

    def test_firm_mounts_on_a_soft_floor_are_not(self):
        self.assertEqual(self.kinds_with([2000, 2000, 2500]), [])  # 15 Hz on a floor of 9 Hz
        self.fan["foundations"]["floor"]["modes"][0]["modal_mass"] = "1500 t"
        self.assertEqual(self.kinds_with([20000, 20000, 20000]), [])


class Acceptances(InTemporaryFolder):
    def setUp(self):
        super().setUp()
        self.machine = tomllib.loads((SOURCE / "examples/skew_mounts/machine.toml").read_text())
        self.machine["second_order"] = False  # with a thousand times its mass it falls over, which nothing accepts

    def check(self, project):
        return check(written(self.folder, project))

    def test_silence_exactly_one_suspicion(self):
        self.machine["bodies"]["compressor"]["mass"] = 400000
        self.machine["damping"] = {"modal": 2}
        self.assertEqual(sorted(reported_kinds(self.check(self.machine))), ["mass", "modal damping"])
        self.machine["bodies"]["compressor"]["accept"] = {"mass": "filled with lead"}
        self.assertEqual(reported_kinds(self.check(self.machine)), ["modal damping"])
        self.machine["damping"]["accept"] = {"modal damping": "in oil"}
        done = self.check(self.machine)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_do_not_silence_other_rules(self):
        self.machine["limits"] = {"compressor.z": 12}
        self.machine["analyses"] = {"response": {"band": [0, "30 Hz"], "of": ["compressor.z"]}}
        self.machine.pop("limit_lines", None)
        self.machine["bodies"]["compressor"]["mass"] = 400000
        self.assertEqual(reported_kinds(self.check(self.machine)), ["mass"])
        self.machine["bodies"]["compressor"]["accept"] = {"mass": "filled with lead"}
        self.assertEqual(reported_kinds(self.check(self.machine)), ["limit"])
        self.machine["limits"]["accept"] = {"limit": "none at all"}
        done = self.check(self.machine)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_those_of_a_mount_do_not_silence_the_analyses(self):
        self.machine["analyses"] = {"response": {"band": ["900 Hz", "2000 Hz"]}}
        self.machine["cases"] = {}
        self.machine.pop("limits", None), self.machine.pop("limit_lines", None)
        mounts = [e for e in self.machine["elements"].values() if e["type"] == "bushing"]
        for mount in mounts:
            mount["scale"] = 100
        self.assertEqual(reported_kinds(self.check(self.machine)), ["scale"])
        mounts[0]["accept"] = {"scale": "stops"}
        self.assertIn("band", reported_kinds(self.check(self.machine)))

    def test_those_of_a_foundation_are_accepted_there(self):
        mount = next(iter(self.machine["elements"].values()))
        mount["foundation"] = "deck"
        self.machine["foundations"] = {
            "deck": {"type": "impedance", "translation": [1e8, 1e8, 1e8], "damping": {"loss_factor": 0.8}}
        }
        done = self.check(self.machine)
        self.assertEqual(reported_kinds(done), ["loss factor"])
        self.assertIn("foundations.deck.damping.loss_factor", done.stderr)
        self.machine["foundations"]["deck"]["accept"] = {"loss factor": "measured"}
        done = self.check(self.machine)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_warnings_reach_every_result(self):
        self.machine["bodies"]["compressor"]["mass"] = 400000
        path = written(self.folder, self.machine)
        for command in (["check"], ["modes"], ["roots"], ["peaks"], ["static"], ["suspension"]):
            done = subprocess.run(
                [TRIVET, *command, str(path), "--json"], capture_output=True, text=True, timeout=HANGS_AFTER
            )
            self.assertEqual(done.returncode, 0, done.stderr)
            found = [w for w in json.loads(done.stdout)["warnings"] if 'suspicion "mass"' in w]
            self.assertEqual(len(found), 1, command)
            self.assertIn("400 kg if the number was meant in grams", found[0])
            self.assertRegex(found[0], r"slipped.toml:\d+: ")
        done = subprocess.run(
            [TRIVET, "run", str(path), "-o", str(self.folder / "out")],
            capture_output=True,
            text=True,
            timeout=HANGS_AFTER,
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("400 kg if the number was meant in grams", (self.folder / "out/report.html").read_text())
        self.assertIn("400 kg if the number was meant in grams", (self.folder / "out/results.json").read_text())

    def test_a_band_of_the_command_line_is_judged_as_that_of_the_file(self):
        self.machine["cases"] = {}
        self.machine.pop("limits", None), self.machine.pop("limit_lines", None)

        def response(band, *options):
            self.machine["analyses"] = {"response": {"band": band} if band else {}}
            path = written(self.folder, self.machine)
            return subprocess.run(
                [TRIVET, "response", path, *options], capture_output=True, text=True, timeout=HANGS_AFTER
            ).stderr

        for found in (response([0, 0.5]), response(None, "--band", "0,0.5 rad/s")):
            self.assertIn('suspicion "band": no natural frequency is in it', found)
        self.assertNotIn("suspicion", response(None, "--band", "0,1000 rad/s"))

    def test_are_errors_if_nothing_is_suspicious(self):
        self.machine["bodies"]["compressor"]["accept"] = {"mass": "heavy"}
        done = self.check(self.machine)
        self.assertEqual(done.returncode, 2)
        self.assertIn("no case has a suspicion of this kind here", done.stderr)

    def test_those_of_a_case_are_needed_by_that_case_only(self):
        self.machine["cases"] = {"heavy": {"bodies": {"compressor": {"mass": 400000, "accept": {"mass": "filled"}}}}}
        self.assertEqual(self.check(self.machine).stderr, "")
        self.machine["cases"] = {"heavy": {"bodies": {"compressor": {"mass": 400000}}}}
        self.machine["bodies"]["compressor"]["accept"] = {"mass": "filled in one case"}
        self.assertEqual(self.check(self.machine).stderr, "")


if __name__ == "__main__":
    unittest.main()
