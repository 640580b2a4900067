// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/periodic/level_crossings.h"

#include <algorithm>
#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/periodic/fourier_basis.h"

namespace trivet::numerics {

using Eigen::Index;
using Eigen::VectorXd;
using foundation::two_pi;

namespace {

struct ValueAndRate {
  double value, rate;  ///< rate: by the phase
};
ValueAndRate above_level(double phase, const VectorXd& motion, double level) {
  const double c = std::cos(phase), s = std::sin(phase);
  ValueAndRate sum{motion(0) - level, 0};
  double ck = 1, sk = 0;
  for (Index k = 1; 2 * k < motion.size(); ++k) {
    const double next = ck * c - sk * s;
    sk = sk * c + ck * s;
    ck = next;
    const double a = motion(2 * k - 1), b = motion(2 * k);
    sum.value += a * ck + b * sk;
    sum.rate += static_cast<double>(k) * (b * ck - a * sk);
  }
  return sum;
}

/// Newton's method in a bracket whose ends have values of opposite signs, from where the line through them is zero.
double crossing(const VectorXd& motion, double level, double low, double high, double value_low, double value_high) {
  constexpr int most = 80;
  constexpr double near = 1e-11;  // the next step would be the square of the last one
  double phase = low + (high - low) * std::clamp(value_low / (value_low - value_high), 0.0, 1.0);
  for (int i = 0; i < most && high - low > 1e-15 * two_pi; ++i) {
    const auto [value, rate] = above_level(phase, motion, level);
    if (value == 0) return phase;
    if ((value < 0) == (value_low < 0)) low = phase;
    else high = phase;
    const double newton = phase - value / rate;
    const bool inside = newton >= low && newton <= high;
    const double next = inside ? newton : (low + high) / 2;
    if (inside && std::abs(next - phase) < near) return next;
    phase = next;
  }
  return phase;
}

/// Σ k² |c_k|: no curvature by the phase is larger.
double largest_curvature(const VectorXd& motion) {
  double sum = 0;
  for (Index k = 1; 2 * k < motion.size(); ++k)
    sum += static_cast<double>(k * k) * std::hypot(motion(2 * k - 1), motion(2 * k));
  return sum;
}

/// samples · motion from the first half of them: cosines are the same and sines opposite in the second one.
VectorXd values_at(const Eigen::Ref<const Eigen::MatrixXd>& samples, const VectorXd& motion) {
  using EveryOtherColumn = Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
  using EveryOther = Eigen::Map<const VectorXd, 0, Eigen::InnerStride<2>>;
  const Index count = samples.rows(), half = count / 2 + 1, harmonics = (motion.size() - 1) / 2;
  VectorXd even = VectorXd::Constant(half, motion(0)), odd = VectorXd::Zero(half), all(count);
  if (harmonics > 0) {
    const auto add = [&](Index first, VectorXd& to) {
      to.noalias() += EveryOtherColumn(&samples.coeffRef(0, first), half, harmonics,
                                       Eigen::OuterStride<>(2 * samples.outerStride())) *
          EveryOther(motion.data() + first, harmonics);
    };
    add(1, even);
    add(2, odd);
  }
  all.head(half) = even + odd;
  for (Index n = half; n < count; ++n) all(n) = even(count - n) - odd(count - n);
  return all;
}

}  // namespace

double crossing_between(const VectorXd& motion, double level, double low, double high) {
  return crossing(motion, level, low, high, above_level(low, motion, level).value,
                  above_level(high, motion, level).value);
}

std::vector<double> level_crossings(const VectorXd& motion, const std::vector<double>& levels,
                                    const Eigen::Ref<const Eigen::MatrixXd>& samples) {
  const VectorXd course = values_at(samples, motion);
  const Index count = course.size();
  const double step = two_pi / static_cast<double>(count);
  // An extremum between two samples is beyond them by less than this.
  const double beyond = largest_curvature(motion) * step * step / 8;
  const VectorXd rate = phase_derivative(motion);
  std::vector<std::pair<double, double>> places;  // phase and value: samples, and extrema that may pass a level
  places.reserve(to_size(count) + 1);
  std::pair<Index, double> last_rate = {-1, 0};  // sample and rate: neighbours are needed one after the other
  const auto rate_at = [&](Index n) {
    if (last_rate.first != n) last_rate = {n, above_level(step * static_cast<double>(n), motion, 0).rate};
    return last_rate.second;
  };
  for (Index n = 0; n < count; ++n) {
    const double phase = step * static_cast<double>(n), next = course((n + 1) % count);
    places.emplace_back(phase, course(n));
    const double low = std::min(course(n), next) - beyond, high = std::max(course(n), next) + beyond;
    if (std::ranges::none_of(levels, [&](double level) { return level >= low && level <= high; })) continue;
    const double rate_here = rate_at(n), rate_next = rate_at(n + 1);
    if ((rate_here < 0) == (rate_next < 0)) continue;
    const double extremum = crossing(rate, 0, phase, phase + step, rate_here, rate_next);
    places.emplace_back(extremum, above_level(extremum, motion, 0).value);
  }
  places.emplace_back(two_pi, course(0));
  std::vector<double> phases;
  for (std::size_t i = 0; i + 1 < places.size(); ++i)
    for (const double level : levels)
      if ((places[i].second < level) != (places[i + 1].second < level))
        phases.push_back(crossing(motion, level, places[i].first, places[i + 1].first, places[i].second - level,
                                  places[i + 1].second - level));
  std::ranges::sort(phases);
  return phases;
}

std::pair<double, double> range_of_motion(const VectorXd& motion) {
  const Index harmonics = (motion.size() - 1) / 2, samples = 16 * motion.size();
  const VectorXd rate = phase_derivative(motion);
  std::pair<double, double> found = {motion_at(harmonics, 0, motion), motion_at(harmonics, 0, motion)};
  double before = motion_at(harmonics, 0, rate);
  for (Index n = 1; n <= samples; ++n) {
    const double step = two_pi / static_cast<double>(samples), phase = step * static_cast<double>(n),
                 here = motion_at(harmonics, phase, rate);
    const bool turns = (before < 0) != (here < 0);
    const double place = turns ? crossing(rate, 0, phase - step, phase, before, here) : phase,
                 value = motion_at(harmonics, place, motion);
    found = {std::min(found.first, value), std::max(found.second, value)};
    before = here;
  }
  return found;
}

}  // namespace trivet::numerics
