// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/periodic/level_crossings.h"

#include <algorithm>
#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/numerics/periodic/fourier_basis.h"

namespace trivet::numerics {

using Eigen::Index;
using Eigen::VectorXd;
using foundation::two_pi;

double crossing_between(const VectorXd& motion, const VectorXd& rate, double level, double low, double high) {
  const Index harmonics = (motion.size() - 1) / 2;
  const auto at = [&](double phase) { return motion_at(harmonics, phase, motion) - level; };
  double value_low = at(low), phase = (low + high) / 2;
  constexpr int most = 80;
  for (int i = 0; i < most && high - low > 1e-15 * two_pi; ++i) {
    const double value = at(phase);
    if (value == 0) return phase;
    if ((value < 0) == (value_low < 0)) {
      low = phase;
      value_low = value;
    } else {
      high = phase;
    }
    const double newton = phase - value / motion_at(harmonics, phase, rate);
    const double next = newton > low && newton < high ? newton : (low + high) / 2;
    if (std::abs(next - phase) < 1e-16 * two_pi) return next;
    phase = next;
  }
  return phase;
}

std::vector<double> level_crossings(const VectorXd& motion, const std::vector<double>& levels,
                                    const Eigen::Ref<const Eigen::MatrixXd>& samples) {
  const Index harmonics = (motion.size() - 1) / 2;
  const VectorXd rate = phase_derivative(motion), curvature = phase_derivative(rate);
  const VectorXd course = samples * motion, rates = samples * rate;
  const double step = two_pi / static_cast<double>(course.size());
  std::vector<std::pair<double, double>> places;  // phase and value: samples and extrema
  for (Index n = 0; n < course.size(); ++n) {
    const double phase = step * static_cast<double>(n);
    places.emplace_back(phase, course(n));
    if ((rates(n) < 0) == (rates((n + 1) % course.size()) < 0)) continue;
    const double extremum = crossing_between(rate, curvature, 0, phase, phase + step);
    places.emplace_back(extremum, motion_at(harmonics, extremum, motion));
  }
  places.emplace_back(two_pi, course(0));
  std::vector<double> phases;
  for (std::size_t i = 0; i + 1 < places.size(); ++i)
    for (const double level : levels)
      if ((places[i].second < level) != (places[i + 1].second < level))
        phases.push_back(crossing_between(motion, rate, level, places[i].first, places[i + 1].first));
  std::sort(phases.begin(), phases.end());
  return phases;
}

}  // namespace trivet::numerics
