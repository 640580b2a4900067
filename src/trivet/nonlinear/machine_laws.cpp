// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/machine_laws.h"

#include <algorithm>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/nonlinear/rubbing_harmonics.h"

namespace trivet::nonlinear {

using Eigen::Index;
using Eigen::MatrixXd;

namespace {

MatrixXd own_course(const MachineLaws::Rubbing& one, const MatrixXd& course) {
  MatrixXd own(course.rows(), 3);
  own << course.col(one.along), course.middleCols<2>(one.across);
  return own;
}

}  // namespace

MachineLaws::MachineLaws(const std::vector<Deflection>& deflections, Index harmonics, Index of_motion) {
  for (std::size_t j = 0; j < deflections.size(); ++j) {
    single_.emplace_back(deflections[j].law, harmonics, of_motion);
    if (deflections[j].distance)
      distances_.push_back({to_index(j), DistanceHarmonics(*deflections[j].distance, harmonics)});
    if (const auto& rubbing = deflections[j].rubbing)
      rubbings_.push_back({to_index(rubbing->along), to_index(j), rubbing->law});
  }
}

RubbingLoop MachineLaws::loop(const Rubbing& one, const MatrixXd& course, double omega) const {
  const Index C = course.rows(), harmonics = (C - 1) / 2;
  // Eight nodes on a sixty-fourth of the period: turning forces are 1e-4 off. On half of the shortest wave of the
  // motion, which is at most one of the tangents, the error of the integrals is far below.
  constexpr double fewest = 64, per_wave = 2;
  const double longest = foundation::two_pi / std::max(fewest, per_wave * static_cast<double>(harmonics));
  return {one.law, own_course(one, course), single_[to_size(one.along)].course(course.col(one.along), omega).corners(),
          omega, longest};
}

MatrixXd MachineLaws::forces(const MatrixXd& course, double omega) const {
  MatrixXd all = MatrixXd::Zero(course.rows(), course.cols());
  for (Index j = 0; j < course.cols(); ++j)
    if (!single_[to_size(j)].law().is_empty()) all.col(j) = single_[to_size(j)].force_at(course.col(j), omega);
  for (const Distance& one : distances_)
    all.middleCols<3>(one.first) += one.law.force_at(course.middleCols<3>(one.first), omega);
  for (const Rubbing& one : rubbings_)
    all.middleCols<2>(one.across) +=
        rubbing_harmonics(loop(one, course, omega), own_course(one, course), omega, false).force;
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
  for (const Rubbing& one : rubbings_) {
    RubbingHarmonics found = rubbing_harmonics(loop(one, course, omega), own_course(one, course), omega, true);
    all.force.middleCols<2>(one.across) += found.force;
    all.by_omega.middleCols<2>(one.across) += found.by_omega;
    for (std::size_t a = 0; a < 2; ++a)
      for (std::size_t b = 0; b < 3; ++b)
        all.tangents.push_back({one.across + to_index(a), b == 0 ? one.along : one.across + to_index(b) - 1,
                                std::move(found.tangent[a][b])});
  }
  return all;
}

}  // namespace trivet::nonlinear
