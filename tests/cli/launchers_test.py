# SPDX-License-Identifier: BSD-3-Clause
"""A study folder under the launchers of this machine: Open MPI's mpirun, MPICH's mpiexec, Slurm's srun. One that is missing is skipped."""
import os
import shutil
import subprocess
import unittest

from trivet_test import HANGS_AFTER, SOURCE, TRIVET, InTemporaryFolder, trivet

ROBUST = SOURCE / "examples/paper/robust.toml"
FEW = ("--set", "analyses.sample.designs=3000")
LAUNCHERS = {  # words before the program, and what its version says
    "Open MPI": (["mpirun", "--oversubscribe", "-n", "3"], "Open MPI"),
    "MPICH": (["mpiexec.hydra", "-n", "3"], "HYDRA"),
    "Slurm": (["srun", "-n", "3", "-O"], "slurm"),
}


class Launchers(InTemporaryFolder):
    def test_ranks_write_the_bytes_of_one_process(self):
        plain = trivet("sample", ROBUST, *FEW, "--json").stdout
        environment = os.environ | {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
        for name, (words, version) in LAUNCHERS.items():
            with self.subTest(name):
                if not shutil.which(words[0]):
                    self.skipTest("it is not installed")
                said = subprocess.run([words[0], "--version"], capture_output=True, text=True, check=True).stdout
                if version.lower() not in said.lower():
                    self.skipTest("another program has its name")
                study = self.folder / name.replace(" ", "-")
                command = [*words, TRIVET, "sample", ROBUST, *FEW, "-o", study]
                done = subprocess.run(command, capture_output=True, text=True, env=environment, timeout=HANGS_AFTER)
                self.assertEqual(done.returncode, 0, done.stderr)
                for part in (1, 2, 3):
                    self.assertIn(f"part {part} of 3 (", done.stderr)
                    self.assertTrue((study / f"part-{part}-of-3").exists())
                self.assertEqual((study / "result.json").read_text(), plain)


if __name__ == "__main__":
    unittest.main()
