# SPDX-License-Identifier: BSD-3-Clause
"""Nodes in the commands: notes, warnings, paths, results, the report and the schema."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

from trivet_test import HANGS_AFTER

TRIVET = os.environ["TRIVET"]
SOURCE = pathlib.Path(os.environ["TRIVET_SOURCE"])
FRAME = str(SOURCE / "examples/frame/frame.toml")

# A mass on two bars in line; the node between them has ball joints.
BARS = """trivet = 1
[bodies.m]
mass = 10
free = ["z"]
position = [0, 0, 0.3]
[nodes.joint]
position = [0, 0, 0.1]
[elements.lower]
type = "link"
on = "joint"
from_at = [0, 0, 0]
stiffness = 6e4
damping = {proportional = 1e-3}
[elements.upper]
type = "link"
on = "m"
at = [0, 0, 0]
from = "joint"
stiffness = 3e4
[excitations.f]
type = "harmonic"
on = "joint"
force = [0, 0, 5]
[analyses]
modes = {}
response = {at = [20], of = ["m.z", "joint", "lower"]}
"""
# Two free bodies on springs in line: only their distance is held, 1e4 N/m twice in series.
PAIR = """trivet = 1
[bodies.a]
mass = 10
inertia = {about = "center_of_mass", xx = 1, yy = 1, zz = 1}
[bodies.b]
mass = 20
inertia = {about = "center_of_mass", xx = 1, yy = 1, zz = 1}
position = [1, 0, 0]
[nodes.n]
position = [0.5, 0, 0]
[elements.left]
type = "three_springs"
on = "a"
at = [0.1, 0, 0]
from = "n"
translation = [1e4, 1e4, 1e4]
[elements.right]
type = "three_springs"
on = "b"
at = [-0.1, 0, 0]
from = "n"
translation = [1e4, 2e4, 1e4]
"""
NOTE = "note: node joint: translation along x, y, rotation about x, y, z are held by no element and left out"


class Nodes(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_on(self, command, text=BARS, *more, code=0):
        path = self.folder / "project.toml"
        path.write_text(text)
        done = subprocess.run([TRIVET, command, str(path), *more], capture_output=True, text=True, timeout=HANGS_AFTER)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def test_left_out_directions_are_noted_by_check_and_run_and_in_the_results(self):
        self.assertIn(NOTE, self.run_on("check"))
        results = self.folder / "results"
        self.assertIn(NOTE, self.run_on("run", BARS, "-o", str(results)))
        case = json.loads((results / "results.json").read_text())["cases"][0]
        self.assertEqual(["note: " + note for note in case["notes"]], [NOTE])
        node = case["model"]["nodes"][0]
        self.assertEqual(node["free"], ["z"])
        self.assertEqual(node["left_out"], ["x", "y", "rx", "ry", "rz"])
        self.assertEqual([body["name"] for body in case["model"]["bodies"]], ["m"])
        self.assertIn("<h3>Nodes</h3>", (results / "report.html").read_text())

    def test_modes_are_those_of_the_masses_and_their_shapes_contain_the_nodes(self):
        result = json.loads(self.run_on("modes", BARS, "--json"))
        self.assertEqual(result["bodies"], ["m", "joint"])
        (mode,) = result["modes"]
        self.assertAlmostEqual(mode["eigenvalue_squared"], 2e4 / 10, places=8)
        self.assertAlmostEqual(mode["shape"][8] / mode["shape"][2], 1 / 3, places=12)

    def test_a_mechanism_of_nodes_is_at_rest_and_does_not_grow(self):
        squares = [mode["eigenvalue_squared"] for mode in json.loads(self.run_on("modes", PAIR, "--json"))["modes"]]
        self.assertEqual(squares[:11], [0] * 11)
        self.assertAlmostEqual(squares[11], 5e3 * (1 / 10 + 1 / 20), places=9)

    def test_lengths_follow_the_nodes_along_a_path(self):
        for place in (0.1, 0.15):
            setting = f"nodes.joint.position.z={place}"
            self.assertIn("no errors", self.run_on("check", BARS, "--set", setting))
        skew = ["--set", "bodies.m.position.x=0.3", "--set", "nodes.joint.position.x=0.1"]  # in line at 45°
        self.assertIn(
            "nodes.joint: no element holds its translation along (", self.run_on("check", BARS, *skew, code=2)
        )
        bent = ["--set", "nodes.joint.position.x=0.1"]  # held, but a mechanism: the mass can move
        self.assertIn("rigid-body mode", self.run_on("check", BARS, *bent))
        refused = self.run_on("check", BARS, "--set", "nodes.join.position.x=0.1", code=2)
        self.assertIn('did you mean "joint"?', refused)

    def test_one_element_on_a_node_is_a_warning(self):
        text = BARS + '[nodes.tip]\nposition = [0, 0, 0.3]\n[elements.end]\ntype = "three_springs"\non = "tip"\n'
        text += 'from = "m"\nfrom_at = [0, 0, 0]\ntranslation = [1, 1, 1]\n'
        self.assertIn('nodes.tip: only "end" ends on it', self.run_on("check", text))

    def test_a_node_has_no_initial_value(self):
        text = BARS + 'transient = {of = ["m.z"], to = 0.1, step = 1e-3, initial_displacement = {"joint.z" = 1e-3}}\n'
        self.assertIn("a node has no mass", self.run_on("transient", text, code=2))
        text = text.replace('"joint.z" = 1e-3', '"m.z" = 1e-3')
        self.run_on("transient", text)

    def test_explain_finds_no_sensitivity_to_masses_of_nodes(self):
        result = json.loads(self.run_on("explain", BARS, "--of", "m.z", "--json"))
        parameters = [one["parameter"] for one in result["peaks"][0]["sensitivities"]]
        self.assertIn("bodies.m.mass", parameters)
        self.assertFalse([name for name in parameters if "joint" in name])

    def test_the_second_solver_agrees_on_the_frame(self):
        done = subprocess.run(
            [TRIVET, "check", FRAME, "--deep", "--json"], capture_output=True, text=True, timeout=HANGS_AFTER
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        for check in json.loads(done.stdout)["deep"]:
            self.assertLess(check["worst_difference"], check["allowed"], check)

    def test_they_come_from_tables_too(self):
        listed = BARS.replace(
            "[nodes.joint]\nposition = [0, 0, 0.1]\n",
            '[tables.nodes]\nrows = [{name = "joint", position.x = 0, position.y = 0, position.z = "100 mm"}]\n',
        )
        self.assertNotEqual(listed, BARS)
        self.assertEqual(self.run_on("modes", listed, "--json"), self.run_on("modes", BARS, "--json"))
        double = listed + "[nodes.joint]\nposition = [0, 0, 0.2]\n"
        self.assertIn("nodes.joint: defined a second time", self.run_on("check", double, code=2))

    def test_the_schema_knows_them(self):
        schema = json.loads(
            subprocess.run([TRIVET, "schema"], capture_output=True, text=True, timeout=HANGS_AFTER).stdout
        )
        self.assertIn("nodes", schema["properties"])
        self.assertEqual(sorted(schema["$defs"]["node"]["properties"]), ["free", "orientation", "position"])


if __name__ == "__main__":
    unittest.main()
