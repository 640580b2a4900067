// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <complex>
#include <string>
#include <vector>

#include "trivet/foundation/problems.h"

namespace trivet::identification {

/// Measured k*(ω), one direction: angular frequencies [rad/s] > 0, increasing; stiffness k' + ik'' [N/m].
struct DynamicStiffnessTable {
  Eigen::VectorXd angular_frequency;
  Eigen::VectorXcd stiffness;
};

/// Problems of a table. Errors: columns of different length, fewer than two rows, entries that are not finite,
/// frequencies not > 0, not increasing or repeated. Warning: negative loss.
[[nodiscard]] foundation::Problems table_problems(const DynamicStiffnessTable& table);

/// Stiffness between the rows; real and imaginary part are linear in ln ω.
/// @throws InvalidInput outside the band of the table, or for a table with errors
[[nodiscard]] std::complex<double> interpolated_stiffness(const DynamicStiffnessTable& table, double angular_frequency);

/// A passive, causal stiffness, s = iω: static + viscous s + mass s² + Σ branches_i s times_i/(1 + s times_i)
/// + Σ s (inertial_j s + elastic_j (s + 2ζω))/(s² + 2ζωs + ω²), every constant ≥ 0.
struct PassiveStiffness {
  double static_stiffness = 0;     ///< [N/m]
  double viscous_coefficient = 0;  ///< [N s/m]
  double mass = 0;                 ///< [kg]
  Eigen::VectorXd branches;        ///< [N/m]
  Eigen::VectorXd times;           ///< [s]
  struct Resonance {
    double angular_frequency = 0, damping_ratio = 0;
    double inertial = 0, elastic = 0;  ///< [N/m]
  };
  std::vector<Resonance> resonances;
};
[[nodiscard]] std::complex<double> stiffness_at(const PassiveStiffness& passive, double angular_frequency);

struct CausalityOptions {
  /// Relative misfit (rms over the band) up to which the table passes; should be above its noise.
  double tolerance = 0.05;
};

/// Verdict on a table. `too_coarse`: only a resonance narrower than the row spacing explains it.
enum class Causality { relaxing, resonant, too_coarse, impossible };

/// Consistency of k' and k''. Causality determines each from the other over all frequencies (Kramers and Kronig); over
/// a finite band, the nearest passive, causal stiffness replaces the integrals. First only relaxations are tried, then
/// also internal resonances and inertia, as far as the rows can resolve them.
struct CausalityCheck {
  Causality kind = Causality::impossible;
  PassiveStiffness nearest;
  Eigen::VectorXcd fitted;  ///< of `nearest` at the frequencies of the table
  Eigen::VectorXd misfit;   ///< |fitted − k*|/|k*| per frequency
  double relative_rms = 0;  ///< of the misfit
  Eigen::Index worst = 0;   ///< row of the largest misfit
  bool passes = false;      ///< relaxing or resonant
  std::string verdict;      ///< a sentence with numbers
  foundation::Problems warnings;
};

/// Recommended action for a table that does not pass.
[[nodiscard]] std::string remedy(Causality kind);

/// @throws InvalidInput if the tolerance is not > 0
[[nodiscard]] foundation::Expected<CausalityCheck> causality(const DynamicStiffnessTable& table,
                                                             const CausalityOptions& options = {});

}  // namespace trivet::identification
