// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

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

}  // namespace trivet::excitation
