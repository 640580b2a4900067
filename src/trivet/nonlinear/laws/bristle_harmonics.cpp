// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/laws/bristle_harmonics.h"

#include <cassert>
#include <cmath>
#include <complex>

#include "trivet/foundation/constants.h"
#include "trivet/numerics/periodic/fourier_basis.h"

namespace trivet::nonlinear {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using foundation::two_pi;

namespace {

/// Bristles that do not move stick with their stiffness, but for a mean that they forget.
MatrixXd sticking(const elements::LuGreFriction& law, Index count, double omega) {
  MatrixXd stiffness = law.stiffness * MatrixXd::Identity(count, count);
  stiffness(0, 0) = 0;
  return stiffness +
      omega * (law.damping + law.viscous) * numerics::phase_derivatives(MatrixXd::Identity(count, count));
}

}  // namespace

BristleHarmonics bristle_harmonics(const BristleLoop& loop, const VectorXd& deflection, double omega,
                                   bool with_tangent) {
  const elements::LuGreFriction& law = loop.law();
  // F = σ₀ z + σ₁ ż + σ₂ v: of coefficients σ₀ ẑ + ω D (σ₁ ẑ + σ₂ δ̂), D the derivative by the phase.
  assert(deflection.size() % 2 == 1 && loop.weights().size() == loop.phases().size());
  const Index count = deflection.size(), harmonics = (count - 1) / 2, nodes = loop.phases().size();
  BristleHarmonics found{VectorXd::Zero(count), {}, {}};
  if (!loop.moves()) {
    const MatrixXd stuck = sticking(law, count, omega);
    found.force = stuck * deflection;
    if (with_tangent) {
      found.tangent = stuck;
      found.by_omega = sticking(law, count, 1) * deflection - sticking(law, count, 0) * deflection;
    }
    return found;
  }
  MatrixXd basis(count, nodes);
  Eigen::RowVectorXd row;
  for (Index i = 0; i < nodes; ++i) {
    numerics::set_fourier_row(harmonics, loop.phases()(i), row);
    basis.col(i) = row.transpose();
  }
  const VectorXd weights = loop.weights() / (two_pi / 2);
  const VectorXd bristles = basis * weights.cwiseProduct(loop.bristles()),
                 rate = numerics::phase_derivative(deflection), bristle_rate = numerics::phase_derivative(bristles);
  found.force = law.stiffness * bristles + omega * (law.damping * bristle_rate + law.viscous * rate);
  found.force(0) -= 2 * loop.at_state();
  if (!with_tangent) return found;
  // dδ/dφ by the coefficients at the nodes.
  MatrixXd slopes = MatrixXd::Zero(nodes, count);
  for (Index k = 1; k <= harmonics; ++k) {
    slopes.col(2 * k - 1) = -static_cast<double>(k) * basis.row(2 * k).transpose();
    slopes.col(2 * k) = static_cast<double>(k) * basis.row(2 * k - 1).transpose();
  }
  const MatrixXd integral = basis * weights.asDiagonal(), by_motion = integral * loop.variation(slopes);
  found.tangent = law.stiffness * by_motion + omega * law.damping * numerics::phase_derivatives(by_motion) +
      omega * law.viscous * numerics::phase_derivatives(MatrixXd::Identity(count, count));
  const VectorXd by_omega = integral * loop.variation_by_omega();
  found.by_omega = law.stiffness * by_omega +
      law.damping * (omega * numerics::phase_derivative(by_omega) + bristle_rate) + law.viscous * rate;
  return found;
}

namespace {

// As waves turn by at most a period, so that μ turns them by at most π/2 from the middle, the error is below 1e-8.
constexpr int chebyshev_places = 12;

double chebyshev_angle(int place) { return two_pi / 4 * (2 * place + 1) / chebyshev_places; }

/// Place of an interpolation between 0 and 1/2.
double chebyshev_place(int place) { return (1 + std::cos(chebyshev_angle(place))) / 4; }

/// Barycentric weights, whose sum is 1.
Eigen::VectorXd chebyshev_weights(double mu) {
  assert(mu >= 0 && mu <= 0.5 && "other multipliers are those of −μ or μ + 1");
  VectorXd weights(chebyshev_places);
  for (int j = 0; j < chebyshev_places; ++j) {
    const double distance = mu - chebyshev_place(j);
    if (distance == 0) return VectorXd::Unit(chebyshev_places, j);
    weights(j) = (j % 2 == 0 ? 1 : -1) * std::sin(chebyshev_angle(j)) / distance;
  }
  return weights / weights.sum();
}

}  // namespace

BristleVariation::BristleVariation(const BristleLoop& loop, double omega, Index harmonics)
    : law_(loop.law()), moves_(loop.moves()), omega_(omega), faded_(loop.faded()), harmonics_(harmonics) {
  for (int j = 0; moves_ && j < chebyshev_places; ++j) at_places_.push_back(open(loop, chebyshev_place(j)));
}

/// In the wave e^{iμ(φ − φ_0)} from the first turning point on, which cancels in the amplitudes.
BristleVariation::Open BristleVariation::open(const BristleLoop& loop, double mu) const {
  const Index count = 2 * harmonics_ + 1, nodes = loop.phases().size();
  MatrixXcd waves(nodes, count), slopes(nodes, count);
  for (Index i = 0; i < nodes; ++i) {
    const double phase = loop.phases()(i);
    const Complex turn = std::polar(1.0, phase);
    Complex wave = std::polar(1.0, mu * (phase - loop.first_turn()) - static_cast<double>(harmonics_) * phase);
    for (Index k = 0; k < count; ++k, wave *= turn) {
      waves(i, k) = wave;
      slopes(i, k) = Complex(0, mu + static_cast<double>(k - harmonics_)) * wave;
    }
  }
  const MatrixXcd bristles = loop.variation_from_zero(slopes),
                  integral = waves.adjoint() * (loop.weights() / two_pi).asDiagonal();
  return {integral * bristles, integral * loop.fading(), bristles.bottomRows<1>()};
}

MatrixXcd BristleVariation::at(double mu) const {
  const Index count = 2 * harmonics_ + 1;
  Eigen::VectorXcd orders(count);  // i (μ + k)
  for (Index k = 0; k < count; ++k) orders(k) = Complex(0, mu + static_cast<double>(k - harmonics_));
  if (!moves_) return (law_.stiffness + omega_ * (law_.damping + law_.viscous) * orders.array()).matrix().asDiagonal();
  assert(at_places_.size() == static_cast<std::size_t>(chebyshev_places));
  const VectorXd weights = chebyshev_weights(mu);
  Open sum{MatrixXcd::Zero(count, count), Eigen::VectorXcd::Zero(count), Eigen::RowVectorXcd::Zero(count)};
  for (int j = 0; j < chebyshev_places; ++j) {
    const Open& one = at_places_[static_cast<std::size_t>(j)];
    sum.from_zero += weights(j) * one.from_zero;
    sum.fading += weights(j) * one.fading;
    sum.ends += weights(j) * one.ends;
  }
  // A start ζ₀ with ζ(2π) = e^{2πiμ} ζ₀ = ends + e^{−∫ p dδ} ζ₀.
  sum.from_zero += sum.fading * (sum.ends / (std::polar(1.0, two_pi * mu) - faded_));
  MatrixXcd found = (law_.stiffness + omega_ * law_.damping * orders.array()).matrix().asDiagonal() * sum.from_zero;
  found.diagonal() += omega_ * law_.viscous * orders;
  return found;
}

}  // namespace trivet::nonlinear
