# SPDX-License-Identifier: BSD-3-Clause
"""Writes generic.toml: bonded rubber discs by their closed forms (docs/elements/catalogue.md).   python3 make_generic.py > generic.toml"""
import math

BULK_MODULUS = 2.0e9  # Pa, filled natural rubber
RUBBER, STEEL = 1100.0, 7850.0  # kg/m3
PLATE = 0.003  # m, each of the two bonded plates
DEFLECTION = 0.10  # of the rubber height, in compression
LOSS_FACTOR = {40: 0.05, 55: 0.08, 70: 0.14}  # assumed, typical of natural rubber with rising carbon black
SIZES = [(20, 10), (30, 15), (40, 20), (50, 25), (50, 20), (75, 25), (100, 40)]  # mm, shape factors 0.5 … 0.75


def young_modulus(shore_a):
    """Gent, Rubber Chemistry and Technology 31 (1958): Pa from Shore A."""
    return 1e6 * 0.0981 * (56 + 7.62336 * shore_a) / (0.137505 * (254 - 2.54 * shore_a))


def mount(diameter, height, shore_a):
    r, h = diameter / 2000, height / 1000
    e = young_modulus(shore_a)
    g, area, inertia, shape = e / 3, math.pi * r * r, math.pi * r**4 / 4, r / (2 * h)
    compression = 1 / (1 / (e * (1 + 2 * shape**2)) + 1 / BULK_MODULUS) * area / h
    shear = g * area / h / (1 + h * h * area / (36 * inertia))  # the layer bends too
    tilt = e * (1 + 2 * shape**2 / 3) * inertia / h
    torsion = g * 2 * inertia / h
    mass = area * (RUBBER * h + STEEL * 2 * PLATE)
    limit = DEFLECTION * h
    return f"""
[mounts."disc {diameter}x{height} {shore_a} ShA"]
maker = "generic"
translation = ["{shear / 1e3:.3g} N/mm", "{shear / 1e3:.3g} N/mm", "{compression / 1e3:.4g} N/mm"]
rotation = ["{tilt:.3g} N m/rad", "{tilt:.3g} N m/rad", "{torsion:.3g} N m/rad"]
loss_factor = {LOSS_FACTOR[shore_a]}
static_load = ["0 N", "{compression * limit:.3g} N"]
static_deflection_limit = "{limit * 1000:.3g} mm"
mass = "{mass * 1000:.3g} g"
"""


print(
    '''# Generic mounts: NO MAKER'S DATA. Rubber discs between two bonded steel plates, from closed forms for a disc of linear rubber;
# good for a first layout, to about 5 % in compression and shear and 10 % in tilting of an ideal disc. A real mount
# differs by its
# rubber by 20 % and more: take the numbers of its maker, or measure it. How they were computed:
# docs/elements/catalogue.md.
catalogue = 1
title = "Generic bonded rubber discs"
source = "closed forms, computed by make_generic.py; no maker's data"'''
)
for hardness in LOSS_FACTOR:
    for size in SIZES:
        print(mount(*size, hardness), end="")
