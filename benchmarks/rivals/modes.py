# SPDX-License-Identifier: BSD-3-Clause
"""K v = λ A v of many designs in Python: SciPy in a loop, NumPy batched."""
import numpy as np
import scipy.linalg
from serve import numbers, serve


def read():
    A, K = (np.ascontiguousarray(numbers(name, 36).T).reshape(-1, 6, 6) for name in "AK")

    def loop():
        return np.array([scipy.linalg.eigh(k, a)[0] for k, a in zip(K, A)]).T

    def batched():
        lower = np.linalg.cholesky(A)
        half = np.linalg.solve(lower, K)
        values, vectors = np.linalg.eigh(np.linalg.solve(lower, half.transpose(0, 2, 1)))
        np.linalg.solve(lower.transpose(0, 2, 1), vectors)
        return values.T

    return {"loop": loop, "batched": batched}


serve(read)
