// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/bristle_harmonics.h"

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

/// d/dφ of all columns of coefficients.
MatrixXd phase_derivatives(const MatrixXd& coefficients) {
  MatrixXd found(coefficients.rows(), coefficients.cols());
  for (Index j = 0; j < coefficients.cols(); ++j) found.col(j) = numerics::phase_derivative(coefficients.col(j));
  return found;
}

/// Bristles that do not move stick with their stiffness, but for a mean that they forget.
MatrixXd sticking(const elements::LuGreFriction& law, Index count, double omega) {
  MatrixXd stiffness = law.stiffness * MatrixXd::Identity(count, count);
  stiffness(0, 0) = 0;
  return stiffness + omega * (law.damping + law.viscous) * phase_derivatives(MatrixXd::Identity(count, count));
}

}  // namespace

BristleHarmonics bristle_harmonics(const BristleLoop& loop, const VectorXd& deflection, double omega,
                                   bool with_tangent) {
  const elements::LuGreFriction& law = loop.law();
  const Index count = deflection.size(), harmonics = (count - 1) / 2, nodes = loop.phases().size();
  BristleHarmonics found{VectorXd::Zero(count), {}, {}};
  if (!loop.moves()) {
    if (with_tangent) {
      found.tangent = sticking(law, count, omega);
      found.by_omega.setZero(count);
    }
    return found;
  }
  MatrixXd basis(count, nodes);
  Eigen::RowVectorXd row;
  for (Index i = 0; i < nodes; ++i) {
    numerics::set_fourier_row(harmonics, loop.phases()(i), row);
    basis.col(i) = row.transpose();
  }
  const MatrixXd integral = basis * (loop.weights() / (two_pi / 2)).asDiagonal();
  const VectorXd bristles = integral * loop.bristles(), rate = numerics::phase_derivative(deflection),
                 bristle_rate = numerics::phase_derivative(bristles);
  found.force = law.stiffness * bristles + omega * (law.damping * bristle_rate + law.viscous * rate);
  found.force(0) -= 2 * loop.at_state();
  if (!with_tangent) return found;
  // dδ/dφ by the coefficients at the nodes.
  MatrixXd slopes = MatrixXd::Zero(nodes, count);
  for (Index k = 1; k <= harmonics; ++k) {
    slopes.col(2 * k - 1) = -static_cast<double>(k) * basis.row(2 * k).transpose();
    slopes.col(2 * k) = static_cast<double>(k) * basis.row(2 * k - 1).transpose();
  }
  const MatrixXd by_motion = integral * loop.variation(slopes);
  found.tangent = law.stiffness * by_motion + omega * law.damping * phase_derivatives(by_motion) +
      omega * law.viscous * phase_derivatives(MatrixXd::Identity(count, count));
  const VectorXd by_omega = integral * loop.variation_by_omega();
  found.by_omega = law.stiffness * by_omega +
      law.damping * (omega * numerics::phase_derivative(by_omega) + bristle_rate) + law.viscous * rate;
  return found;
}

MatrixXcd bristle_variation(const BristleLoop& loop, double mu, double omega, Index harmonics) {
  const elements::LuGreFriction& law = loop.law();
  const Index count = 2 * harmonics + 1, nodes = loop.phases().size();
  Eigen::VectorXcd orders(count);  // i (μ + k)
  for (Index k = 0; k < count; ++k) orders(k) = Complex(0, mu + static_cast<double>(k - harmonics));
  if (!loop.moves())
    return (law.stiffness + omega * (law.damping + law.viscous) * orders.array()).matrix().asDiagonal();
  MatrixXcd waves(nodes, count);
  for (Index i = 0; i < nodes; ++i) {
    const double phase = loop.phases()(i);
    const Complex turn = std::polar(1.0, phase);
    Complex wave = std::polar(1.0, (mu - static_cast<double>(harmonics)) * phase);
    for (Index k = 0; k < count; ++k, wave *= turn) waves(i, k) = wave;
  }
  const MatrixXcd bristles = loop.variation(MatrixXcd(waves * orders.asDiagonal()), std::polar(1.0, two_pi * mu));
  const MatrixXcd amplitudes = waves.adjoint() * ((loop.weights() / two_pi).asDiagonal() * bristles);
  MatrixXcd found = (law.stiffness + omega * law.damping * orders.array()).matrix().asDiagonal() * amplitudes;
  found.diagonal() += omega * law.viscous * orders;
  return found;
}

}  // namespace trivet::nonlinear
