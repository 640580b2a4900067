# SPDX-License-Identifier: BSD-3-Clause
"""Designs within tolerances by NumPy, and by OpenTURNS and SALib if they are there: sampled.py FOLDER DESIGNS reads machine.toml and
ours.json (the worst designs that `trivet sample` found) in the folder and prints as JSON
- worst: the margin of each requirement in its worst design, on a refined grid of frequencies,
- yields: the share of DESIGNS random designs that meet each requirement,
- seconds: CPU time of a design with natural frequencies (batched Cholesky and eigvalsh) and amplitudes (batched solve at 200
  frequencies of the band, and a parabola between them), by NumPy alone and behind a function of OpenTURNS with its Sobol numbers,
- shares: first and total shares of the variance of the first limit, by OpenTURNS (Jansen) and SALib."""
import json
import math
import sys
import time
import tomllib
from pathlib import Path

import numpy as np

FREQUENCIES, PIECE = 200, 500


def rigid(points):
    """Displacements at points from that of the pole, one 6 × 6 for each."""
    x, y, z = np.moveaxis(np.asarray(points, dtype=float), -1, 0)
    motion = np.zeros(x.shape + (6, 6))
    motion[..., range(6), range(6)] = 1
    motion[..., 0, 4], motion[..., 0, 5] = z, -y
    motion[..., 1, 3], motion[..., 1, 5] = -z, x
    motion[..., 2, 3], motion[..., 2, 4] = y, -x
    return motion


def between(amplitudes):
    """Largest over the frequencies (axis 1), by a parabola of 1/amplitude² through the largest one and its neighbours."""
    inverse = amplitudes**-2.0
    k = inverse.argmin(axis=1, keepdims=True)
    inner = np.clip(k, 1, inverse.shape[1] - 2)
    low, middle, high = (np.take_along_axis(inverse, inner + shift, axis=1)[:, 0] for shift in (-1, 0, 1))
    bend = low - 2 * middle + high
    inside = (k == inner)[:, 0] & (bend > 0)
    least = np.where(inside, middle - (high - low) ** 2 / (8 * np.where(inside, bend, 1)), inverse.min(axis=1))
    return least**-0.5


class Machine:
    def __init__(self, project):
        self.body = project["bodies"]["machine"]
        self.elements = project["elements"]
        self.type = project["element_types"]["mount"]
        force = project["excitations"]["force"]
        self.load = rigid(force["at"]).T @ np.array([*force["force"], 0, 0, 0], dtype=float)
        required = project["requirements"]
        self.band = [2 * math.pi * float(end.split()[0]) for end in required["band"]]
        self.omega = np.linspace(*self.band, FREQUENCIES)
        self.limits = [("xyz".index(name[-1]), float(text)) for name, text in required["limits"].items()]
        self.windows = [
            [2 * math.pi * float(end.split()[0]) for end in one] for one in required["natural_frequencies"]["avoid"]
        ]
        self.numbers = []  # path, given number, half width
        for one in project["tolerances"].values():
            for path in [one["path"]] if isinstance(one["path"], str) else one["path"]:
                given, width = self.given(path), one["half_width"]
                relative = width.endswith("%")
                width = float(width.split()[0])
                self.numbers.append((path, given, width / 100 * given if relative else width / 1000))

    def given(self, path):
        words = path.split(".")
        if words[0] == "elements":
            return 1.0 if words[2] == "scale" else self.elements[words[1]]["at"]["xyz".index(words[3])]
        if words[2] == "center_of_mass":
            return self.body["center_of_mass"]["xyz".index(words[3])]
        return self.body["inertia"][words[3]] if words[2] == "inertia" else self.body["mass"]

    def bounds(self):
        return [[given - width, given + width] for _, given, width in self.numbers]

    def matrices(self, designs):
        """A and K of designs, a row each."""
        of = {path: designs[:, i] for i, (path, _, _) in enumerate(self.numbers)}
        n = len(designs)
        K = np.zeros((n, 6, 6))
        local = np.diag([*self.type["translation"], 0, 0, 0]).astype(float)
        for name, element in self.elements.items():
            at = np.tile(np.array(element["at"], dtype=float), (n, 1))
            at[:, 0] = of.get(f"elements.{name}.at.x", at[:, 0])
            motion = rigid(at)
            K += of[f"elements.{name}.scale"][:, None, None] * (motion.transpose(0, 2, 1) @ local @ motion)
        centre = np.tile(np.array(self.body["center_of_mass"], dtype=float), (n, 1))
        centre[:, 2] = of["bodies.machine.center_of_mass.z"]
        own = np.zeros((n, 6, 6))
        own[:, range(3), range(3)] = of["bodies.machine.mass"][:, None]
        for k, axis in enumerate(("xx", "yy", "zz")):
            own[:, 3 + k, 3 + k] = of.get(f"bodies.machine.inertia.{axis}", self.body["inertia"][axis])
        motion = rigid(centre)
        return motion.transpose(0, 2, 1) @ own @ motion, K

    def amplitudes(self, A, K, omega):
        """Translations of the pole, designs × frequencies × 3; the damping is proportional to the stiffness."""
        factor = 1 + 1j * omega * self.type["damping"]["proportional"]
        Z = factor[:, None, None] * K[:, None] - (omega**2)[:, None, None] * A[:, None]
        return np.abs(np.linalg.solve(Z, np.broadcast_to(self.load[:, None], Z.shape[:-1] + (1,)))[..., :3, 0])

    def natural(self, A, K):
        lower = np.linalg.cholesky(A)
        half = np.linalg.solve(lower, K)
        return np.sqrt(np.linalg.eigvalsh(np.linalg.solve(lower, half.transpose(0, 2, 1))))

    def values(self, designs):
        """Natural frequencies and largest amplitudes in the band."""
        parts = []
        for first in range(0, len(designs), PIECE):
            A, K = self.matrices(np.asarray(designs[first : first + PIECE]))
            parts.append(np.hstack([self.natural(A, K), between(self.amplitudes(A, K, self.omega))]))
        return np.vstack(parts)

    def met(self, values):
        met = [values[:, 6 + axis] <= limit for axis, limit in self.limits]
        inside = [(values[:, :6] > low) & (values[:, :6] < high) for low, high in self.windows]
        return [*met, *(~one.any(axis=1) for one in inside)]

    def margin(self, numbers, axis, limit):
        """In one design, by a grid that becomes finer around the largest amplitude."""
        A, K = self.matrices(np.array([[numbers[path] for path, _, _ in self.numbers]]))
        low, high = self.band
        for _ in range(6):
            omega = np.linspace(low, high, 2001)
            found = self.amplitudes(A, K, omega)[0, :, axis]
            k, step = int(found.argmax()), omega[1] - omega[0]
            low, high = max(self.band[0], omega[k] - 2 * step), min(self.band[1], omega[k] + 2 * step)
        return limit / found.max()


def timed(work):
    work()
    start = time.process_time()
    result = work()
    return result, time.process_time() - start


def by_openturns(machine, count, answer):
    import openturns as ot

    law = ot.JointDistribution([ot.Uniform(*ends) for ends in machine.bounds()])
    function = ot.PythonFunction(len(machine.numbers), 9, func_sample=lambda rows: machine.values(np.array(rows)))
    _, seconds = timed(lambda: function(ot.LowDiscrepancyExperiment(ot.SobolSequence(), law, count).generate()))
    answer["seconds"]["openturns"] = seconds / count
    pairs, axis = 1024, machine.limits[0][0]
    rows = ot.SobolIndicesExperiment(law, pairs).generate()
    value = ot.Sample(machine.values(np.array(rows))[:, 6 + axis].reshape(-1, 1))
    found = ot.JansenSensitivityAlgorithm(rows, value, pairs)
    answer["shares"]["openturns"] = {
        "first": list(found.getFirstOrderIndices()),
        "total": list(found.getTotalOrderIndices()),
    }


def by_salib(machine, answer):
    from SALib.analyze import sobol as analysis
    from SALib.sample import sobol

    problem = {
        "num_vars": len(machine.numbers),
        "names": [path for path, _, _ in machine.numbers],
        "bounds": machine.bounds(),
    }
    rows = sobol.sample(problem, 1024, calc_second_order=False, seed=1)
    value = machine.values(rows)[:, 6 + machine.limits[0][0]]
    found = analysis.analyze(problem, value, calc_second_order=False, seed=1)
    answer["shares"]["salib"] = {"first": list(found["S1"]), "total": list(found["ST"])}


def main(folder, count):
    machine = Machine(tomllib.loads((folder / "machine.toml").read_text()))
    ours = json.loads((folder / "ours.json").read_text())["cases"][0]["requirements"]
    limits = iter(machine.limits)
    answer = {"seconds": {}, "shares": {}, "numbers": [path for path, _, _ in machine.numbers]}
    answer["worst"] = [machine.margin(r["worst_numbers"], *next(limits)) for r in ours if r["kind"] == "amplitude"]
    bounds = np.array(machine.bounds())
    random = np.random.default_rng(3)
    designs = bounds[:, 0] + random.random((count, len(bounds))) * (bounds[:, 1] - bounds[:, 0])
    values, seconds = timed(lambda: machine.values(designs))
    answer["seconds"]["numpy"] = seconds / count
    answer["yields"] = [float(met.mean()) for met in machine.met(values)]
    for by in (lambda: by_openturns(machine, count, answer), lambda: by_salib(machine, answer)):
        try:
            by()
        except ImportError:
            pass  # it is not installed: no row
    print(json.dumps(answer))


main(Path(sys.argv[1]), int(sys.argv[2]))
