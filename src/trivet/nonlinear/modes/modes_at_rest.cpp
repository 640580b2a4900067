// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/modes/modes_at_rest.h"

#include <cmath>

#include "trivet/modal/modes.h"
#include "trivet/numerics/linalg/symmetric_eigen.h"

namespace trivet::nonlinear {

using Eigen::Index;
using Eigen::MatrixXd;

std::vector<ModeAtRest> modes_at_rest(const model::System& system, const assembly::Assembled& assembled,
                                      const MatrixXd& holding) {
  std::vector<ModeAtRest> found;
  const modal::Modes all = modal::modes(system, assembled);
  MatrixXd still(assembled.matrices.size(), 0);
  for (const modal::Mode& mode : all.list) {
    if (mode.eigenvalue_squared != 0) continue;
    still.conservativeResize(Eigen::NoChange, still.cols() + 1);
    still.rightCols<1>() = mode.coordinates / std::sqrt(std::abs(mode.modal_mass));
  }
  if (still.cols() > 0) {
    const auto eigen = numerics::symmetric_eigen(MatrixXd(still.transpose() * holding * still));
    constexpr double round_off = 1e-12;  // of rigid-body modes
    const double least = round_off * holding.diagonal().cwiseAbs().maxCoeff() * still.squaredNorm();
    for (Index i = 0; i < eigen.values.size(); ++i)
      if (eigen.values(i) > least) found.push_back({0, still * eigen.vectors.col(i)});
  }
  for (const modal::Mode& mode : all.list)
    if (mode.angular_frequency && *mode.angular_frequency > 0)
      found.push_back({*mode.angular_frequency, mode.coordinates});
  return found;
}

}  // namespace trivet::nonlinear
