// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/rest_slopes.h"

#include "trivet/assembly/loads.h"
#include "trivet/assembly/rest_coordinates.h"
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
  Eigen::MatrixXd first, whole;   ///< K₀, K
  Eigen::VectorXd weight, loads;  ///< Q_w, Q_l
};
Statics statics_of(const response::AtRest& at_rest) {
  const assembly::Assembled &whole = at_rest.assembled(), &first = whole.first_order();
  const Eigen::VectorXd load = assembly::static_load(at_rest.system(), first),
                        loads = assembly::constant_load(at_rest.system(), first);
  return {first.matrices.K, whole.matrices.K, load - loads, loads};
}

/// Of a hung machine, whose K₀ has no inverse: differences of its values.
Eigen::RowVectorXd slopes_of_values(const response::AtRest& at_rest, const DesignNeighbours& neighbours,
                                    const RestRowOf& row_of) {
  const auto value = [&](const response::AtRest& machine) {
    const response::RestRow row = row_of(machine.system(), machine.assembled());
    const response::StaticSolution rest = response::static_solution(machine.system(), machine.assembled());
    return row.row.dot(rest.by_weight) + row.beside.dot(rest.by_loads) + row.at_rest;
  };
  const double here = value(at_rest);
  Eigen::RowVectorXd slopes = Eigen::RowVectorXd::Zero(to_index(neighbours.parameters()));
  for (std::size_t j = 0; j < neighbours.parameters(); ++j)
    for (const response::WeightedModel& model : neighbours.along(j))
      slopes(to_index(j)) += model.weight * (value({*model.system, *model.assembled}) - here) / here;
  return slopes;
}

}  // namespace

Eigen::RowVectorXd rest_slopes(const CaseContext& c, const DesignNeighbours& neighbours, const RestRowOf& row_of) {
  const response::AtRest at_rest(c.system, c.assembled);
  const assembly::Assembled& first = at_rest.assembled().first_order();
  if (!assembly::coordinates_at_rest(first.matrices, assembly::static_load(c.system, first)).unique)
    return slopes_of_values(at_rest, neighbours, row_of);
  const Eigen::VectorXd scale = numerics::unit_scale(c.assembled.matrices);
  const response::RestRow here = row_of(at_rest.system(), at_rest.assembled());
  const Statics rest = statics_of(at_rest);
  const Eigen::VectorXd by_weight = solution_at_rest(rest.first, scale, rest.weight),
                        by_loads = solution_at_rest(rest.whole, scale, rest.loads),
                        mu = solution_at_rest(rest.first.transpose(), scale, here.row.transpose()),
                        lambda = solution_at_rest(rest.whole.transpose(), scale, here.beside.transpose());
  const double value = here.row.dot(by_weight) + here.beside.dot(by_loads) + here.at_rest;
  Eigen::RowVectorXd slopes(to_index(neighbours.parameters()));
  for (std::size_t j = 0; j < neighbours.parameters(); ++j) {
    double change = 0;
    for (const response::WeightedModel& model : neighbours.along(j)) {
      const response::AtRest near(*model.system, *model.assembled);
      const response::RestRow there = row_of(near.system(), near.assembled());
      const Statics moved = statics_of(near);
      const Eigen::VectorXd on_weight = moved.weight - rest.weight - (moved.first - rest.first) * by_weight,
                            on_loads = moved.loads - rest.loads - (moved.whole - rest.whole) * by_loads;
      change += model.weight *
          (mu.dot(on_weight) + lambda.dot(on_loads) + (there.row - here.row).dot(by_weight) +
           (there.beside - here.beside).dot(by_loads) + there.at_rest - here.at_rest);
    }
    slopes(to_index(j)) = change / value;
  }
  return slopes;
}

}  // namespace trivet::study
