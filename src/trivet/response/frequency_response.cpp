// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/frequency_response.h"

#include <cmath>
#include <numbers>

#include "trivet/numerics/frequency_sweep.h"
#include "trivet/response/exact_response.h"

namespace trivet::response {
namespace {

using Complex = std::complex<double>;

/// (iω)^derivative, exact in its zeros.
Complex derivative_factor(double omega, int derivative) {
  if (derivative == 1) return {0, omega};
  if (derivative == 2) return {-omega * omega, 0};
  return {1, 0};
}

/// Columns of coordinates, weighted by the terms of a channel.
Eigen::RowVectorXcd weighted(const Eigen::VectorXcd& on_displacement, const Eigen::VectorXd& on_velocity, const Eigen::VectorXd& on_acceleration,
                             const Eigen::MatrixXcd& q, const Eigen::RowVectorXd& omega) {
  Eigen::RowVectorXcd y = on_displacement.transpose() * q;
  if (!on_velocity.isZero(0))
    y += Complex(0, 1) * (on_velocity.transpose().cast<Complex>() * q).cwiseProduct(omega.cast<Complex>());
  if (!on_acceleration.isZero(0))
    y -= (on_acceleration.transpose().cast<Complex>() * q).cwiseProduct(omega.cwiseAbs2().cast<Complex>());
  return y;
}

Eigen::VectorXcd curve_values(const assembly::Channel& channel, const Eigen::MatrixXcd& q, const Eigen::MatrixXcd& g, const Eigen::RowVectorXd& omega) {
  Eigen::RowVectorXcd y = weighted(channel.on_displacement, channel.on_velocity, channel.on_acceleration, q, omega);
  if (!channel.ground.empty() && g.size() > 0) y += weighted(channel.ground.on_displacement, channel.ground.on_velocity, channel.ground.on_acceleration, g, omega);
  for (Eigen::Index i = 0; i < y.size(); ++i) y(i) *= derivative_factor(omega(i), channel.derivative);
  return y.transpose();
}

void note_error(double error, double omega, SolutionCheck& check) {
  if (std::isnan(error)) check.undefined_at.push_back(omega);
  if (error > check.worst_backward_error) {
    check.worst_backward_error = error;
    check.at_angular_frequency = omega;
  }
}

FrequencyResponse exact_response(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                                 const assembly::Loading& loading, const std::vector<double>& omega) {
  FrequencyResponse result;
  result.angular_frequency = omega;
  result.solves = static_cast<int>(omega.size());
  for (const assembly::Channel& channel : channels)
    result.curves.push_back({channel.name, channel.unit, Eigen::VectorXcd(static_cast<Eigen::Index>(omega.size()))});
  const ExactResponse exact(assembled, channels, loading);
  for (std::size_t i = 0; i < omega.size(); ++i) {
    const ExactSample sample = exact.at(omega[i]);
    for (std::size_t c = 0; c < channels.size(); ++c) result.curves[c].value(static_cast<Eigen::Index>(i)) = sample.values(static_cast<Eigen::Index>(c));
    note_error(sample.backward_error, omega[i], result.check);
  }
  return result;
}

}  // namespace

FrequencyResponse frequency_response(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                                     const assembly::Loading& loading, const std::vector<double>& angular_frequency) {
  if (assembled.frequency_dependent()) return exact_response(assembled, channels, loading, angular_frequency);
  const numerics::SweepResult solved = numerics::sweep(assembled.matrices, assembly::right_side(assembled, loading), angular_frequency);
  const Eigen::RowVectorXd omega = Eigen::Map<const Eigen::RowVectorXd>(angular_frequency.data(), static_cast<Eigen::Index>(angular_frequency.size()));
  Eigen::MatrixXcd ground;
  if (!loading.motion.vanishes()) {
    ground.resize(loading.motion.size(), omega.size());
    for (Eigen::Index i = 0; i < omega.size(); ++i) ground.col(i) = loading.motion.at(omega(i));
  }
  FrequencyResponse result;
  result.angular_frequency = angular_frequency;
  result.solves = static_cast<int>(angular_frequency.size());
  for (const assembly::Channel& channel : channels)
    result.curves.push_back({channel.name, channel.unit, curve_values(channel, solved.response, ground, omega)});
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
