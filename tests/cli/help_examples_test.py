# SPDX-License-Identifier: BSD-3-Clause
"""Every help has two examples, and each of them runs as it stands on a machine that has what it names."""
import os
import pathlib
import re
import shlex
import shutil
import signal
import subprocess
import unittest

from trivet_test import HANGS_AFTER, SOURCE, TRIVET, InTemporaryFolder, trivet

# Examples with the analyses of a command; all others run on the first.
MACHINES = {
    "curves": "three_coil_springs/machine.toml",
    "run": "genset/genset.toml",
    "steady": "isolator/hardening.toml",
    "backbone": "isolator/hardening.toml",
    "transmissibility": "genset/mounts.toml",
    "random": "optical_table/table.toml",
    "transient": "transport_shock/device.toml",
    "shock_spectrum": "transport_shock/device.toml",
    "earthquake": "skew_mounts/machine.toml",
    "operation": "fan/fan.toml",
    "map": "paper/map.toml",
    "optimize": "powertrain/decoupled.toml",
    "verdict": "compressor/requirements.toml",
    "explain": "measured_response/machine.toml",
    "measurements": "measured_response/machine.toml",
    "select": "genset/mounts.toml",
    "sample": "paper/robust.toml",
    "box": "powertrain/box.toml",
}
ADDED = {"earthquake": '[analyses.earthquake]\ndirection = "x"\nrows = [[0.001, 3], [10, 2]]\n'}


def commands():
    return re.findall(r"^  ([a-z_]+)  ", trivet("--help").stdout, re.M)


def examples(command):
    text = trivet(command, "--help").stdout
    return re.findall(r"^  (.+)$", text.split("Examples:\n")[1].split("\n\n")[0], re.M)


class HelpExamples(InTemporaryFolder):
    def test_two_of_each_command(self):
        for command in commands():
            with self.subTest(command=command):
                self.assertGreaterEqual(len(examples(command)), 2)
                for example in examples(command):
                    self.assertIn(f"trivet {command}", example)

    def test_each_runs(self):
        for command in commands():
            if command != "serve":
                self.run_examples(command)

    def test_serve_runs_until_it_is_interrupted(self):
        shutil.copy(SOURCE / "examples" / MACHINES["run"], self.folder / "machine.toml")
        for example in examples("serve"):
            words = [TRIVET, *shlex.split(example)[1:]]
            environment = {**os.environ, "BROWSER": "true"}
            run = subprocess.Popen(
                words, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, cwd=self.folder, env=environment
            )
            self.assertIn(b"http://127.0.0.1:", run.stdout.readline())
            run.send_signal(signal.SIGINT)
            self.assertEqual(run.wait(timeout=HANGS_AFTER), 130)
            run.stdout.close()

    def run_examples(self, command):
        folder = self.folder / command
        source = SOURCE / "examples" / MACHINES.get(command, MACHINES["run"])
        shutil.copytree(source.parent, folder)
        (folder / "machine.toml").write_text(source.read_text() + "\n[cases.winter]\n" + ADDED.get(command, ""))
        path = f"{pathlib.Path(TRIVET).resolve().parent}:{os.environ['PATH']}"
        for example in examples(command):
            with self.subTest(example=example):
                done = subprocess.run(
                    ["bash", "-c", "set -o pipefail; " + example],
                    capture_output=True,
                    text=True,
                    cwd=folder,
                    timeout=HANGS_AFTER,
                    env={**os.environ, "PATH": path},
                )
                accepted = (0, 3, 4) if "--strict" in example else (0,)
                self.assertIn(done.returncode, accepted, done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
