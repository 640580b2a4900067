# SPDX-License-Identifier: BSD-3-Clause
"""Thousands of wrong, odd and random projects: the program ends in time with 0, 1 or 2, gives a clear message if the
code is not 0, prints no nan and no messages of a library, and leaves no files behind.

    TRIVET=… TRIVET_SOURCE=… python3 tests/campaign/campaign.py [--each 2000] [--machines 100]
                                                                [--only "KIND" NUMBER] [--keep FOLDER]

The same numbers give the same projects on every machine. `--only` repeats one of them; `--keep` stores failed projects
in that folder."""
import argparse
import collections
import concurrent.futures
import os
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import machines  # noqa: E402
import mutations  # noqa: E402
import verdict  # noqa: E402

TRIVET = os.environ["TRIVET"]
SOURCE = pathlib.Path(os.environ["TRIVET_SOURCE"])
EXAMPLES = sorted((SOURCE / "examples").glob("*/*.toml"))
SLOWER = int(os.environ.get("TRIVET_SLOWER", "1"))  # with sanitizers
SECONDS = {"check": 60, "run": 120, "peaks": 120, "export": 120}  # each takes less than a tenth on an idle machine
RUN_EVERY = 10
FORMATS = (
    "matlab",
    "universal",
    "universal_binary",
    "nastran",
    "numpy",
    "hdf5",
    "excel",
    "fmu",
    "fmu3",
    "matrix_market",
    "csv",
)
ODD_FILES, MACHINES = "odd file", "machine"
MESHED = {"step_mount", "rubber_mounts"}  # a changed number costs seconds of finite elements: only every eighth time


def seeded(kind, number):
    return random.Random(f"trivet {kind} {number}")


def change_project(chance, kind, folder, project):
    text = mutations.without_comments(project.read_text())
    changed = mutations.KINDS[kind](chance, text)
    project.write_bytes(changed if isinstance(changed, bytes) else changed.encode("utf-8", "surrogatepass"))


def change_file(chance, folder, project):
    """Makes one of the project's data files odd, empty, missing, a folder or a pipe."""
    files = [p for p in sorted(folder.iterdir()) if p.suffix in (".csv", ".step")]
    one = chance.choice(files)
    kind = chance.randrange(8)
    data = one.read_bytes()
    if kind < 5:
        one.write_bytes(mutations.odd_table(chance, data))
        return
    one.unlink()
    if kind == 6:
        one.mkdir()
    elif kind == 7:
        os.mkfifo(one)


def scene(kind, number, folder):
    """Writes the project of this kind and number into the folder. @returns it and the commands to try"""
    chance = seeded(kind, number)
    if kind == MACHINES:
        project = folder / "machine.toml"
        project.write_text(machines.machine(chance))
        if number % 4 == 0:  # results without a load, and a model without inputs
            project.write_text(machines.without_excitations(project.read_text()))
        if number % 8 == 2:
            project.write_text(machines.within_tolerances(chance, project.read_text()))
        return project, ["peaks", "run", f"export --to {FORMATS[number % len(FORMATS)]}"]
    examples = [
        e for e in EXAMPLES if kind != ODD_FILES or any(p.suffix in (".csv", ".step") for p in e.parent.iterdir())
    ]
    turn, place = divmod(number, len(examples))
    example = examples[place]
    if example.parent.name in MESHED and turn % 8:
        example = examples[place // 2 - 1]
    for other in example.parent.iterdir():
        if other.is_dir():
            shutil.copytree(other, folder / other.name)
        elif other.suffix != ".toml":
            shutil.copy(other, folder / other.name)
    project = folder / "project.toml"
    shutil.copy(example, project)
    if kind == ODD_FILES:
        change_file(chance, folder, project)
    else:
        change_project(chance, kind, folder, project)
    return project, ["check"] + (["run"] if number % RUN_EVERY == RUN_EVERY - 1 else []) + (
        [f"export --to {FORMATS[number // RUN_EVERY % len(FORMATS)]}"] if number % RUN_EVERY == 0 else []
    )


def tried(kind, number, cache, keep, memory):
    """(kind, number, command, seconds, faults) of every command on one project."""
    results = []
    with tempfile.TemporaryDirectory(prefix="campaign-") as name:
        folder = pathlib.Path(name)
        project, commands = scene(kind, number, folder)
        for command in commands:
            begin = time.monotonic()
            name, *options = command.split()
            arguments = [name, str(project), *options]
            found = verdict.faults(
                TRIVET, arguments, folder, cache, SECONDS[name] * SLOWER, memory, plausible=kind == MACHINES
            )
            results.append((kind, number, command, time.monotonic() - begin, found))
        if keep and any(r[4] for r in results):
            target = pathlib.Path(keep) / f"{kind} {number}".replace(" ", "_")
            shutil.rmtree(target, ignore_errors=True)
            shutil.copytree(folder, target, ignore=lambda _, names: [n for n in names if (folder / n).is_fifo()])
    return results


def warm_cache(cache):
    """Computes the mounts of the examples once, so that later only changed ones need a solution."""
    for example in EXAMPLES:
        subprocess.run(
            [TRIVET, "check", str(example)],
            env={**os.environ, "TRIVET_CACHE": str(cache)},
            capture_output=True,
            check=True,
        )


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--each", type=int, default=110)
    options.add_argument("--machines", type=int, default=40)
    options.add_argument("--only", nargs=2)
    options.add_argument("--keep")
    options.add_argument("--memory", type=float, default=verdict.MOST_MEMORY, help="bytes that one run may take")
    options.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    chosen = options.parse_args()
    if chosen.keep:
        pathlib.Path(chosen.keep).mkdir(parents=True, exist_ok=True)
    cache = tempfile.mkdtemp(prefix="campaign-cache-")
    try:
        warm_cache(cache)
        jobs = [(kind, n) for n in range(chosen.each) for kind in [*mutations.KINDS, ODD_FILES]] + [
            (MACHINES, n) for n in range(chosen.machines)
        ]
        if chosen.only:
            jobs = [(chosen.only[0], int(chosen.only[1]))]
        count, failed, slowest = collections.Counter(), [], []
        with concurrent.futures.ThreadPoolExecutor(chosen.jobs) as pool:
            for done, results in enumerate(
                pool.map(lambda job: tried(*job, cache, chosen.keep, chosen.memory), jobs), 1
            ):
                if done % 1000 == 0:
                    print(f"{done} of {len(jobs)} projects, {len(failed)} failed", flush=True)
                for kind, number, command, seconds, found in results:
                    count[command.split()[0]] += 1
                    slowest = sorted([*slowest, (seconds, kind, number, command)])[-8:]
                    if found:
                        failed.append((kind, number, command))
                        print(f'FAILED: {command} --only "{kind}" {number}: ' + "; ".join(found), flush=True)
    finally:
        shutil.rmtree(cache, ignore_errors=True)
    print(
        f"{len(jobs)} projects; "
        + ", ".join(f"{n} × {command}" for command, n in count.items())
        + f"; {len(failed)} failed"
    )
    print(
        "slowest: "
        + ", ".join(
            f"{seconds:.1f} s {command} {kind} {number}" for seconds, kind, number, command in reversed(slowest)
        )
    )
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
