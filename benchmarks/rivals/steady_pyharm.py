# SPDX-License-Identifier: BSD-3-Clause
"""Curve of steady motion of a mass on a cubic spring in pyHarm, if it is present: harmonic balance with sampled forces and
analytic tangents, pseudo arc length; folds from signs of determinants, no stability. The answer: amplitude of the first
harmonic of the deflection at the end of the band."""
import logging
import os
import warnings

import numpy as np
from serve import folder, numbers, serve


def read():
    os.environ["PYHARM_CONTEXT_FILE"] = str(folder / "pyharm.json")  # pyHarm writes it to the current folder otherwise
    logging.disable(logging.WARNING)
    warnings.filterwarnings("ignore", message=".*contiguous arrays")  # Numba's advice about products of pyHarm
    try:
        from pyHarm import Maestro
    except ImportError:
        return {}
    coordinates, deflections, harmonics = np.fromfile(folder / "sizes").astype(int)
    if coordinates != 1 or deflections != 1:
        raise ValueError("one coordinate with one deflection expected")
    A, B, K = (numbers(name, 1) for name in "ABK")
    (across,), (force,) = np.fromfile(folder / "W"), np.fromfile(folder / "force")
    cubic, low, high = np.fromfile(folder / "scalars")
    cubic *= across**4
    # Units in which the curve is about as high as wide: the length at which the linear and the cubic force are equal.
    length, natural_frequency = np.sqrt(K[0, 0] / cubic), np.sqrt(K[0, 0] / A[0, 0])
    ends = [("mass", [0]), ("GROUND", [0])]
    units = {"status": True, "lc": length, "wc": natural_frequency}
    band = {"study": "frf", "puls_inf": low, "puls_sup": high, "verbose": False}
    tight = {"root": {"method": "hybr", "tol": 1e-12}}
    problem = {
        "system": {"type": "Base", "nh": int(harmonics), "nti": 32, "adim": units},
        "substructures": {"mass": {"matrix": {"M": A, "C": B, "K": K}, "ndofs": 1}},
        "connectors": {
            "spring": {"type": "CubicSpring", "connect": ends, "dirs": [0], "k": cubic},
            "force": {"type": "CosinusForcing", "connect": ends, "dirs": [0], "amp": force},
        },
        "analysis": {
            "curve": band | {"corrector": "pseudo_arc_length", "ds0": 0.0185, "ds_max": 0.0185},  # about 150 points
            "end": band | {"puls_start": high / natural_frequency, "solver_options": tight},
        },
    }

    def curve():
        maestro = Maestro(problem)
        analysis, end = maestro.nls["curve"], maestro.nls["end"]
        analysis.Solve()
        if sum(point.flag_bifurcation for point in analysis.SolList) != 2:
            raise ValueError("two folds expected")
        end.initialise(analysis.SolList[-1].x[:-1])  # the last point is the first one beyond the band
        _, cosine, sine = end.SolList[0].x[:3]
        return length * abs(across) * np.hypot(cosine, sine)

    return {"curve": curve}


serve(read)
