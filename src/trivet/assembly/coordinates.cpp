// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/assembly/coordinates.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/decompositions.h"

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

std::vector<ChannelGroup> by_coordinates(const Ground& ground, const std::vector<Channel>& channels,
                                         const Loading& loading) {
  ChannelGroup in_space{{}, {}, loading}, relative{{}, {}, loading};
  bool drifts = !loading.motion.vanishes() && loading.motion.lowest_power() < 0;
  if (drifts) {
    relative.loading = following(ground, loading);
    drifts = follows(ground, relative.loading.motion);
  }
  for (std::size_t c = 0; c < channels.size(); ++c) {
    ChannelGroup& group = drifts && is_relative(ground, channels[c], relative.loading.motion) ? relative : in_space;
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
