// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/deep_check.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "trivet/elements/law.h"
#include "trivet/numerics/frequency_sweep.h"
#include "trivet/numerics/refined_solution.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::response {
namespace {

using Extended = long double;
using Complex = std::complex<Extended>;
using numerics::ExtendedMatrix;
using numerics::ExtendedVector;

/// T (n × 12) of one element, straight from the convention: columns are what a unit end force does to the coordinates.
Eigen::Matrix<Extended, Eigen::Dynamic, 12> carrier(const assembly::Layout& layout, const model::Element& element) {
  Eigen::Matrix<Extended, Eigen::Dynamic, 12> t = Eigen::Matrix<Extended, Eigen::Dynamic, 12>::Zero(layout.size(), 12);
  int first = 0;
  for (const model::End* end : {&element.n, &element.k}) {
    if (end->body)
      for (int j = 0; j < 6; ++j) {
        const Eigen::Index row = layout.row(*end->body, j);
        if (row < 0) continue;
        const Eigen::Matrix<Extended, 6, 6> x = spatial::rigid_motion(end->at).cast<Extended>();
        const Eigen::Matrix<Extended, 6, 6> r = spatial::both_blocks(end->axes).cast<Extended>();
        t.block<1, 6>(row, first) += (x.transpose() * r).row(j);
      }
    first += 6;
  }
  return t;
}

}  // namespace

DeepCheck deep_check(const model::System& system, const assembly::Assembled& assembled, const Eigen::VectorXcd& load,
                     const std::vector<double>& angular_frequency) {
  const assembly::Layout& layout = assembled.layout;
  const Eigen::Index n = layout.size();
  const Eigen::VectorXd d = numerics::unit_scale(assembled.matrices.A);
  ExtendedMatrix stiffness = ExtendedMatrix::Zero(n, n), damping = ExtendedMatrix::Zero(n, n), mass = ExtendedMatrix::Zero(n, n);
  Eigen::MatrixXd element_damping = Eigen::MatrixXd::Zero(n, n);
  for (const model::Element& element : system.elements()) {
    const Eigen::Matrix<Extended, Eigen::Dynamic, 12> t = carrier(layout, element);
    const Eigen::Matrix<Extended, 12, 12> c = elements::stiffness(element.law).cast<Extended>();
    const Eigen::Matrix<Extended, 12, 12> b = elements::viscous_damping(element.law).cast<Extended>();
    stiffness += (t * c * t.transpose()).cast<Complex>() * Complex(1, elements::loss_factor(element.law));
    const Eigen::Matrix<Extended, Eigen::Dynamic, Eigen::Dynamic> carried = t * b * t.transpose();
    damping += carried.cast<Complex>();
    element_damping += carried.cast<double>();
  }
  // What the system as a whole adds to the damping (Rayleigh, modal ratios) has no second derivation here.
  if (!std::holds_alternative<std::monostate>(system.description().damping))
    damping += (assembled.matrices.B - element_damping).cast<Complex>();
  for (std::size_t b = 0; b < system.bodies().size(); ++b) {
    const spatial::Matrix6 a = spatial::mass_matrix(system.bodies()[b].mass);
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j)
        if (layout.row(b, i) >= 0 && layout.row(b, j) >= 0) mass(layout.row(b, i), layout.row(b, j)) += a(i, j);
  }
  const numerics::SweepResult fast = numerics::sweep(assembled.matrices, load, angular_frequency);
  const ExtendedMatrix scale = d.cast<Complex>().asDiagonal();
  const ExtendedVector h = scale * load.cast<Complex>();

  DeepCheck check;
  double worst_ratio = -1;
  for (std::size_t i = 0; i < angular_frequency.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(i);
    if (!fast.response.col(column).allFinite()) continue;  // singular, and reported as such
    const Extended w = angular_frequency[i];
    const ExtendedMatrix z = scale * (stiffness + Complex(0, w) * damping - w * w * mass) * scale;
    const numerics::RefinedSolver direct(z);
    const ExtendedVector q = direct.solve(h);
    const ExtendedVector difference = (d.cwiseInverse().asDiagonal() * fast.response.col(column)).cast<Complex>() - q;
    const Extended size = q.cwiseAbs().maxCoeff();
    const double relative = size > 0 ? static_cast<double>(difference.cwiseAbs().maxCoeff() / size) : 0;
    const double allowed = 16 * static_cast<double>(n) * std::numeric_limits<double>::epsilon() * direct.condition();
    if (!(allowed < 1e-3)) {
      ++check.incomparable;
      continue;
    }
    ++check.frequencies;
    if (!(relative <= allowed)) check.passed = false;
    if (relative / allowed > worst_ratio) {
      worst_ratio = relative / allowed;
      check.worst_difference = relative;
      check.allowed = allowed;
      check.at_angular_frequency = angular_frequency[i];
    }
  }
  return check;
}

std::vector<double> check_frequencies(const Eigen::VectorXcd& poles, double from, double to, int count) {
  std::vector<double> result;
  for (Eigen::Index k = 0; k < poles.size() && static_cast<int>(result.size()) < count / 2; ++k)
    if (poles(k).imag() > from && poles(k).imag() < to) result.push_back(poles(k).imag());
  const int spread = count - static_cast<int>(result.size());
  for (int i = 0; i < spread; ++i) result.push_back(from + (to - from) * (i + 0.5) / spread);
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace trivet::response
