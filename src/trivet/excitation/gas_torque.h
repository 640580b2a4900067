// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <complex>
#include <string>
#include <vector>

#include "trivet/excitation/engine.h"
#include "trivet/foundation/problems.h"

namespace trivet::excitation {

/// Harmonic of the torque that the gas of one cylinder gives to the crank, Re(torque · e^{i order φ}), φ = crank angle
/// after its firing top dead centre. `order` counts per turn of the crank: multiples of ½ with four strokes. Order 0 is
/// the mean, a real number.
struct TorqueHarmonic {
  double order = 0;
  std::complex<double> torque;  ///< [N m]
};

/// Pressure in a cylinder above that of the crankcase [Pa] over φ [rad], straight lines between; closed by a line from
/// the last to the first point one cycle later.
struct PressureTrace {
  std::vector<double> angles;  ///< increasing, over at most one cycle
  std::vector<double> pressures;
};

/// Errors: unequal counts, fewer than three points, not finite, angles that do not increase or span more than a cycle,
/// a gap of more than 30° to be closed. Warning: a trace over a whole cycle whose ends differ, which jumps there.
[[nodiscard]] foundation::Problems check(const PressureTrace& trace, double cycle, const std::string& subject);

/// All harmonics up to `highest_order` of −p A s′(φ), exact for the straight lines and the whole series of the crank
/// drive.
/// @param bore  diameter of the cylinder [m] > 0
/// @throws foundation::InvalidInput with the first error of the engine or the trace
[[nodiscard]] std::vector<TorqueHarmonic> gas_harmonics(const PressureTrace& trace, const Engine& engine, double bore,
                                                        double highest_order);

}  // namespace trivet::excitation
