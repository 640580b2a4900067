// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <complex>
#include <string>
#include <vector>

#include "trivet/excitation/engine.h"
#include "trivet/foundation/problems.h"

namespace trivet::excitation {

/// Fourier series of the piston of a central slider-crank. The piston is at s(φ) = r cos φ + l √(1 − λ² sin²φ) from
/// the crank axis, φ from top dead centre, and −s″(φ)/r = Σ aₙ cos nφ: a₁ = 1, a₂ = λ + λ³/4 + 15λ⁵/128 + …, a₄ = −λ³/4
/// − …, odd ones above 1 are 0.
/// @param rod_ratio  λ = crank radius / length of the rod, 0 < λ < 1
/// @return a₀ … a_highest (a₀ = 0), each with its whole series in λ [Taylor, The Internal-Combustion Engine, volume 2;
/// Den Hartog, Mechanical Vibrations]
[[nodiscard]] std::vector<double> inertia_coefficients(double rod_ratio, int highest);

/// Order beyond which all coefficients are below 1e-18 of a₁.
[[nodiscard]] int negligible_order(double rod_ratio);

/// Coefficients g₀ … g_highest of s′(φ)s″(φ)/r² = Σ gₙ sin nφ: an oscillating mass m exerts the torque −m r² Ω² Σ gₙ
/// sin nφ on the crank.
[[nodiscard]] std::vector<double> inertia_torque_coefficients(double rod_ratio, int highest);

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
