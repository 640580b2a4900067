// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/family/rest_slopes.h"

#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/pivoted_lu.h"
#include "trivet/response/steady/at_rest.h"
#include "trivet/response/steady/static_solution.h"

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

/// Loads and stiffnesses of a machine at rest.
struct Statics {
  Eigen::MatrixXd first, whole;  ///< K₀, K
  response::RestLoads loads;
};
Statics statics_of(const response::AtRest& at_rest) {
  const assembly::Assembled& whole = at_rest.assembled();
  return {whole.first_order().matrices.K, whole.matrices.K, response::rest_loads(at_rest.system(), whole)};
}

}  // namespace

Eigen::RowVectorXd rest_slopes(const CaseContext& c, const DesignNeighbours& neighbours, const RestRowOf& row_of) {
  const response::AtRest at_rest(c.system, c.assembled);
  const Eigen::VectorXd scale = numerics::unit_scale(c.assembled.matrices);
  const response::RestRow here = row_of(at_rest.system(), at_rest.assembled());
  const Statics rest = statics_of(at_rest);
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(scale.size());
  // K₀ that does not hold the machine bears no load: its inverse is not asked for.
  const bool bears = !rest.loads.on_first.isZero(0), has_others = !rest.loads.on_whole.isZero(0);
  const auto solution = [&](bool wanted, const Eigen::MatrixXd& stiffness, const Eigen::VectorXd& load) {
    return wanted ? solution_at_rest(stiffness, scale, load) : none;
  };
  const Eigen::VectorXd by_weight = solution(bears, rest.first, rest.loads.on_first),
                        by_loads = solution(has_others, rest.whole, rest.loads.on_whole),
                        mu = solution(bears, rest.first.transpose(), here.row.transpose()),
                        lambda = solution(has_others, rest.whole.transpose(), here.beside.transpose());
  const double value = here.row.dot(by_weight) + here.beside.dot(by_loads) + here.at_rest;
  Eigen::RowVectorXd slopes(to_index(neighbours.parameters()));
  for (std::size_t j = 0; j < neighbours.parameters(); ++j) {
    double change = 0;
    for (const response::WeightedModel& model : neighbours.along(j)) {
      const response::AtRest near(*model.system, *model.assembled);
      const response::RestRow there = row_of(near.system(), near.assembled());
      const Statics moved = statics_of(near);
      const Eigen::VectorXd on_weight =
          moved.loads.on_first - rest.loads.on_first - (moved.first - rest.first) * by_weight;
      const Eigen::VectorXd on_loads =
          moved.loads.on_whole - rest.loads.on_whole - (moved.whole - rest.whole) * by_loads;
      change += model.weight *
          (mu.dot(on_weight) + lambda.dot(on_loads) + (there.row - here.row).dot(by_weight) +
           (there.beside - here.beside).dot(by_loads) + there.at_rest - here.at_rest);
    }
    slopes(to_index(j)) = change / value;
  }
  return slopes;
}

}  // namespace trivet::study
