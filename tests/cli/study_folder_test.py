# SPDX-License-Identifier: BSD-3-Clause
"""Study folders of `trivet sample`: parts, threads, kills, signals and wrong folders. What processes keep in a folder is
the same, to the byte, as the result of one process without a folder."""
import json
import os
import random
import re
import shutil
import signal
import subprocess
import time
import unittest

from trivet_test import HANGS_AFTER, SOURCE, TRIVET, InTemporaryFolder, trivet

ROBUST = SOURCE / "examples/paper/robust.toml"
KILLS = 20
SEED = 20261130


class StudyFolder(InTemporaryFolder):
    def setUp(self):
        super().setUp()
        self.project = self.folder / "robust.toml"
        shutil.copy(ROBUST, self.project)
        self.study = self.folder / "study"
        self.environment = {
            name: value for name, value in os.environ.items() if not name.startswith(("SLURM_", "PMI_", "OMPI_"))
        }

    def sample(self, *arguments, designs=20_000, **more):
        environment = dict(self.environment, **more)
        return trivet(
            "sample", self.project, "--set", f"analyses.sample.designs={designs}", *arguments, env=environment
        )

    def start(self, *arguments, designs):
        return subprocess.Popen(
            [
                TRIVET,
                "sample",
                self.project,
                "--set",
                f"analyses.sample.designs={designs}",
                "-o",
                self.study,
                *arguments,
            ],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            env=self.environment,
        )

    def one_process(self, **options):
        done = self.sample("--json", **options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def assert_result(self, expected):
        self.assertEqual((self.study / "result.json").read_text(), expected)

    def test_parts_have_the_bytes_of_one_process(self):
        expected = self.one_process()
        for parts in (1, 3, 7):
            numbers = list(range(1, parts + 1))
            random.Random(SEED).shuffle(numbers)
            for number in numbers:
                done = self.sample("-o", self.study, "--part", f"{number}/{parts}", "--json")
                self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(done.stdout, expected)
            self.assert_result(expected)
            csv = self.sample("--csv").stdout
            self.assertEqual((self.study / "sample.csv").read_text(), csv)
            shutil.rmtree(self.study)

    def test_ranks_of_the_environment_are_parts(self):
        expected = self.one_process()
        array = {"SLURM_ARRAY_TASK_COUNT": "2", "SLURM_ARRAY_TASK_MIN": "5"}
        for names in (
            [{"OMPI_COMM_WORLD_RANK": str(i), "OMPI_COMM_WORLD_SIZE": "2", "SLURM_PROCID": "0"} for i in (0, 1)],
            [{"PMI_RANK": str(i), "PMI_SIZE": "2"} for i in (0, 1)],
            [{"SLURM_PROCID": str(i), "SLURM_NTASKS": "2"} for i in (0, 1)],
            [dict(array, SLURM_ARRAY_TASK_ID=str(i)) for i in (5, 6)],
            [
                dict(array, SLURM_ARRAY_TASK_ID=str(i), SLURM_PROCID=str(k), SLURM_NTASKS="2")
                for i in (5, 6)
                for k in (0, 1)
            ],
        ):
            for name in names:
                done = self.sample("-o", self.study, "--json", **name)
                self.assertEqual(done.returncode, 0, done.stderr)
            self.assertRegex(done.stderr, rf"part {len(names)} of {len(names)} \(\w+ and \w+")
            self.assertEqual(done.stdout, expected)
            shutil.rmtree(self.study)
        for name, said in (
            ({"PMI_RANK": "x", "PMI_SIZE": "2"}, 'PMI_RANK is "x", not a whole number'),
            ({"PMI_RANK": "2", "PMI_SIZE": "2"}, "name process 2 of 2"),
            (dict(array, SLURM_ARRAY_TASK_ID="9"), "not evenly spaced"),
        ):
            done = self.sample("-o", self.study, **name)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(said, done.stderr)

    def test_another_number_of_parts_goes_on(self):
        expected = self.one_process()
        self.sample("-o", self.study, "--part", "2/3")
        done = self.sample("-o", self.study, "--json")
        self.assertRegex(done.stderr, r"19 of 56 chunks were there; part 1 of 1 computed 37")
        self.assertEqual(done.stdout, expected)

    def test_an_incomplete_study_has_a_partial_result(self):
        done = self.sample("-o", self.study, "--part", "1/3")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("PARTIAL: 19 of 56 chunks of the study, 6840 of 20000 designs.", done.stdout)
        self.assertFalse((self.study / "result.json").exists())

    def test_shares_belong_to_the_complete_result(self):
        text = self.project.read_text()
        self.project.write_text(re.sub(r'correlation = .*\n', '', text))
        self.sample("-o", self.study, "--part", "1/2", "--shares")
        done = self.sample("-o", self.study, "--part", "2/2", "--shares", "--json")
        self.assertEqual(done.stdout, self.sample("--shares", "--json").stdout)
        self.assertIn('"shares"', done.stdout)

    def test_kills_at_random_moments(self):
        designs = 200_000
        expected = self.one_process(designs=designs)
        moments = random.Random(SEED)
        for _ in range(KILLS):
            parts = [self.start("--part", f"{number}/2", designs=designs) for number in (1, 2)]
            time.sleep(moments.uniform(0.01, 0.4))
            for part in parts:
                part.send_signal(signal.SIGKILL)
                part.communicate()
        found = 0
        for number in (1, 2):
            done = self.sample("-o", self.study, "--part", f"{number}/2", "--json", designs=designs)
            self.assertEqual(done.returncode, 0, done.stderr)
            found += int(re.search(r"(\d+) of \d+ chunks were there", done.stderr).group(1))
        self.assertGreater(found, 0, "the kills were after some files")
        self.assertEqual(done.stdout, expected)
        left = {path.name for path in self.study.iterdir()} - {"study.txt.new", "part-1-of-2.new", "part-2-of-2.new"}
        self.assertEqual(
            left, {"study.txt", "part-1-of-2", "part-2-of-2", "result.json", "sample.csv", "designs.csv", "bands.csv"}
        )

    def test_signals_leave_a_partial_result_and_the_command_to_go_on(self):
        designs = 3_000_000
        found = 0
        for number in (signal.SIGTERM, signal.SIGINT, signal.SIGUSR1):
            process = self.start(designs=designs)
            time.sleep(0.8)
            begin = time.monotonic()
            process.send_signal(number)
            output, errors = process.communicate(timeout=HANGS_AFTER)
            self.assertLess(time.monotonic() - begin, 2, "seconds")
            self.assertEqual(process.returncode, 128 + number, errors)
            self.assertRegex(output, r"^PARTIAL: \d+ of \d+ chunks of the study")
            there, computed = map(int, re.search(r"(\d+) of \d+ chunks were there; .* computed (\d+)", errors).groups())
            self.assertEqual(there, found)
            found += computed
            self.assertGreater(computed, 0)
            self.assertIn(f"trivet sample {self.project} --set analyses.sample.designs={designs} --output", errors)

    def test_damaged_files_are_computed_again(self):
        expected = self.one_process()
        for number in (1, 2, 3):
            self.sample("-o", self.study, "--part", f"{number}/3")
        part = self.study / "part-2-of-3"
        text = part.read_text()
        for damaged in (text[:-100], text.replace("1", "2", 1), "", "nothing"):
            part.write_text(damaged)
            done = self.sample("-o", self.study, "--part", "2/3", "--json")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("37 of 56 chunks were there; part 2 of 3 (--part) computed 19", done.stderr)
            self.assertEqual("1 file (part-2-of-3) cannot be read: damaged" in done.stderr, damaged != "")
            self.assertEqual(done.stdout, expected)
        (self.study / "study.txt").write_text("nothing")
        done = self.sample("-o", self.study, "--json")
        self.assertIn("1 file (study.txt) cannot be read: damaged", done.stderr)
        self.assertEqual(done.stdout, expected)
        (self.study / "study.txt").write_text("nothing")
        self.refused("study.txt is damaged, and part-1-of-3 is of another study", "-o", self.study, designs=30_000)
        self.assertEqual((self.study / "study.txt").read_text(), "nothing")
        for part in self.study.glob("part-*"):
            part.unlink()
        self.refused("study.txt is damaged, and no other file says what the study is of", "-o", self.study)
        self.assertEqual((self.study / "result.json").read_text(), expected)

    def test_files_with_the_same_chunks_count_once(self):
        expected = self.one_process()
        other = self.folder / "other"
        for folder, part in ((self.study, "1/2"), (self.study, "2/2"), (other, "2/3")):
            self.sample("-o", folder, "--part", part)
        shutil.copy(other / "part-2-of-3", self.study)
        done = self.sample("-o", self.study, "--part", "2/2", "--json")
        self.assertIn("1 file (part-2-of-3) not counted: other files have the same chunks", done.stderr)
        self.assertEqual(done.stdout, expected)

    def refused(self, said, *arguments, **options):
        done = self.sample(*arguments, **options)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn(said, done.stderr)

    def test_folders_of_other_studies(self):
        self.sample("-o", self.study)
        before = (self.study / "result.json").read_text()
        to = ("-o", self.study)
        self.refused("number of designs: 20000 there, 30000 here", *to, designs=30_000)
        self.refused("seed: 1 there, 2 here", *to, "--set", "analyses.sample.seed=2")
        self.refused("sampling: sobol there, random here", *to, "--set", "analyses.sample.sampling=random")
        self.refused("settings: analyses.sample.designs=20000 there, ", *to, "--set", "bodies.aggregate.mass=200")
        manifest = self.study / "study.txt"
        self.project.write_text(self.project.read_text() + "# another\n")
        self.refused("the project file has another content there", *to)
        self.assertEqual((self.study / "result.json").read_text(), before)
        shutil.copy(ROBUST, self.project)
        other = self.folder / "other"
        self.sample("-o", other, "--set", "analyses.sample.seed=2")
        shutil.copy(other / "part-1-of-1", self.study)
        self.refused("part-1-of-1 is of another study than study.txt", *to)
        self.assertTrue(manifest.exists())

    def test_folders_without_a_study(self):
        self.study.mkdir()
        (self.study / "notes.md").write_text("mine")
        self.refused("it has no study but other files, such as notes.md", "-o", self.study)
        self.refused("this is a file", "-o", self.project)
        self.refused("the folder above it does not exist", "-o", self.folder / "none" / "study")
        self.refused("parts share a study folder", "--part", "1/2")
        for part in ("0/2", "3/2", "1", "a/b", "1/2/3", "-1/2"):
            self.refused(
                "give the part and the number of all, at most 1000000, as in 3/64",
                "-o",
                self.folder / "new",
                f"--part={part}",
            )

    def test_one_part_is_for_one_process(self):
        first = self.start("--part", "1/2", designs=3_000_000)
        try:
            part = self.study / "part-1-of-2"
            while not part.exists():
                time.sleep(0.01)
            time.sleep(0.1)
            to = ("-o", self.study, "--part")
            self.refused("another process works on part 1 of 2", *to, "1/2", designs=3_000_000)
            self.refused("a process works on part 1 of 2 now", *to, "1/3", designs=3_000_000)
        finally:
            first.kill()
            first.communicate()

    def test_status_from_elsewhere(self):
        def status(*arguments):
            return trivet("sample", "--status", self.study, *arguments, env=self.environment)

        self.sample("-o", self.study, "--part", "1/2")
        self.assertIn(
            "28 of 56 chunks are done (50 %), of 20000 designs; no process works on it: start its command again",
            status().stdout,
        )
        self.sample("-o", self.study, "--part", "2/2")
        found = json.loads(status("--json").stdout)
        self.assertEqual((found["designs"], found["chunks"], found["done"]), (20_000, 56, 56))
        self.assertEqual(
            [(part["part"], part["of"], part["state"]) for part in found["parts"]], [(1, 2, "ended"), (2, 2, "ended")]
        )
        self.assertIn("the study is complete", status().stdout)
        self.assertEqual(len(status("--csv").stdout.splitlines()), 3)
        shutil.rmtree(self.study)

        running = self.start("--part", "2/2", designs=3_000_000)
        try:
            found = {"done": 0}
            while found["done"] == 0:
                self.assertIsNone(running.poll(), "it has ended")
                time.sleep(0.05)
                done = status("--json")
                if done.returncode == 0:  # otherwise study.txt is not there yet
                    found = json.loads(done.stdout)
            self.assertEqual(found["parts"][0]["state"], "running")
            self.assertGreater(found["rate"], 0)
            self.assertEqual(found["parts"][0]["missing"] + found["done"], found["chunks"] // 2)
            self.assertRegex(status().stdout, r"1 part running, \S+ designs/s, about \d+ (s|min|h) left for it\.")
        finally:
            running.kill()
            running.communicate()
        self.assertEqual(json.loads(status("--json").stdout)["parts"][0]["state"], "stopped")

        for arguments, said in (
            (("--status", self.folder), "there is no study in it: study.txt is missing"),
            (("--status", self.folder / "none"), "No such file"),
            (("--status", self.study, "--shares"), "--shares: true; this asks about no project"),
            ((self.project, "--status", self.study), "this asks about no project; omit the project file"),
            ((), "PROJECT is required"),
        ):
            done = trivet("sample", *arguments)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(said, done.stderr)

    def test_a_full_disk_is_reported_and_the_study_goes_on(self):
        expected = self.one_process()
        self.sample("-o", self.study, "--part", "1/2")
        command = f'ulimit -f 1; exec "{TRIVET}" sample "{self.project}" --set analyses.sample.designs=20000 -o "{self.study}"'
        full = subprocess.run(["bash", "-c", command], capture_output=True, text=True, env=self.environment)
        self.assertEqual(full.returncode, 1, full.stderr)
        self.assertIn("part-1-of-1 cannot be written: File too large", full.stderr)
        self.assertIn("start the same command again to go on", full.stderr)
        done = self.sample("-o", self.study, "--json")
        self.assertIn("28 of 56 chunks were there", done.stderr)
        self.assertEqual(done.stdout, expected)

    def test_a_name_with_an_ending_is_a_file(self):
        expected = self.one_process()
        file = self.folder / "result.json"
        self.assertEqual(self.sample("-o", file).returncode, 0)
        self.assertEqual(file.read_text(), expected)


if __name__ == "__main__":
    unittest.main()
