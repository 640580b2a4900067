# SPDX-License-Identifier: BSD-3-Clause
"""Largest |q_j| over 500 frequencies of many designs in Python: NumPy batched over designs and frequencies, and by poles."""
import numpy as np
from serve import numbers, serve


def read():
    A, B, K = (np.ascontiguousarray(numbers(name, 36).T).reshape(-1, 6, 6) for name in "ABK")
    H, p = numbers("H", 6)[:, 0], numbers("p", 1)[0]

    def in_pieces(highest, size):
        return np.concatenate([highest(slice(d, d + size)) for d in range(0, len(A), size)]).T

    def batched(some):
        a, b, k = (x[some, None] for x in (A, B, K))
        q = np.linalg.solve(k - (p**2)[:, None, None] * a + 1j * p[:, None, None] * b, H[None, None, :, None])
        return abs(q[..., 0]).max(axis=1)

    def modal(some):
        a, b, k = A[some], B[some], K[some]
        state = np.zeros((len(a), 12, 12))
        state[:, :6, 6:] = np.eye(6)
        state[:, 6:] = -np.linalg.solve(a, np.concatenate([k, b], axis=2))
        values, vectors = np.linalg.eig(state)
        start = np.zeros((len(a), 12, 1))
        start[:, 6:] = np.linalg.solve(a, np.broadcast_to(H[:, None], (len(a), 6, 1)))
        residues = vectors[:, :6] * np.linalg.solve(vectors, start).transpose(0, 2, 1)
        return abs(residues @ (1 / (1j * p - values[:, :, None]))).max(axis=2)

    return {"batched": lambda: in_pieces(batched, 40), "modal": lambda: in_pieces(modal, 20)}


serve(read)
