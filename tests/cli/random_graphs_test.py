# SPDX-License-Identifier: BSD-3-Clause
"""Whole commands on random systems of 2 to 60 bodies, against matrices and elimination written here from the equations
of motion: chains, rings, trees and graphs of any two bodies."""
import json
import random
import unittest

from trivet_test import InTemporaryFolder, trivet

OF_THE_TERMS = 1e-11  # residual of a mode or root; shapes have double precision
OF_THE_LARGEST = 1e-9  # of the largest motion or force; eliminations of 180 rows without refinement keep ten digits


def cross(v):
    return [[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]]


def rigid(arm):
    """Motion of a point at this arm from the pole: rows of translation and rotation over the six of the body."""
    c = cross(arm)
    return [[float(i == j) if j < 3 else -c[i][j - 3] for j in range(6)] for i in range(3)] + [
        [float(i == j) for j in range(6)] for i in range(3, 6)
    ]


def solved(matrix, right):
    """Gaussian elimination with partial pivoting."""
    a = [row[:] + [b] for row, b in zip(matrix, right)]
    n = len(a)
    for k in range(n):
        pivot = max(range(k, n), key=lambda i: abs(a[i][k]))
        a[k], a[pivot] = a[pivot], a[k]
        top = a[k]
        for i in range(k + 1, n):
            if a[i][k] != 0:
                factor = a[i][k] / top[k]
                row = a[i]
                for j in range(k, n + 1):
                    if top[j] != 0:
                        row[j] -= factor * top[j]
    x = [0.0] * n
    for i in reversed(range(n)):
        x[i] = (a[i][n] - sum(a[i][j] * x[j] for j in range(i + 1, n) if a[i][j] != 0)) / a[i][i]
    return x


def product(matrix, x):
    return [sum(m * v for m, v in zip(row, x) if m != 0) for row in matrix]


def largest_sum(matrix, x):
    """Largest Σ|M_ij||x_j| of a row: round-off of a product is a share of it."""
    return max(sum(abs(m * v) for m, v in zip(row, x)) for row in matrix)


class System:
    """Bodies on bushings, with their project file and their own matrices."""

    def __init__(self, bodies, edges, seed, free=6):
        draw = random.Random(seed)
        self.free, self.bodies = free, bodies
        n = bodies * free
        self.mass, self.damping, self.stiffness = ([[0.0] * n for _ in range(n)] for _ in range(3))
        self.text = "trivet = 1\n"
        self.places = []
        for b in range(bodies):
            place = [draw.uniform(-1, 1) + 2 * b, draw.uniform(-1, 1), draw.uniform(-1, 1)]
            centre = [draw.uniform(-0.1, 0.1) for _ in range(3)]
            moments = [draw.uniform(2, 3) for _ in range(3)]
            mass = draw.uniform(20, 60)
            self.places.append(place)
            self.text += f"[bodies.b{b}]\nmass = {mass!r}\nposition = {place}\ncenter_of_mass = {centre}\n"
            self.text += f'inertia = {{about = "center_of_mass", xx = {moments[0]!r}, yy = {moments[1]!r}, zz = {moments[2]!r}}}\n'
            if free < 6:
                self.text += f"free = {json.dumps(['x', 'y', 'z', 'rx', 'ry', 'rz'][:free])}\n"
            motion = rigid(centre)
            inertias = [mass] * 3 + moments
            for i in range(free):
                for j in range(free):
                    self.mass[b * free + i][b * free + j] = sum(
                        motion[k][i] * inertias[k] * motion[k][j] for k in range(6)
                    )
        for number, (near, far) in enumerate(edges):
            self.add_bushing(draw, number, near, far)
        self.force = [draw.uniform(-50, 50) for _ in range(3)]
        self.text += f'[excitations.f]\ntype = "harmonic"\non = "b{bodies - 1}"\nat = [0, 0, 0]\nforce = {self.force}\n'
        self.load = [0.0] * n
        for i in range(min(3, free)):
            self.load[(bodies - 1) * free + i] = self.force[i]

    def add_bushing(self, draw, number, near, far):
        """Between body `near` and body `far`, None: the ground."""
        at = [draw.uniform(-0.5, 0.5) for _ in range(3)]
        constants = [10 ** draw.uniform(4.5, 5.5) for _ in range(3)] + [10 ** draw.uniform(3, 4) for _ in range(3)]
        dampers = [k * draw.uniform(2e-4, 3e-3) for k in constants]
        start = f'from = "b{far}"\n' if far is not None else ""
        self.text += (
            f'[elements.e{number}]\ntype = "bushing"\non = "b{near}"\n{start}at = {at}\n'
            f"translation = {constants[:3]}\nrotation = {constants[3:]}\n"
            f"damping = {{translation = {dampers[:3]}, rotation = {dampers[3:]}}}\n"
        )
        ends = [(near, 1.0, rigid(at))]
        if far is not None:
            arm = [at[i] + self.places[near][i] - self.places[far][i] for i in range(3)]
            ends.append((far, -1.0, rigid(arm)))
        for a, sign_a, motion_a in ends:
            for b, sign_b, motion_b in ends:
                for i in range(self.free):
                    for j in range(self.free):
                        for k in range(6):
                            share = sign_a * sign_b * motion_a[k][i] * motion_b[k][j]
                            self.stiffness[a * self.free + i][b * self.free + j] += share * constants[k]
                            self.damping[a * self.free + i][b * self.free + j] += share * dampers[k]

    def motion(self, omega):
        rows = zip(self.mass, self.damping, self.stiffness)
        z = [[k + 1j * omega * b - omega * omega * m for m, b, k in zip(*row)] for row in rows]
        return solved(z, self.load)

    def free_part(self, shape):
        """Of a shape with six coordinates for each body."""
        return [entry for place, entry in enumerate(shape) if place % 6 < self.free]

    def names(self, coordinates):
        return [f"b{c // self.free}.{('x', 'y', 'z', 'rx', 'ry', 'rz')[c % self.free]}" for c in coordinates]


def graphs(bodies, seed):
    """Edges of connected graphs; the first body, and every fifth, stands on the ground."""
    draw = random.Random(seed)
    ground = [(b, None) for b in range(0, bodies, 5)] + [(0, None)]
    chain = [(b, b - 1) for b in range(1, bodies)]
    return {
        "chain": ground + chain,
        "ring": ground + chain + [(0, bodies - 1)],
        "tree": ground + [(b, draw.randrange(b)) for b in range(1, bodies)],
        "dense": ground + [(b, a) for b in range(1, bodies) for a in range(b) if a == b - 1 or draw.random() < 0.4],
    }


def systems():
    for bodies, free in ((2, 6), (5, 6), (14, 6), (60, 3)):
        for number, (name, edges) in enumerate(graphs(bodies, bodies).items()):
            if bodies < 60 or name != "dense":
                yield f"{name} of {bodies}", System(bodies, edges, 10 * bodies + number, free)


class RandomGraphs(InTemporaryFolder):
    def json(self, command, text):
        done = trivet(command, self.file(text), "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def test_response(self):
        for name, system in systems():
            with self.subTest(name):
                n = len(system.load)
                request = sorted(random.Random(n).sample(range(n), min(n, 12)))
                omega = [3.7, 41.3, 180.9] if n > 100 else [0.0, 3.7, 17.1, 41.3, 77.7, 180.9]
                of = json.dumps(system.names(request))
                found = self.json("response", system.text + f"[analyses.response]\nat = {omega}\nof = {of}\n")
                self.assertTrue(found["checks"]["second_solver"]["passed"])
                for at, w in enumerate(omega):
                    exact = system.motion(w)
                    largest = max(map(abs, exact))
                    for curve, c in zip(found["results"], request):
                        self.assertLessEqual(abs(complex(*curve["complex"][at]) - exact[c]), OF_THE_LARGEST * largest)

    def test_modes(self):
        for name, system in systems():
            with self.subTest(name):
                modes = self.json("modes", system.text)["modes"]
                self.assertEqual(len(modes), len(system.load))
                for mode in modes:
                    shape = system.free_part(mode["shape"])
                    elastic, inertial = product(system.stiffness, shape), product(system.mass, shape)
                    rest = [k - mode["eigenvalue_squared"] * m for k, m in zip(elastic, inertial)]
                    self.assertLessEqual(max(map(abs, rest)), OF_THE_TERMS * largest_sum(system.stiffness, shape))
                    self.assertAlmostEqual(sum(a * b for a, b in zip(shape, inertial)), mode["modal_mass"], 9)
                # Each ω² once: their sum is the trace of A⁻¹K, body by body.
                trace, f = 0, system.free
                for b in range(system.bodies):
                    block = [row[b * f : (b + 1) * f] for row in system.mass[b * f : (b + 1) * f]]
                    for j in range(f):
                        column = [system.stiffness[b * f + i][b * f + j] for i in range(f)]
                        trace += solved(block, column)[j]
                self.assertAlmostEqual(sum(m["eigenvalue_squared"] for m in modes) / trace, 1, 9)

    def test_roots(self):
        for name, system in systems():
            with self.subTest(name):
                roots = self.json("roots", system.text)["roots"]
                self.assertEqual(len(roots), 2 * len(system.load))
                for root in random.Random(5).sample(roots, 8):
                    value = complex(*root["eigenvalue"])
                    shape = [complex(*entry) for entry in system.free_part(root["shape"])]
                    parts = [product(m, shape) for m in (system.mass, system.damping, system.stiffness)]
                    rest = [value * value * m + value * b + k for m, b, k in zip(*parts)]
                    terms = largest_sum(system.stiffness, shape) + abs(value) ** 2 * largest_sum(system.mass, shape)
                    self.assertLessEqual(max(map(abs, rest)), OF_THE_TERMS * terms)

    def test_peaks(self):
        for name, system in systems():
            n = len(system.load)
            if n > 40:
                continue
            with self.subTest(name):
                request = [0, n // 2, n - 1]
                of = json.dumps(system.names(request))
                peaks = self.json("peaks", system.text + f"[analyses.peaks]\nof = {of}\n")["peaks"]
                for curve, c in zip(system.names(request), request):
                    own = [p for p in peaks if p["name"] == curve]
                    self.assertTrue(own)
                    for peak in own:
                        exact = abs(system.motion(peak["angular_frequency"])[c])
                        self.assertAlmostEqual(peak["amplitude"] / exact, 1, 9)
                    # Around every peak of a scan there is one in the list, if it rises by a millionth of the highest.
                    scan = [1.5 * 1.01**i for i in range(560)]
                    height = [abs(system.motion(w)[c]) for w in scan]
                    for i in range(1, len(scan) - 1):
                        if height[i] - max(height[i - 1], height[i + 1]) > 1e-6 * max(p["amplitude"] for p in own):
                            self.assertTrue(
                                any(scan[i - 1] < p["angular_frequency"] < scan[i + 1] for p in own), scan[i]
                            )


if __name__ == "__main__":
    unittest.main()
