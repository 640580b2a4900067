// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/machine_laws.h"

#include "trivet/foundation/index.h"

namespace trivet::nonlinear {

using Eigen::Index;
using Eigen::MatrixXd;

MachineLaws::MachineLaws(const std::vector<Deflection>& deflections, Index harmonics, Index of_motion) {
  for (std::size_t j = 0; j < deflections.size(); ++j) {
    single_.emplace_back(deflections[j].law, harmonics, of_motion);
    if (deflections[j].distance)
      distances_.push_back({to_index(j), DistanceHarmonics(*deflections[j].distance, harmonics)});
  }
}

MatrixXd MachineLaws::forces(const MatrixXd& course, double omega) const {
  MatrixXd all = MatrixXd::Zero(course.rows(), course.cols());
  for (Index j = 0; j < course.cols(); ++j)
    if (!single_[to_size(j)].law().is_empty()) all.col(j) = single_[to_size(j)].force_at(course.col(j), omega);
  for (const Distance& one : distances_)
    all.middleCols<3>(one.first) += one.law.force_at(course.middleCols<3>(one.first), omega);
  return all;
}

CoupledForces MachineLaws::at(const MatrixXd& course, double omega) const {
  CoupledForces all{MatrixXd::Zero(course.rows(), course.cols()), MatrixXd::Zero(course.rows(), course.cols()), {}};
  for (Index j = 0; j < course.cols(); ++j) {
    if (single_[to_size(j)].law().is_empty()) continue;
    ForceHarmonics found = single_[to_size(j)].at(course.col(j), omega);
    all.force.col(j) = found.force;
    all.by_omega.col(j) = found.by_omega;
    all.tangents.push_back({j, j, std::move(found.tangent)});
  }
  for (const Distance& one : distances_) {
    DistanceHarmonics::Found found = one.law.at(course.middleCols<3>(one.first), omega);
    all.force.middleCols<3>(one.first) += found.force;
    all.by_omega.middleCols<3>(one.first) += found.by_omega;
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b)
        all.tangents.push_back({one.first + to_index(a), one.first + to_index(b), std::move(found.tangent[a][b])});
  }
  return all;
}

}  // namespace trivet::nonlinear
