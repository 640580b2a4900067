// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <complex>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "trivet/elements/viscoelastic.h"
#include "trivet/identification/hysteresis_loop.h"

namespace trivet::identification {

/// Dynamic stiffness measured at one frequency.
struct StiffnessPoint {
  double angular_frequency = 0;    ///< [rad/s] > 0
  std::complex<double> stiffness;  ///< k' + ik'' [N/m]
  /// Of the real and of the imaginary part [N/m]. If any point has none, all weights are 1/|k|: equal relative errors.
  double standard_deviation = std::numeric_limits<double>::quiet_NaN();
};

/// Points of the loops with known frequency. Their standard deviations are used only on request: the differences
/// between laws are usually larger than the noise of one loop. Warns if loops at one frequency and different amplitudes
/// differ in stiffness.
[[nodiscard]] std::vector<StiffnessPoint> stiffness_points(const std::vector<LoopFit>& loops, bool with_deviations,
                                                           foundation::Problems& problems);

/// A parameter and its confidence interval; a limit is 0 or infinity if the data do not determine it.
struct Parameter {
  std::string name;  ///< "stiffness", "loss_factor", "time", "ratio", "order"
  std::string unit;
  double value = 0, low = 0, high = 0;
};

/// One law fitted to k*(ω): k(1 + iη) (hysteretic), or stiffness times a viscoelastic law's relative modulus.
struct LawFit {
  std::string law;                    ///< "hysteretic", "viscous (Kelvin–Voigt)", "Zener", "fractional Zener"
  double stiffness = 0;               ///< [N/m], relaxed (ω → 0) for viscoelastic laws
  std::optional<double> loss_factor;  ///< of the hysteretic law
  std::optional<elements::Viscoelastic> viscoelastic;  ///< of the others
  std::vector<Parameter> parameters;
  double relative_rms = 0;       ///< rms over the points of |k_law − k|/|k|
  double akaike = 0;             ///< corrected criterion AICc from the weighted residuals; lower is better; perhaps NaN
  double akaike_difference = 0;  ///< to the best law; above 10 the data clearly contradict this one
  bool converged = false;
};

struct LawRanking {
  std::vector<LawFit> laws;       ///< the best first
  foundation::Problems warnings;  ///< laws omitted because of too few points, open intervals
};

[[nodiscard]] std::complex<double> stiffness_at(const LawFit& law, double angular_frequency);

/// Fewest points from which laws are ranked.
inline constexpr std::size_t fewest_ranked_points = 3;

/// Fits the law of this name (as in LawFit) alone. One point determines the two constants of the hysteretic and of the
/// viscous law, two points at different frequencies those of the Zener law, three those of the fractional one; without
/// more points the limits of the constants are open, and there is no criterion (NaN). Problems as for `fitted_laws`.
[[nodiscard]] foundation::Expected<LawFit> fitted_law(const std::string& law, const std::vector<StiffnessPoint>& points,
                                                      double confidence = 0.95);

/// Fits the laws to k*(ω) and ranks them. Problems: fewer than three points (four for the fractional law, which is
/// otherwise omitted), frequencies not > 0, values not finite, nonpositive deviations, a mean stiffness or loss that is
/// not > 0.
/// @param confidence  of the intervals, in (0, 1)
[[nodiscard]] foundation::Expected<LawRanking> fitted_laws(const std::vector<StiffnessPoint>& points,
                                                           double confidence = 0.95);

}  // namespace trivet::identification
