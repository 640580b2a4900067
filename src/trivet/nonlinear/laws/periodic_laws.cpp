// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/laws/periodic_laws.h"

#include <algorithm>
#include <cassert>

#include "trivet/foundation/index.h"
#include "trivet/numerics/periodic/fourier_basis.h"

namespace trivet::nonlinear {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

PeriodicLaws::PeriodicLaws(const LawSet& laws, const VectorXd& deflections, double frequency) : omega(frequency) {
  const std::vector<LawHarmonics>& single = laws.single();
  const Index C = deflections.size() / to_index(single.size());
  harmonics = (C - 1) / 2;
  assert(C % 2 == 1 && deflections.size() == C * to_index(single.size()) && "one course for each deflection");
  const MatrixXd motion = deflections.reshaped(C, to_index(single.size()));
  const VectorXd rests_below = laws.round_off(motion);
  for (std::size_t j = 0; j < single.size(); ++j) {
    courses.push_back(single[j].course(motion.col(to_index(j)), omega, rests_below(to_index(j))));
    is_piecewise_linear = is_piecewise_linear && single[j].law().is_piecewise_linear();
  }
  for (const LawSet::Distance& one : laws.distances()) {
    distances.push_back({one.first, &one.law, deflections.segment(one.first * C, 3 * C).reshaped(C, 3)});
    is_piecewise_linear = false;
  }
  for (const LawSet::Rubbing& one : laws.rubbings()) {
    RubbingLoop loop = laws.loop(one, deflections.reshaped(C, to_index(single.size())), omega);
    is_piecewise_linear = false;
    rubbings.push_back({one.on, std::move(loop)});
  }
  for (std::size_t j = 0; j < courses.size(); ++j)
    for (const HystereticLoop& loop : courses[j].loops())
      (loop.sticks() ? sticking : loops)
          .push_back({to_index(j), &loop, loop.jumps(deflections.segment(to_index(j) * C, C))});
  for (std::size_t j = 0; j < courses.size(); ++j)
    for (const BristleLoop& loop : courses[j].bristles())
      (loop.moves() ? bristles : stuck).push_back({to_index(j), &loop});
}

bool PeriodicLaws::is_damped() const {
  return std::ranges::any_of(courses, [](const LawOverPeriod& course) { return course.is_damped(); }) ||
      std::ranges::any_of(distances, [](const Distance& one) { return one.law->law().has_dampers(); }) ||
      !rubbings.empty();
}

std::vector<double> TangentsAlong::list() const {
  std::vector<double> all;
  for (const VectorXd* part : {&by_deflection, &by_rate, &by_travel, &by_start})
    all.insert(all.end(), part->begin(), part->end());
  return all;
}

MatrixXd TangentsAlong::stiffness(const PeriodicLaws& motion) const {
  MatrixXd all = by_deflection.asDiagonal();
  for (std::size_t h = 0; h < motion.loops.size(); ++h) {
    const Index j = motion.loops[h].deflection;
    all(j, j) += by_travel(to_index(h));
  }
  for (std::size_t d = 0; d < distances.size(); ++d)
    all.block<3, 3>(motion.distances[d].first, motion.distances[d].first) += distances[d].by_deflection;
  for (std::size_t r = 0; r < rubbings.size(); ++r)
    all(motion.rubbings[r].on, motion.rubbings[r].on) += rubbings[r].by_deflection;
  return all;
}

MatrixXd TangentsAlong::damping(const PeriodicLaws& motion) const {
  MatrixXd all = by_rate.asDiagonal();
  for (std::size_t b = 0; b < bristles.size(); ++b) {
    const Index j = motion.bristles[b].deflection;
    all(j, j) += bristles[b].by_rate;
  }
  for (std::size_t d = 0; d < distances.size(); ++d)
    all.block<3, 3>(motion.distances[d].first, motion.distances[d].first) += distances[d].by_rate;
  for (std::size_t r = 0; r < rubbings.size(); ++r)
    all(motion.rubbings[r].on, motion.rubbings[r].on) += rubbings[r].by_rate;
  return all;
}

MatrixXd TangentsAlong::forces(const PeriodicLaws& motion, const MatrixXd& values, const MatrixXd& rates) const {
  const Index n = values.cols();
  MatrixXd rows = MatrixXd::Zero(values.rows(), n + 2 * by_travel.size());
  rows.leftCols(n) = by_deflection.asDiagonal() * values + by_rate.asDiagonal() * rates;
  for (Index h = 0; h < by_travel.size(); ++h) {
    const Index j = motion.loops[h].deflection;
    rows.row(j).head(n) += by_travel(h) * values.row(j);
    rows(j, n + 2 * h) = -by_travel(h);
    rows(j, n + 2 * h + 1) = by_start(h);
  }
  return rows;
}

namespace {

TangentsAlong::Rubbing tangents_of(const RubbingLoop& loop, double phase, double omega) {
  TangentsAlong::Rubbing found{loop.moment(phase), -loop.law().own_stiffness(), Eigen::Matrix3d::Zero()};
  const RubbingLoop::Moment& here = found.moment;
  const ContactFrame& frame = here.frame;
  if (here.state == RubbingLoop::State::open) return found;
  found.by_deflection += frame.turned(here.friction);
  if (here.state == RubbingLoop::State::sticks) {
    ContactFrame::Rows friction = loop.law().law().stiffness * frame.on_wall;
    friction.row(0) *= frame.hoop;
    friction.row(0) -= frame.curvature * here.friction.x() * frame.normal;
    found.by_deflection += frame.tangents.transpose() * friction;
    return found;
  }
  const Eigen::Vector3d along_slip = frame.tangents.transpose() * here.direction;
  found.by_deflection +=
      along_slip * (here.limit.by_deflection * frame.normal + here.limit.by_rate * omega * here.rates.normal);
  found.by_rate = along_slip * here.limit.by_rate * frame.normal;
  return found;
}

}  // namespace

void set_tangents(const PeriodicLaws& motion, double phase, TangentsAlong& found) {
  const Index count = to_index(motion.courses.size()), loops = to_index(motion.loops.size());
  found.by_deflection.resize(count);
  found.by_rate.resize(count);
  found.by_travel.resize(loops);
  found.by_start.resize(loops);
  numerics::set_fourier_row(motion.harmonics, phase, found.row);
  for (Index j = 0; j < count; ++j) {
    if (motion.courses[j].has_no_law()) {  // a deflection of a distance
      found.by_deflection(j) = found.by_rate(j) = 0;
      continue;
    }
    const DeviationLaw::Force here = motion.courses[j].at(found.row);
    found.by_deflection(j) = here.by_deviation;
    found.by_rate(j) = here.by_rate;
  }
  found.distances.clear();
  for (const PeriodicLaws::Distance& one : motion.distances)
    found.distances.push_back(one.law->at_row(one.course, motion.omega, found.row));
  const auto on_loop = [&](const PeriodicLaws::Loop& one) {
    return one.loop->at(one.loop->branch_at(phase), motion.courses[one.deflection].deflection_at(phase));
  };
  for (const PeriodicLaws::Loop& one : motion.sticking) found.by_deflection(one.deflection) += on_loop(one).by_travel;
  found.bristles.clear();
  for (const PeriodicLaws::Bristles& one : motion.bristles) found.bristles.push_back(one.loop->at(phase));
  found.rubbings.clear();
  for (const PeriodicLaws::Rubbing& one : motion.rubbings)
    found.rubbings.push_back(tangents_of(one.loop, phase, motion.omega));
  for (const PeriodicLaws::Bristles& one : motion.stuck) {
    found.by_deflection(one.deflection) += one.loop->law().stiffness;
    found.by_rate(one.deflection) += one.loop->law().damping + one.loop->law().viscous;
  }
  for (Index h = 0; h < loops; ++h) {
    const elements::ForceOnTravel here = on_loop(motion.loops[h]);
    found.by_travel(h) = here.by_travel;
    found.by_start(h) = here.by_start;
  }
}

}  // namespace trivet::nonlinear
