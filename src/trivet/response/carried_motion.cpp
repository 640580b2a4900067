// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/carried_motion.h"

#include <Eigen/LU>
#include <algorithm>
#include <limits>

namespace trivet::response {
namespace {

/// b + A q, with zero where the sum is below a share of its terms.
template <typename Matrix>
Matrix with_carried(const Matrix& b, const Matrix& a, const Eigen::MatrixXd& q, double round_off) {
  Matrix sum = b + a * q.template cast<typename Matrix::Scalar>();
  const Eigen::MatrixXd terms = b.cwiseAbs() + a.cwiseAbs() * q.cwiseAbs();
  for (Eigen::Index j = 0; j < sum.cols(); ++j)
    for (Eigen::Index i = 0; i < sum.rows(); ++i)
      if (std::abs(sum(i, j)) <= round_off * terms(i, j)) sum(i, j) = 0;
  return sum;
}

assembly::Channel with_carried(assembly::Channel channel, Eigen::Index ground, const Eigen::MatrixXd& q, double round_off) {
  numerics::CurveTerms& g = channel.ground;
  if (g.empty()) g = {Eigen::VectorXcd::Zero(ground), Eigen::VectorXd::Zero(ground), Eigen::VectorXd::Zero(ground)};
  const auto carried = [&](const auto& on_ground, const auto& on_coordinates) {
    using Row = Eigen::Matrix<typename std::decay_t<decltype(on_ground)>::Scalar, 1, Eigen::Dynamic>;
    return Row(with_carried(Row(on_ground.transpose()), Row(on_coordinates.transpose()), q, round_off)).transpose().eval();
  };
  g = {carried(g.on_displacement, channel.on_displacement), carried(g.on_velocity, channel.on_velocity), carried(g.on_acceleration, channel.on_acceleration)};
  if (g.on_displacement.isZero(0) && g.on_velocity.isZero(0) && g.on_acceleration.isZero(0)) g = {};
  return channel;
}

}  // namespace

std::optional<BeyondCarried> beyond_carried(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                                            const assembly::Loading& loading) {
  constexpr double regular = 1e-10, least_round_off = 1e-12;
  const assembly::Ground& ground = assembled.ground;
  if (loading.motion.vanishes() || loading.motion.lowest_power() >= 0 || assembled.frequency_dependent() || ground.K.isZero(0)) return std::nullopt;
  const numerics::DynamicMatrices& m = assembled.matrices;
  const Eigen::VectorXd scale = numerics::unit_scale(m);
  const Eigen::PartialPivLU<Eigen::MatrixXd> stiffness(scale.asDiagonal() * m.K * scale.asDiagonal());
  const double condition = stiffness.rcond();
  if (!(condition > regular)) return std::nullopt;
  const Eigen::MatrixXd loaded = scale.asDiagonal() * ground.K;
  const Eigen::MatrixXd carried = -(scale.asDiagonal() * stiffness.solve(loaded));
  if (!carried.allFinite()) return std::nullopt;
  const double round_off = std::max(least_round_off, 64 * std::numeric_limits<double>::epsilon() / condition);
  BeyondCarried result{assembled, {}};
  assembly::Ground& left = result.assembled.ground;
  left.K.setZero();
  if (m.lossy() || ground.K_loss.size() > 0) {
    const Eigen::MatrixXd of_ground = ground.K_loss.size() > 0 ? ground.K_loss : Eigen::MatrixXd::Zero(ground.K.rows(), ground.K.cols());
    left.K_loss = m.lossy() ? with_carried(of_ground, m.K_loss, carried, round_off) : of_ground;
  }
  left.B = with_carried(ground.B, m.B, carried, round_off);
  left.A = with_carried(ground.A, m.A, carried, round_off);
  for (const assembly::Channel& channel : channels) result.channels.push_back(with_carried(channel, loading.motion.size(), carried, round_off));
  return result;
}

}  // namespace trivet::response
