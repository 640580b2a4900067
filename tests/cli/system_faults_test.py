# SPDX-License-Identifier: BSD-3-Clause
"""Faults of the system: no place for temporary files, invalid cache entries, a broken gmsh, pipes as files. Each ends
with one clear message (or none), with 1 or 2 (or 0), and leaves no files behind."""
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import tempfile
import time
import unittest
import uuid

from trivet_test import HANGS_AFTER

TRIVET = os.path.abspath(os.environ["TRIVET"])
SOURCE = pathlib.Path(os.environ["TRIVET_SOURCE"]).resolve()
STEP = SOURCE / "examples/step_mount"
LIBRARY_WORDS = ("filesystem error", "basic_", "json.exception", "max_size", "std::", "what()", "vector", "terminate")

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
[excitations.shaker]
type = "harmonic"
on = "mass"
at = [0, 0, 0]
force = [0, 0, 18]
[analyses]
modes = {}
response = {at = ["1 rad/s", "2 rad/s", "3 rad/s"]}
"""
DISC = """[elements.pad]
type = "solid_mount"
on = "mass"
at = [0.1, 0, 0]
axis = "z"
shape = "disc"
diameter = "60 mm"
thickness = "30 mm"
material = {hardness = 45}
"""


def marked_processes(mark):
    """Command lines of the processes that have inherited our mark."""
    found = []
    for entry in pathlib.Path("/proc").iterdir():
        try:
            if entry.name.isdigit() and mark.encode() in (entry / "environ").read_bytes():
                found.append((entry / "cmdline").read_bytes())
        except OSError:
            pass
    return found


class Faults(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder, True)
        self.temporary, self.cache, self.work = (self.folder / name for name in ("temporary", "cache", "work"))
        for folder in (self.temporary, self.cache, self.work):
            folder.mkdir()
        self.mark = str(uuid.uuid4())
        self.environment = dict(
            os.environ, TMPDIR=str(self.temporary), TRIVET_CACHE=str(self.cache), TRIVET_TEST=self.mark
        )
        self.project = self.file(ONE_MASS)
        for name in ("pump.toml", "hour_glass.step"):
            shutil.copy(STEP / name, self.folder)

    def file(self, text, name="one.toml"):
        path = self.folder / name
        path.write_text(text)
        return path

    def run_trivet(self, *arguments, environment=None, **options):
        done = subprocess.run(
            [TRIVET, *map(str, arguments)],
            capture_output=True,
            timeout=HANGS_AFTER,
            env=dict(self.environment, **(environment or {})),
            **options,
        )
        done.stdout, done.stderr = (text.decode(errors="replace") for text in (done.stdout, done.stderr))
        for word in LIBRARY_WORDS:
            self.assertNotIn(word, done.stdout + done.stderr)
        self.assertIn(done.returncode, (0, 1, 2))
        return done

    def fails(self, words, *arguments, codes=(1, 2), lines=1, **options):
        done = self.run_trivet(*arguments, **options)
        self.assertIn(done.returncode, codes, done.stderr)
        self.assertIn(words, done.stderr)
        messages = re.sub(r"(?m)^ *\d* \|.*\n?", "", done.stderr).splitlines()  # without the marked lines of the file
        self.assertLessEqual(len(messages), lines, done.stderr)
        return done

    def nothing_left(self):
        self.assertEqual(os.listdir(self.temporary), [])
        deadline = time.monotonic() + 20
        while marked_processes(self.mark) and time.monotonic() < deadline:
            time.sleep(0.01)
        self.assertEqual(marked_processes(self.mark), [])


class TemporaryFiles(Faults):
    def test_no_place_for_them(self):
        file = self.file("")
        for place, words in (
            (self.folder / "missing", "No such file or directory"),
            (file, "Not a directory"),
            ("/proc", "set TMPDIR"),
            (self.folder / ("n" * 300), "File name too long"),
        ):
            with self.subTest(place=place):
                done = self.fails(
                    "set TMPDIR to a folder with write permission",
                    "element",
                    self.folder / "pump.toml",
                    "left mount",
                    environment={"TMPDIR": str(place)},
                )
                self.assertIn(words, done.stderr)
        self.fails(
            "set TMPDIR",
            "run",
            self.folder / "pump.toml",
            "-o",
            self.work / "out",
            environment={"TMPDIR": str(self.folder / "missing")},
        )
        self.assertEqual(os.listdir(self.work), [])

    def test_commands_that_need_none_succeed(self):
        self.assertEqual(
            self.run_trivet(
                "run", self.project, "-o", self.work / "out", environment={"TMPDIR": "/missing"}
            ).returncode,
            0,
        )

    def test_a_full_quota(self):
        limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))
        self.fails("File too large", "run", self.project, "-o", self.work / "out", preexec_fn=limit)
        self.assertEqual(os.listdir(self.work), [])
        self.fails("hour_glass.step", "element", self.folder / "pump.toml", "left mount", preexec_fn=limit, lines=3)
        self.nothing_left()


class Cache(Faults):
    def entry_made(self):
        project = self.file(ONE_MASS.replace("[excitations", DISC + "[excitations"), "pad.toml")
        self.first = self.run_trivet("modes", project)
        self.assertEqual(self.first.returncode, 0, self.first.stderr)
        [entry] = os.listdir(self.cache)
        self.assertEqual((self.cache / entry).stat().st_nlink, 1)
        return project, self.cache / entry

    def test_odd_things_in_the_place_of_an_entry(self):
        project, entry = self.entry_made()
        content = entry.read_bytes()
        secret = self.file("secret", "secret")
        copy = self.folder / "copy"
        copy.write_bytes(content)

        def damaged():
            entry.write_bytes(content[:-8] + b"\0" * 8)

        makers = {
            "folder": entry.mkdir,
            "pipe": lambda: os.mkfifo(entry),
            "link": lambda: entry.symlink_to(secret),
            "link to an entry": lambda: entry.symlink_to(copy),
            "link to nothing": lambda: entry.symlink_to(self.folder / "nothing"),
            "damaged": damaged,
            "empty": lambda: entry.write_bytes(b""),
            "huge": lambda: (entry.touch(), os.truncate(entry, 1 << 40)),
        }
        for name, make in makers.items():
            with self.subTest(name=name):
                entry.unlink()
                make()
                done = self.run_trivet("modes", project)
                self.assertEqual((done.returncode, done.stdout, done.stderr), (0, self.first.stdout, ""))
                self.assertEqual(os.listdir(self.cache), [entry.name])
                if entry.is_dir() and not entry.is_symlink():
                    entry.rmdir()
                    entry.write_bytes(content)
                self.assertEqual((entry.is_symlink(), entry.read_bytes()), (False, content))
        self.assertEqual((secret.read_text(), copy.read_bytes()), ("secret", content))
        self.assertFalse((self.folder / "nothing").exists())

    def test_no_folder_for_it(self):
        project, entry = self.entry_made()
        for place in (self.file("", "file"), "/proc/cache", self.folder / ("n" * 300), "/dev/null"):
            with self.subTest(place=place):
                done = self.run_trivet("modes", project, environment={"TRIVET_CACHE": str(place)})
                self.assertEqual((done.returncode, done.stdout, done.stderr), (0, self.first.stdout, ""))

    def test_leftovers_of_a_killed_run_are_removed(self):
        project, entry = self.entry_made()
        left = self.cache / ".trivet-aaaaaaaaaaaaaaaaaaaa"
        left.mkdir()
        (left / "unfinished").write_text("half")
        (left / ".owned-by-trivet").write_text("")
        self.run_trivet("modes", project)
        self.assertEqual(os.listdir(self.cache), [entry.name])


class Gmsh(Faults):
    """Other programs under the name of gmsh."""

    def fake(self, script, mode=0o755):
        programs = self.folder / "programs"
        programs.mkdir(exist_ok=True)
        (programs / "gmsh").write_text(script)
        (programs / "gmsh").chmod(mode)
        return {"PATH": f"{programs}:{os.environ['PATH']}", "TRIVET_GMSH_SECONDS": "60"}

    def rejected(self, words, script, environment=None, **options):
        for command in (
            ("element", self.folder / "pump.toml", "left mount"),
            ("run", self.folder / "pump.toml", "-o", self.work / "out"),
        ):
            with self.subTest(command=command[0]):
                self.fails(
                    words, *command, environment=dict(self.fake(script), **(environment or {})), lines=6, **options
                )
                self.nothing_left()
                self.assertEqual((os.listdir(self.work), os.listdir(self.cache)), ([], []))

    def test_failure_is_reported(self):
        self.rejected("gmsh failed (exit code 3): no licence", "#!/bin/sh\necho no licence\nexit 3\n")
        self.rejected("gmsh failed (signal 11)", "#!/bin/sh\nkill -SEGV $$\n")
        self.rejected("gmsh cannot be started: Exec format error", "nonsense\n")
        self.rejected("gmsh cannot be started: No such file or directory", "#!/no/such/program\n")

    def test_failure_is_reported_although_our_parent_ignores_the_end_of_children(self):
        self.rejected(
            "gmsh failed (exit code 3)",
            "#!/bin/sh\nexit 3\n",
            preexec_fn=lambda: signal.signal(signal.SIGCHLD, signal.SIG_IGN),
        )

    def test_no_output_or_nonsense_is_rejected(self):
        self.rejected("hour_glass.step", "#!/bin/sh\nexit 0\n")
        for odd in ("mkfifo faces.txt", "mkdir faces.msh", "ln -s /dev/zero faces.msh"):
            self.rejected("which is not a file", f"#!/bin/sh\n{odd}\n")
        for name in ("faces.txt", "faces.msh"):
            self.rejected("", f"#!/bin/sh\nhead -c 100000 /dev/urandom > {name}\n")
        self.rejected(
            "",
            "#!/bin/sh\nprintf '1e18 nan -1\\n999999999999999999 1 2 3' > faces.txt\nprintf '$MeshFormat\\n2.2 0 8\\n$Nodes\\n99999999999\\n' > faces.msh\n",
        )
        self.rejected(
            "",
            "#!/bin/sh\nprintf '1\\n1\\n1\\n1\\n1 1 0 0 0\\n' > faces.txt\nprintf '$MeshFormat\\n2.2 0 8\\n$EndMeshFormat\\n$Nodes\\n9\\n' > faces.msh\n",
        )

    def test_a_hanging_one_is_stopped(self):
        self.rejected(
            "gmsh had not finished after 0.5 s and was stopped",
            "#!/bin/sh\nsleep 1000\n",
            environment={"TRIVET_GMSH_SECONDS": "0.5"},
        )
        self.rejected(
            "gmsh had not finished",
            "#!/bin/sh\ntrap '' TERM INT HUP\nsleep 1000 & sleep 1000\n",
            environment={"TRIVET_GMSH_SECONDS": "0.5"},
        )

    def test_endless_output_is_stopped(self):
        self.rejected("ended after 100 MB of messages", "#!/bin/sh\nexec yes\n")

    def test_its_time_must_be_a_time(self):
        for wrong in ("0", "-1", "nan", "inf", "1e9", "soon", "1 s"):
            self.rejected(
                f'TRIVET_GMSH_SECONDS = "{wrong}"', "#!/bin/sh\nexit 0\n", environment={"TRIVET_GMSH_SECONDS": wrong}
            )

    def test_its_children_end_with_it(self):
        self.rejected("hour_glass.step", "#!/bin/sh\nsleep 1000 &\nexit 0\n")


class Files(Faults):
    def test_pipes_and_devices_do_not_block(self):
        pipe = self.folder / "pipe"
        os.mkfifo(pipe)
        for name in (pipe, "/dev/zero"):
            self.fails("this is a pipe or a device", "check", name)
        history = '[excitations.ramp]\ntype = "time"\non = "mass"\nat = [0, 0, 0]\nfile = "pipe"\nforce = {z = "f"}\n'
        table = '[elements.t]\ntype = "table"\non = "mass"\nat = [0, 0, 0.1]\naxis = "z"\nfile = "pipe"\n'
        matrix = (
            '[elements.m]\ntype = "imported"\non = "mass"\nat = [0, 0, 0.1]\nfile = "pipe"\nformat = "matrix_market"\n'
        )
        catalogue = ONE_MASS.replace("trivet = 1", 'trivet = 1\ncatalogues = ["pipe"]')
        for text in (ONE_MASS + history, ONE_MASS + table, ONE_MASS + matrix, catalogue):
            self.fails("pipe", "check", self.file(text, "piped.toml"), lines=10)

    def test_long_names(self):
        self.fails("File name too long", "check", self.folder / ("n" * 300))
        self.fails("too long", "check", "/".join(["n" * 200] * 30))
        name, other = "ä" * 50, "b" * 100
        cases = f'[cases."{name}"]\nelements.spring.scale = 2\n[cases."{other}"]\nelements.spring.scale = 3\n'
        long_body = ONE_MASS.replace("bodies.mass", f'bodies."{name}"').replace('on = "mass"', f'on = "{name}"')
        done = self.run_trivet("run", self.file(long_body + cases, "long.toml"), "-o", self.work / "out")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual([len(case.name.encode()) for case in sorted((self.work / "out").glob("0*"))], [7, 103, 103])
        self.fails(
            "at most 100 bytes", "check", self.file(long_body.replace(name, name + "ä"), "longer.toml"), lines=10
        )
        self.fails(
            "File name too long",
            "map",
            SOURCE / "examples/paper/map.toml",
            "--points",
            "3",
            "--picture",
            self.work / ("n" * 300 + ".svg"),
        )

    def test_names_that_are_not_utf_8(self):
        raw = os.fsencode(self.folder) + b"/\xff\xfe\x80.toml"
        shutil.copy(os.fsencode(self.project), raw)
        target = os.fsencode(self.work) + b"/out\xff"
        done = subprocess.run(
            [TRIVET, b"run", raw, b"-o", target], capture_output=True, env=self.environment, timeout=HANGS_AFTER
        )
        self.assertEqual((done.returncode, done.stderr), (0, b""))
        self.assertIn(b"results.json", os.listdir(target))
        for arguments in (
            (b"check", raw, b"--json"),
            (b"modes", raw, b"--json"),
            (b"check", b"/missing\xff", b"--json"),
            (b"modes", raw, b"--case", b"\xff"),
            (b"modes", raw, b"--set", b"\xff=1", b"--json"),
            (b"element", raw, b"\xff"),
            (b"check", raw + b"x"),
        ):
            with self.subTest(arguments=arguments):
                self.run_trivet(*(os.fsdecode(argument) for argument in arguments))

    def test_the_current_folder_is_gone(self):
        gone = self.folder / "gone"
        gone.mkdir()
        for arguments, codes in (
            (f'check "{self.project}"', (0,)),
            ("check one.toml", (2,)),
            (f'element "{self.folder}/pump.toml" "left mount"', (0, 1, 2)),
            (f'map "{SOURCE}/examples/paper/map.toml" --points 3 --picture map.svg', (2,)),
        ):
            with self.subTest(arguments=arguments):
                done = subprocess.run(
                    ["sh", "-c", f'mkdir -p "{gone}" && cd "{gone}" && rmdir "{gone}" && exec "{TRIVET}" {arguments}'],
                    capture_output=True,
                    text=True,
                    env=self.environment,
                    timeout=HANGS_AFTER,
                )
                self.assertIn(done.returncode, codes, done.stderr)
                for word in LIBRARY_WORDS:
                    self.assertNotIn(word, done.stderr)
        self.nothing_left()

    def test_a_picture_is_not_drawn_through_a_link(self):
        victim = self.folder / "victim.svg"
        victim.write_text("<svg/>")
        link = self.work / "map.svg"
        for target in (victim, self.folder / "nothing.svg"):
            link.symlink_to(target)
            self.fails(
                "this is a symbolic link",
                "map",
                SOURCE / "examples/paper/map.toml",
                "--points",
                "3",
                "--picture",
                link,
                codes=(2,),
            )
            self.assertTrue(link.is_symlink())
            link.unlink()
        self.assertEqual(victim.read_text(), "<svg/>")


if __name__ == "__main__":
    unittest.main()
