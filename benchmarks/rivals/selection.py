# SPDX-License-Identifier: BSD-3-Clause
"""Which mounts, by NumPy and SciPy: selection.py FOLDER reads genset.toml and maker.toml there, judges every combination
of mounts at three pairs of feet, and prints the best one, its margin, and the CPU time as JSON. Static loads and natural
frequencies by scipy.linalg, one combination after the other; amplitudes of those that these leave by NumPy's batched
solution on a grid of the band, which holds no resonance."""
import itertools
import json
import math
import sys
import time
import tomllib
from pathlib import Path

import numpy as np
import scipy.linalg

FREQUENCIES = 64


def rigid(point):
    """Displacement at a point from that of the pole."""
    x, y, z = point
    motion = np.eye(6)
    motion[:3, 3:] = [[0, z, -y], [-z, 0, x], [y, -x, 0]]
    return motion


def in_radians(band):
    """A band of texts "45 Hz"."""
    return [2 * math.pi * float(end.split()[0]) for end in band]


def inertia(body):
    mass, centre, about = body["mass"], np.array(body["center_of_mass"]), body["inertia"]
    central = np.diag([about["xx"], about["yy"], about["zz"]]).astype(float)
    central[0, 2] = central[2, 0] = -about["xz"]
    motion = rigid(centre)
    own = np.zeros((6, 6))
    own[:3, :3], own[3:, 3:] = mass * np.eye(3), central
    return motion.T @ own @ motion


def main(folder):
    project = tomllib.loads((folder / "genset.toml").read_text())
    catalogue = tomllib.loads((folder / "maker.toml").read_text())["mounts"]
    names = list(catalogue)
    begin = time.process_time()
    body, required = project["bodies"]["genset"], project["requirements"]
    mass = inertia(body)
    weight = rigid(body["center_of_mass"]).T @ np.array([0, 0, body["mass"] * project["gravity"][2], 0, 0, 0])
    force = project["excitations"]["firing"]
    load = rigid(force["at"]).T @ np.array([0, 0, 0, *force["moment"]])
    feet = {}
    for foot in project["tables"]["elements"]["rows"]:
        feet.setdefault(foot["type"], []).append(foot["at"])
    ends = in_radians(required["band"])
    omega = np.linspace(*ends, FREQUENCIES)
    (point, allowed), (_, on_ground) = required["limits"].items()
    row = rigid(body["points"][point.split(".")[1]])["xyz".index(point[-1])]
    windows = [in_radians(window) for window in required["natural_frequencies"]["avoid"]]

    def parts(group, mount):
        local = np.diag([*mount["translation"], *mount["rotation"]])
        return sum(rigid(at).T @ local @ rigid(at) for at in feet[group])

    stiffness = [[parts(group, catalogue[name]) for name in names] for group in feet]
    best, left = (0.0, None), 0
    for combination in itertools.product(range(len(names)), repeat=len(feet)):
        chosen = [catalogue[names[i]] for i in combination]
        pairs = [stiffness[c][i] for c, i in enumerate(combination)]
        margin = required["price"] / sum(2 * float(mount["price"].split()[0]) for mount in chosen)
        K = sum(pairs)
        rest = scipy.linalg.solve(K, weight, assume_a="pos")
        for group, mount in zip(feet, chosen):
            low, high = mount["static_load"]
            for at in feet[group]:
                sag = -(rigid(at) @ rest)[2]
                carried = sag * mount["translation"][2]
                margin = min(margin, high / carried, carried / low, mount["static_deflection_limit"] / sag)
        natural = np.sqrt(scipy.linalg.eigh(K, mass, eigvals_only=True))
        margin = min(margin, *(max(low / w, w / high) for low, high in windows for w in natural))
        if margin < 1:
            continue
        left += 1
        complex_stiffness = sum((1 + 1j * m["loss_factor"]) * k for m, k in zip(chosen, pairs))
        dynamic = complex_stiffness - omega[:, None, None] ** 2 * mass
        q = np.linalg.solve(dynamic, np.broadcast_to(load, (FREQUENCIES, 6))[..., None])[..., 0]
        margin = min(margin, allowed / np.abs(q @ row).max(), on_ground / np.abs(q @ complex_stiffness[1]).max())
        if margin > best[0]:
            best = (margin, [names[i] for i in combination])
    seconds = time.process_time() - begin
    print(json.dumps({"margin": best[0], "mounts": best[1], "left": left, "seconds": seconds}))


main(Path(sys.argv[1]))
