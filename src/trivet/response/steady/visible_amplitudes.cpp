// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/steady/visible_amplitudes.h"

#include <algorithm>

#include "trivet/assembly/answer_coordinates.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/dynamic_matrices.h"
#include "trivet/numerics/linalg/pivoted_solution.h"
#include "trivet/numerics/peaks/extremum.h"
#include "trivet/response/steady/exact_response.h"

namespace trivet::response {
namespace {

/// Amplitudes of channels in the coordinates of the loading.
Eigen::VectorXd visible_in(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                           const assembly::Loading& loading, double omega) {
  const Eigen::MatrixXcd stiffness = assembled.dynamic_stiffness(omega, omega);
  const Eigen::VectorXd unit = numerics::unit_scale(assembled.matrices).head(stiffness.rows());
  const Eigen::VectorXcd load = unit.asDiagonal() * assembly::exact_right_side(assembled, loading, omega, omega);
  const Eigen::VectorXcd scaled =
      numerics::pivoted_solution(unit.asDiagonal() * stiffness * unit.asDiagonal(), load, false).x;
  const Eigen::VectorXd together = scaled.cwiseAbs().maxCoeff() * unit;
  const ExactValues exact = exact_values(assembled, channels, loading, unit.asDiagonal() * scaled, omega);
  const Eigen::VectorXd ground = loading.motion.vanishes() ? Eigen::VectorXd() : loading.motion.possible(omega);
  Eigen::VectorXd amplitudes = exact.values.cwiseAbs();
  for (Eigen::Index c = 0; c < amplitudes.size(); ++c) {
    const auto curve = channels[c].curve();
    const double possible = std::max(
        exact.possible(c),
        numerics::possible_amplitudes(curve, together, ground, Eigen::RowVectorXd::Constant(1, omega)).value());
    if (amplitudes(c) <= numerics::vanishing_share * possible) amplitudes(c) = 0;
  }
  return amplitudes;
}

}  // namespace

Eigen::VectorXd visible_amplitudes(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                                   const assembly::Loading& loading, double omega) {
  Eigen::VectorXd result(std::ssize(channels));
  for (const assembly::AnsweredTogether& group : assembly::by_coordinates(assembled.ground, channels, loading)) {
    const Eigen::VectorXd part = visible_in(assembled, group.channels, group.loading, omega);
    for (Eigen::Index k = 0; k < part.size(); ++k) result(to_index(group.which[k])) = part(k);
  }
  return result;
}

}  // namespace trivet::response
