# SPDX-License-Identifier: BSD-3-Clause
"""Signals at random moments of `run`, `map` and a solid mount leave no incomplete file, no process and no folder; the
next run removes the remains of SIGKILL. `python3 interrupts_test.py 200` sends 200 signals; the moments follow from a
fixed seed and the duration of an undisturbed run."""
import hashlib
import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import uuid

from trivet_test import HANGS_AFTER

TRIVET = os.path.abspath(os.environ["TRIVET"])
SOURCE = pathlib.Path(os.environ["TRIVET_SOURCE"]).resolve()
SIGNALS_IN_TESTS = 21
SEED = 20260501
SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGKILL, signal.SIGKILL)
CASES = "".join(f"[cases.c{i}]\nelements.suspension.scale = {i + 2}\n" for i in range(6))


class Place:
    """Folders of one command (work, temporary files, cache) and a mark that its processes inherit."""

    def __init__(self, name, arguments, files):
        self.name, self.arguments = name, arguments
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.mark = str(uuid.uuid4())
        for part in ("work", "temporary", "cache"):
            (self.folder / part).mkdir()
        for source in files:
            shutil.copy(source, self.folder)
        self.environment = dict(
            os.environ,
            TMPDIR=str(self.folder / "temporary"),
            TRIVET_CACHE=str(self.folder / "cache"),
            TRIVET_TEST=self.mark,
        )

    def start(self):
        return subprocess.Popen(
            [TRIVET, *self.arguments],
            cwd=self.folder,
            env=self.environment,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
        )

    def empty_cache(self):
        for entry in (self.folder / "cache").iterdir():
            assert not entry.is_dir(), entry
            entry.unlink()

    def processes(self):
        found = []
        for entry in pathlib.Path("/proc").iterdir():
            try:
                if entry.name.isdigit() and self.mark.encode() in (entry / "environ").read_bytes():
                    found.append((entry / "cmdline").read_bytes())
            except OSError:
                pass
        return found

    def wait_for_processes(self):
        """Waits until the kernel has ended the processes that a killed process has started."""
        deadline = time.monotonic() + 30
        while self.processes() and time.monotonic() < deadline:
            time.sleep(0.005)
        return self.processes()

    def complaints(self, after_a_kill):
        """Faults of the folders and processes; a killed run may leave folders named `.trivet-…`."""
        found = [f"process left: {line}" for line in self.wait_for_processes()]
        for part in ("work", "temporary", "cache"):
            for entry in (self.folder / part).iterdir():
                if entry.name.startswith(".trivet-"):
                    found += [] if after_a_kill else [f"left in {part}: {entry.name}"]
                elif part == "temporary":
                    found.append(f"left in {part}: {entry.name}")
                elif part == "cache":
                    content = entry.read_bytes()
                    if hashlib.sha256(content[64:]).hexdigest() != content[:64].decode():
                        found.append(f"half cache entry {entry.name}")
                elif entry.name == "map.svg":
                    text = entry.read_text()
                    if not (text.startswith("<") and text.rstrip().endswith("</svg>")):
                        found.append("half picture")
                elif entry.name == "out":
                    found += self.complaints_about_result(entry)
                elif entry.name != "note.txt":
                    found.append(f"left in {part}: {entry.name}")
        return found

    def complaints_about_result(self, folder):
        listed = {entry["path"]: entry for entry in json.loads((folder / "manifest.json").read_text())["files"]}
        there = {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}
        found = [
            f"missing or half: {path}"
            for path, entry in listed.items()
            if hashlib.sha256(there.get(path, b"")).hexdigest() != entry["sha256"]
        ]
        found += [
            f"not ours: {path}" for path in there if path not in listed and path not in ("manifest.json", "note.txt")
        ]
        if there.get("note.txt") != b"mine":
            found.append("the note is gone")
        return found


def places():
    paper = SOURCE / "examples/paper"
    run = Place("run", ["run", "many.toml", "-o", "work/out"], [])
    (run.folder / "many.toml").write_text((paper / "corrected.toml").read_text() + CASES)
    drawn = Place("map", ["map", "map.toml", "--points", "60", "--picture", "work/map.svg"], [paper / "map.toml"])
    mount = Place("solid mount", ["run", "pump.toml", "-o", "work/out"], [])
    step = SOURCE / "examples/step_mount"
    shutil.copy(step / "hour_glass.step", mount.folder)
    (mount.folder / "pump.toml").write_text((step / "pump.toml").read_text().replace('"6 mm"', '"12 mm"'))
    return [run, drawn, mount]


def campaign(count, show=lambda line: None):
    """Sends the signals. @returns complaints, number of runs hit by each signal"""
    chance = random.Random(SEED)
    complaints, hit, times = [], {}, {}
    all_places = places()
    try:
        for place in all_places:
            begun = time.monotonic()
            process = place.start()
            _, errors = process.communicate(timeout=HANGS_AFTER)
            assert process.returncode == 0, errors
            times[place.name] = time.monotonic() - begun
            if (place.folder / "work/out").exists():
                (place.folder / "work/out/note.txt").write_text("mine")
        for i in range(count):
            place = all_places[i % len(all_places)]
            number = SIGNALS[chance.randrange(len(SIGNALS))]
            place.empty_cache()
            process = place.start()
            time.sleep(chance.random() * times[place.name])
            process.send_signal(number)
            _, errors = process.communicate(timeout=HANGS_AFTER)
            killed = number == signal.SIGKILL
            expected = (-9, 0) if killed else (128 + number, 0)
            found = [] if process.returncode in expected else [f"exit code {process.returncode}: {errors}"]
            if not killed and process.returncode and "interrupted" not in errors:
                # A signal before the first line of main ends the program by default: no files exist yet.
                found.append(f"no word: {errors!r}")
            if process.returncode == -number and not killed:
                found = []
            found += place.complaints(killed)
            if killed:
                process = place.start()
                _, errors = process.communicate(timeout=HANGS_AFTER)
                found += [f"the next run: {process.returncode} {errors}"] if process.returncode else []
                found += [f"after the next run: {line}" for line in place.complaints(False)]
            key = (place.name, signal.Signals(number).name, "hit" if process.returncode != 0 or killed else "too late")
            hit[key] = hit.get(key, 0) + 1
            complaints += [f"{i} {place.name} {signal.Signals(number).name}: {line}" for line in found]
            show(f"{i + 1}/{count} {key}: {found or 'clean'}")
        return complaints, hit
    finally:
        for place in all_places:
            shutil.rmtree(place.folder, True)


def wait_until(happened, seconds=60):
    end = time.monotonic() + seconds
    while not happened():
        assert time.monotonic() < end, f"it did not happen within {seconds} s"
        time.sleep(0.005)


class Interrupts(unittest.TestCase):
    def test_signals_leave_nothing_behind(self):
        complaints, hit = campaign(SIGNALS_IN_TESTS)
        self.assertEqual(complaints, [])
        self.assertGreater(sum(count for (_, _, when), count in hit.items() if when == "hit"), SIGNALS_IN_TESTS // 2)

    def test_an_ignored_hangup_stays_ignored(self):
        place = places()[0]
        self.addCleanup(shutil.rmtree, place.folder, True)
        process = subprocess.Popen(
            ["sh", "-c", f'trap "" HUP; exec "{TRIVET}" run many.toml -o work/out'],
            cwd=place.folder,
            env=place.environment,
            stdout=subprocess.DEVNULL,
        )
        wait_until(lambda: list((place.folder / "work").iterdir()))
        process.send_signal(signal.SIGHUP)
        self.assertEqual(process.wait(timeout=HANGS_AFTER), 0)

    def test_a_program_of_another_name_ends_with_us(self):
        """gmsh is a script that starts other processes and ignores signals."""
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGKILL):
            with self.subTest(signal=number):
                place = places()[2]
                self.addCleanup(shutil.rmtree, place.folder, True)
                programs = place.folder / "programs"
                programs.mkdir()
                (programs / "gmsh").write_text(
                    f"#!/bin/sh\ntrap '' INT TERM HUP\nsleep 1000 &\ntouch '{place.folder}/begun'\nsleep 1000\n"
                )
                (programs / "gmsh").chmod(0o755)
                place.environment["PATH"] = f"{programs}:{os.environ['PATH']}"
                process = place.start()
                wait_until(lambda: (place.folder / "begun").exists() or process.poll() is not None)
                self.assertIsNone(process.poll())
                process.send_signal(number)
                process.communicate(timeout=HANGS_AFTER)
                self.assertEqual(process.returncode, -9 if number == signal.SIGKILL else 128 + number)
                self.assertEqual(place.complaints(number == signal.SIGKILL), [])


if __name__ == "__main__":
    if len(sys.argv) == 2 and sys.argv[1].isdigit():
        wrong, counts = campaign(int(sys.argv[1]), lambda line: print(line, flush=True))
        for key in sorted(counts):
            print(*key, counts[key])
        print("complaints:", len(wrong), *wrong, sep="\n")
        sys.exit(1 if wrong else 0)
    unittest.main()
