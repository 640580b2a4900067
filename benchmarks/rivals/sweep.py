# SPDX-License-Identifier: BSD-3-Clause
"""q(p) = (K - p²A + ipB)⁻¹H for many p in Python: NumPy batched and by hand, SciPy in a loop, pyYeti where it is present."""
import numpy as np
import scipy.linalg
from serve import numbers, serve


def in_pieces(evaluate, size):
    q = np.empty((6, len(p)), dtype=complex)
    for first in range(0, len(p), size):
        q[:, first : first + size] = evaluate(p[first : first + size])
    return q


def dynamic_stiffness(some):
    return K - (some**2)[:, None, None] * A + 1j * some[:, None, None] * B


def batched(some):
    return np.linalg.solve(dynamic_stiffness(some), H[None, :, None])[:, :, 0].T


def vectorised_ldlt(some):
    """LDLᵀ without pivoting, each entry a vector over frequencies."""
    x, lower, scaled, inverse, y = some**2, {}, {}, {}, {}
    for j in range(6):
        for i in range(j, 6):
            z = np.empty(len(some), dtype=complex)
            z.real = K[i, j] - A[i, j] * x
            z.imag = B[i, j] * some
            for k in range(j):
                z -= scaled[i, k] * lower[j, k]
            if i == j:
                inverse[j] = 1 / z
                y[j] = H[j] - sum((scaled[j, k] * y[k] for k in range(j)), np.zeros(1))
            else:
                lower[i, j] = z
                scaled[i, j] = z * inverse[j]
    q = np.empty((6, len(some)), dtype=complex)
    for i in reversed(range(6)):
        s = y[i] * inverse[i]
        for k in range(i + 1, 6):
            s -= scaled[k, i] * q[k]
        q[i] = s
    return q


def poles():
    state = np.block([[np.zeros((6, 6)), np.eye(6)], [-np.linalg.solve(A, K), -np.linalg.solve(A, B)]])
    values, vectors = np.linalg.eig(state)
    weights = np.linalg.solve(vectors, np.concatenate([np.zeros(6), np.linalg.solve(A, H)]).astype(complex))
    return vectors[:6] * weights, values


def modal():
    residues, values = poles()
    return in_pieces(lambda some: residues @ (1 / (1j * some - values[:, None])), 1500)


def modal_pairs():
    """Conjugate pairs joined, (a + ipb) / (|λ|² - p² - 2ip Re λ), in real arithmetic: NumPy divides complex numbers slowly."""
    residues, values = poles()
    upper = values.imag > 0
    if 2 * np.count_nonzero(upper) != 12:
        raise ValueError("a real pole has no partner")
    r, v = residues[:, upper], values[upper]
    ab = np.vstack([-2 * (r * v.conj()).real, 2 * r.real])
    square, damping = abs(v[:, None]) ** 2, -2 * v.real[:, None]

    def some_of_them(some):
        x, y = square - some * some, damping * some
        scale = 1 / (x * x + y * y)
        real, minus_imaginary = ab @ (x * scale), ab @ (y * scale)
        q = np.empty((6, len(some)), dtype=complex)
        q.real = real[:6] + some * minus_imaginary[6:]
        q.imag = some * real[6:] - minus_imaginary[:6]
        return q

    return in_pieces(some_of_them, 2000)


def loop(solve):
    q = np.empty((6, len(p)), dtype=complex)
    for k, w in enumerate(p):
        q[:, k] = solve(K - w**2 * A + 1j * w * B)
    return q


def read():
    global A, B, K, H, p
    A, B, K, H = (numbers(name, 6) for name in "ABKH")
    H = H[:, 0]
    p = numbers("p", 1)[0]
    ways = {
        "batched": lambda: in_pieces(batched, 20000),
        "ldlt": lambda: in_pieces(vectorised_ldlt, 2000),
        "modal": modal,
        "modal_pairs": modal_pairs,
        "scipy": lambda: loop(lambda z: scipy.linalg.solve(z, H)),
        "scipy_zgesv": lambda: loop(lambda z: scipy.linalg.lapack.zgesv(z, H)[2]),
    }
    try:
        from pyyeti import ode
    except ImportError:
        return ways
    # Complex poles of the coupled equations, pyYeti's way to frequency responses.
    ways["pyyeti"] = lambda: ode.SolveUnc(A, B, K).fsolve(np.repeat(H[:, None], len(p), axis=1), p / (2 * np.pi)).d
    return ways


serve(read)
