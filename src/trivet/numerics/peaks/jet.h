// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>

#include "trivet/numerics/linalg/dynamic_matrices.h"
#include "trivet/numerics/linalg/load.h"
#include "trivet/numerics/peaks/extremum.h"

// Real: double, or extended precision for the refinement of peaks.
namespace trivet::numerics {

/// A quantity with its first and second derivatives with respect to ω [rad/s].
template <typename T>
using Jet = std::array<T, 3>;
template <typename Real>
using ComplexVector = Eigen::Matrix<std::complex<Real>, Eigen::Dynamic, 1>;
template <typename Real>
using ComplexMatrix = Eigen::Matrix<std::complex<Real>, Eigen::Dynamic, Eigen::Dynamic>;

/// Z = K + iK_loss + iωB − ω²A.
template <typename Real>
[[nodiscard]] Jet<ComplexMatrix<Real>> stiffness_jet(const DynamicMatrices& m, Real omega) {
  using Scalar = std::complex<Real>;
  const ComplexMatrix<Real> a = m.A.cast<Scalar>(), b = Scalar(0, 1) * m.B.cast<Scalar>();
  return {m.complex_stiffness().cast<Scalar>() + omega * b - omega * omega * a, b - Real(2) * omega * a, Real(-2) * a};
}

/// h = Σ (iω)^p e^{−iωd} v of a load, ω > 0.
template <typename Real>
[[nodiscard]] Jet<ComplexVector<Real>> load_jet(const Load& load, Real omega) {
  using Scalar = std::complex<Real>;
  Jet<ComplexVector<Real>> jet;
  jet.fill(ComplexVector<Real>::Zero(load.size()));
  for (const LoadTerm& term : load.terms()) {
    const Scalar factor = integer_power(Scalar(0, omega), term.power) * std::polar(Real(1), -omega * Real(term.delay));
    const Scalar rate(Real(term.power) / omega, -Real(term.delay));  // of its logarithm
    const ComplexVector<Real> value = term.value.cast<Scalar>() * factor;
    jet[0] += value;
    jet[1] += value * rate;
    jet[2] += value * (rate * rate - Real(term.power) / (omega * omega));
  }
  return jet;
}

/// c = c0 + iω c1 − ω² c2 of the first n coordinates.
template <typename Real>
[[nodiscard]] Jet<ComplexVector<Real>> terms_jet(const CurveTerms& terms, Eigen::Index n, Real omega) {
  using Scalar = std::complex<Real>;
  const ComplexVector<Real> velocity = Scalar(0, 1) * terms.on_velocity.head(n).cast<Scalar>(),
                            acceleration = -terms.on_acceleration.head(n).cast<Scalar>();
  return {terms.on_displacement.head(n).cast<Scalar>() + omega * velocity + omega * omega * acceleration,
          velocity + Real(2) * omega * acceleration, Real(2) * acceleration};
}

/// cᵀq.
template <typename Real>
[[nodiscard]] Jet<std::complex<Real>> dot(const Jet<ComplexVector<Real>>& c, const Jet<ComplexVector<Real>>& q) {
  const auto with = [&](std::size_t j, std::size_t k) -> std::complex<Real> { return c[j].cwiseProduct(q[k]).sum(); };
  return {with(0, 0), with(1, 0) + with(0, 1), with(2, 0) + Real(2) * with(1, 1) + with(0, 2)};
}

/// iω y.
template <typename T, typename Real>
[[nodiscard]] Jet<T> time_derivative(const Jet<T>& y, Real omega) {
  const std::complex<Real> i(0, 1);
  return {T(i * omega * y[0]), T(i * (y[0] + omega * y[1])), T(i * (Real(2) * y[1] + omega * y[2]))};
}

/// Solution x of Z x = b. @param solve  applies Z⁻¹ to a vector
template <typename Real, typename Solve>
[[nodiscard]] Jet<ComplexVector<Real>> solution_jet(const Solve& solve, const Jet<ComplexMatrix<Real>>& z,
                                                    const Jet<ComplexVector<Real>>& b) {
  Jet<ComplexVector<Real>> x;
  x[0] = solve(b[0]);
  x[1] = solve(ComplexVector<Real>(b[1] - z[1] * x[0]));
  x[2] = solve(ComplexVector<Real>(b[2] - Real(2) * (z[1] * x[1]) - z[2] * x[0]));
  return x;
}

}  // namespace trivet::numerics
