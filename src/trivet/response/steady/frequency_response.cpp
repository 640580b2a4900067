// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/steady/frequency_response.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "trivet/assembly/coordinates.h"
#include "trivet/foundation/index.h"
#include "trivet/response/steady/exact_response.h"
#include "trivet/response/steady/steady_motion.h"

namespace trivet::response {
namespace {

using Complex = std::complex<double>;

void note_error(double error, double omega, SolutionCheck& check) {
  if (std::isnan(error)) check.undefined_at.push_back(omega);
  if (error > check.worst_backward_error) {
    check.worst_backward_error = error;
    check.at_angular_frequency = omega;
  }
}

/// Values with frequency-dependent elements, one column per ω.
Eigen::MatrixXcd exact_curves(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                              const assembly::Loading& loading, const Eigen::MatrixXcd& q,
                              const std::vector<double>& omega) {
  Eigen::MatrixXcd values(to_index(channels.size()), q.cols());
  for (Eigen::Index i = 0; i < q.cols(); ++i)
    values.col(i) = exact_values(assembled, channels, loading, q.col(i), omega[i]).values;
  return values;
}

/// Response of all channels in the coordinates of the loading.
FrequencyResponse group_response(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                                 const assembly::Loading& loading, const std::vector<double>& angular_frequency) {
  const numerics::SweepResult solved = steady_solution(assembled, loading, angular_frequency);
  const Eigen::RowVectorXd omega =
      Eigen::Map<const Eigen::RowVectorXd>(angular_frequency.data(), to_index(angular_frequency.size()));
  Eigen::MatrixXcd ground, exact;
  const assembly::GivenCurves given = assembly::given_curves(channels, loading.motion);
  if (assembled.frequency_dependent())
    exact = exact_curves(assembled, channels, loading, solved.response, angular_frequency);
  else ground = given.given.at(angular_frequency);
  FrequencyResponse result;
  result.angular_frequency = angular_frequency;
  result.solves = static_cast<int>(angular_frequency.size());
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const assembly::Channel& channel = channels[c];
    Eigen::VectorXcd values;
    if (assembled.frequency_dependent()) values = exact.row(to_index(c)).transpose();
    else values = numerics::curve_values(given.curves[c], solved.response, ground, omega.cast<Complex>()).transpose();
    result.curves.push_back({channel.name, channel.unit, std::move(values)});
  }
  result.check.fallbacks = solved.fallbacks;
  for (Eigen::Index i = 0; i < solved.backward_error.size(); ++i)
    note_error(solved.backward_error(i), angular_frequency[i], result.check);
  return result;
}

void add(const SolutionCheck& part, SolutionCheck& whole) {
  whole.fallbacks += part.fallbacks;
  if (part.worst_backward_error > whole.worst_backward_error) {
    whole.worst_backward_error = part.worst_backward_error;
    whole.at_angular_frequency = part.at_angular_frequency;
  }
  for (const double omega : part.undefined_at)
    if (std::ranges::find(whole.undefined_at, omega) == whole.undefined_at.end()) whole.undefined_at.push_back(omega);
}

}  // namespace

FrequencyResponse frequency_response(const assembly::Assembled& assembled,
                                     const std::vector<assembly::Channel>& channels, const assembly::Loading& loading,
                                     const std::vector<double>& angular_frequency) {
  const std::vector<assembly::ChannelGroup> groups = assembly::by_coordinates(assembled.ground, channels, loading);
  if (groups.size() == 1) return group_response(assembled, channels, groups[0].loading, angular_frequency);
  FrequencyResponse result;
  result.angular_frequency = angular_frequency;
  result.solves = static_cast<int>(angular_frequency.size());
  result.curves.resize(channels.size());
  for (const assembly::ChannelGroup& group : groups) {
    FrequencyResponse part = group_response(assembled, group.channels, group.loading, angular_frequency);
    for (std::size_t k = 0; k < group.which.size(); ++k) result.curves[group.which[k]] = std::move(part.curves[k]);
    add(part.check, result.check);
  }
  return result;
}

double phase(const Complex& value) {
  if (value.imag() == 0) return value.real() < 0 ? std::numbers::pi : 0.0;
  const double angle = std::arg(value);
  return angle <= -std::numbers::pi ? std::numbers::pi : angle;
}

Eigen::VectorXd continuous_phase(const Eigen::VectorXcd& values) {
  constexpr double turn = 2 * std::numbers::pi;
  Eigen::VectorXd result(values.size());
  double last = 0;
  bool started = false;
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    double angle = phase(values(i));
    if (started && std::isfinite(angle)) angle -= turn * std::round((angle - last) / turn);
    result(i) = angle;
    if (std::isfinite(angle)) {
      last = angle;
      started = true;
    }
  }
  return result;
}

}  // namespace trivet::response
