# SPDX-License-Identifier: BSD-3-Clause
"""The package with NumPy alone: it computes, shows itself, and uses only libraries that came with it or belong to every
Linux (the C library, those of the compiler, zlib and Expat)."""

import pathlib
import re
import sys

import numpy as np

import trivet

machine = trivet.Project(
    bodies={"machine": {"mass": "250 lb", "inertia": {"about": "center_of_mass", "xx": 4, "yy": 5, "zz": 6}}},
    elements={
        name: {"type": "bushing", "on": "machine", "at": [x, y, "-4 in"], "translation": ["200 lbf/in"] * 3}
        for name, x, y in (("a", -0.3, -0.2), ("b", 0.3, -0.2), ("c", -0.3, 0.2), ("d", 0.3, 0.2))
    },
    excitations={"force": {"type": "harmonic", "on": "machine", "at": [0, 0, 0], "force": [0, 0, 10]}},
)
vertical = float(machine.modes().angular_frequency[2])
assert abs(vertical / np.sqrt(4 * 200 * 4.4482216152605 / 0.0254 / (250 * 0.45359237)) - 1) < 1e-12, vertical
assert "machine.z" in machine.response(band=("0 Hz", "40 Hz")).names
assert "<table" in machine._repr_html_() + machine.peaks()._repr_html_()
assert not {"pandas", "matplotlib", "xarray", "pint"} & set(sys.modules)

of_every_linux = re.compile(r"/(lib(c|m|dl|pthread|rt|util)\.so|libstdc\+\+\.so|libgcc_s\.so|ld-linux)")
used = {line.split()[-1] for line in pathlib.Path("/proc/self/maps").read_text().splitlines() if ".so" in line}
ours = {path for path in used if "trivet" in path}
numpy_or_python = {path for path in used if "numpy" in path or "python" in path or sys.base_prefix + "/lib" in path}
foreign = {path for path in used - ours - numpy_or_python if not of_every_linux.search(path)}
print(f"NumPy {np.__version__}, Python {sys.version.split()[0]}; libraries of the system: {sorted(foreign) or 'none'}")
assert not {path for path in foreign if re.search(r"nlopt|fmt|toml|libmd|hdf5|xlsxwriter", path)}, foreign
