// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/exact_response.h"

#include <Eigen/LU>
#include <limits>
#include <tuple>

namespace trivet::response {
namespace {

using Complex = std::complex<double>;

/// A channel, and the sum of the magnitudes of its terms.
std::pair<Complex, double> value(const assembly::Assembled& assembled, const assembly::Channel& channel, const Eigen::VectorXcd& q, Complex omega, double near) {
  const Complex i(0, 1);
  const Eigen::Index n = q.size();
  Complex y = channel.on_displacement.head(n).cwiseProduct(q).sum() + i * omega * channel.on_velocity.head(n).cast<Complex>().cwiseProduct(q).sum() -
              omega * omega * channel.on_acceleration.head(n).cast<Complex>().cwiseProduct(q).sum();
  const Eigen::VectorXd size = q.cwiseAbs();
  double possible = channel.on_displacement.head(n).cwiseAbs().dot(size) + std::abs(omega) * channel.on_velocity.head(n).cwiseAbs().dot(size) +
                    std::norm(omega) * channel.on_acceleration.head(n).cwiseAbs().dot(size);
  for (const assembly::DynamicForce& force : channel.dynamic_forces) {
    const assembly::ElementMap& map = assembled.elements[force.element];
    Eigen::Matrix<Complex, 12, 1> ends = Eigen::Matrix<Complex, 12, 1>::Zero();
    for (Eigen::Index j = 0; j < map.end_columns; ++j) ends += map.ends.col(j).head<12>().cast<Complex>() * q(map.rows[static_cast<std::size_t>(j)]);
    const elements::Matrix12c stiffness = map.dynamic_stiffness(omega, near);
    const Eigen::Matrix<Complex, 12, 1> wrenches = stiffness * ends;
    possible += force.row.cwiseAbs() * (stiffness.cwiseAbs() * ends.cwiseAbs());
    y += force.row.transpose().cast<Complex>().cwiseProduct(wrenches).sum();
  }
  for (int d = 0; d < channel.derivative; ++d) {
    y *= i * omega;
    possible *= std::abs(omega);
  }
  return {y, possible};
}

}  // namespace

ExactResponse::ExactResponse(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels, const Eigen::VectorXcd& load)
    : assembled_(assembled), channels_(channels), scale_(numerics::unit_scale(assembled.constant)),
      load_(scale_.asDiagonal() * load.head(assembled.constant.size())) {}

ExactSample ExactResponse::at(Complex omega, double near) const {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Eigen::MatrixXcd z = scale_.asDiagonal() * assembled_.dynamic_stiffness(omega, near) * scale_.asDiagonal();
  const Eigen::PartialPivLU<Eigen::MatrixXcd> lu(z);
  Eigen::VectorXcd q = lu.solve(load_);
  q += lu.solve(load_ - z * q);
  const double norm = z.cwiseAbs().rowwise().sum().maxCoeff();
  const double negligible = 4 * static_cast<double>(z.rows()) * std::numeric_limits<double>::epsilon();
  ExactSample sample{q, Eigen::VectorXcd::Constant(static_cast<Eigen::Index>(channels_.size()), Complex(nan, nan)),
                     Eigen::VectorXd::Constant(static_cast<Eigen::Index>(channels_.size()), nan), std::numeric_limits<double>::infinity(), nan};
  if (!q.allFinite() || lu.matrixLU().diagonal().cwiseAbs().minCoeff() <= negligible * norm) {
    sample.coordinates.setConstant(nan);
    return sample;
  }
  const double size = norm * q.cwiseAbs().maxCoeff() + load_.cwiseAbs().maxCoeff();
  sample.backward_error = size > 0 ? (load_ - z * q).cwiseAbs().maxCoeff() / size : 0;
  sample.condition = 1 / lu.rcond();
  sample.coordinates = scale_.asDiagonal() * q;
  for (std::size_t c = 0; c < channels_.size(); ++c)
    std::tie(sample.values(static_cast<Eigen::Index>(c)), sample.possible(static_cast<Eigen::Index>(c))) = value(assembled_, channels_[c], sample.coordinates, omega, near);
  return sample;
}

}  // namespace trivet::response
