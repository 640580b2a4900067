# SPDX-License-Identifier: BSD-3-Clause
"""Result folders belong to the user: what a second run replaces, keeps and rejects."""
import hashlib
import json
import os
import pathlib
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

from trivet_test import HANGS_AFTER

TRIVET = os.environ["TRIVET"]

ONE_MASS = """trivet = 1
[bodies.mass]
mass = 4
inertia = {about = "pole", xx = 1, yy = 1, zz = 1}
[elements.spring]
type = "bushing"
on = "mass"
at = [0, 0, 0]
translation = [4e3, 5e3, 3600]
rotation = [400, 300, 200]
damping = {proportional = 1e-3}
[excitations.shaker]
type = "harmonic"
on = "mass"
at = [0, 0, 0]
force = [0, 0, 18]
[analyses]
modes = {}
peaks = {}
response = {at = [1, 2, 3]}
"""
CASES = "[cases.soft]\nelements.spring.scale = 0.5\n[cases.stiff]\nelements.spring.scale = 2\n"
OURS = ["00-base", "01-soft", "02-stiff", "manifest.json", "report.html", "results.json"]


def is_whole(folder):
    """Does every file of the manifest exist, unchanged?"""
    manifest = json.loads((folder / "manifest.json").read_text())
    listed = [entry["path"] for entry in manifest["files"]]
    assert {"results.json", "report.html"} <= set(listed), listed
    for entry in manifest["files"]:
        content = (folder / entry["path"]).read_bytes()
        if len(content) != entry["size"] or hashlib.sha256(content).hexdigest() != entry["sha256"]:
            return False
    return True


class InFolder(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder, True)
        self.work = self.folder / "work"
        self.work.mkdir()
        self.project = self.folder / "one.toml"
        self.project.write_text(ONE_MASS + CASES)
        self.target = self.work / "out"

    def run_trivet(self, project=None, target=None, **options):
        return subprocess.run(
            [TRIVET, "run", str(project or self.project), "-o", str(target or self.target)],
            capture_output=True,
            text=True,
            timeout=HANGS_AFTER,
            **options,
        )

    def succeeds(self, **options):
        done = self.run_trivet(**options)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(is_whole(self.target))
        return done

    def refused(self, *words, **options):
        done = self.run_trivet(**options)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertEqual(done.stdout, "")
        for word in words:
            self.assertIn(word, done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)

    def without_case(self, name):
        text = ONE_MASS + "".join(f"[cases.{part}" for part in CASES.split("[cases.")[1:] if not part.startswith(name))
        path = self.folder / "fewer.toml"
        path.write_text(text)
        return path

    def nothing_beside(self, *others):
        self.assertEqual(sorted(os.listdir(self.work)), sorted(["out", *others]))


class SecondRun(InFolder):
    def test_the_manifest_names_every_file(self):
        self.succeeds()
        self.assertEqual(sorted(os.listdir(self.target)), OURS)
        listed = {entry["path"] for entry in json.loads((self.target / "manifest.json").read_text())["files"]}
        found = {str(path.relative_to(self.target)) for path in self.target.rglob("*") if path.is_file()}
        self.assertEqual(listed | {"manifest.json"}, found)

    def test_files_of_the_user_stay(self):
        self.succeeds()
        (self.target / "note.txt").write_text("mine")
        (self.target / "00-base" / "note.txt").write_text("mine too")
        (self.target / "2026-05-01" / "deep").mkdir(parents=True)
        (self.target / "2026-05-01" / "deep" / "data.csv").write_text("1,2,3")
        (self.target / "03-empty").mkdir(mode=0o750)
        (self.target / "link").symlink_to(self.project)
        os.mkfifo(self.target / "pipe")
        os.utime(self.target / "2026-05-01", (1e9, 1e9))
        note = (self.target / "note.txt").stat()
        done = self.succeeds()
        self.assertEqual(done.stderr, "")
        self.assertEqual((self.target / "note.txt").read_text(), "mine")
        self.assertEqual((self.target / "note.txt").stat().st_ino, note.st_ino)
        self.assertEqual((self.target / "00-base" / "note.txt").read_text(), "mine too")
        self.assertEqual((self.target / "2026-05-01" / "deep" / "data.csv").read_text(), "1,2,3")
        self.assertEqual((self.target / "2026-05-01").stat().st_mtime, 1e9)
        self.assertEqual((self.target / "03-empty").stat().st_mode & 0o777, 0o750)
        self.assertEqual(os.readlink(self.target / "link"), str(self.project))
        self.assertTrue((self.target / "pipe").is_fifo())
        self.assertEqual(
            sorted(os.listdir(self.target)), sorted(OURS + ["note.txt", "2026-05-01", "03-empty", "link", "pipe"])
        )
        self.nothing_beside()

    def test_a_case_that_no_longer_exists_goes_unless_the_user_keeps_something_in_it(self):
        self.succeeds()
        self.succeeds(project=self.without_case("stiff"))
        self.assertEqual(sorted(os.listdir(self.target)), sorted(set(OURS) - {"02-stiff"}))
        self.succeeds()
        (self.target / "02-stiff" / "note.txt").write_text("mine")
        self.succeeds(project=self.without_case("stiff"))
        self.assertEqual(os.listdir(self.target / "02-stiff"), ["note.txt"])

    def test_a_file_that_the_user_edited_is_kept_under_another_name(self):
        self.succeeds()
        edited = self.target / "00-base" / "modes.csv"
        edited.write_text("my own numbers")
        done = self.succeeds()
        self.assertIn(
            "00-base/modes.csv was changed since trivet wrote it; it is kept as 00-base/modes.kept-1.csv", done.stderr
        )
        self.assertEqual((self.target / "00-base" / "modes.kept-1.csv").read_text(), "my own numbers")
        edited.write_text("other numbers")
        self.succeeds()
        self.assertEqual((self.target / "00-base" / "modes.kept-1.csv").read_text(), "my own numbers")
        self.assertEqual((self.target / "00-base" / "modes.kept-2.csv").read_text(), "other numbers")

    def test_a_file_of_the_user_in_the_way_is_kept_under_another_name(self):
        self.succeeds(project=self.without_case("stiff"))
        (self.target / "02-stiff").mkdir()
        (self.target / "02-stiff" / "modes.csv").symlink_to(self.project)
        done = self.succeeds()
        self.assertIn("was not written by trivet", done.stderr)
        self.assertEqual(os.readlink(self.target / "02-stiff" / "modes.kept-1.csv"), str(self.project))
        self.assertEqual(self.project.read_text(), ONE_MASS + CASES)

    def test_rights_of_the_folder_stay(self):
        self.succeeds()
        self.target.chmod(0o750)
        self.succeeds()
        self.assertEqual(self.target.stat().st_mode & 0o7777, 0o750)

    def test_an_empty_folder_is_used(self):
        self.target.mkdir()
        self.succeeds()

    def test_missing_parents_are_made_and_removed_if_the_run_fails(self):
        self.target = self.work / "a" / "b" / "out"
        bad = self.folder / "bad.toml"
        bad.write_text((ONE_MASS + CASES).replace("mass = 4", "mass = -4"))
        self.assertEqual(self.run_trivet(project=bad).returncode, 2)
        self.assertEqual(os.listdir(self.work), [])
        self.succeeds()
        self.assertEqual(os.listdir(self.work / "a" / "b"), ["out"])


class Rejection(InFolder):
    def test_links_are_neither_followed_nor_replaced(self):
        elsewhere = self.work / "elsewhere"
        elsewhere.mkdir()
        self.target.symlink_to(elsewhere)
        for target in (self.target, f"{self.target}/"):
            self.refused("out is a symbolic link", target=target)
        self.target.unlink()
        self.target.symlink_to(self.work / "nowhere")
        self.refused("out is a symbolic link")
        self.target.unlink()
        self.succeeds()
        shutil.rmtree(self.target / "01-soft")
        (self.target / "01-soft").symlink_to(elsewhere)
        self.refused("01-soft is a symbolic link, but the result needs a folder")
        (self.target / "01-soft").unlink()
        for name in ("results.json", "report.html", "manifest.json"):
            (self.target / name).unlink()
            (self.target / name).symlink_to(self.project)
            self.refused("out")
            self.assertTrue((self.target / name).is_symlink())
            (self.target / name).unlink()
            shutil.rmtree(self.target)
            self.succeeds()
        self.assertEqual(os.listdir(elsewhere), [])
        self.nothing_beside("elsewhere")

    def test_a_manifest_cannot_name_files_outside(self):
        self.succeeds()
        victim = self.work / "victim"
        victim.write_text("text")
        digest = hashlib.sha256(b"text").hexdigest()
        for path in ("../victim", str(victim), "00-base/../../victim", "link/victim"):
            manifest = json.loads((self.target / "manifest.json").read_text())
            manifest["files"] = [{"path": path, "size": 4, "sha256": digest}] + [
                f for f in manifest["files"] if "victim" not in f["path"]
            ]
            (self.target / "manifest.json").write_text(json.dumps(manifest))
            if not (self.target / "link").exists():
                (self.target / "link").symlink_to(self.work)
            self.run_trivet()
            self.assertEqual(victim.read_text(), "text")

    def test_files_that_are_not_manifests(self):
        for text in (
            "",
            "{",
            "[]",
            '{"format": "other"}',
            '{"format": "trivet-manifest", "files": 3}',
            '{"format": "trivet-manifest", "files": [{"path": 3}]}',
            '{"format": "trivet-manifest", "files": [{"path": "a", "size": -1, "sha256": "x"}]}',
            "\0" * 100,
        ):
            self.target.mkdir(exist_ok=True)
            (self.target / "manifest.json").write_text(text)
            self.refused("exists and is not an earlier result")
            self.assertEqual((self.target / "manifest.json").read_text(), text)

    def test_other_things_in_the_place(self):
        self.target.write_text("a file")
        self.refused("out is a file, not a folder")
        self.target.unlink()
        os.mkfifo(self.target)
        self.refused("neither a file nor a folder")
        self.target.unlink()
        self.refused("choose another folder", target=self.work / ("n" * 300))
        self.refused("choose another folder", target=self.work / ("n" * 300) / "out")
        self.refused("choose another folder", target="/")
        self.assertEqual(os.listdir(self.work), [])

    def test_the_current_folder_and_one_that_is_gone(self):
        self.refused("is the current folder", target=".", cwd=self.work)
        gone = self.work / "gone"
        gone.mkdir()
        done = subprocess.run(
            ["sh", "-c", f'cd "{gone}" && rmdir "{gone}" && exec "{os.path.abspath(TRIVET)}" run "{self.project}"'],
            capture_output=True,
            text=True,
            timeout=HANGS_AFTER,
        )
        self.assertEqual(done.returncode, 1)
        self.assertIn("current folder", done.stderr)
        self.assertNotIn("filesystem", done.stderr)


class AtOnce(InFolder):
    def test_eight_runs_into_one_folder_all_succeed(self):
        fewer = self.without_case("stiff")
        for begin in ("none", "earlier result"):
            with self.subTest(begin=begin):
                runs = [
                    subprocess.Popen(
                        [TRIVET, "run", str(fewer if i % 2 else self.project), "-o", str(self.target)],
                        stdout=subprocess.DEVNULL,
                        stderr=subprocess.PIPE,
                        text=True,
                    )
                    for i in range(8)
                ]
                results = [(run.communicate(timeout=HANGS_AFTER)[1], run.returncode) for run in runs]
                self.assertEqual(results, [("", 0)] * 8)
                self.assertTrue(is_whole(self.target))
                self.nothing_beside()
                (self.target / "note.txt").write_text("mine")
        self.assertEqual((self.target / "note.txt").read_text(), "mine")

    def test_the_name_always_contains_a_whole_result(self):
        self.succeeds()
        (self.target / "note.txt").write_text("mine")
        runs = [
            subprocess.Popen(
                [TRIVET, "run", str(self.project), "-o", str(self.target)],
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
            )
            for _ in range(4)
        ]
        looks = 0
        while any(run.poll() is None for run in runs):
            folder = os.open(self.target, os.O_RDONLY | os.O_DIRECTORY)  # fails if the name is missing for a moment
            if os.path.samestat(os.fstat(folder), os.stat(self.target)):
                self.assertEqual((self.target / "note.txt").read_text(), "mine")
            os.close(folder)
            looks += 1
        self.assertGreater(looks, 0)
        self.assertTrue(is_whole(self.target))


class AfterAKill(InFolder):
    def stopped_in_the_making(self):
        """Kills a run while its working folder exists."""
        run = subprocess.Popen(
            [TRIVET, "run", str(self.slow()), "-o", str(self.target)],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        while not any(name.startswith(".trivet-") for name in os.listdir(self.work)):
            self.assertIsNone(run.poll())
            time.sleep(0.001)
        run.send_signal(signal.SIGKILL)
        run.wait(timeout=HANGS_AFTER)

    def slow(self):
        text = ONE_MASS.replace("response = {at = [1, 2, 3]}", "response = {}") + CASES
        for i in range(12):
            text += f"[cases.c{i}]\nelements.spring.scale = {i + 3}\n"
        path = self.folder / "slow.toml"
        path.write_text(text)
        return path

    def test_the_next_run_cleans_up_and_publishes_nothing_of_it(self):
        self.stopped_in_the_making()
        left = [name for name in os.listdir(self.work) if name != "out"]
        self.assertEqual(len(left), 1)
        self.assertRegex(left[0], "^\\.trivet-[a-z2-7]{20}$")
        self.succeeds()
        self.assertEqual(sorted(os.listdir(self.target)), OURS)
        self.nothing_beside()

    def test_folders_with_similar_names_are_kept(self):
        lookalike = self.work / ".trivet-aaaaaaaaaaaaaaaaaaaa"
        lookalike.mkdir()
        (lookalike / "note.txt").write_text("mine")
        linked = self.work / ".trivet-bbbbbbbbbbbbbbbbbbbb"
        linked.symlink_to(self.folder)
        self.succeeds()
        self.assertEqual((lookalike / "note.txt").read_text(), "mine")
        self.assertTrue(linked.is_symlink())
        self.assertTrue(self.project.exists())


if __name__ == "__main__":
    unittest.main()
