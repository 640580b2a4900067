// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/assembly/rest_coordinates.h"

#include <cmath>

#include "trivet/numerics/linalg/orthogonal.h"
#include "trivet/numerics/linalg/pivoted_lu.h"

namespace trivet::assembly {

RestCoordinates coordinates_at_rest(const numerics::DynamicMatrices& m, const Eigen::VectorXd& load) {
  constexpr double regular = 1e-13;
  Eigen::VectorXd scale = numerics::unit_scale(m);
  for (Eigen::Index i = 0; i < scale.size(); ++i)  // a light part has a stiffness like others, but a high frequency
    if (m.K(i, i) > 0) scale(i) = 1 / std::sqrt(m.K(i, i));
  const Eigen::MatrixXd stiffness = scale.asDiagonal() * m.K * scale.asDiagonal();
  const Eigen::VectorXd scaled = scale.asDiagonal() * load;
  const numerics::PivotedLu<double> factors(stiffness);
  if (factors.reciprocal_condition() > regular) {
    const Eigen::VectorXd rest = factors.solve(scaled);
    return {scale.asDiagonal() * (rest + factors.solve(Eigen::VectorXd(scaled - stiffness * rest))), true};
  }
  return {scale.asDiagonal() * numerics::smallest_solution(stiffness, scaled), false};
}

}  // namespace trivet::assembly
