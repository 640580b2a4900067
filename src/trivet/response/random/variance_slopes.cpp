// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/random/variance_slopes.h"

#include <array>
#include <cassert>
#include <cmath>
#include <complex>

#include "trivet/assembly/coordinates.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/load.h"
#include "trivet/numerics/sweep/frequency_sweep.h"
#include "trivet/response/random/basis_integrals.h"
#include "trivet/response/random/random_variance.h"

namespace trivet::response {
namespace {

using Complex = std::complex<double>;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;

/// A result and its inputs in one model.
struct RandomSetup {
  assembly::Channel channel;
  RandomLoading loading;
  std::vector<assembly::Loading> motions;  ///< per input, in the coordinates that suit the result
  std::vector<numerics::Load> sides;       ///< per input: h of Z q = h
};

RandomSetup setup_of(const model::System& system, const assembly::Assembled& assembled, const RandomResult& result) {
  RandomSetup setup{assembly::channels(system, assembled, {result.channel}, result.quantity).front(),
                    random_loading(system, assembled, result.excitations),
                    {},
                    {}};
  for (const RandomInput& input : setup.loading.inputs) {
    setup.motions.push_back(assembly::by_coordinates(assembled.ground, {setup.channel}, input.loading).front().loading);
    setup.sides.push_back(assembly::right_side(assembled, setup.motions.back()));
  }
  return setup;
}

/// c as the right side of Zᵀλ = c.
numerics::Load adjoint_load(const assembly::Channel& channel, Eigen::Index n) {
  numerics::Load load(n);
  load.add({channel.derivative, 0, channel.on_displacement.head(n)});
  load.add({channel.derivative + 1, 0, channel.on_velocity.head(n).cast<Complex>()});
  load.add({channel.derivative + 2, 0, channel.on_acceleration.head(n).cast<Complex>()});
  return load;
}

numerics::DynamicMatrices transposed(const numerics::DynamicMatrices& m) {
  numerics::DynamicMatrices result = m;
  if (m.symmetric) return result;
  for (Eigen::MatrixXd* each : {&result.A, &result.B, &result.K, &result.K_loss}) each->transposeInPlace();
  return result;
}

/// Poles off the axis, for panels: an undamped one that the result does not contain must not stop them.
VectorXcd poles_beside_axis(const VectorXcd& poles) {
  constexpr double beside = 1e-8;
  const double fastest = poles.size() ? poles.cwiseAbs().maxCoeff() : 0;
  std::vector<Complex> moving;
  for (const Complex& pole : poles)
    if (std::abs(pole) > 1e-9 * fastest)
      moving.emplace_back(std::min(pole.real(), -beside * std::abs(pole)), pole.imag());
  return Eigen::Map<const VectorXcd>(moving.data(), to_index(moving.size()));
}

/// dV as a linear function of changes of Z, h and c: what one input contributes, W_k = 2 Σ_j H_j* S_jk dω per node.
/// With H = cᵀq, q = Z⁻¹h and the adjoint λ = Z⁻ᵀc, dV = Re Σ_k W_k dH_k and dH = dcᵀq + λᵀdh − λᵀdZ q.
class InputShare {
 public:
  InputShare(const VectorXcd& s, VectorXcd weight, const MatrixXcd& adjoint, const MatrixXcd& q)
      : s_(s), weight_(std::move(weight)), adjoint_(adjoint), q_(q) {
    for (int m = 0; m < 3; ++m) of_stiffness_[m] = adjoint_ * weighted(m, 0).asDiagonal() * q_.transpose();
  }

  [[nodiscard]] double of_matrices(const MatrixRates& rates) const {
    const auto product = [](const MatrixXcd& a, const Eigen::MatrixXd& b) { return a.cwiseProduct(b).sum(); };
    return -(product(of_stiffness_[0], rates.K) + Complex(0, 1) * product(of_stiffness_[0], rates.K_loss) +
             product(of_stiffness_[1], rates.B) + product(of_stiffness_[2], rates.A))
                .real();
  }
  [[nodiscard]] double of_load(const numerics::Load& load) const {
    double sum = 0;
    for (const numerics::LoadTerm& term : load.terms())
      sum += (adjoint_ * weighted(term.power, term.delay)).cwiseProduct(term.value).sum().real();
    return sum;
  }
  [[nodiscard]] double of_channel(const assembly::Channel& channel) const {
    const Eigen::Index n = q_.rows();
    const auto product = [&](int power, const auto& row) {
      return (q_ * weighted(channel.derivative + power, 0)).cwiseProduct(row.head(n)).sum().real();
    };
    return product(0, channel.on_displacement) + product(1, channel.on_velocity.template cast<Complex>()) +
        product(2, channel.on_acceleration.template cast<Complex>());
  }
  /// Of the part of the result that the ground contributes directly.
  [[nodiscard]] double of_ground(const assembly::Channel& channel, const numerics::Load& motion) const {
    if (channel.ground.empty()) return 0;
    double sum = 0;
    for (const numerics::LoadTerm& term : motion.terms()) {
      const auto product = [&](int power, const auto& row) {
        const Complex at_nodes = weighted(channel.derivative + power + term.power, term.delay).sum();
        return (at_nodes * row.cwiseProduct(term.value).sum()).real();
      };
      sum += product(0, channel.ground.on_displacement) +
          product(1, channel.ground.on_velocity.template cast<Complex>()) +
          product(2, channel.ground.on_acceleration.template cast<Complex>());
    }
    return sum;
  }

 private:
  /// W s^power e^{−s delay}
  [[nodiscard]] VectorXcd weighted(int power, double delay) const {
    return weight_.binaryExpr(s_, [&](const Complex& w, const Complex& s) {
      return w * numerics::integer_power(s, power) * std::exp(-s * delay);
    });
  }

  const VectorXcd& s_;
  VectorXcd weight_;
  const MatrixXcd& adjoint_;
  const MatrixXcd& q_;
  std::array<MatrixXcd, 3> of_stiffness_;
};

/// Everything solved at the nodes.
class SolvedNodes {
 public:
  SolvedNodes(const assembly::Assembled& assembled, const RandomSetup& setup, const VectorXcd& poles)
      : nodes_(gauss_nodes(panel_ends(poles_beside_axis(poles), setup.loading, random_moments({setup.channel}, {})))),
        s_(Complex(0, 1) * nodes_.omega) {
    const std::vector<double> omega(nodes_.omega.begin(), nodes_.omega.end());
    const Eigen::Index n = assembled.matrices.size();
    adjoint_ = numerics::sweep(transposed(assembled.matrices), adjoint_load(setup.channel, n), omega).response;
    for (std::size_t k = 0; k < setup.sides.size(); ++k) {
      q_.push_back(numerics::sweep(assembled.matrices, setup.sides[k], omega).response);
      const numerics::Load& motion = setup.motions[k].motion;
      const MatrixXcd given = motion.vanishes() ? MatrixXcd(0, 0) : motion.at(omega);
      values_.push_back(
          numerics::curve_values(setup.channel.curve(), q_.back(), given, nodes_.omega.transpose().cast<Complex>()));
    }
  }

  /// @param variance  is increased by the part of this input
  [[nodiscard]] InputShare share(const RandomSetup& setup, std::size_t k, double& variance) const {
    assert(k < values_.size() && setup.loading.inputs.size() == values_.size());
    VectorXcd weight = VectorXcd::Zero(s_.size());
    for (std::size_t j = 0; j < values_.size(); ++j) {
      const VectorXcd density = cross_density(setup.loading, j, k, nodes_.omega);
      if (density.size() == 0) continue;
      const VectorXcd conjugate = values_[j].adjoint();
      weight += 2 * conjugate.cwiseProduct(density).cwiseProduct(nodes_.weight.cast<Complex>());
    }
    variance += weight.cwiseProduct(values_[k].transpose()).sum().real() / 2;
    return {s_, std::move(weight), adjoint_, q_[k]};
  }

 private:
  IntegrationNodes nodes_;
  VectorXcd s_;
  MatrixXcd adjoint_;
  std::vector<MatrixXcd> q_;                 ///< per input
  std::vector<Eigen::RowVectorXcd> values_;  ///< H
};

/// What the loads and rows of a setup contribute; only differences of it have a meaning.
double of_setup(const InputShare& share, const RandomSetup& setup, std::size_t k) {
  return share.of_load(setup.sides[k]) + share.of_channel(setup.channel) +
      share.of_ground(setup.channel, setup.motions[k].motion);
}

}  // namespace

Eigen::RowVectorXd rms_slopes(const model::System& system, const assembly::Assembled& assembled,
                              const RandomResult& result, const Eigen::VectorXcd& poles,
                              const std::vector<WeightedModels>& models) {
  const RandomSetup here = setup_of(system, assembled, result);
  const SolvedNodes solved(assembled, here, poles);
  double variance = 0;
  std::vector<InputShare> shares;
  for (std::size_t k = 0; k < here.sides.size(); ++k) shares.push_back(solved.share(here, k, variance));
  Eigen::RowVectorXd slopes(to_index(models.size()));
  for (std::size_t j = 0; j < models.size(); ++j) {
    const MatrixRates rates = matrix_rates(models[j], assembled);
    double change = 0;
    for (const InputShare& share : shares) change += share.of_matrices(rates);
    for (const WeightedModel& model : models[j]) {
      const RandomSetup there = setup_of(*model.system, *model.assembled, result);
      assert(there.sides.size() == shares.size() && "neighbouring models have the same excitations");
      for (std::size_t k = 0; k < shares.size(); ++k)
        change += model.weight * (of_setup(shares[k], there, k) - of_setup(shares[k], here, k));
    }
    slopes(to_index(j)) = change / (2 * variance);
  }
  return slopes;
}

}  // namespace trivet::response
