# SPDX-License-Identifier: BSD-3-Clause
"""Completion in shells and the manual page, both generated from the options that the program accepts."""
import os
import pathlib
import re
import shutil
import subprocess
import unittest

from trivet_test import SOURCE, TRIVET, InTemporaryFolder, trivet

GENSET = SOURCE / "examples/genset/load_cases.toml"
# Sources the script and asks it as the shell does: `words` are those of the line, the last is completed.
ASK = """
source "$1"; shift
COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _trivet 2>/dev/null; printf '%s\\n' "${COMPREPLY[@]}"
"""

GUIDED = """trivet = 1
gravity = [0, 0, -9.80665]
[bodies.m]
mass = 40
free = ["z"]
[bodies.m.points]
top = [0, 0, 0.1]
[bodies.table]
mass = 90
inertia = {about = "center_of_mass", xx = 2, yy = 2, zz = 3}
position = [0, 0, -1]
[elements.s]
type = "bushing"
from = "table"
on = "m"
at = [0, 0, -0.5]
translation = [1e5, 1e5, 2.5e5]
rotation = [1e4, 1e4, 1e4]
[elements.floor]
type = "bushing"
on = "table"
at = [0, 0, -1.5]
translation = [1e6, 1e6, 2.5e6]
rotation = [1e6, 1e6, 1e6]
[sections.joint]
elements = ["s"]
at = [0, 0, -0.5]
[clearances.gap]
between = ["m.top", "ground"]
direction = "z"
gap = "6 mm"
[relative.lift]
of = "m"
to = "table"
axis = "z"
[excitations.f]
type = "harmonic"
on = "m"
at = [0, 0, 0]
force = [0, 0, 30]
[analyses]
response = {band = ["1 Hz", "30 Hz"], of = ["m.z"]}
"""


def listed_commands():
    return re.findall(r"^  ([a-z_]+)  ", trivet("--help").stdout, re.M)


class Completion(InTemporaryFolder):
    def bash(self, *words):
        script = self.folder / "completion.bash"
        script.write_text(trivet("completion", "bash").stdout)
        path = f"{pathlib.Path(TRIVET).resolve().parent}:{os.environ['PATH']}"
        done = subprocess.run(
            ["bash", "--norc", "-c", ASK, "bash", script, *map(str, words)],
            capture_output=True,
            text=True,
            cwd=self.folder,
            env={**os.environ, "PATH": path},
        )
        self.assertEqual(done.stderr, "")
        return [word for word in done.stdout.split("\n") if word]

    def test_commands(self):
        self.assertEqual(self.bash("trivet", "ver"), ["verdict"])
        every = self.bash("trivet", "")
        self.assertLessEqual(set(listed_commands()), set(every))
        self.assertIn("completion", every)
        self.assertNotIn("names", every)

    def test_every_option_of_every_help(self):
        for command in listed_commands():
            options = set(re.findall(r"^ +(?:-\w, *)?(--[a-z-]+)", trivet(command, "--help").stdout, re.M))
            with self.subTest(command=command):
                self.assertEqual(set(word for word in self.bash("trivet", command, "-") if word[1] == "-"), options)

    def test_values(self):
        self.assertEqual(self.bash("trivet", "select", "a.toml", "--by", "p"), ["price"])
        self.assertEqual(self.bash("trivet", "run", "a.toml", "--report", ""), ["full", "short"])
        self.assertIn("matlab", self.bash("trivet", "export", "a.toml", "--to", "mat"))
        self.assertEqual(self.bash("trivet", "completion", ""), ["bash", "zsh", "fish"])

    def test_names_in_the_project(self):
        shutil.copytree(GENSET.parent, self.folder / "genset")
        names = trivet("names", GENSET, "cases").stdout.splitlines()
        self.assertGreater(len(names), 3)
        plain = [re.sub(r"\\(.)", r"\1", one) for one in self.bash("trivet", "modes", GENSET, "--case", "")]
        self.assertEqual(plain, names)
        self.assertEqual(self.bash("trivet", "element", GENSET, "front"), [r"front\ left", r"front\ right"])
        self.assertEqual(self.bash("trivet", "element", "--case", "hot", GENSET, "'front l"), ["front left"])
        self.assertEqual(self.bash("trivet", "modes", "no such file", "--case", ""), [])

    def test_results_and_paths_of_the_project(self):
        fan = SOURCE / "examples/fan/fan.toml"
        self.assertEqual(self.bash("trivet", "explain", fan, "--of", "fan.bearing.rx"), ["fan.bearing.rx"])
        self.assertEqual(
            self.bash("trivet", "explain", fan, "--of", "ground.force"), [f"ground.force.{a}" for a in "xyz"]
        )
        (speed,) = self.bash("trivet", "modes", fan, "--set", "excitations.rotor.serv")
        self.assertEqual(speed, "excitations.rotor.service_speed=")
        paths = trivet("names", fan, "paths").stdout.split("=\n")
        self.assertIn('elements."front left".at.x', paths)
        for path in ("bodies.fan.points.bearing.z", "element_types.spring.translation.x", "analyses.response.band"):
            self.assertIn(path, paths)
        self.assertNotIn("title", paths)
        self.assertEqual(self.bash("trivet", "explain", "no such file", "--of", ""), [])

    def test_results_and_paths_of_all_parts(self):
        machine = self.file(GUIDED)
        results = set(trivet("names", machine, "results").stdout.splitlines())
        self.assertLessEqual(
            {"coordinates", "m.z", "m.top.z", "joint", "joint.moment.y", "gap.approach", "base.rx"}, results
        )
        self.assertFalse({"m.x", "m.rz"} & results)
        of = f"analyses.response.of = {sorted(results)}"
        self.assertEqual(trivet("response", machine, "--set", of).returncode, 0)
        paths = trivet("names", machine, "paths").stdout.split("=\n")
        self.assertLessEqual({"bodies.m.mass", "bodies.m.points.top.x", "analyses.response.band"}, set(paths))
        self.assertFalse({path for path in paths if "free" in path or path.endswith(".of")})

    def test_nothing_of_the_line_is_run_or_written(self):
        for words in (("$(touch made)", "--case"), ("`touch made`", "--case"), (">", "log", GENSET, "--case")):
            self.bash("trivet", "modes", *words, "")
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["completion.bash"])

    def test_files(self):
        self.file("", "machine one.toml")
        self.assertEqual(self.bash("trivet", "modes", "mach"), ["machine one.toml"])
        self.assertEqual(self.bash("trivet", "map", "a.toml", "--picture", "mach"), ["machine one.toml"])

    def test_scripts_are_of_their_shells(self):
        for shell in ("bash", "zsh", "fish"):
            script = self.folder / shell
            script.write_text(trivet("completion", shell).stdout)
            for command in listed_commands():
                self.assertIn(command, script.read_text())
            if shutil.which(shell):
                done = subprocess.run([shell, "-n", script], capture_output=True, text=True)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(trivet("completion", "tcsh").returncode, 2)


class Manual(InTemporaryFolder):
    def test_every_command_and_option_is_there(self):
        page = self.folder / "trivet.1"
        page.write_text(trivet("man").stdout)
        if not shutil.which("groff"):
            self.skipTest("no groff")
        done = subprocess.run(
            ["groff", "-ww", "-K", "utf8", "-T", "utf8", "-P", "-cbou", "-man", page], capture_output=True, text=True
        )
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        text = re.sub(r"[‐−]", "-", done.stdout)
        self.assertTrue(text.startswith("TRIVET(1)"), text[:60])
        for command in listed_commands():
            help_text = trivet(command, "--help").stdout
            self.assertRegex(text, rf"\n +trivet {command}\b")
            for option in re.findall(r"^ +(?:-\w, *)?(--[a-z-]+)", help_text, re.M):
                if option != "--help":
                    self.assertIn(option, text)
        for words in ("NO_COLOR", "EXIT STATUS", 'trivet element machine.toml "front left" --picture mount.svg'):
            self.assertIn(words, text)


if __name__ == "__main__":
    unittest.main()
