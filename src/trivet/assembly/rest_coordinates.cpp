// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/assembly/rest_coordinates.h"

#include <cassert>
#include <cmath>

#include "trivet/numerics/linalg/orthogonal.h"
#include "trivet/numerics/linalg/pivoted_lu.h"

namespace trivet::assembly {

namespace {

/// K in units in which a light part has a stiffness like others, but a high frequency.
struct ScaledStiffness {
  explicit ScaledStiffness(const numerics::DynamicMatrices& m) : scale(numerics::unit_scale(m)) {
    for (Eigen::Index i = 0; i < scale.size(); ++i)
      if (m.K(i, i) > 0) scale(i) = 1 / std::sqrt(m.K(i, i));
    stiffness = scale.asDiagonal() * m.K * scale.asDiagonal();
  }
  Eigen::VectorXd scale;
  Eigen::MatrixXd stiffness;
};

constexpr double regular = 1e-13;

}  // namespace

bool holds_all(const numerics::DynamicMatrices& m) {
  return m.size() == 0 || numerics::PivotedLu<double>(ScaledStiffness(m).stiffness).reciprocal_condition() > regular;
}

Eigen::VectorXd coordinates_at_rest(const numerics::DynamicMatrices& m, const Eigen::VectorXd& load) {
  assert(load.size() == m.size());
  const ScaledStiffness scaled(m);
  const Eigen::VectorXd right = scaled.scale.asDiagonal() * load;
  const numerics::PivotedLu<double> factors(scaled.stiffness);
  if (!(factors.reciprocal_condition() > regular))
    return scaled.scale.asDiagonal() * numerics::smallest_solution(scaled.stiffness, right);
  const Eigen::VectorXd rest = factors.solve(right);
  return scaled.scale.asDiagonal() * (rest + factors.solve(Eigen::VectorXd(right - scaled.stiffness * rest)));
}

}  // namespace trivet::assembly
