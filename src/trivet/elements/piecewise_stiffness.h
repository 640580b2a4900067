// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <complex>
#include <vector>

#include "trivet/elements/table_law.h"

namespace trivet::elements {

/// k*(ω) of a table without amplitudes as a piecewise cubic in ω, each piece continued to complex ω.
class PiecewiseStiffness {
 public:
  explicit PiecewiseStiffness(const StiffnessTable& table);

  /// Value by the piece at the real frequency `near` [rad/s]; the end pieces also apply beyond the ends.
  [[nodiscard]] std::complex<double> at(std::complex<double> omega, double near) const;

 private:
  std::vector<double> knots_;
  std::vector<std::array<std::complex<double>, 4>> pieces_;  ///< values at four equidistant frequencies of each
};

}  // namespace trivet::elements
