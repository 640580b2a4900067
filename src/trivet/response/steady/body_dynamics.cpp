// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/steady/body_dynamics.h"

#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/decompositions.h"

namespace trivet::response {
namespace {

using Complex = std::complex<double>;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;
using Factors = numerics::PivotedLu<Complex>;

/// R = [I; X] with derivatives: inner coordinates follow by Z_ii X = −Z_ib, so that Z_i· R = 0.
Jet<MatrixXcd> condensation_basis(const Jet<MatrixXcd>& z, Eigen::Index kept) {
  const Eigen::Index inner = z[0].rows() - kept;
  assert(inner > 0 && kept >= 0 && z[0].rows() == z[0].cols());
  const Factors lu(z[0].bottomRightCorner(inner, inner));
  const auto rows = [&](int k) { return z[k].bottomRows(inner); };
  Jet<MatrixXcd> result;
  for (MatrixXcd& r : result) r = MatrixXcd::Zero(z[0].rows(), kept);
  result[0].topRows(kept).setIdentity();
  result[0].bottomRows(inner) = -lu.solve(MatrixXcd(rows(0).leftCols(kept)));
  result[1].bottomRows(inner) = -lu.solve(MatrixXcd(rows(1) * result[0]));
  result[2].bottomRows(inner) = -lu.solve(MatrixXcd(rows(2) * result[0] + 2.0 * (rows(1) * result[1])));
  return result;
}

template <typename A, typename B>
auto product(const Jet<A>& a, const Jet<B>& b) {
  using T = Eigen::Matrix<Complex, A::RowsAtCompileTime, B::ColsAtCompileTime>;
  return Jet<T>{T(a[0] * b[0]), T(a[1] * b[0] + a[0] * b[1]), T(a[2] * b[0] + 2.0 * (a[1] * b[1]) + a[0] * b[2])};
}

/// Z x = b with derivatives.
Jet<VectorXcd> solution(const Factors& lu, const Jet<MatrixXcd>& z, const Jet<VectorXcd>& b) {
  const auto solve = [&](const VectorXcd& right) {
    VectorXcd x = lu.solve(right);
    const VectorXcd reached = z[0] * x;
    x += lu.solve(VectorXcd(right - reached));
    return x;
  };
  return numerics::solution_jet<double>(solve, z, b);
}

/// Diagonal D that makes the entries of D Z D comparable: metres and radians.
Eigen::VectorXd scale(const MatrixXcd& z) {
  Eigen::VectorXd d(z.rows());
  for (Eigen::Index i = 0; i < z.rows(); ++i) {
    const double size = z.row(i).cwiseAbs().maxCoeff();
    d(i) = size > 0 ? 1 / std::sqrt(size) : 1;
  }
  return d;
}

Dynamics scaled(const Dynamics& given, const Eigen::VectorXd& d) {
  Dynamics result = given;
  for (MatrixXcd& z : result.stiffness) z = d.asDiagonal() * z * d.asDiagonal();
  for (VectorXcd& h : result.load) h = d.asDiagonal() * h;
  for (VectorXcd& c : result.channel) c = d.asDiagonal() * c;
  return result;
}

Factors factors(const MatrixXcd& z) {
  const Factors lu(z);
  if (!(lu.reciprocal_condition() > 4 * std::numeric_limits<double>::epsilon()))
    throw foundation::NotComputable(
        "the dynamic stiffness is singular here: an undamped resonance or a rigid-body mode");
  return lu;
}

}  // namespace

Jet<elements::Matrix12c> element_jet(const assembly::ElementMap& map, double omega) {
  // Taylor coefficients from a circle around ω: eight points leave (radius / distance of the next pole)^8 and little
  // round-off.
  constexpr int points = 8;
  assert(omega > 0 && "the circle is a share of ω");
  const double radius = 1e-3 * omega;
  Jet<elements::Matrix12c> sum;
  for (auto& s : sum) s.setZero();
  for (int j = 0; j < points; ++j) {
    const Complex turn = std::polar(1.0, 2 * std::numbers::pi * (j + 0.5) / points);
    const elements::Matrix12c d = map.dynamic_stiffness(omega + radius * turn, omega);
    sum[0] += d / points;
    sum[1] += d / (points * radius * turn);
    sum[2] += 2.0 * d / (points * radius * radius * turn * turn);
  }
  return sum;
}

ElementJets element_jets(const assembly::Assembled& assembled, double omega) {
  ElementJets jets(assembled.elements.size());
  for (std::size_t e = 0; e < jets.size(); ++e)
    if (assembled.elements[e].frequency_dependent()) jets[e] = element_jet(assembled.elements[e], omega);
  return jets;
}

void Dynamics::add(double weight, const Dynamics& other) {
  for (std::size_t k = 0; k < 3; ++k) {
    stiffness[k] += weight * other.stiffness[k];
    load[k] += weight * other.load[k];
    channel[k] += weight * other.channel[k];
    direct[k] += weight * other.direct[k];
  }
}

Dynamics dynamics(const assembly::Assembled& assembled, const assembly::Channel& channel,
                  const assembly::Loading& loading, double omega, const ElementJets& jets) {
  const numerics::DynamicMatrices& m = assembled.frequency_dependent() ? assembled.constant : assembled.matrices;
  const Eigen::Index n = m.size();
  assert(jets.size() == assembled.elements.size());
  Dynamics result;
  result.stiffness = numerics::stiffness_jet(m, omega);
  result.load = numerics::load_jet(assembly::right_side(assembled, loading).head(n), omega);
  result.channel = numerics::terms_jet(channel, n, omega);
  const bool moving = !loading.motion.vanishes();
  const Jet<VectorXcd> ground = numerics::load_jet(loading.motion, omega);
  if (moving && !channel.ground.empty())
    result.direct = numerics::dot<double>(numerics::terms_jet(channel.ground, loading.motion.size(), omega), ground);
  for (std::size_t e = 0; e < assembled.elements.size(); ++e) {
    if (!jets[e]) continue;
    const assembly::ElementMap& map = assembled.elements[e];
    const MatrixXcd ends = map.ends.topLeftCorner(12, map.end_columns).cast<Complex>();
    const std::vector<Eigen::Index> rows(map.rows.begin(), map.rows.begin() + map.end_columns);
    Jet<MatrixXcd> local;
    Jet<VectorXcd> moved;
    for (std::size_t k = 0; k < 3; ++k) {
      local[k] = (*jets[e])[k];
      moved[k] = moving ? VectorXcd(map.moved_by_ground(ground[k]).head(12)) : VectorXcd::Zero(12);
    }
    const Jet<VectorXcd> from_ground = product(local, moved);
    for (std::size_t k = 0; k < 3; ++k) {
      result.stiffness[k](rows, rows) += ends.transpose() * local[k] * ends;
      result.load[k](rows) -= ends.transpose() * from_ground[k];
      for (const assembly::DynamicForce& force : channel.dynamic_forces) {
        if (force.element != e) continue;
        const Eigen::RowVectorXcd row = force.row.cast<Complex>();
        result.channel[k](rows) += (row * local[k] * ends).transpose();
        result.direct[k] += (row * from_ground[k]).value();
      }
    }
  }
  for (int d = 0; d < channel.derivative; ++d) {
    result.channel = numerics::time_derivative(result.channel, omega);
    result.direct = numerics::time_derivative(result.direct, omega);
  }
  return result;
}

Dynamics body_dynamics(const Dynamics& all, Eigen::Index kept) {
  const Eigen::Index inner = all.stiffness[0].rows() - kept;
  if (inner == 0) return all;
  Jet<MatrixXcd> transposed, upper, inner_stiffness;
  Jet<VectorXcd> inner_load;
  for (std::size_t k = 0; k < 3; ++k) {
    transposed[k] = all.stiffness[k].transpose();
    upper[k] = all.stiffness[k].topRows(kept);
    inner_stiffness[k] = all.stiffness[k].bottomRightCorner(inner, inner);
    inner_load[k] = all.load[k].tail(inner);
  }
  const Jet<MatrixXcd> right = condensation_basis(all.stiffness, kept);
  Jet<MatrixXcd> left = condensation_basis(transposed, kept);
  for (MatrixXcd& l : left) l = l.transpose().eval();
  Jet<Eigen::RowVectorXcd> row;
  Jet<VectorXcd> inner_channel;
  for (std::size_t k = 0; k < 3; ++k) {
    row[k] = all.channel[k].transpose();
    inner_channel[k] = all.channel[k].tail(inner);
  }
  // Inner coordinates that a load moves while the bodies are at rest.
  const Jet<Complex> direct =
      numerics::dot<double>(inner_channel, solution(Factors(inner_stiffness[0]), inner_stiffness, inner_load));
  const auto channel = product(row, right);
  Dynamics result;
  result.stiffness = product(upper, right);
  result.load = product(left, all.load);
  for (std::size_t k = 0; k < 3; ++k) {
    result.channel[k] = channel[k].transpose();
    result.direct[k] = all.direct[k] + direct[k];
  }
  return result;
}

Motion motion(const Dynamics& given) {
  const Eigen::VectorXd d = scale(given.stiffness[0]);
  const Dynamics s = scaled(given, d);
  Motion result;
  result.coordinates = solution(factors(s.stiffness[0]), s.stiffness, s.load);
  result.value = numerics::dot<double>(s.channel, result.coordinates);
  for (std::size_t k = 0; k < 3; ++k) result.value[k] += given.direct[k];
  for (VectorXcd& x : result.coordinates) x = d.asDiagonal() * x;
  return result;
}

std::array<Eigen::VectorXcd, 2> adjoint(const Dynamics& given) {
  const Eigen::VectorXd d = scale(given.stiffness[0]);
  Dynamics s = scaled(given, d);
  for (MatrixXcd& z : s.stiffness) z = z.transpose().eval();
  const Jet<VectorXcd> x = solution(factors(s.stiffness[0]), s.stiffness, s.channel);
  return {VectorXcd(d.asDiagonal() * x[0]), VectorXcd(d.asDiagonal() * x[1])};
}

}  // namespace trivet::response
