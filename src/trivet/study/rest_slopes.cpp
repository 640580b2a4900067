// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/rest_slopes.h"

#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/pivoted_lu.h"
#include "trivet/response/steady/at_rest.h"

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
  const response::AtRest at_rest(c.system, c.assembled);
  const Eigen::MatrixXd& stiffness = at_rest.assembled().matrices.K;
  const Eigen::VectorXd scale = numerics::unit_scale(c.assembled.matrices);
  const response::RestRow here = row_of(at_rest.system(), at_rest.assembled());
  const Eigen::VectorXd load = assembly::static_load(at_rest.system(), at_rest.assembled()),
                        q = solution_at_rest(stiffness, scale, load),
                        adjoint = solution_at_rest(stiffness.transpose(), scale, here.row.transpose());
  const double value = here.row.dot(q) + here.at_rest;
  Eigen::RowVectorXd slopes(to_index(neighbours.parameters()));
  for (std::size_t j = 0; j < neighbours.parameters(); ++j) {
    double change = 0;
    for (const response::WeightedModel& model : neighbours.along(j)) {
      const response::AtRest near(*model.system, *model.assembled);
      const response::RestRow there = row_of(near.system(), near.assembled());
      const Eigen::VectorXd more =
          assembly::static_load(near.system(), near.assembled()) - load - (near.assembled().matrices.K - stiffness) * q;
      change += model.weight * (adjoint.dot(more) + (there.row - here.row).dot(q) + there.at_rest - here.at_rest);
    }
    slopes(to_index(j)) = change / value;
  }
  return slopes;
}

}  // namespace trivet::study
