#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Random nonlinear machines: steady motions of the program against integration in time.

    TRIVET=… python3 tests/campaign/steady_machines.py [--machines 300] [--only NUMBER] [--keep FOLDER]

Needs NumPy and SciPy. The equations of motion are written here a second time: bodies, skew springs with offsets, laws
along their axes, a moving ground. At some points of each curve a periodic motion is found by Newton's method on the
return map (DOP853 with variational equations), begun at the state that the program gives. Its mean, extremes and
largest multiplier must be those of the program. A machine without a result needs a reason. With loss factors, which
have no motion in time, the balance of harmonics is checked instead."""
import argparse
import collections
import concurrent.futures
import json
import os
import pathlib
import random
import subprocess
import sys
import tempfile

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import root

TRIVET = os.environ["TRIVET"]
TOLERANCE = 1e-5  # of the program's curve: share of the deflections that left out harmonics add
MOTION = 2e-3  # agreement of mean and extremes over the range: contacts converge with the cube of the harmonics
MULTIPLIER = 2e-2  # of the largest magnitude; its square root enters where two multipliers almost coincide
NEAR_ONE = 5e-3  # a multiplier this close to 1 may be on either side
POINTS = 5  # of a curve that are integrated
SECONDS = 200


class Part:
    """A law over one deflection δ = row · q: forces, their slope, and the text of the project file."""

    def __init__(self, row, force, slope):
        self.row, self.force, self.slope = np.array(row), force, slope


def law(chance, stiffness, length):
    """A law whose force at a deflection of `length` is about stiffness × length."""
    kind = chance.choice(["cubic", "quadratic", "softening", "gap", "gap of one side", "curve"])
    k = stiffness * 10 ** chance.uniform(-0.5, 0.7)
    if kind == "cubic":
        c = k / length**2
        return f"cubic = {c!r}", lambda d: c * d**3, lambda d: 3 * c * d**2
    if kind == "quadratic":
        c, e = 0.3 * k / length, k / length**2
        return (
            f"polynomial = [0, {c!r}, {e!r}]",
            lambda d: c * d**2 + e * d**3,
            lambda d: 2 * c * d + 3 * e * d**2,
        )
    if kind == "softening":
        c, e = -0.2 * stiffness / length**2, 0.2 * stiffness / length**4
        return (
            f"polynomial = [0, 0, {c!r}, 0, {e!r}]",
            lambda d: c * d**3 + e * d**5,
            lambda d: 3 * c * d**2 + 5 * e * d**4,
        )
    if kind == "curve":
        half = 0.5 * k
        text = f"curve = {{rows = [[{-length!r}, {-half * length!r}], [0, 0], [{length!r}, {k * length!r}]]}}"
        return text, lambda d: d * (half if d < 0 else k), lambda d: half if d < 0 else k
    above, below = length * chance.uniform(0.3, 1.2), length * chance.uniform(0.3, 1.2)
    if kind == "gap of one side":
        below = np.inf
        text = f"gap_stop = {{gap = {above!r}, stiffness = {k!r}}}"
    else:
        text = f"gap_stop = {{gaps = [{above!r}, {below!r}], stiffness = {k!r}}}"
    return (
        text,
        lambda d: k * (max(d - above, 0) - max(-below - d, 0)),
        lambda d: k if d > above or d < -below else 0.0,
    )


def rotation(chance):
    axis = np.array([chance.gauss(0, 1) for _ in range(3)])
    axis /= np.linalg.norm(axis)
    angle = chance.uniform(-1.2, 1.2)
    cross = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross, axis, np.degrees(angle)


def at_point(r):
    """Translation of a point at r from the pole, by the six coordinates of the body."""
    x, y, z = r
    return np.hstack([np.eye(3), np.array([[0, z, -y], [-z, 0, x], [y, -x, 0]])])


class Machine:
    NAMES = ["x", "y", "z", "rx", "ry", "rz"]

    def __init__(self, number):
        self.chance = chance = random.Random(f"trivet steady {number}")
        self.kind = chance.choice(
            ["one", "one", "critical", "undamped", "zero tangent", "two", "light", "plane", "plane", "loss"]
        )
        self.text, self.parts = "trivet = 1\n", []
        self.free = {"plane": ["x", "z", "ry"]}.get(self.kind, ["z"])
        count = 2 if self.kind in ("two", "light") else 1
        self.n = count * len(self.free)
        self.M, self.K, self.B, self.H = (np.zeros((self.n, self.n)) for _ in range(4))
        self.loaded = np.zeros(self.n, complex)
        self.ground = []  # (row of the coordinates, stiffness, damping) on a moving ground
        self.length = 10 ** chance.uniform(-3.5, -1.5)
        self.mass = 10 ** chance.uniform(0, 3)
        self.omega = 2 * np.pi * 10 ** chance.uniform(-0.2, 1.3)
        self.bodies(count)
        self.springs(count)
        self.excitation(count)
        band = [0.3 * self.omega, 2.6 * self.omega]
        of = [f"b{b}.{name}" for b in range(count) for name in self.free]
        self.text += (
            f"[analyses]\nsteady = {{of = {json.dumps(of)}, band = [\"{band[0]!r} rad/s\", \"{band[1]!r} rad/s\"], "
            f"tolerance = {TOLERANCE}}}\n"
        )

    def columns(self, body):
        return slice(body * len(self.free), (body + 1) * len(self.free))

    def rows(self, body, r, axes):
        """Deflections along local axes by all coordinates."""
        full = np.zeros((3, self.n))
        chosen = [self.NAMES.index(name) for name in self.free]
        full[:, self.columns(body)] = axes.T @ at_point(r)[:, chosen]
        return full

    def bodies(self, count):
        self.masses = [self.mass]
        if count == 2:
            share = 10 ** self.chance.uniform(-3, -1.5) if self.kind == "light" else 10 ** self.chance.uniform(-1, 0.5)
            self.masses.append(self.mass * share)
        for b, mass in enumerate(self.masses):
            inertia = mass * 0.1 * self.chance.uniform(0.5, 2)
            self.text += (
                f"[bodies.b{b}]\nmass = {mass!r}\ninertia = {{about = \"center_of_mass\", xx = {inertia!r}, "
                f"yy = {inertia!r}, zz = {inertia!r}}}\nfree = {json.dumps(self.free)}\n"
            )
            diagonal = {"x": mass, "y": mass, "z": mass}
            self.M[self.columns(b), self.columns(b)] = np.diag([diagonal.get(name, inertia) for name in self.free])

    def springs(self, count):
        chance, k0 = self.chance, self.mass * self.omega**2
        mounts = 3 if self.kind == "plane" else count
        for m in range(mounts):
            body = 0 if self.kind == "plane" else m
            k, mass = k0, self.mass
            if self.kind in ("two", "light") and body == 1:  # on the first body; a light one is stiffly held
                mass = self.masses[1]
                k = (
                    mass * (self.omega * chance.uniform(0.7, 3)) ** 2
                    if self.kind == "two"
                    else k0 * chance.uniform(0.3, 3)
                )
            if self.kind == "plane":
                k /= 3
            axes, place, orientation = np.eye(3), np.zeros(3), ""
            if self.kind == "plane":
                axes, axis, angle = rotation(chance)
                place = np.array([chance.uniform(-0.5, 0.5), chance.uniform(-0.2, 0.2), chance.uniform(-0.3, 0.3)])
                orientation = f"orientation = {{axis = {axis.tolist()!r}, angle = \"{float(angle)!r} deg\"}}\n"
            across = [k * chance.uniform(0.4, 1), k * chance.uniform(0.4, 1), k]
            if self.kind == "zero tangent":
                across = [0.0, 0.0, 0.0]
            ratio = {"critical": 1.0, "undamped": 0.0}.get(self.kind, 10 ** chance.uniform(-2.2, -0.7))
            if self.kind == "loss":
                ratio = 0.0
            c = [ratio * 2 * (k * mass) ** 0.5] * 3
            below = "from = \"b0\"\nfrom_at = [0, 0, 0]\n" if body == 1 else ""
            damping = f"damping = {{translation = {c!r}, rotation = [0, 0, 0]}}\n" if ratio else ""
            eta = 0.0
            if self.kind == "loss":
                eta = chance.uniform(0.02, 0.3)
                damping = f"damping = {{loss_factor = {eta!r}}}\n"
            words, force, slope = law(chance, k, self.length)
            if self.kind == "zero tangent":
                cubic = k / self.length**2
                words, force, slope = (
                    f"cubic = {cubic!r}",
                    lambda d, c=cubic: c * d**3,
                    lambda d, c=cubic: 3 * c * d**2,
                )
            self.text += (
                f"[elements.e{m}]\ntype = \"bushing\"\non = \"b{body}\"\nat = {place.tolist()!r}\n{below}{orientation}"
                f"translation = {across!r}\n{damping}laws.z = {{{words}}}\n"
            )
            rows = self.rows(body, place, axes)
            if body == 1:
                rows[:, self.columns(0)] = -np.eye(3)[:, [2]]
            self.K += rows.T @ np.diag(across) @ rows
            self.B += rows.T @ np.diag(c) @ rows
            self.H += eta * rows.T @ np.diag(across) @ rows
            self.parts.append(Part(rows[2], force, slope))
            self.ground.append((rows, axes, across, c, body == 0))

    def excitation(self, count):
        chance = self.chance
        size = 10 ** chance.uniform(-1.3, 0.3)
        self.base = self.kind in ("one", "critical") and chance.random() < 0.4
        if self.base:
            self.amplitude = size * self.length
            self.text += f"[excitations.f]\ntype = \"base\"\ntranslation = [0, 0, {self.amplitude!r}]\n"
            return
        force = size * self.mass * self.omega**2 * self.length
        self.text += (
            f"[excitations.f]\ntype = \"harmonic\"\non = \"b{count - 1}\"\nat = [0, 0, 0]\nforce = [0, 0, {force!r}]\n"
        )
        self.loaded[self.columns(count - 1).start + self.free.index("z")] = force

    # Motion in time: coordinates x = q with a ground that moves by self.amplitude cos ωt.

    def floor(self, omega, t):
        a = self.amplitude if self.base else 0.0
        return a * np.cos(omega * t), -a * omega * np.sin(omega * t)

    def forces(self, q, v, omega, t):
        """Forces of springs, dampers and laws, and their slopes over q and v."""
        g, dg = self.floor(omega, t)
        restoring = self.K @ q + self.B @ v
        if self.base:  # a single coordinate: the spring sees q − g
            restoring = self.K @ (q - g) + self.B @ (v - dg)
        slopes = self.K.copy()
        for part in self.parts:
            d = part.row @ q - (g if self.base else 0.0)
            restoring = restoring + part.row * part.force(d)
            slopes += np.outer(part.row, part.row) * part.slope(d)
        return restoring, slopes

    def flow(self, state, omega, extremes=False):
        """State and transition matrix after a period; with `extremes` also mean, smallest and largest of q."""
        n, period = self.n, 2 * np.pi / omega
        inverse = np.linalg.inv(self.M)

        def rates(t, y):
            q, v, transition = y[:n], y[n : 2 * n], y[2 * n :].reshape(2 * n, 2 * n)
            restoring, slopes = self.forces(q, v, omega, t)
            load = (self.loaded * np.exp(1j * omega * t)).real
            tangent = np.block([[np.zeros((n, n)), np.eye(n)], [-inverse @ slopes, -inverse @ self.B]])
            return np.concatenate([v, inverse @ (load - restoring), (tangent @ transition).ravel()])

        begin = np.concatenate([state, np.eye(2 * n).ravel()])
        size = np.concatenate([np.full(n, self.length), np.full(n, self.length * omega), np.ones(4 * n * n)])
        done = solve_ivp(
            rates,
            (0, period),
            begin,
            method="DOP853",
            rtol=1e-9,
            atol=1e-11 * size,
            max_step=period / 60,
            dense_output=extremes,
        )
        if extremes:
            q = done.sol(np.linspace(0, period, 4001)[:-1])[:n]
            return q.mean(axis=1), q.min(axis=1), q.max(axis=1)
        return done.y[: 2 * n, -1], done.y[2 * n :, -1].reshape(2 * n, 2 * n)

    def periodic(self, state, omega):
        """The periodic motion near a state by Newton's method. @returns state, multipliers; None if it does not converge"""
        size = np.concatenate([np.full(self.n, self.length), np.full(self.n, self.length * omega)])
        if self.kind == "undamped":  # two multipliers may be 1, and then there is no other motion to go to
            end, transition = self.flow(state, omega)
            reach = max(1, np.max(np.abs(state) / size))
            return (state, np.linalg.eigvals(transition)) if np.max(np.abs(end - state) / size) < 1e-3 * reach else None
        for _ in range(8):
            end, transition = self.flow(state, omega)
            if np.max(np.abs(end - state) / size) < 1e-6:
                return state, np.linalg.eigvals(transition)
            state = state + np.linalg.lstsq(transition - np.eye(2 * self.n), state - end, rcond=None)[0]
        return None

    def balance(self, point, omega):
        """Largest remainder of the balance of harmonics over the excitation (loss factors)."""
        harmonics = np.array([[complex(*c) for c in r["harmonics"]] for r in point["results"]])
        mean = np.array([r["mean"] for r in point["results"]])
        count = harmonics.shape[1]
        time = np.arange(16 * (count + 1)) * 2 * np.pi / (16 * (count + 1))
        q = mean[:, None] + sum((np.outer(harmonics[:, k], np.exp(1j * (k + 1) * time))).real for k in range(count))
        nonlinear = np.zeros_like(q)
        for part in self.parts:
            nonlinear += np.outer(part.row, [part.force(d) for d in part.row @ q])
        worst = 0.0
        for k in range(1, min(count, 5) + 1):
            f = 2 * (nonlinear * np.exp(-1j * k * time)).mean(axis=1)
            z = self.K + 1j * self.H - (k * omega) ** 2 * self.M + 1j * k * omega * self.B
            load = self.loaded if k == 1 else 0
            worst = max(worst, np.max(np.abs(z @ harmonics[:, k - 1] + f - load)))
        return worst / np.max(np.abs(self.loaded))


def state_of(point, omega):
    harmonics = np.array([[complex(*c) for c in r["harmonics"]] for r in point["results"]])
    orders = 1j * omega * np.arange(1, harmonics.shape[1] + 1)
    mean = np.array([r["mean"] for r in point["results"]])
    return np.concatenate([mean + harmonics.sum(axis=1).real, (harmonics * orders).sum(axis=1).real])


def is_uncertain(point):
    """The program does not state whether the motion is stable."""
    return point["stable"] is None


def compared(machine, point):
    """None, or what is wrong with a point of the curve."""
    omega = point["angular_frequency"]
    if machine.kind == "loss":
        rest = machine.balance(point, omega)
        return None if rest < 30 * TOLERANCE**0.5 * 0.1 else f"the balance at {omega:.6g} rad/s is {rest:.2g} off"
    found = machine.periodic(state_of(point, omega), omega)
    if found is None:
        return f"no motion in time near that at {omega:.6g} rad/s"
    state, multipliers = found
    mean, smallest, largest = machine.flow(state, omega, extremes=True)
    span = np.max(largest - smallest)
    for i, result in enumerate(point["results"]):
        for name, value in (("mean", mean[i]), ("smallest", smallest[i]), ("largest", largest[i])):
            if abs(result[name] - value) > MOTION * span:
                return f"{name} of coordinate {i} at {omega:.6g} rad/s is {result[name]:.6g}, in time {value:.6g}"
    biggest = np.max(np.abs(multipliers))
    if machine.kind != "undamped":
        if is_uncertain(point):
            return None
        if point["stable"] != (biggest < 1) and abs(biggest - 1) > NEAR_ONE:
            said = f"{point['stable']} ({point['largest_multiplier']})"
            return f"at {omega:.6g} rad/s stable = {said}, in time {biggest:.6g}"
        if point["largest_multiplier"] is None:
            return None
        if abs(point["largest_multiplier"] - biggest) > MULTIPLIER * max(1, biggest):
            return f"multiplier at {omega:.6g} rad/s is {point['largest_multiplier']:.6g}, in time {biggest:.6g}"
    return None


def judged(number, keep=None):
    """@returns kind, verdict ("right", "no result", "wrong"), words, examined points of uncertain stability"""
    machine = Machine(number)
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(keep or folder) / f"machine_{number}.toml"
        file.write_text(machine.text)
        try:
            done = subprocess.run(
                [TRIVET, "steady", str(file), "--json"], capture_output=True, text=True, timeout=SECONDS
            )
        except subprocess.TimeoutExpired:
            return machine.kind, "wrong", f"no answer in {SECONDS} s", 0
    if done.returncode not in (0, 1, 2) or not (done.stdout.strip() or done.stderr.strip()):
        return machine.kind, "wrong", f"exit {done.returncode} without a reason", 0
    if not done.stdout.strip():
        return machine.kind, "no answer", " ".join(done.stderr.split())[:300], 0
    result = json.loads(done.stdout)
    points = result["points"]
    if not points:
        reason = "; ".join([result["ended"], *result["warnings"]])[:300]
        return machine.kind, "no answer" if reason else "wrong", reason or "no points and no reason", 0
    if done.returncode and not result["ended"] and not result["warnings"]:
        return machine.kind, "wrong", f"exit {done.returncode} without a reason", 0
    chosen = machine.chance.sample(points, min(POINTS, len(points)))
    uncertain = 0 if machine.kind in ("loss", "undamped") else sum(map(is_uncertain, chosen))
    problems = [words for words in (compared(machine, point) for point in chosen) if words]
    if problems:
        return machine.kind, "wrong", problems[0] + (f" ({len(problems)} of {len(chosen)} points)"), uncertain
    reach = [min(p["angular_frequency"] for p in points), max(p["angular_frequency"] for p in points)]
    ended = f"; ended: {result['ended']}" if result["ended"] else ""
    return machine.kind, "right", f"{len(points)} points from {reach[0]:.4g} to {reach[1]:.4g} rad/s{ended}", uncertain


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--machines", type=int, default=300)
    parser.add_argument("--only", type=int)
    parser.add_argument("--keep")
    options = parser.parse_args()
    numbers = [options.only] if options.only is not None else range(options.machines)
    counts = collections.Counter()
    points_uncertain = 0
    with concurrent.futures.ProcessPoolExecutor(max_workers=2) as pool:
        verdicts = pool.map(judged, numbers, [options.keep] * len(numbers))
        for number, (kind, verdict, words, uncertain) in zip(numbers, verdicts):
            counts[verdict] += 1
            points_uncertain += uncertain
            if verdict != "right" or "ended" in words or options.only is not None:
                print(f"{number:5} {kind:13} {verdict}: {words}", flush=True)
    print(", ".join(f"{count} {verdict}" for verdict, count in sorted(counts.items())))
    print(f"{points_uncertain} examined points of uncertain stability")
    sys.exit(1 if counts["wrong"] else 0)


if __name__ == "__main__":
    main()
