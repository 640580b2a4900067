// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/select/summed_model.h"

#include <algorithm>
#include <utility>

#include "trivet/assembly/loads.h"
#include "trivet/foundation/constants.h"
#include "trivet/numerics/linalg/eigenvalues.h"
#include "trivet/response/steady/at_rest.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::study {

UnitModes unit_modes(const Eigen::MatrixXd& stiffness) {
  if (stiffness.rows() == 6) {  // most machines: without allocation, faster
    const auto found = numerics::symmetric_eigen(spatial::Matrix6(stiffness));
    return {found.values, found.vectors};
  }
  auto found = numerics::symmetric_eigen(stiffness);
  return {std::move(found.values), std::move(found.vectors)};
}

double least_decoupling(const Eigen::MatrixXd& motion, const Eigen::MatrixXd& momentum, const UnitModes& modes) {
  constexpr double apart = 1e-5;  // of the highest ω²: closer ones have shapes without digits
  const Eigen::MatrixXd shares = (motion * modes.shapes).cwiseProduct(momentum * modes.shapes);
  const Eigen::VectorXd& squares = modes.squares;
  const Eigen::Index n = squares.size();
  const double least_gap = apart * squares(n - 1);
  double least = foundation::infinity;
  for (Eigen::Index k = 0; k < n; ++k) {
    const bool alone =
        (k == 0 || squares(k) - squares(k - 1) > least_gap) && (k + 1 == n || squares(k + 1) - squares(k) > least_gap);
    if (alone) least = std::min(least, shares.col(k).maxCoeff());
  }
  return least;
}

namespace {

/// Sums differ from assembled models by at most this share of the scale of an entry.
constexpr double sum_tolerance = 1e-11;

}  // namespace

SummedModel summed_model(const model::System& system, const assembly::Assembled& assembled) {
  if (assembled.frequency_dependent()) throw NoSum{"elements depend on frequency"};
  if (!assembled.matrices.symmetric) throw NoSum{"the stiffness matrix is not symmetric"};
  if (assembled.hangs_aside) throw NoSum{"a hung body is beside its plumb line"};
  const response::AtRest rest(system, assembled);
  const assembly::Assembled& first = assembled.first_order();
  SummedModel result{assembled.matrices.A,
                     assembled.matrices.K,
                     first.matrices.K,
                     rest.assembled().first_order().matrices.K,
                     assembly::static_load(rest.system(), first),
                     {},
                     {}};
  if (assembly::has_second_order(system)) result.forces_at_rest = assembly::second_order_forms(system, first);
  if (rest.assembled().without_second_order && !system.description().constant_forces.empty())
    result.beside = assembly::constant_load(system, first);
  return result;
}

Eigen::MatrixXd on_shapes(const assembly::SecondOrderForms& forms, const Eigen::MatrixXd& shapes) {
  if (forms.constant.size() == 0) return {};
  const Eigen::Index n = shapes.cols();
  Eigen::MatrixXd result(n * n, 1 + n);
  const auto set = [&](Eigen::Index column, const Eigen::MatrixXd& form) {
    result.col(column) = (shapes.transpose() * form * shapes).reshaped();
  };
  set(0, forms.constant);
  for (Eigen::Index j = 0; j < n; ++j) set(1 + j, forms.at(shapes.col(j)) - forms.constant);
  return result;
}

bool equal(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  if (a.rows() != b.rows()) return false;
  const Eigen::VectorXd scale = b.diagonal().cwiseAbs().cwiseSqrt();
  constexpr double round_off = 1e-14;
  const double floor = round_off * std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff());
  return ((a - b).cwiseAbs().array() <= sum_tolerance * (scale * scale.transpose()).array() + floor).all();
}

bool equal(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  if (a.rows() != b.rows()) return false;
  return (a - b).lpNorm<Eigen::Infinity>() <= sum_tolerance * b.lpNorm<Eigen::Infinity>();
}

}  // namespace trivet::study
