// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/elements/coil_spring.h"

namespace trivet::elements {

/// Stress correction factors of round wire for the index C = D/d > 1, at the inside of the coil.
[[nodiscard]] double wahl_factor(double index);           ///< (4C − 1)/(4C − 4) + 0.615/C
[[nodiscard]] double bergstraesser_factor(double index);  ///< (C + ½)/(C − ¾), that of EN 13906-1

/// Torsional shear stress [Pa] of the wire under an axial force [N] of either sign, as for a straight wire: 8 F D/(π
/// d³) for round wire, at the middle of the longer side for rectangular wire. Not negative.
[[nodiscard]] double nominal_shear_stress(const CoilSpring& spring, double axial_force);

/// The same times Wahl's factor, for fatigue.
/// @throws InvalidInput for rectangular wire, to which the factor does not apply
[[nodiscard]] double wahl_shear_stress(const CoilSpring& spring, double axial_force);

}  // namespace trivet::elements
