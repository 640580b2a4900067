// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/piecewise_stiffness.h"

#include <algorithm>

#include "trivet/foundation/index.h"

namespace trivet::elements {

PiecewiseStiffness::PiecewiseStiffness(const StiffnessTable& table) : knots_(table.angular_frequencies) {
  for (std::size_t i = 0; i + 1 < knots_.size(); ++i) {
    const double from = knots_[i], width = knots_[i + 1] - from;
    std::array<std::complex<double>, 4> samples;
    for (int k = 0; k < 4; ++k)
      samples[k] = dynamic_stiffness(table, k == 3 ? knots_[i + 1] : from + width * k / 3.0, 0);
    pieces_.push_back(samples);
  }
}

std::complex<double> PiecewiseStiffness::at(std::complex<double> omega, double near) const {
  const auto above = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, near);
  const std::size_t i = to_size(above - knots_.begin()) - 1;
  const std::complex<double> t = 3.0 * (omega - knots_[i]) / (knots_[i + 1] - knots_[i]);
  // Lagrange's form.
  std::complex<double> sum = 0;
  for (int j = 0; j < 4; ++j) {
    std::complex<double> term = pieces_[i][j];
    for (int k = 0; k < 4; ++k)
      if (k != j) term *= (t - double(k)) / double(j - k);
    sum += term;
  }
  return sum;
}

}  // namespace trivet::elements
