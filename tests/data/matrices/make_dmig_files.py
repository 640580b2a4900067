# SPDX-License-Identifier: BSD-3-Clause
"""Writes the DMIG files of this folder from chain.npy and beam_complex.npy; run it here with pyNastran 1.4."""
import io

import numpy as np
from pyNastran.bdf.bdf import BDF


def write(file_name, name, matrix, nodes, form, number_type, size, is_double):
    rows = [(node, component) for node in nodes for component in range(1, 7)]
    entries = [
        (i, j) for j in range(len(rows)) for i in range(len(rows)) if matrix[i, j] != 0 and (form != 6 or i >= j)
    ]
    model = BDF(debug=False)
    values = np.array([matrix[i, j] for i, j in entries])
    arguments = {"Complex": values.imag} if number_type > 2 else {}
    model.add_dmig(
        name,
        form,
        number_type,
        0,
        0,
        len(rows),
        [rows[j] for i, j in entries],
        [rows[i] for i, j in entries],
        values.real,
        **arguments,
    )
    text = io.StringIO()
    for card in model.dmig.values():
        text.write(card.write_card(size, is_double))
    with open(file_name, "w") as file:
        file.write("$ written by pyNastran\n" + text.getvalue())


chain, lossy = np.load("chain.npy"), np.load("beam_complex.npy")
write("chain_large.pch", "KAAX", chain, [11, 12, 13, 14, 15], 6, 2, 16, True)
write("chain_small.bdf", "STIF", chain, [11, 12, 13, 14, 15], 1, 1, 8, False)
write("beam_complex.pch", "K4XX", lossy, [3, 7], 6, 4, 16, True)
