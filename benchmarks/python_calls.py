# SPDX-License-Identifier: BSD-3-Clause
"""What does Python cost? Times of the package beside those of the same calls from C++, and of `import trivet`.

usage: python_calls.py PROGRAM PROJECT      PROGRAM: build/release/benchmarks/python_calls
"""

import json
import statistics
import subprocess
import sys
import time
import warnings

import numpy as np

import trivet

warnings.simplefilter("ignore")
program, path = sys.argv[1:]


def median(calls, call):
    times = []
    for _ in range(calls):
        start = time.perf_counter()
        call()
        times.append(time.perf_counter() - start)
    return statistics.median(times)


def sweep(project):
    element = project.elements[0]
    return project.sweep(
        {
            f"elements.{element}.scale": np.linspace(0.5, 2, 1000),
            f"elements.{element}.damping.proportional": np.linspace(0.02, 0.2, 1000),
        }
    )


IMPORT = "import numpy, time; t = time.perf_counter(); import trivet; print(time.perf_counter() - t)"

project = trivet.open(path)
rounds = []
for _ in range(5):
    core = json.loads(subprocess.run([program, path], capture_output=True, text=True, check=True).stdout)
    first = abs(project.response().curves[next(iter(project.response().curves))].values[0])
    largest = float(sweep(project).amplitude.max())
    assert np.allclose([first, largest], core["checks"], rtol=1e-12), "the answers differ"
    rounds.append((core, median(101, project.response), median(5, lambda: sweep(project))))
started = [
    float(subprocess.run([sys.executable, "-c", IMPORT], capture_output=True, text=True, check=True).stdout)
    for _ in range(11)
]
response = statistics.median(python / core["response"] for core, python, _ in rounds)
rate = statistics.median(core["sweep"] / python for core, _, python in rounds)
print(
    f"response of {len(project.matrices().coordinates)} coordinates: {1e3 * rounds[0][1]:.3f} ms, {response:.3f} × the C++ call (goal ≤ 1.2)"
)
print(f"sweep of 1e6 designs: {rounds[0][2]:.3f} s, {rate:.2f} of the rate of the core (goal ≥ 0.8)")
print(f"import trivet: {1e3 * statistics.median(started):.1f} ms beyond NumPy (goal ≤ 30)")
