# SPDX-License-Identifier: BSD-3-Clause
"""Writes the NumPy and Matrix Market files of this folder; run it here with NumPy 1.24 and SciPy 1.10."""
import numpy as np
import scipy.io
import scipy.sparse

# A steel bar 20 mm x 10 mm along z in mm, N: Bernoulli beam, four elements of 30 mm, five nodes.
E, G, A, IX, IY, J, LENGTH, ELEMENTS = 210e3, 80e3, 200.0, 1666.6666666666667, 6666.6666666666667, 4577.0, 30.0, 4


def beam(length):
    """12 x 12 in the order (u_N, theta_N, u_K, theta_K), axis along z."""
    k = np.zeros((12, 12))

    def put(rows, block):
        k[np.ix_(rows, rows)] += block

    rod = np.array([[1, -1], [-1, 1]])
    put([2, 8], E * A / length * rod)
    put([5, 11], G * J / length * rod)
    for inertia, rows, sign in ((IY, [0, 4, 6, 10], 1), (IX, [1, 3, 7, 9], -1)):
        s, l = sign, length
        bending = np.array(
            [
                [12, s * 6 * l, -12, s * 6 * l],
                [s * 6 * l, 4 * l * l, -s * 6 * l, 2 * l * l],
                [-12, -s * 6 * l, 12, -s * 6 * l],
                [s * 6 * l, 2 * l * l, -s * 6 * l, 4 * l * l],
            ]
        )
        put(rows, E * inertia / l**3 * bending)
    return k


def chain():
    k = np.zeros((6 * (ELEMENTS + 1),) * 2)
    for i in range(ELEMENTS):
        k[6 * i : 6 * i + 12, 6 * i : 6 * i + 12] += beam(LENGTH)
    return k


whole = beam(LENGTH * ELEMENTS)
lossy = whole * (1 + 0.02j)
np.save("beam.npy", whole)
np.save(
    "beam_by_columns.npy", np.asfortranarray(whole + np.triu(np.ones((12, 12))))
)  # unsymmetric, to detect a wrong order
np.save("beam_complex.npy", lossy)
np.save("chain.npy", chain())
with open("beam_version_2.npy", "wb") as file:
    np.lib.format.write_array(file, whole, version=(2, 0))
with open("beam_version_3.npy", "wb") as file:
    np.lib.format.write_array(file, whole, version=(3, 0))
scipy.io.mmwrite("beam_coordinate_symmetric.mtx", scipy.sparse.coo_matrix(whole), symmetry="symmetric", precision=16)
scipy.io.mmwrite("beam_coordinate_general.mtx", scipy.sparse.coo_matrix(whole), symmetry="general", precision=16)
scipy.io.mmwrite("beam_array_symmetric.mtx", whole, symmetry="symmetric", precision=16)
scipy.io.mmwrite("beam_array_general.mtx", whole + np.triu(np.ones((12, 12))), symmetry="general", precision=16)
scipy.io.mmwrite("beam_complex.mtx", scipy.sparse.coo_matrix(lossy), symmetry="symmetric", precision=16)
scipy.io.mmwrite("chain.mtx", scipy.sparse.coo_matrix(chain()), symmetry="symmetric", precision=16)
np.savetxt("beam.csv", whole, delimiter=",", fmt="%.17g", header="beam 12 x 12 in mm, N")
np.savetxt("beam_semicolon.csv", whole, delimiter=";", fmt="%.17g")
