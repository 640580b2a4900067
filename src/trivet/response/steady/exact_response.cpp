// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/steady/exact_response.h"

#include <cmath>
#include <limits>
#include <tuple>

#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/refined_solution.h"

namespace trivet::response {
namespace {

using Complex = std::complex<double>;

/// Value of a channel, and the sum of the magnitudes of its terms. `g`: motion of the ground, empty if it is at rest.
std::pair<Complex, double> value(const assembly::Assembled& assembled, const assembly::Channel& channel,
                                 const Eigen::VectorXcd& q, const Eigen::VectorXcd& g, Complex omega, double near) {
  numerics::ObservedCurve curve = channel.curve();
  curve.derivative = 0;  // applied last, also to the dynamic forces
  const Eigen::RowVectorXcd at = Eigen::RowVectorXcd::Constant(1, omega);
  Complex y = numerics::curve_values(curve, q, g, at).value();
  double possible = numerics::possible_amplitudes(curve, q.cwiseAbs(), g.cwiseAbs(), at.cwiseAbs()).value();
  for (const assembly::DynamicForce& force : channel.dynamic_forces) {
    const assembly::ElementMap& map = assembled.elements[force.element];
    Eigen::Matrix<Complex, 12, 1> ends = Eigen::Matrix<Complex, 12, 1>::Zero();
    for (Eigen::Index j = 0; j < map.end_columns; ++j)
      ends += map.ends.col(j).head<12>().cast<Complex>() * q(map.rows[j]);
    if (g.size() > 0) ends += map.moved_by_ground(g).head<12>();
    const elements::Matrix12c stiffness = map.dynamic_stiffness(omega, near);
    const Eigen::Matrix<Complex, 12, 1> wrenches = stiffness * ends;
    possible += force.row.cwiseAbs() * (stiffness.cwiseAbs() * ends.cwiseAbs());
    y += force.row.transpose().cast<Complex>().cwiseProduct(wrenches).sum();
  }
  for (int d = 0; d < channel.derivative; ++d) {
    y *= Complex(0, 1) * omega;
    possible *= std::abs(omega);
  }
  return {y, possible};
}

}  // namespace

ExactValues exact_values(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                         const assembly::Loading& loading, const Eigen::VectorXcd& coordinates, Complex omega,
                         double near) {
  const auto count = to_index(channels.size());
  const Eigen::VectorXcd ground = loading.motion.vanishes() ? Eigen::VectorXcd() : loading.motion.at(omega);
  ExactValues result{Eigen::VectorXcd(count), Eigen::VectorXd(count)};
  for (Eigen::Index c = 0; c < count; ++c)
    std::tie(result.values(c), result.possible(c)) = value(assembled, channels[c], coordinates, ground, omega, near);
  return result;
}

ExactResponse::ExactResponse(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                             const assembly::Loading& loading)
    : assembled_(assembled), channels_(channels), scale_(numerics::unit_scale(assembled.constant)), loading_(loading) {}

ExactSample ExactResponse::at(Complex omega, double near) const {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Eigen::MatrixXcd z = scale_.asDiagonal() * assembled_.dynamic_stiffness(omega, near) * scale_.asDiagonal();
  const Eigen::VectorXcd load = scale_.asDiagonal() * assembly::exact_right_side(assembled_, loading_, omega, near);
  numerics::PivotedSolution solution = numerics::pivoted_solution(z, load, true);
  const auto count = to_index(channels_.size());
  ExactSample sample{{Eigen::VectorXcd::Constant(count, Complex(nan, nan)), Eigen::VectorXd::Constant(count, nan)},
                     scale_.asDiagonal() * solution.x,
                     solution.condition,
                     solution.backward_error};
  if (std::isnan(solution.backward_error)) return sample;
  static_cast<ExactValues&>(sample) = exact_values(assembled_, channels_, loading_, sample.coordinates, omega, near);
  return sample;
}

}  // namespace trivet::response
