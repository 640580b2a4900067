// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/laws/law_set.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"

namespace trivet::nonlinear {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

MatrixXd own_course(const LawSet::Rubbing& one, const MatrixXd& course) { return course(Eigen::all, one.on); }

}  // namespace

LawSet::LawSet(const std::vector<Deflection>& deflections, DeflectionScales sizes, Index harmonics, Index of_motion)
    : sizes_(std::move(sizes)) {
  for (std::size_t j = 0; j < deflections.size(); ++j) {
    single_.emplace_back(deflections[j].law, harmonics, of_motion);
    if (deflections[j].distance)
      distances_.push_back({to_index(j), DistanceHarmonics(*deflections[j].distance, harmonics)});
    if (const auto& rubbing = deflections[j].rubbing) {
      const Index first = to_index(j);
      if (rubbing->law.is_ring()) rubbings_.push_back({{first, first + 1, first + 2}, rubbing->law});
      else rubbings_.push_back({{to_index(rubbing->along), first, first + 1}, rubbing->law});
    }
  }
}

/// Newton's method leaves errors of 1e-11 of the largest deflection (numerics::BranchOptions).
VectorXd LawSet::round_off(const MatrixXd& course) const {
  constexpr double share = 1e-10;
  return share * sizes_.largest_of_kind(course.bottomRows(course.rows() - 1).colwise().norm().transpose());
}

LawOverPeriod LawSet::course(Index deflection, const MatrixXd& course, double omega) const {
  return single_[deflection].course(course.col(deflection), omega, round_off(course)(deflection));
}

RubbingLoop LawSet::loop(const Rubbing& one, const MatrixXd& course, double omega, const Steps& steps) const {
  const Index C = course.rows(), harmonics = (C - 1) / 2;
  // Eight nodes on a sixty-fourth of the period: turning forces are 1e-4 off, by the square of the steps. On half of
  // the shortest wave of the motion, which is at most one of the tangents, the error of the integrals is far below.
  constexpr double per_wave = 2;
  const double longest = foundation::two_pi / std::max(steps.fewest, per_wave * static_cast<double>(harmonics));
  const Index first = one.on[0];
  if (!one.law.is_ring())
    return {
        one.law,    own_course(one, course), single_[first].course(course.col(first), omega).corners(), omega, longest,
        steps.rough};
  const auto ring = std::ranges::find(distances_, first, &Distance::first);
  return {one.law,    own_course(one, course), ring->law.corners(course.middleCols<3>(first)), omega, longest,
          steps.rough};
}

/// The errors of turning forces, of second order in the steps, are removed by those of steps of twice the length
/// (Richardson): 1e-5 are left. They are not where only one of both sticks all the time or finds a closed loop.
RubbingHarmonics LawSet::friction(const Rubbing& one, const MatrixXd& course, double omega, bool with_tangent) const {
  constexpr double fewest = 32;
  const MatrixXd own = own_course(one, course);
  const RubbingLoop fine = loop(one, course, omega, {fewest});
  assert(own.cols() == 3 && own.rows() == course.rows());
  RubbingHarmonics found = rubbing_harmonics(fine, own, omega, with_tangent);
  if (fine.points().empty() || fine.always_sticks()) return found;
  const RubbingLoop rough = loop(one, course, omega, {fewest, true});
  if (rough.always_sticks()) return found;
  const RubbingHarmonics other = rubbing_harmonics(rough, own, omega, with_tangent);
  if (!other.force.allFinite()) return found;
  found.force += (found.force - other.force) / 3;
  found.by_omega += (found.by_omega - other.by_omega) / 3;
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b)
      if (found.tangent[a][b].size() > 0) found.tangent[a][b] += (found.tangent[a][b] - other.tangent[a][b]) / 3;
  return found;
}

MatrixXd LawSet::forces(const MatrixXd& course, double omega) const {
  assert(course.cols() == to_index(single_.size()) && "one course for each deflection");
  MatrixXd all = MatrixXd::Zero(course.rows(), course.cols());
  const VectorXd rests_below = round_off(course);
  for (Index j = 0; j < course.cols(); ++j)
    if (!single_[j].law().is_empty()) all.col(j) = single_[j].force_at(course.col(j), omega, rests_below(j));
  for (const Distance& one : distances_)
    all.middleCols<3>(one.first) += one.law.force_at(course.middleCols<3>(one.first), omega);
  for (const Rubbing& one : rubbings_) all(Eigen::all, one.on) += friction(one, course, omega, false).force;
  return all;
}

CoupledForces LawSet::at(const MatrixXd& course, double omega) const {
  assert(course.cols() == to_index(single_.size()) && course.rows() % 2 == 1);
  CoupledForces all{MatrixXd::Zero(course.rows(), course.cols()), MatrixXd::Zero(course.rows(), course.cols()), {}};
  const VectorXd rests_below = round_off(course);
  for (Index j = 0; j < course.cols(); ++j) {
    if (single_[j].law().is_empty()) continue;
    ForceHarmonics found = single_[j].at(course.col(j), omega, rests_below(j));
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
    RubbingHarmonics found = friction(one, course, omega, true);
    all.force(Eigen::all, one.on) += found.force;
    all.by_omega(Eigen::all, one.on) += found.by_omega;
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b)
        if (found.tangent[a][b].size() > 0)
          all.tangents.push_back({one.on[a], one.on[b], std::move(found.tangent[a][b])});
  }
  return all;
}

}  // namespace trivet::nonlinear
