// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Forces that depend on the amplitude of a periodic deflection. They are known for steady motion only.
namespace trivet::elements {

/// Stiffness and loss of filled rubber over the amplitude A [Kraus 1984], in addition to those at large amplitudes:
/// k' = Δ/(1 + (A/A_c)^2m),  k'' = 2 L (A/A_c)^m/(1 + (A/A_c)^2m).
/// The loss has its largest value L at A_c, and vanishes for small and for large amplitudes.
struct PayneForce {
  double stiffness = 0;   ///< Δ: k' of small amplitudes less that of large ones [N/m or N m/rad], ≥ 0
  double loss = 0;        ///< L [N/m or N m/rad], ≥ 0
  double amplitude = 0;   ///< A_c [m or rad], > 0
  double exponent = 0.6;  ///< m, > 0
};

/// Complex stiffness k' + i k'' and its derivative by the amplitude.
struct StiffnessOfAmplitude {
  double storage = 0, loss = 0, storage_slope = 0, loss_slope = 0;
};
/// @param amplitude  ≥ 0; slopes at 0 are those just above it
[[nodiscard]] StiffnessOfAmplitude stiffness_at(const PayneForce& law, double amplitude);

}  // namespace trivet::elements
