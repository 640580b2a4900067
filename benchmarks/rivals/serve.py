# SPDX-License-Identifier: BSD-3-Clause
"""Answers requests for ways (a dict of functions) line by line: their names, answers written to a file, CPU seconds of one call."""
import pathlib
import sys
import time

import numpy as np

folder = pathlib.Path(sys.argv[1])


def numbers(name, rows):
    """Raw doubles of a file of the problem, by columns."""
    return np.fromfile(folder / name).reshape((rows, -1), order="F")


def serve(ways):
    for request in sys.stdin:
        what, _, name = request.strip().partition(" ")
        if what == "names":
            print(" ".join(ways), flush=True)
        elif what == "answer":
            np.asarray(ways[name](), dtype=complex).ravel(order="F").tofile(folder / f"{name}.answer")
            print("done", flush=True)
        elif what == "time":
            calls, start = 0, time.process_time()
            while True:
                ways[name]()
                calls += 1
                spent = time.process_time() - start
                if spent >= 1e-3:
                    break
            print(f"{spent / calls:.12g}", flush=True)
