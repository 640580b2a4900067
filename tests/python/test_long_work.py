# SPDX-License-Identifier: BSD-3-Clause
"""Progress, Ctrl-C, other threads, and the number of threads."""

import _thread
import subprocess
import sys
import threading
import time

import numpy as np
import pytest
from conftest import MACHINE, ROOT, example

import trivet

SCALES = np.geomspace(0.2, 5, 700)


def long_sweep(project: trivet.Project, **keys):
    return project.sweep(
        {"elements.a.scale": SCALES, "elements.b.scale": SCALES, "elements.c.scale": [1, 2, 3]}, **keys
    )


def test_progress(machine):
    seen = []
    long_sweep(machine, progress=lambda done, total, task: seen.append((done, total, task)))
    assert seen
    assert all(total == 1 and task == "designs" for _, total, task in seen)
    assert [done for done, _, _ in seen] == sorted(done for done, _, _ in seen)
    assert seen[-1][0] == 1


def test_every_analysis_shows_that_it_ends(machine):
    seen = []
    machine.modes(progress=lambda *call: seen.append(call))
    assert seen == [(1, 1, "modes")]


def test_bar(machine, capsys):
    long_sweep(machine, progress=True)
    assert "designs: 100%" in capsys.readouterr().err
    with pytest.raises(trivet.InputError, match="progress"):
        machine.sweep({"elements.a.scale": [1.0]}, progress=3)
    with pytest.raises(trivet.InputError, match="threads"):
        machine.sweep({"elements.a.scale": [1.0]}, threads=-1)


def test_error_of_the_callback_stops_the_work(machine):
    def fail(done, total, task):
        raise LookupError(task)

    with pytest.raises(LookupError, match="designs"):
        long_sweep(machine, progress=fail)


def test_error_of_the_callback_after_the_end_of_the_work():
    """The work ends while the callback runs, and then the callback fails: nothing is left to wait for."""
    program = f"""
import numpy as np, sys, time, trivet
sys.path.insert(0, {str(ROOT / "tests" / "python")!r})
from conftest import MACHINE
def fail(done, total, task):
    time.sleep(4)
    raise LookupError(task)
scales = np.geomspace(0.2, 5, 700)
try:
    trivet.Project(**MACHINE).sweep({{"elements.a.scale": scales, "elements.b.scale": scales}}, progress=fail)
except LookupError:
    print("raised")
"""
    ended = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, cwd=ROOT, timeout=120)
    assert (ended.stdout.strip(), ended.returncode) == ("raised", 0), ended.stderr


def test_interrupt_stops_within_a_fifth_of_a_second(machine):
    at = []

    def interrupt() -> None:
        time.sleep(0.25)
        at.append(time.perf_counter())
        _thread.interrupt_main()

    thread = threading.Thread(target=interrupt)
    thread.start()
    with pytest.raises(KeyboardInterrupt):
        for _ in range(100):
            long_sweep(machine)
    stopped = time.perf_counter()
    thread.join()
    assert stopped - at[0] < 0.2


def test_interrupted_program_ends():
    """A program that is interrupted in a computation without progress ends, and not by a crash."""
    program = f"""
import _thread, threading, time, trivet
project = trivet.open({example("rubber_mounts/compressor.toml")!r})
threading.Timer(0.4, _thread.interrupt_main).start()
try:
    for _ in range(1000):
        project.explain()
except KeyboardInterrupt:
    print("interrupted")
"""
    ended = subprocess.run(
        [sys.executable, "-W", "ignore", "-c", program], capture_output=True, text=True, cwd=ROOT, timeout=120
    )
    assert ended.stdout.strip() == "interrupted", ended.stderr
    assert ended.returncode in (0, 130)


def test_other_threads_run_meanwhile(machine):
    ticks, stop = [], threading.Event()

    def count() -> None:
        while not stop.is_set():
            ticks.append(time.perf_counter())
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    start = time.perf_counter()
    long_sweep(machine)
    end = time.perf_counter()
    stop.set()
    thread.join()
    during = [tick for tick in ticks if start < tick < end]
    assert end - start > 0.1
    assert max(np.diff(during)) < 0.2


def test_threads_give_the_same_numbers(machine):
    values = {"elements.a.scale": SCALES[:50], "bodies.machine.mass": [100.0, 120.0]}
    one = machine.sweep(values, threads=1).amplitude
    np.testing.assert_array_equal(machine.sweep(values, threads=2).amplitude, one)
    with pytest.raises(trivet.InputError, match="threads"):
        machine.modes(threads=-1)


def test_several_machines_at_once():
    def ask(result: list) -> None:
        result.append(trivet.Project(**MACHINE).peaks().array("amplitude"))

    results: list = []
    threads = [threading.Thread(target=ask, args=(results,)) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for found in results:
        np.testing.assert_array_equal(found, results[0])
