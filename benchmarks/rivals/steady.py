# SPDX-License-Identifier: BSD-3-Clause
"""Curve of steady motion with cubic springs in NumPy: condensed harmonic balance with analytic tangents, sampled forces, pseudo
arc length; no stability, no folds located. The answer: amplitude of the first harmonic of each deflection at the end of the band."""
import numpy as np
from serve import folder, numbers, serve


def read():
    sizes = np.fromfile(folder / "sizes").astype(int)  # coordinates, deflections, harmonics
    n, m, H = sizes
    A, B, K = (numbers(name, n) for name in "ABK")
    W = numbers("W", n)
    force = np.fromfile(folder / "force")
    cubic, low, high = np.fromfile(folder / "scalars")
    C = 2 * H + 1
    samples = 64 if H > 7 else 32
    phase = 2 * np.pi * np.arange(samples) / samples
    basis = np.ones((samples, C))
    for k in range(1, H + 1):
        basis[:, 2 * k - 1], basis[:, 2 * k] = np.cos(k * phase), np.sin(k * phase)
    to = 2 / samples * basis.T
    to[0] /= 2
    right = np.column_stack([W, force])

    def receptances(omega):
        """Deflections by forces of all harmonics and by the excitation, and their slopes by omega."""
        k = np.arange(H + 1)[:, None, None]
        s = k * omega
        Z = K - s**2 * A + 1j * s * B
        dZ = -2 * k * s * A + 1j * k * B
        full = np.linalg.solve(Z, np.broadcast_to(right.astype(complex), (H + 1, n, m + 1)))
        slope = -np.linalg.solve(Z, dZ @ full)
        return W.T @ full, W.T @ slope

    def evaluate(u, omega):
        G, dG = receptances(omega)
        x = u.reshape(m, C)
        course = x @ basis.T
        f = cubic * course**3 @ to.T
        tangent = np.einsum("cs,js,sd->jcd", to, 3 * cubic * course**2, basis, optimize=True)
        r, J, by = u.copy().reshape(m, C), np.eye(m * C).reshape(m, C, m, C), np.zeros((m, C))
        r[:, 0] += G[0].real[:, :m] @ f[:, 0]
        J[:, 0] += G[0].real[:, :m, None] * tangent[None, :, 0]
        for k in range(1, H + 1):
            g, d, a, b = G[k], dG[k], 2 * k - 1, 2 * k
            fa, fb, ta, tb = f[:, a], f[:, b], tangent[:, a], tangent[:, b]
            gr, gi, dr, di = g.real[:, :m], g.imag[:, :m], d.real[:, :m], d.imag[:, :m]
            r[:, a] += gr @ fa + gi @ fb
            r[:, b] += gr @ fb - gi @ fa
            by[:, a] += dr @ fa + di @ fb
            by[:, b] += dr @ fb - di @ fa
            J[:, a] += gr[:, :, None] * ta[None] + gi[:, :, None] * tb[None]
            J[:, b] += gr[:, :, None] * tb[None] - gi[:, :, None] * ta[None]
        r[:, 1] -= G[1].real[:, m]
        r[:, 2] += G[1].imag[:, m]
        by[:, 1] -= dG[1].real[:, m]
        by[:, 2] += dG[1].imag[:, m]
        return r.ravel(), J.reshape(m * C, m * C), by.ravel()

    def curve():
        u, omega = np.zeros(m * C), low
        G, _ = receptances(low)
        u.reshape(m, C)[:, 1], u.reshape(m, C)[:, 2] = G[1].real[:, m], -G[1].imag[:, m]
        for _ in range(20):
            r, J, _ = evaluate(u, omega)
            change = np.linalg.solve(J, r)
            u -= change
            if np.abs(change).max() < 1e-11 * np.abs(u).max():
                break
        direction, step = np.append(np.zeros(m * C), 1.0), 0.03
        while omega < high:
            scale = np.append(np.full(m * C, np.abs(u).max()), high - low)
            bordered = np.zeros((m * C + 1, m * C + 1))
            _, J, by = evaluate(u, omega)
            bordered[:-1] = np.column_stack([J, by]) * scale
            bordered[-1] = direction / np.linalg.norm(direction)
            tangent = np.linalg.solve(bordered, np.append(np.zeros(m * C), 1.0))
            tangent /= np.linalg.norm(tangent)
            place = np.append(u, omega) + step * tangent * scale
            for iteration in range(8):
                r, J, by = evaluate(place[:-1], place[-1])
                bordered[:-1] = np.column_stack([J, by]) * scale
                bordered[-1] = tangent
                change = np.linalg.solve(bordered, np.append(r, 0.0))
                place -= change * scale
                if np.linalg.norm(change) < 1e-9:
                    break
            else:
                step /= 2
                continue
            u, omega, direction = place[:-1], place[-1], tangent
            step = min(0.1, step * (1.4 if iteration < 3 else 1.0))
        for _ in range(10):  # at the end of the band
            r, J, _ = evaluate(u, high)
            u -= np.linalg.solve(J, r)
        x = u.reshape(m, C)
        return np.hypot(x[:, 1], x[:, 2])

    return {"curve": curve}


serve(read)
