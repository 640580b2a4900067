// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/stiffness_over_deflection.h"

#include <algorithm>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"

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

namespace {

using spatial::Matrix12;

/// In a rigid rotation it turns a force of one between the ends: a string, or at one point a force −e·(θ × Δu) that
/// follows the mean rotation θ of the ends.
Matrix12 turning_stiffness(Eigen::Index axis, double arm) {
  Matrix12 found = Matrix12::Zero();
  for (const Eigen::Index across : {(axis + 1) % 3, (axis + 2) % 3}) {
    spatial::Vector12 difference = spatial::Vector12::Zero();
    difference(across) = -1;
    difference(across + 6) = 1;
    if (arm > 0) {
      found += difference * difference.transpose() / arm;
      continue;
    }
    const Eigen::Index about = 3 - axis - across;
    spatial::Vector12 rotation = spatial::Vector12::Zero();
    rotation(about + 3) = rotation(about + 9) = across == (axis + 1) % 3 ? 0.5 : -0.5;
    found += rotation * difference.transpose() + difference * rotation.transpose();
  }
  return found;
}

/// Slopes of the parabolas through neighbours. They are linear in y, and so keep linear relations between entries.
std::vector<double> parabola_slopes(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<double> slopes;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const std::size_t j = std::clamp<std::size_t>(i, 1, x.size() - 2);  // in the middle of the three
    const double before = (y[j] - y[j - 1]) / (x[j] - x[j - 1]), after = (y[j + 1] - y[j]) / (x[j + 1] - x[j]),
                 bend = (after - before) / (x[j + 1] - x[j - 1]);
    slopes.push_back(before + bend * (2 * x[i] - x[j - 1] - x[j]));
  }
  return slopes;
}

}  // namespace

StiffnessOverDeflection::StiffnessOverDeflection(const std::vector<State>& states, Eigen::Index axis, double arm)
    : axis_(axis) {
  const auto does_not_ascend = [](const State& a, const State& b) { return !(a.deflection < b.deflection); };
  if (states.size() < 3 || std::ranges::adjacent_find(states, does_not_ascend) != states.end() || axis < 0 ||
      axis > 2 || !(arm >= 0))
    throw foundation::InvalidInput(
        "a stiffness over a deflection has three states or more, ascending, an axis from 0 to 2, and an arm of 0 or "
        "more");
  from_ = states.front().deflection;
  to_ = states.back().deflection;
  per_force_ = turning_stiffness(axis, arm);
  std::vector<double> deflections;
  for (const State& state : states) deflections.push_back(state.deflection);
  for (Eigen::Index i = 0; i < Matrix12::SizeAtCompileTime; ++i) {
    std::vector<double> entry;
    for (const State& state : states)
      entry.push_back(state.stiffness.reshaped()(i) - state.force * per_force_.reshaped()(i));
    without_force_.emplace_back(deflections, entry, parabola_slopes(deflections, entry));
  }
}

Matrix12 StiffnessOverDeflection::at(double deflection, double force) const {
  const double nearest = std::clamp(deflection, from_, to_);
  Matrix12 found = force * per_force_;
  for (Eigen::Index i = 0; i < found.size(); ++i) found.reshaped()(i) += without_force_[i].at(nearest).value;
  return found;
}

}  // namespace trivet::elements
