// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <complex>
#include <string>
#include <vector>

#include "trivet/excitation/engine.h"
#include "trivet/foundation/problems.h"

namespace trivet::excitation {

/// Harmonic of the gas torque of one cylinder on the crank, Re(torque · e^{i order φ}), φ = crank angle after its
/// firing top dead centre. `order` is per turn of the crank: multiples of ½ with four strokes. Order 0 is the mean, a
/// real number.
struct TorqueHarmonic {
  double order = 0;
  std::complex<double> torque;  ///< [N m]
};

/// Cylinder pressure minus crankcase pressure [Pa] over φ [rad], linear between the points; closed by a line from the
/// last to the first point one cycle later.
struct PressureTrace {
  std::vector<double> angles;  ///< increasing, over at most one cycle
  std::vector<double> pressures;
};

/// Errors: unequal counts, fewer than three points, numbers not finite, angles that do not increase or span more than a
/// cycle, a gap of more than 30° to be closed. Warning: a trace over a whole cycle with different end values (a jump).
[[nodiscard]] foundation::Problems check(const PressureTrace& trace, double cycle, const std::string& subject);

/// Harmonics of −p A s′(φ) up to `highest_order`, exact for the straight lines and the whole series of the crank drive.
/// @param bore  diameter of the cylinder [m] > 0
/// @throws foundation::InvalidInput with the first error of the engine or the trace
[[nodiscard]] std::vector<TorqueHarmonic> gas_harmonics(const PressureTrace& trace, const Engine& engine, double bore,
                                                        double highest_order);

}  // namespace trivet::excitation
