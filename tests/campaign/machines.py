# SPDX-License-Identifier: BSD-3-Clause
"""Plausible random machines: one to three bodies on four to eight mounts, 5 kg to 50 t, natural frequencies of a few
hertz."""
import re


def three(values):
    return "[" + ", ".join(f"{v:.6g}" for v in values) + "]"


def damping(random):
    return random.choice(
        [
            "",
            f"damping = {{loss_factor = {random.uniform(0.01, 0.3):.3g}}}\n",
            f"damping = {{proportional = {random.uniform(1e-5, 1e-2):.3g}}}\n",
            f'damping = {{zener = {{ratio = {random.uniform(0.1, 2):.3g}, time = "{random.uniform(0.5, 20):.3g} ms"}}}}\n',
            f'damping = {{maxwell = {{ratios = [0.4, 0.2], times = [0.001, {random.uniform(0.005, 0.1):.3g}]}}}}\n',
        ]
    )


def machine(random):
    """The text of a project file that requests modes, roots, response and peaks."""
    bodies = random.choice([1, 1, 1, 2, 3])
    mass = 10 ** random.uniform(0.7, 4.7)
    text = "trivet = 1\ngravity = [0, 0, -9.80665]\n"
    height = 0.0
    for b in range(bodies):
        size = [random.uniform(0.3, 1.2) * (mass / 500) ** (1 / 3) for _ in range(3)]
        inertia = [mass * (size[(i + 1) % 3] ** 2 + size[(i + 2) % 3] ** 2) / 12 for i in range(3)]
        centre = [random.uniform(-0.1, 0.1) * size[0], random.uniform(-0.1, 0.1) * size[1], size[2] / 2]
        text += (
            f'\n[bodies."body {b}"]\nmass = {mass:.6g}\nposition = [0, 0, {height:.6g}]\ncenter_of_mass = {three(centre)}\n'
            f'inertia = {{about = "center_of_mass", xx = {inertia[0]:.6g}, yy = {inertia[1]:.6g}, zz = {inertia[2]:.6g}}}\n'
            f'points.top = [0, 0, {size[2]:.6g}]\n'
        )
        stiffness = mass * (6.283 * random.uniform(2, 15)) ** 2 / 4
        for m, (x, y) in enumerate([(1, 1), (1, -1), (-1, 1), (-1, -1)]):
            k = [stiffness * random.uniform(0.3, 1.5) for _ in range(3)]
            below = f'from = "body {b - 1}"\n' if b > 0 else ""
            turning = f"rotation = {three([0.002 * size[0] ** 2 * v for v in k])}\n" if random.random() < 0.5 else ""
            text += (
                f'[elements."mount {b}{m}"]\ntype = "bushing"\non = "body {b}"\n{below}at = {three([x * size[0] / 2, y * size[1] / 2, 0])}\n'
                f"translation = {three(k)}\n{turning}{damping(random)}"
            )
        height += size[2] + 0.1
        mass *= random.uniform(0.2, 0.9)
    if random.random() < 0.4:
        text += f'\n[elements.damper]\ntype = "damper"\non = "body 0"\nat = [0.05, 0, 0]\nfrom_at = [0.05, {random.uniform(-0.2, 0.2):.3g}, -0.3]\ncoefficient = {random.uniform(10, 5000):.6g}\n'
    text += f'\n[excitations.force]\ntype = "harmonic"\non = "body {bodies - 1}"\nat = [0.1, 0.05, 0.2]\nforce = {three([random.uniform(-100, 100), 10, 120])}\n'
    if random.random() < 0.4:
        text += '[excitations.floor]\ntype = "base"\ntranslation = [0, 0, "1 mm"]\n'
    return (
        text
        + f'\n[analyses]\nmodes = {{}}\nroots = {{}}\nresponse = {{band = ["0 Hz", "{random.uniform(20, 100):.4g} Hz"]}}\npeaks = {{}}\nstatic = {{}}\n'
    )


def within_tolerances(random, text):
    """The machine with tolerances on its lowest mounts and body, an amplitude that is limited at a speed, and a sample."""
    paths = ", ".join(f"'elements.\"mount 0{m}\".scale'" for m in range(4))
    if random.random() < 0.5:  # kernels judge the designs of constant matrices alone
        text = re.sub(r"(?m)^damping = \{(zener|maxwell) .*$", "damping = {loss_factor = 0.1}", text)
    return (
        text.replace("\n[analyses]\n", '\n[analyses]\nsample = {designs = 100}\n')
        + f'[tolerances.rubber]\npath = [{paths}]\nhalf_width = "{random.uniform(1, 60):.3g} %"\n'
        + "[tolerances.weight]\npath = 'bodies.\"body 0\".mass'\n"
        + f'standard_deviation = "{random.uniform(1, 40):.3g} %"\n'
        + '[operation]\nspeeds = ["980 rpm"]\n'
        + f'limits = {{"body 0.top.z" = "{10 ** random.uniform(-1, 1):.3g} mm/s rms"}}\n'
        + f'[limits]\n"body 0.top.x" = "{10 ** random.uniform(-3, 0):.3g} mm"\n'
    )


def without_excitations(text):
    """The machine at rest: it requests modes and static deflections only."""
    return text.partition("\n[excitations.")[0] + "\n[analyses]\nmodes = {}\nroots = {}\nstatic = {}\n"
