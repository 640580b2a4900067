// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/steady/deep_check.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "trivet/assembly/geometric_stiffness.h"
#include "trivet/elements/law.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/refined_solution.h"
#include "trivet/response/steady/prescribed_ends.h"
#include "trivet/response/steady/steady_solution.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::response {
namespace {

using Extended = long double;
using ExtendedComplex = std::complex<Extended>;
using numerics::ExtendedMatrix;
using numerics::ExtendedVector;
using Carrier = Eigen::Matrix<Extended, Eigen::Dynamic, Eigen::Dynamic>;

/// System damping in the free rows from the motion of the ground; it has no second derivation here.
Eigen::MatrixXd system_damping_on_ground(const assembly::Assembled& assembled, Eigen::Index n) {
  Eigen::MatrixXd rest = assembled.ground.B.topRows(n);
  for (const assembly::ElementMap& map : assembled.elements) {
    if (map.frequency_dependent() || map.ground_rows.empty()) continue;
    rest(map.rows, map.ground_rows) -= map.ends.transpose() * map.matrices.damping * map.ground_ends;
  }
  return rest;
}

/// T (n × (12 + internal)) of one element, directly from the convention: each column is the generalised force of a unit
/// force on an end or an internal coordinate.
Carrier carrier(const assembly::Layout& layout, std::size_t index, const model::Element& element, Eigen::Index internal,
                Eigen::Index n) {
  Carrier t = Carrier::Zero(n, 12 + internal);
  for (Eigen::Index i = 0; i < internal; ++i) t(layout.internal_row(index) + i, 12 + i) = 1;
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
    if (end->foundation)
      t.block(layout.foundation_row(end->foundation->foundation), first, end->foundation->shape.cols(), 6) +=
          end->foundation->shape.transpose().cast<Extended>() * spatial::both_blocks(end->axes).cast<Extended>();
    first += 6;
  }
  return t;
}

/// Largest column sum of the magnitudes of entries.
Extended one_norm(const ExtendedMatrix& m) { return m.cwiseAbs().colwise().sum().maxCoeff(); }

/// Relative difference that round-off explains: that of the terms of Z and of the load per unit motion, times the size
/// of Z⁻¹. An entry of Z sums the 12×12 of elements, so at least twelve terms contribute to it however few coordinates
/// are free. K, iωB and −ω²A may cancel: the condition of Z does not show these lost digits (that of a single
/// coordinate is always 1).
double allowed_difference(Eigen::Index n, double condition, Extended terms, Extended load, Extended sum) {
  constexpr Eigen::Index least_terms = 12;
  constexpr double per_term = 16;
  const double lost = sum > 0 ? static_cast<double>(std::max(terms, load) / sum) : 1;
  return per_term * static_cast<double>(std::max(n, least_terms)) * std::numeric_limits<double>::epsilon() * condition *
      std::max(lost, 1.0);
}

}  // namespace

DeepCheck deep_check(const model::System& system, const assembly::Assembled& assembled,
                     const assembly::Loading& loading, const std::vector<double>& angular_frequency,
                     const std::vector<std::string>& excitations) {
  const PrescribedEnds ends(system, excitations);
  const assembly::Layout& layout = assembled.layout;
  const numerics::DynamicMatrices& constant = assembled.frequency_dependent() ? assembled.constant : assembled.matrices;
  const Eigen::Index n = constant.size();
  const Eigen::VectorXd d = numerics::unit_scale(constant);
  ExtendedMatrix stiffness = ExtendedMatrix::Zero(n, n), damping = ExtendedMatrix::Zero(n, n),
                 mass = ExtendedMatrix::Zero(n, n);
  Eigen::MatrixXd element_damping = Eigen::MatrixXd::Zero(n, n);
  struct Dependent {
    std::size_t element;
    Carrier free;
  };
  std::vector<Dependent> dependent;
  struct Driven {
    std::size_t element;
    elements::Matrices matrices;
  };
  std::vector<Driven> driven;
  for (std::size_t e = 0; e < system.elements().size(); ++e) {
    const model::Element& element = system.elements()[e];
    if (elements::is_frequency_dependent(element.law)) {
      dependent.push_back({e, carrier(layout, e, element, 0, n)});
      continue;
    }
    const elements::Matrices m = elements::matrices(element.law);
    const Carrier t = carrier(layout, e, element, m.stiffness.rows() - 12, n);
    const auto transformed = [&](const Eigen::MatrixXd& local) -> Carrier {
      return t * local.cast<Extended>() * t.transpose();
    };
    stiffness += transformed(m.stiffness).cast<ExtendedComplex>() * ExtendedComplex(1, m.loss_factor);
    mass += transformed(m.mass).cast<ExtendedComplex>();
    damping += transformed(m.damping).cast<ExtendedComplex>();
    element_damping += transformed(m.damping).cast<double>();
    if (ends.can_move(e)) driven.push_back({e, m});
  }
  for (std::size_t f = 0; f < system.description().foundations.size(); ++f) {
    const model::Foundation& foundation = system.description().foundations[f];
    const Eigen::Index row = layout.foundation_row(f), size = foundation.mass.rows();
    stiffness.block(row, row, size, size) += foundation.stiffness.cast<ExtendedComplex>();
    damping.block(row, row, size, size) += foundation.damping.cast<ExtendedComplex>();
    mass.block(row, row, size, size) += foundation.mass.cast<ExtendedComplex>();
    element_damping.block(row, row, size, size) += foundation.damping;
  }
  // System damping (Rayleigh, modal ratios) has no second derivation here.
  ExtendedMatrix driven_damping;
  if (!std::holds_alternative<std::monostate>(system.description().damping)) {
    damping += (constant.B - element_damping).cast<ExtendedComplex>();
    driven_damping = system_damping_on_ground(assembled, n).cast<ExtendedComplex>();
  }
  for (std::size_t b = 0; b < system.bodies().size(); ++b) {
    const spatial::Matrix6 a = spatial::mass_matrix(system.bodies()[b].mass);
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j)
        if (layout.row(b, i) >= 0 && layout.row(b, j) >= 0) mass(layout.row(b, i), layout.row(b, j)) += a(i, j);
  }
  stiffness += assembly::geometric_stiffness(system, layout).topLeftCorner(n, n).cast<ExtendedComplex>();
  const Eigen::MatrixXcd fast = steady_solution(assembled, loading, angular_frequency).response;
  const ExtendedMatrix scale = d.cast<ExtendedComplex>().asDiagonal();

  DeepCheck check;
  double worst_ratio = -1;
  for (std::size_t i = 0; i < angular_frequency.size(); ++i) {
    const auto column = to_index(i);
    if (!fast.col(column).allFinite()) continue;  // singular, and reported as such
    const Extended w = angular_frequency[i];
    ExtendedMatrix z = stiffness + ExtendedComplex(0, w) * damping - w * w * mass;
    ExtendedMatrix terms = stiffness.cwiseAbs().cast<ExtendedComplex>() +
        w * damping.cwiseAbs().cast<ExtendedComplex>() + w * w * mass.cwiseAbs().cast<ExtendedComplex>();
    ExtendedVector h = loading.force.head(n).at(angular_frequency[i]).cast<ExtendedComplex>();
    ExtendedVector load_terms = h.cwiseAbs().cast<ExtendedComplex>();
    const auto drive = [&](const ExtendedVector& load) {
      h -= load;
      load_terms += load.cwiseAbs().cast<ExtendedComplex>();
    };
    for (const auto& [element, t] : dependent) {
      const ExtendedMatrix exact =
          elements::dynamic_stiffness(system.elements()[element].law, angular_frequency[i]).cast<ExtendedComplex>();
      const ExtendedMatrix transformed = t.cast<ExtendedComplex>() * exact * t.transpose().cast<ExtendedComplex>();
      z += transformed;
      terms += transformed.cwiseAbs().cast<ExtendedComplex>();
      drive(t.cast<ExtendedComplex>() * (exact * ends.at(element, angular_frequency[i])));
    }
    for (const auto& [element, m] : driven) {
      const Carrier t = carrier(layout, element, system.elements()[element], m.stiffness.rows() - 12, n);
      const ExtendedMatrix dynamic =
          m.stiffness.leftCols(12).cast<ExtendedComplex>() * ExtendedComplex(1, m.loss_factor) +
          ExtendedComplex(0, w) * m.damping.leftCols(12).cast<ExtendedComplex>() -
          w * w * m.mass.leftCols(12).cast<ExtendedComplex>();
      drive(t.cast<ExtendedComplex>() * (dynamic * ends.at(element, angular_frequency[i])));
    }
    if (driven_damping.size() > 0 && !loading.motion.vanishes())
      drive(ExtendedComplex(0, w) * driven_damping * loading.motion.at(angular_frequency[i]).cast<ExtendedComplex>());
    h = (scale * h).eval();
    z = (scale * z * scale).eval();
    terms = (scale * terms * scale).eval();
    const numerics::RefinedSolver direct(z);
    const ExtendedVector q = direct.solve(h);
    const ExtendedVector difference = (d.cwiseInverse().asDiagonal() * fast.col(column)).cast<ExtendedComplex>() - q;
    const Extended size = q.cwiseAbs().maxCoeff();
    const double relative = size > 0 ? static_cast<double>(difference.cwiseAbs().maxCoeff() / size) : 0;
    const Extended of_load = size > 0 ? (scale * load_terms).cwiseAbs().sum() / size : 0;
    const double allowed = allowed_difference(n, direct.condition(), one_norm(terms), of_load, one_norm(z));
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
  constexpr double oscillating =
      1e-9;  // of |λ|: complex solvers give an overdamped root an imaginary part of round-off, even 1e-150
  std::vector<double> result;
  for (Eigen::Index k = 0; k < poles.size() && static_cast<int>(result.size()) < count / 2; ++k)
    if (const double at = poles(k).imag(); at > from && at < to && at > oscillating * std::abs(poles(k)))
      result.push_back(at);
  const int spread = count - static_cast<int>(result.size());
  for (int i = 0; i < spread; ++i) result.push_back(from + (to - from) * (i + 0.5) / spread);
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace trivet::response
