// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "trivet/nonlinear/rest/load_path.h"
#include "trivet/numerics/linalg/eigenvalues.h"
#include "trivet/numerics/search/zeros_and_minima.h"

namespace trivet::nonlinear {

using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Newton's step in each of its own directions: down where the curvature is negative, and as if it were a share of that
/// of the references where there is none.
VectorXd step_down(const VectorXd& curvatures, const VectorXd& slopes) {
  constexpr double none = 1e-9, flat = 1e-3;
  return slopes.binaryExpr(curvatures, [=](double slope, double curvature) {
    return -slope / (curvature > none ? curvature : std::max(std::abs(curvature), flat));
  });
}

}  // namespace

std::optional<VectorXd> LoadPath::released() const {
  constexpr int most = 3000, looks = 8;
  const VectorXd scale = stiffness_.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse();
  if (!scale.allFinite()) return std::nullopt;
  VectorXd now = VectorXd::Zero(load_.size());  // coordinates
  const auto gradient = [&](const VectorXd& q) {
    return VectorXd(stiffness_ * q + across_ * forces(across_.transpose() * q).force - load_);
  };
  for (int i = 0; i < most; ++i) {
    const MatrixXd curvature = stiffness_ + across_ * forces(across_.transpose() * now).tangent * across_.transpose();
    const auto eigen = numerics::symmetric_eigen(
        MatrixXd(scale.asDiagonal() * (0.5 * (curvature + curvature.transpose())) * scale.asDiagonal()));
    const VectorXd slopes = eigen.vectors.transpose() * scale.cwiseProduct(gradient(now));
    VectorXd change = scale.cwiseProduct(eigen.vectors * step_down(eigen.values, slopes));
    if (!change.allFinite()) return std::nullopt;
    const VectorXd deflections = across_.transpose() * now;
    const double size = std::max(deflections.norm(), typical_.norm());
    constexpr double near = 1e-6, unstable = -1e-9, aside = 1e-3;
    if ((across_.transpose() * change).norm() <= near * size) {
      if (eigen.values(0) > unstable) return solved(deflections, 0);
      change = scale.cwiseProduct(eigen.vectors.col(0));  // off the ridge
      now += aside * size / (across_.transpose() * change).norm() * change;
      continue;
    }
    const auto slope = [&](double step) { return gradient(now + step * change).dot(change); };
    double before = 0, step = 1;
    for (int look = 1; look <= looks; ++look) {
      const double here = static_cast<double>(look) / looks, there = slope(here);
      if (!std::isfinite(there)) return std::nullopt;
      if (there > 0) {
        step = slope(before) < 0 ? numerics::zero_between(before, here, slope) : here / 2;
        break;
      }
      before = here;
    }
    now += step * change;
  }
  return std::nullopt;
}

}  // namespace trivet::nonlinear
