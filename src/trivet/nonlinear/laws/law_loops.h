// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/model/system.h"

namespace trivet::nonlinear {

/// The force of the laws of one nonlinear part under a slow sine of the deflection about rest, after the loop has
/// closed: in addition to the linear element, without its dampers; bristles at rates far below their Stribeck velocity.
struct LawLoop {
  double amplitude = 0;                     ///< of the deflection [m, rad]
  std::vector<double> deflections, forces;  ///< of one period from the largest deflection, whole ones [m, N; rad, N m]
  double storage = 0, loss = 0;             ///< stiffness of the first harmonic in phase and in quadrature
  double energy = 0;                        ///< lost per period [J]
};

/// Loops from a twentieth of the deflection at which the laws show themselves up to it.
/// @param own_stiffness  of the linear element along the part
[[nodiscard]] std::vector<LawLoop> law_loops(const model::NonlinearPart& part, double own_stiffness);

}  // namespace trivet::nonlinear
