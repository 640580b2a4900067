// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/assembly/answer_coordinates.h"

#include <algorithm>
#include <cassert>

#include "trivet/foundation/index.h"

namespace trivet::assembly {
namespace {

/// True if a row has a nonzero term, from `first` on, for a coordinate that the motion moves.
template <typename Row>
bool holds(const Row& row, const Eigen::VectorXcd& motion, Eigen::Index first) {
  assert(row.size() == motion.size() && "a channel has one coefficient for each ground coordinate");
  for (Eigen::Index j = first; j < motion.size(); ++j)
    if (row(j) != typename Row::Scalar(0) && motion(j) != 0.0) return true;
  return false;
}

/// True if the result does not contain the followed motions, except through the inertia of elements.
bool is_relative(const Ground& ground, const Channel& channel, const numerics::Load& followed) {
  return channel.ground.empty() || std::ranges::none_of(followed.terms(), [&](const numerics::LoadTerm& term) {
           return holds(channel.ground.on_displacement, term.value, ground.followed_row()) ||
               holds(channel.ground.on_velocity, term.value, ground.followed_row());
         });
}

bool follows(const Ground& ground, const numerics::Load& motion) {
  return std::ranges::any_of(
      motion.terms(), [&](const numerics::LoadTerm& term) { return !term.value.tail(ground.followed()).isZero(0); });
}

}  // namespace

Loading following(const Ground& ground, const Loading& loading) {
  Loading result{loading.force, numerics::Load(loading.motion.size())};
  for (const numerics::LoadTerm& term : loading.motion.terms()) {
    Eigen::VectorXcd value = term.value;
    assert(value.size() == ground.size() && "a motion has a value for each ground coordinate");
    for (std::size_t t = 0; t < ground.together.size(); ++t) {
      const std::vector<Eigen::Index>& rows = ground.together[t];
      const Eigen::Matrix<std::complex<double>, 6, 1> moved = value.segment<6>(rows.front());
      if (!std::ranges::all_of(rows, [&](Eigen::Index row) { return value.segment<6>(row) == moved; })) continue;
      value.segment<6>(ground.followed_row() + 6 * to_index(t)) += moved;
      for (const Eigen::Index row : rows) value.segment<6>(row).setZero();
    }
    result.motion.add({term.power, term.delay, value});
  }
  return result;
}

std::vector<AnsweredTogether> by_coordinates(const Ground& ground, const std::vector<Channel>& channels,
                                             const Loading& loading) {
  AnsweredTogether in_space{{}, {}, loading}, relative{{}, {}, loading};
  bool drifts = !loading.motion.vanishes() && loading.motion.lowest_power() < 0;
  if (drifts) {
    relative.loading = following(ground, loading);
    drifts = follows(ground, relative.loading.motion);
  }
  for (std::size_t c = 0; c < channels.size(); ++c) {
    AnsweredTogether& group = drifts && is_relative(ground, channels[c], relative.loading.motion) ? relative : in_space;
    group.which.push_back(c);
    group.channels.push_back(channels[c]);
  }
  if (relative.which.empty()) return {in_space};
  if (in_space.which.empty()) return {relative};
  return {relative, in_space};
}

GivenCurves given_curves(const std::vector<Channel>& channels, const numerics::Load& motion) {
  bool as_displacement = false, as_acceleration = false;
  for (const Channel& channel : channels)
    for (const numerics::LoadTerm& term : motion.terms()) {
      if (channel.ground.empty()) continue;
      as_displacement = as_displacement || holds(channel.ground.on_displacement, term.value, 0) ||
          holds(channel.ground.on_velocity, term.value, 0);
      as_acceleration = as_acceleration || holds(channel.ground.on_acceleration, term.value, 0);
    }
  if (as_displacement) return {motion, curves(channels)};
  GivenCurves result{numerics::Load(motion.size()), curves(channels)};
  for (numerics::ObservedCurve& curve : result.curves) {
    if (as_acceleration && !curve.of_given.empty()) {
      const Eigen::VectorXd none = Eigen::VectorXd::Zero(motion.size());
      curve.of_given = {curve.of_given.on_acceleration.cast<std::complex<double>>(), none, none};
    } else {
      curve.of_given = {};
    }
  }
  if (as_acceleration)
    for (const numerics::LoadTerm& term : motion.terms()) result.given.add({term.power + 2, term.delay, term.value});
  return result;
}

}  // namespace trivet::assembly
