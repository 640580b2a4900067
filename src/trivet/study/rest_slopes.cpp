// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/rest_slopes.h"

#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/pivoted_lu.h"

namespace trivet::study {
namespace {

/// D K D x = D b, refined once: light and stiff coordinates keep their digits.
Eigen::VectorXd solution_at_rest(const Eigen::MatrixXd& stiffness, const Eigen::VectorXd& scale,
                                 const Eigen::VectorXd& load) {
  const numerics::PivotedLu<double> factors(Eigen::MatrixXd(scale.asDiagonal() * stiffness * scale.asDiagonal()));
  const auto solve = [&](const Eigen::VectorXd& b) -> Eigen::VectorXd {
    return scale.asDiagonal() * factors.solve(Eigen::VectorXd(scale.asDiagonal() * b));
  };
  const Eigen::VectorXd first = solve(load);
  return first + solve(load - stiffness * first);
}

}  // namespace

Eigen::RowVectorXd rest_slopes(const CaseContext& c, const DesignNeighbours& neighbours, const RestRowOf& row_of) {
  const assembly::Assembled& first = c.assembled.first_order();
  const Eigen::MatrixXd& stiffness = first.matrices.K;
  const Eigen::VectorXd scale = numerics::unit_scale(first.matrices);
  const response::RestRow here = row_of(c.system, first);
  const Eigen::VectorXd load = assembly::static_load(c.system, first), q = solution_at_rest(stiffness, scale, load),
                        adjoint = solution_at_rest(stiffness.transpose(), scale, here.row.transpose());
  const double value = here.row.dot(q) + here.at_rest;
  Eigen::RowVectorXd slopes(to_index(neighbours.parameters()));
  for (std::size_t j = 0; j < neighbours.parameters(); ++j) {
    double change = 0;
    for (const response::WeightedModel& model : neighbours.along(j)) {
      const assembly::Assembled& moved = model.assembled->first_order();
      const response::RestRow there = row_of(*model.system, moved);
      const Eigen::VectorXd more =
          assembly::static_load(*model.system, moved) - load - (moved.matrices.K - stiffness) * q;
      change += model.weight * (adjoint.dot(more) + (there.row - here.row).dot(q) + there.at_rest - here.at_rest);
    }
    slopes(to_index(j)) = change / value;
  }
  return slopes;
}

}  // namespace trivet::study
