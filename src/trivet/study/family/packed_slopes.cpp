// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/family/packed_slopes.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/modal/free_motions.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/dynamic_matrices.h"
#include "trivet/numerics/roots/design_modes.h"
#include "trivet/spatial/rigid_motion.h"
#include "trivet/study/family/packed_margins.h"
#include "trivet/study/requirements/mount_loads.h"

namespace trivet::study {
namespace {

using Complex = std::complex<double>;

/// Σ a_i b_i, without conjugation.
Complex with(const Eigen::VectorXcd& a, const Eigen::VectorXcd& b) { return a.cwiseProduct(b).sum(); }

}  // namespace

PackedSlopes::PackedSlopes(const CaseVector& of, const Eigen::VectorXd& entries, const Eigen::MatrixXd& slopes)
    : of_(of),
      here_(of.unpacked(entries.transpose())),
      change_(of.changes(here_, slopes.transpose())),
      here_free_(of.free(here_)),
      change_free_(of.free(change_)),
      parameters_(slopes.cols()),
      of_decoupled_(of.decoupled().size()) {}

Eigen::MatrixXd PackedSlopes::height_slopes(std::size_t result, const std::vector<double>& frequencies) const {
  for (std::size_t s = 0; s < of_.searches().size(); ++s) {
    const std::vector<std::size_t>& results = of_.searches()[s].results;
    const auto at = std::ranges::find(results, result);
    if (at == results.end()) continue;
    const std::size_t curve = to_size(of_.searches()[s].curves[at - results.begin()]);
    const numerics::DrivenDesigns own = of_.searched(here_, of_.searches()[s]),
                                  moved = of_.searched(change_, of_.searches()[s]);
    Eigen::MatrixXd slopes(to_index(frequencies.size()), parameters_);
    for (std::size_t i = 0; i < frequencies.size(); ++i) {
      const double omega = std::max(frequencies[i], almost_at_rest());
      const PackedCurve here = packed_curve(own, 0, curve, omega);
      const numerics::PivotedLu<Complex> solver(here.stiffness);
      const Eigen::VectorXcd q = solver.solve(here.load), adjoint = solver.solve(here.row);
      const Complex y = with(here.row, q) + here.constant;
      for (Eigen::Index j = 0; j < parameters_; ++j) {
        const PackedCurve change = packed_curve(moved, j, curve, omega);
        const Complex dy = with(adjoint, change.load - change.stiffness * q) + with(change.row, q) + change.constant;
        slopes(to_index(i), j) = (std::conj(y) * dy).real() / std::norm(y);
      }
    }
    return slopes;
  }
  throw foundation::InvalidInput("PackedSlopes: this requirement has no curve");
}

double PackedSlopes::almost_at_rest() const {
  constexpr double share = 1e-6;  // of the lowest natural frequency: the slopes are those at rest to 1e-12
  const Eigen::MatrixXd K = numerics::unpacked(here_free_.K, 0), A = numerics::unpacked(here_free_.A, 0);
  double square = foundation::infinity;  // not below the lowest ω²
  for (Eigen::Index i = 0; i < K.rows(); ++i)
    if (A(i, i) > 0) square = std::min(square, K(i, i) / A(i, i));
  return std::isfinite(square) ? share * std::sqrt(square) : share;
}

PackedSlopes::Modes PackedSlopes::modes(const numerics::Designs& here, const numerics::Designs& change) const {
  const numerics::DesignModes found = numerics::design_modes(here, {.shapes = true, .threads = 1});
  const Eigen::Index n = found.lambda.cols();
  if (std::isnan(found.lambda(0, 0))) throw foundation::NotComputable("the modes of the design cannot be computed");
  Modes result{found.lambda.row(0).transpose(),
               Eigen::Map<const Eigen::MatrixXd>(Eigen::MatrixXd(found.shapes.row(0).matrix()).data(), n, n),
               {},
               {}};
  for (Eigen::Index j = 0; j < parameters_; ++j) {
    result.inertia.emplace_back(result.shapes.transpose() * numerics::unpacked(change.A, j) * result.shapes);
    result.stiffness.emplace_back(result.shapes.transpose() * numerics::unpacked(change.K, j) * result.shapes);
  }
  return result;
}

Eigen::RowVectorXd PackedSlopes::frequency_slopes(int mode) const {
  if (!all_) all_ = modes(here_free_, change_free_);
  const Eigen::Index k = mode - 1;
  const double square = all_->squares(k);
  Eigen::RowVectorXd slopes(parameters_);
  for (Eigen::Index j = 0; j < parameters_; ++j)
    slopes(j) = (all_->stiffness[j](k, k) - square * all_->inertia[j](k, k)) / (2 * square);
  return slopes;
}

Eigen::RowVectorXd PackedSlopes::rest_slopes(std::size_t result) const {
  const auto& values = of_.at_rest();
  const auto found = std::ranges::find_if(values, [&](const auto& one) { return one.result == result; });
  const auto& rows = here_.rows[found - values.begin()];
  const auto& moved = change_.rows[found - values.begin()];
  const Eigen::Index n = of_.coordinates();
  const Eigen::VectorXd row = rows.row(0).head(n).transpose();
  const auto [by_weight, by_loads] = CaseVector::rest_of(here_, 0);
  const Eigen::VectorXd rest = by_weight + by_loads,
                        mu = numerics::cholesky_solution(numerics::unpacked(here_.rest_stiffness, 0), row);
  Eigen::VectorXd lambda;  // λ of the loads beside the weight, see slopes.h
  if (here_.beside.size() > 0) lambda = numerics::cholesky_solution(numerics::unpacked(here_.standing, 0), row);
  const double value = row.dot(rest) + rows(0, n);
  const bool grows = found->range && is_near_lower_end(value, *found->range);
  Eigen::RowVectorXd slopes(parameters_);
  for (Eigen::Index j = 0; j < parameters_; ++j) {
    Eigen::VectorXd on_weight =
        change_.load.row(j).transpose() - numerics::unpacked(change_.rest_stiffness, j) * by_weight;
    double change = moved.row(j).head(n).dot(rest) + moved(j, n);
    if (lambda.size() > 0) {
      const Eigen::VectorXd beside = change_.beside.row(j).transpose();
      on_weight -= beside;
      change += lambda.dot(beside - numerics::unpacked(change_.standing, j) * by_loads);
    }
    change += mu.dot(on_weight);
    slopes(j) = (grows ? 1 : -1) * change / value;
  }
  return slopes;
}

Eigen::RowVectorXd PackedSlopes::decoupling_slopes(std::size_t result, int mode) const {
  const auto& all = of_.decoupled();
  const auto found = std::ranges::find_if(all, [&](const auto& one) { return one.result == result; });
  const std::size_t number = to_size(found - all.begin());
  std::optional<Modes>& own = of_decoupled_[number];
  if (!own) own = modes(part_of_designs(here_free_, found->rows), part_of_designs(change_free_, found->rows));
  const auto n = to_index(found->rows.size());
  const Eigen::Index k = mode - 1;
  const MassNumbers numbers = here_.bodies[number].row(0).transpose();
  const spatial::MassProperties mass = mass_of(numbers);
  const spatial::Matrix6 to_centre = spatial::rigid_motion(mass.centre);
  const auto momentum = [](const spatial::MassProperties& of, const spatial::Vector6& motion) {
    spatial::Vector6 result_of;
    result_of << of.mass * motion.head<3>(), of.inertia_about_centre * motion.tail<3>();
    return result_of;
  };
  const auto six = [&](const Eigen::VectorXd& shape) {
    spatial::Vector6 motion = spatial::Vector6::Zero();
    for (Eigen::Index i = 0; i < n; ++i) motion(found->coordinates[i]) = shape(i);
    return motion;
  };
  const spatial::Vector6 pole = six(own->shapes.col(k)), centre = to_centre * pole, moving = momentum(mass, centre);
  Eigen::Index purest = 0;
  const double share = centre.cwiseProduct(moving).maxCoeff(&purest);
  Eigen::RowVectorXd slopes(parameters_);
  for (Eigen::Index j = 0; j < parameters_; ++j) {
    Eigen::VectorXd weights(n);
    for (Eigen::Index m = 0; m < n; ++m) {
      const double dA = own->inertia[j](m, k), dK = own->stiffness[j](m, k);
      const double apart = own->squares(k) - own->squares(m);
      constexpr double repeated = 1e-12;  // shapes of a repeated ω² turn among themselves: no derivative
      if (m == k) weights(m) = -dA / 2;
      else weights(m) = std::abs(apart) > repeated * own->squares(k) ? (dK - own->squares(k) * dA) / apart : 0;
    }
    const spatial::MassProperties change = mass_of(MassNumbers(change_.bodies[number].row(j).transpose()));
    spatial::Matrix6 turned = spatial::rigid_motion(change.centre);
    turned.diagonal().setZero();
    const spatial::Vector6 d_centre = to_centre * six(own->shapes * weights) + turned * pole;
    const spatial::Vector6 d_moving = momentum(mass, d_centre) + momentum(change, centre);
    slopes(j) = (d_centre(purest) * moving(purest) + centre(purest) * d_moving(purest)) / share;
  }
  return slopes;
}

Eigen::RowVectorXd PackedSlopes::damping_ratio_slopes(Complex root) const {
  const Complex lambda =
      root.imag() < 0 ? std::conj(root) : root;  // the same damping ratio; loss factors are for ω > 0
  const auto matrices = [](const numerics::Designs& of, const Eigen::ArrayXXd& loss, Eigen::Index design) {
    numerics::DynamicMatrices one = numerics::matrices_of(of, design);
    one.K_loss = numerics::unpacked(loss, design);
    return one;
  };
  const auto stiffness = [&](const numerics::DynamicMatrices& m) -> Eigen::MatrixXcd {
    return m.complex_stiffness() + lambda * m.B.cast<Complex>() + lambda * lambda * m.A.cast<Complex>();
  };
  const numerics::DynamicMatrices here = matrices(here_free_, of_.loss(here_), 0);
  const Eigen::VectorXcd v = modal::null_vectors(stiffness(here), numerics::unit_scale(here), 1).right.col(0);
  const Complex rate = with(v, (2.0 * lambda * here.A.cast<Complex>() + here.B.cast<Complex>()) * v);
  const Eigen::ArrayXXd loss = of_.loss(change_);
  Eigen::RowVectorXd slopes(parameters_);
  for (Eigen::Index j = 0; j < parameters_; ++j) {
    const Complex change = -with(v, stiffness(matrices(change_free_, loss, j)) * v) / rate;
    slopes(j) = change.real() / lambda.real() - (std::conj(lambda) * change).real() / std::norm(lambda);
  }
  return slopes;
}

Eigen::MatrixXd PackedSlopes::slopes(std::size_t result, const RequirementResult& found,
                                     const std::vector<RequirementResult::Candidate>& candidates) const {
  const auto rows = to_index(candidates.size());
  std::vector<double> places;
  for (const RequirementResult::Candidate& one : candidates) places.push_back(one.angular_frequency);
  if (found.kind == RequirementKind::amplitude || found.kind == RequirementKind::isolation)
    return -height_slopes(result, places);
  if (found.kind == RequirementKind::no_peak) {
    for (const RequirementResult::Candidate& one : candidates) places.push_back(one.minimum_at);
    const Eigen::MatrixXd both = height_slopes(result, places);
    Eigen::MatrixXd slopes = both.bottomRows(rows) - both.topRows(rows);
    // margin (1 + a)/(1 + r) below 1 and a/r above, with 1 + r = peak / minimum
    for (Eigen::Index i = 0; i < rows; ++i)
      if (const double margin = candidates[i].margin; margin >= 1)
        slopes.row(i) *= (1 + found.allowed / margin) / (found.allowed / margin);
    return slopes;
  }
  Eigen::MatrixXd slopes(rows, parameters_);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const RequirementResult::Candidate& one = candidates[i];
    if (found.kind == RequirementKind::avoided_frequencies)
      slopes.row(i) = (one.below ? -1 : 1) * frequency_slopes(one.mode);
    else if (found.kind == RequirementKind::separation)
      slopes.row(i) = frequency_slopes(one.mode + 1) - frequency_slopes(one.mode);
    else if (found.kind == RequirementKind::decoupling) slopes.row(i) = decoupling_slopes(result, one.mode);
    else slopes.row(i) = rest_slopes(result);
  }
  return slopes;
}

}  // namespace trivet::study
