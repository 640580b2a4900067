# SPDX-License-Identifier: BSD-3-Clause
"""The paper's question in five steps: which stiffness and damping keep every amplitude below its limit, without a
resonance peak? Run it as a script, or cell by cell in a notebook."""

# %% 1. The machine: an aggregate of 205 kg on three rubber-metal elements, given by their full 6×6 stiffness.
import pathlib
import warnings

import numpy as np

import trivet

warnings.simplefilter("ignore", trivet.ModelWarning)  # the last step shows them
project = trivet.open(pathlib.Path(__file__).parents[1] / "paper" / "map.toml")
print(project)

# %% 2. Its natural frequencies and exact resonance peaks.
frequencies = project.modes().frequency_hz
print("natural frequencies [Hz]:", np.round(frequencies, 3))
peaks = project.peaks()
highest = int(np.argmax(peaks.array("amplitude")))
print("highest peak:", peaks.array("amplitude")[highest], "at", peaks.angular_frequency[highest], "rad/s")

# %% 3. More damping, as in the paper's figures: the peaks become lower, and some disappear.
for damping in (0.05, 0.1, 0.15, 0.3):
    damped = project.changed({"elements.suspension.damping.proportional": damping})
    print(f"δ = {damping} s: {len(damped.peaks().angular_frequency)} peaks")

# %% 4. All combinations of stiffness and damping at once, without a loop in Python.
sweep = project.sweep(
    {
        "elements.suspension.scale": np.geomspace(0.3, 10, 80),
        "elements.suspension.damping.proportional": np.geomspace(0.01, 0.5, 60),
    },
    of="coordinates",
)
limits = np.array([0.020, 0.020, 0.020, 0.0205, 0.0205, 0.0205])  # [m], [rad]
within = np.all(sweep.amplitude <= limits, axis=-1)
print(f"{within.mean():.0%} of {within.size} designs keep every amplitude below its limit")

# %% 5. The answer: the map of limits and peaks, and the best design with its margin.
result = project.map(points=60)
found = result.to_dict()
print(result)
for warning in result.warnings:
    print(warning)
assert 0 < within.mean() < 1
assert len(found) > 0
