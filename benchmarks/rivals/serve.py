# SPDX-License-Identifier: BSD-3-Clause
"""Answers requests line by line: names of the ways that `read` gives for the problem in the folder (a dict of functions), answers
written to a file, CPU seconds of one call."""
import pathlib
import sys
import time

import numpy as np

folder = pathlib.Path(sys.argv[1])


def numbers(name, rows):
    """Raw doubles of a file of the problem, by columns."""
    return np.fromfile(folder / name).reshape((rows, -1), order="F")


def serve(read):
    for request in sys.stdin:
        what, _, name = request.strip().partition(" ")
        if what == "names":
            ways = read()
            print(" ".join(ways), flush=True)
        elif what == "answer":
            np.asarray(ways[name](), dtype=complex).ravel(order="F").tofile(folder / f"{name}.answer")
            print("done", flush=True)
        elif what == "time":
            start = time.process_time()
            ways[name]()  # fills the caches that the others emptied
            spent, calls = time.process_time() - start, 1
            if spent < 20e-3:
                calls, start = 0, time.process_time()
                while calls == 0 or spent < 1e-3:
                    ways[name]()
                    calls += 1
                    spent = time.process_time() - start
            print(f"{spent / calls:.12g}", flush=True)
