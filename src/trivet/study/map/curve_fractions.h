// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "trivet/assembly/assembled.h"
#include "trivet/assembly/band.h"
#include "trivet/assembly/channels.h"
#include "trivet/assembly/loads.h"

namespace trivet::study {

/// The form of the curves of one design, from its poles and residues, a fraction of second order for each pair of
/// poles: y_c(s) = Σ_d e^{−s delay_d} (Σ_k (a_ck + b_ck s)/(p_k + q_k s + s²) + Σ_m power_cm s^m), s = iω.
struct CurveForm {
  Eigen::Index curves = 0, pairs = 0;
  std::vector<double> delays;  ///< [s], at least one
  std::vector<int> powers;     ///< m, ascending

  /// Numbers of one curve and delay: a_1, b_1, a_2, … and then one for each power.
  [[nodiscard]] Eigen::Index terms() const { return 2 * pairs + static_cast<Eigen::Index>(powers.size()); }
  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(delays.size()) * curves * terms(); }
  /// Values of all curves at ω [rad/s].
  /// @param denominators  p_1, q_1, p_2, …  @param numerators  `terms()` of each curve with the first delay, then those
  /// with the next
  [[nodiscard]] Eigen::VectorXcd at(const Eigen::VectorXcd& denominators, const Eigen::VectorXcd& numerators,
                                    double omega) const;
};

/// Largest deviation of curves from poles and residues that are shown.
inline constexpr double curves_within = 1e-4;

/// The curves of one design with all powers of s that an expansion has.
struct CurveFractions {
  CurveForm form;
  bool real = true;  ///< all numbers are real
  Eigen::VectorXcd denominators, numerators;
  double error = std::numeric_limits<double>::infinity();  ///< of the numbers as they are, see `curve_fractions`
  double rounded_error = std::numeric_limits<double>::infinity();  ///< with numerators of 24 bits
};

/// Curves from poles and residues, compared with direct solutions at some frequencies around the poles and over a band;
/// deviations are relative to the value, or to a millionth of the highest of its curve, or to 1e-10 of the highest of
/// all curves of its unit: below it is round-off. Infinite with a double pole and
/// for a load with other delays.
/// @param assembled  of constant matrices  @throws foundation::NotComputable if the poles cannot be computed
[[nodiscard]] CurveFractions curve_fractions(const assembly::Assembled& assembled,
                                             const std::vector<assembly::Channel>& channels,
                                             const assembly::Loading& loading, const assembly::Band& band,
                                             const std::vector<double>& delays);

/// Numbers rounded to 24 bits.
[[nodiscard]] Eigen::MatrixXcd rounded(const Eigen::MatrixXcd& numbers);

}  // namespace trivet::study
