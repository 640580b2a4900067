# SPDX-License-Identifier: BSD-3-Clause
"""A complex matrix of another program against elements of the same stiffness with loss factors."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

from trivet_test import HANGS_AFTER

TRIVET = os.environ["TRIVET"]

BODY = """trivet = 1
[bodies.machine]
mass = 20
inertia = {about = "center_of_mass", xx = 0.4, yy = 0.5, zz = 0.6}
center_of_mass = [0.01, 0, 0.05]
[excitations.push]
type = "harmonic"
on = "machine"
at = [0.02, 0.01, 0]
force = [1, 2, 3]
[analyses]
response = {of = ["machine", "ground"], at = ["1 Hz", "12 Hz", "25 Hz", "60 Hz"]}
peaks = {of = ["machine"]}
"""
SPRINGS = {"soft": ([2e5, 3e5, 4e5], [900, 800, 700], 0.05), "stiff": ([5e5, 1e5, 9e5], [100, 200, 300], 0.3)}
ELEMENT = 'type = "bushing"\non = "machine"\nat = [0, 0, 0]\n'


def complex_file(path, blocks):
    """Writes a diagonal K of the moved end and its mirror images for two ends at one place; nonzero entries only."""
    rows = []
    for end, other in ((0, 6), (6, 0)):
        for i in range(6):
            k = sum((translation + rotation)[i] * complex(1, loss) for translation, rotation, loss in blocks)
            rows.append((end + i + 1, end + i + 1, k))
            rows.append((end + i + 1, other + i + 1, -k))
    path.write_text(
        "%%MatrixMarket matrix coordinate complex general\n"
        + f"12 12 {len(rows)}\n"
        + "".join(f"{i} {j} {k.real!r} {k.imag!r}\n" for i, j, k in rows)
    )


class ImportedComplex(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def result_of(self, command, elements, *more):
        path = pathlib.Path(self.folder.name) / "model.toml"
        path.write_text(BODY + elements)
        done = subprocess.run(
            [TRIVET, command, path, "--json", *more], capture_output=True, text=True, timeout=HANGS_AFTER
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def bushings(self, *names):
        return "".join(
            f"[elements.{name}]\n{ELEMENT}translation = {SPRINGS[name][0]}\nrotation = {SPRINGS[name][1]}\ndamping = {{loss_factor = {SPRINGS[name][2]}}}\n"
            for name in names
        )

    def imported(self, *names):
        complex_file(pathlib.Path(self.folder.name) / "mount.mtx", [SPRINGS[name] for name in names])
        return '[elements.mount]\ntype = "imported"\non = "machine"\nat = [0, 0, 0]\nfile = "mount.mtx"\n'

    def assert_same(self, left, right, within):
        for one, other in zip(left["results"], right["results"], strict=True):
            self.assertEqual(one["name"], other["name"])
            for a, b in zip(one["complex"], other["complex"], strict=True):
                self.assertLessEqual(
                    abs(complex(*a) - complex(*b)),
                    within * max(abs(complex(*v)) for v in other["complex"]),
                    one["name"],
                )

    def test_one_loss_factor_for_all_becomes_that_loss_factor(self):
        imported, given = self.imported("stiff"), self.bushings("stiff")
        self.assert_same(self.result_of("response", imported), self.result_of("response", given), 1e-12)
        facts = subprocess.run(
            [TRIVET, "element", pathlib.Path(self.folder.name) / "model.toml", "stiff", "--json"],
            capture_output=True,
            text=True,
            timeout=HANGS_AFTER,
        )
        self.assertAlmostEqual(json.loads(facts.stdout)["loss_factor"], 0.3)
        self.result_of("response", imported)  # writes the model again
        facts = subprocess.run(
            [TRIVET, "element", pathlib.Path(self.folder.name) / "model.toml", "mount", "--json"],
            capture_output=True,
            text=True,
            timeout=HANGS_AFTER,
        )
        self.assertAlmostEqual(json.loads(facts.stdout)["loss_factor"], 0.3, delta=1e-12)

    def test_different_losses_in_one_matrix_answer_like_the_elements_they_come_from(self):
        imported, given = self.imported("soft", "stiff"), self.bushings("soft", "stiff")
        self.assert_same(self.result_of("response", imported), self.result_of("response", given), 1e-11)
        left, right = self.result_of("peaks", imported)["peaks"], self.result_of("peaks", given)["peaks"]
        self.assertEqual([p["name"] for p in left], [p["name"] for p in right])
        for one, other in zip(left, right):
            self.assertAlmostEqual(one["angular_frequency"] / other["angular_frequency"], 1, delta=1e-7)
            self.assertAlmostEqual(one["amplitude"] / other["amplitude"], 1, delta=1e-9)
        roots = [
            [complex(*r["eigenvalue"]) for r in self.result_of("roots", e)["roots"] if r["eigenvalue"][1] > 0]
            for e in (imported, given)
        ]
        for one, other in zip(*(sorted(r, key=abs) for r in roots), strict=True):
            self.assertLessEqual(abs(one - other), 1e-8 * abs(other))

    def test_its_scale_multiplies_both_parts_and_statics_take_the_real_one(self):
        imported, given = self.imported("soft", "stiff"), self.bushings("soft", "stiff")
        twice = ("--set", "elements.soft.scale=2", "--set", "elements.stiff.scale=2")
        self.assert_same(
            self.result_of("response", imported, "--set", "elements.mount.scale=2"),
            self.result_of("response", given, *twice),
            1e-11,
        )
        pull = '[excitations.pull]\ntype = "constant"\non = "machine"\nat = [0, 0, 0]\nforce = [0, 0, 100]\n'
        values = [
            [r["value"] for r in self.result_of("static", e + pull)["results"] if r["name"].startswith("machine")]
            for e in (imported, given)
        ]
        for one, other in zip(*values, strict=True):
            self.assertAlmostEqual(one, other, delta=1e-12)


if __name__ == "__main__":
    unittest.main()
