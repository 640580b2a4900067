// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/steady/channel_terms.h"

#include <algorithm>
#include <cassert>
#include <complex>

#include "trivet/assembly/coordinates.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/dynamic_matrices.h"
#include "trivet/response/steady/exact_response.h"
#include "trivet/response/steady/steady_motion.h"

namespace trivet::response {

namespace {

using Complex = std::complex<double>;
/// Callers treat a result below 1e-12 of `possible` as 0. The round-off of a solution is 1e-14 of its largest
/// coordinate.
constexpr double round_off_share = 1e-2;

std::vector<ChannelTerm> nonzero_terms(const Eigen::VectorXcd& on_displacement, const Eigen::VectorXd& on_velocity,
                                       const Eigen::VectorXd& on_acceleration) {
  std::vector<ChannelTerm> terms;
  assert(on_velocity.size() == on_displacement.size() && on_acceleration.size() == on_displacement.size());
  for (Eigen::Index i = 0; i < on_displacement.size(); ++i)
    if (on_displacement(i) != 0.0 || on_velocity(i) != 0 || on_acceleration(i) != 0)
      terms.push_back({i, {on_displacement(i), on_velocity(i), on_acceleration(i)}});
  return terms;
}

/// Round-off of each channel: this share of its value if all coordinates moved as much as the largest. Needed because
/// an result that vanishes by symmetry is as small as its own terms.
Eigen::MatrixXd round_off(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                          const Eigen::MatrixXcd& q, const Eigen::RowVectorXd& omega) {
  const Eigen::VectorXd unit =
      numerics::unit_scale(assembled.frequency_dependent() ? assembled.constant : assembled.matrices).head(q.rows());
  const Eigen::MatrixXd alike = unit * (unit.cwiseInverse().asDiagonal() * q.cwiseAbs()).colwise().maxCoeff();
  Eigen::MatrixXd result(std::ssize(channels), q.cols());
  for (Eigen::Index c = 0; c < result.rows(); ++c)
    result.row(c) = round_off_share * numerics::possible_amplitudes(channels[c].curve(), alike, {}, omega);
  return result;
}

ChannelSamples exact_samples(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                             const assembly::Loading& loading, const std::vector<double>& omega) {
  const auto count = to_index(channels.size()), points = to_index(omega.size());
  ChannelSamples result{Eigen::MatrixXcd(count, points), Eigen::MatrixXd(count, points)};
  const Eigen::MatrixXcd q = steady_solution(assembled, loading, omega).response;
  for (Eigen::Index i = 0; i < points; ++i) {
    const ExactValues exact = exact_values(assembled, channels, loading, q.col(i), omega[i]);
    result.value.col(i) = exact.values;
    result.possible.col(i) = exact.possible;
  }
  const Eigen::RowVectorXd at = Eigen::Map<const Eigen::RowVectorXd>(omega.data(), points);
  result.possible = result.possible.cwiseMax(round_off(assembled, channels, q, at));
  return result;
}

/// Samples of all channels in the coordinates of the loading.
ChannelSamples samples_in(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                          const assembly::Loading& loading, const std::vector<double>& omega) {
  if (assembled.frequency_dependent()) return exact_samples(assembled, channels, loading, omega);
  const auto count = to_index(channels.size()), points = to_index(omega.size());
  ChannelSamples result{Eigen::MatrixXcd(count, points), Eigen::MatrixXd(count, points)};
  const Eigen::MatrixXcd q = steady_solution(assembled, loading, omega).response;
  const assembly::GivenCurves given = assembly::given_curves(channels, loading.motion);
  const Eigen::MatrixXcd ground = given.given.at(omega);
  const Eigen::RowVectorXd at = Eigen::Map<const Eigen::RowVectorXd>(omega.data(), points);
  const Eigen::MatrixXd size = q.cwiseAbs(), ground_size = ground.cwiseAbs();
  for (Eigen::Index c = 0; c < count; ++c) {
    const numerics::ObservedCurve& curve = given.curves[c];
    result.value.row(c) = numerics::curve_values(curve, q, ground, at.cast<Complex>());
    result.possible.row(c) = numerics::possible_amplitudes(curve, size, ground_size, at);
  }
  result.possible = result.possible.cwiseMax(round_off(assembled, channels, q, at));
  return result;
}

}  // namespace

std::vector<ChannelTerms> channel_terms(const std::vector<assembly::Channel>& channels) {
  std::vector<ChannelTerms> result;
  for (const assembly::Channel& channel : channels)
    result.push_back(
        {channel.derivative, nonzero_terms(channel.on_displacement, channel.on_velocity, channel.on_acceleration),
         nonzero_terms(channel.ground.on_displacement, channel.ground.on_velocity, channel.ground.on_acceleration)});
  return result;
}

ChannelSamples channel_samples(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                               const assembly::Loading& loading, const std::vector<double>& omega) {
  const std::vector<assembly::ChannelGroup> groups = assembly::by_coordinates(assembled.ground, channels, loading);
  if (groups.size() == 1) return samples_in(assembled, channels, groups[0].loading, omega);
  assert(groups.size() == 2 && groups[0].which.size() + groups[1].which.size() == channels.size());
  ChannelSamples result{Eigen::MatrixXcd(std::ssize(channels), std::ssize(omega)),
                        Eigen::MatrixXd(std::ssize(channels), std::ssize(omega))};
  for (const assembly::ChannelGroup& group : groups) {
    const ChannelSamples part = samples_in(assembled, group.channels, group.loading, omega);
    for (Eigen::Index k = 0; k < std::ssize(group.which); ++k) {
      const auto row = to_index(group.which[k]);
      result.value.row(row) = part.value.row(k);
      result.possible.row(row) = part.possible.row(k);
    }
  }
  return result;
}

namespace {

numerics::Load undelayed_load(const numerics::Load& load, double delay) {
  numerics::Load part(load.size());
  for (const numerics::LoadTerm& term : load.terms())
    if (term.delay == delay) part.add({term.power, 0, term.value});
  return part;
}

}  // namespace

assembly::Loading undelayed(const assembly::Loading& loading, double delay) {
  return {undelayed_load(loading.force, delay), undelayed_load(loading.motion, delay)};
}

std::vector<double> delays_of(const assembly::Loading& loading) {
  std::vector<double> delays;
  for (const numerics::Load* load : {&loading.force, &loading.motion})
    for (const numerics::LoadTerm& term : load->terms()) delays.push_back(term.delay);
  if (delays.empty()) delays.push_back(0);
  std::ranges::sort(delays);
  delays.erase(std::ranges::unique(delays).begin(), delays.end());
  return delays;
}

Eigen::VectorXcd summed(const Eigen::VectorXcd& parts, const std::vector<double>& delays, double omega) {
  assert(!delays.empty() && parts.size() % std::ssize(delays) == 0 && "all curves by the first delay, then the next");
  const Eigen::Index curves = parts.size() / std::ssize(delays);
  Eigen::VectorXcd sum = Eigen::VectorXcd::Zero(curves);
  for (std::size_t d = 0; d < delays.size(); ++d)
    sum += std::polar(1.0, -omega * delays[d]) * parts.segment(to_index(d) * curves, curves);
  return sum;
}

}  // namespace trivet::response
