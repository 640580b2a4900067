// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/frequency_response.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "trivet/response/carried_motion.h"
#include "trivet/response/exact_response.h"
#include "trivet/response/steady_solution.h"

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

/// Of elements that depend on frequency in their own way, one column of values per ω.
Eigen::MatrixXcd exact_curves(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels, const assembly::Loading& loading,
                              const Eigen::MatrixXcd& q, const std::vector<double>& omega) {
  Eigen::MatrixXcd values(static_cast<Eigen::Index>(channels.size()), q.cols());
  for (Eigen::Index i = 0; i < q.cols(); ++i)
    values.col(i) = exact_values(assembled, channels, loading, q.col(i), omega[static_cast<std::size_t>(i)]).values;
  return values;
}

}  // namespace

FrequencyResponse frequency_response(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                                     const assembly::Loading& loading, const std::vector<double>& angular_frequency) {
  const bool at_rest = std::find(angular_frequency.begin(), angular_frequency.end(), 0.0) != angular_frequency.end();
  const auto beyond = at_rest ? std::nullopt : beyond_carried(assembled, channels, loading);  // at rest such a ground has no motion to go beyond
  if (beyond) return frequency_response(beyond->assembled, beyond->channels, loading, angular_frequency);
  const numerics::SweepResult solved = steady_solution(assembled, loading, angular_frequency);
  const Eigen::RowVectorXd omega = Eigen::Map<const Eigen::RowVectorXd>(angular_frequency.data(), static_cast<Eigen::Index>(angular_frequency.size()));
  Eigen::MatrixXcd ground, exact;
  if (assembled.frequency_dependent()) exact = exact_curves(assembled, channels, loading, solved.response, angular_frequency);
  else ground = loading.motion.at(angular_frequency);
  FrequencyResponse result;
  result.angular_frequency = angular_frequency;
  result.solves = static_cast<int>(angular_frequency.size());
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const assembly::Channel& channel = channels[c];
    Eigen::VectorXcd values;
    if (assembled.frequency_dependent()) values = exact.row(static_cast<Eigen::Index>(c)).transpose();
    else values = numerics::curve_values(channel.curve(), solved.response, ground, omega.cast<Complex>()).transpose();
    result.curves.push_back({channel.name, channel.unit, std::move(values)});
  }
  result.check.fallbacks = solved.fallbacks;
  for (Eigen::Index i = 0; i < solved.backward_error.size(); ++i)
    note_error(solved.backward_error(i), angular_frequency[static_cast<std::size_t>(i)], result.check);
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
