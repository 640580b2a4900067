// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/quadratic_roots.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/general_eigen.h"
#include "trivet/numerics/linalg/pivoted_lu.h"

namespace trivet::numerics {
namespace {

using foundation::epsilon;
using Extended = long double;
using ExtendedComplex = std::complex<Extended>;

void eigen(const Eigen::MatrixXcd& matrix, bool real, Eigen::VectorXcd& values, Eigen::MatrixXcd& vectors) {
  GeneralEigen found = real ? general_eigen(Eigen::MatrixXd(matrix.real())) : general_eigen(matrix);
  if (!found.converged) throw foundation::NotComputable("the eigensolver of the state matrix did not converge");
  values = std::move(found.values);
  vectors = std::move(found.vectors);
}

void normalise_by_largest(Eigen::Ref<Eigen::VectorXcd> v, const Eigen::VectorXd& weight) {
  Eigen::Index largest = 0;
  v.cwiseAbs().cwiseProduct(weight).maxCoeff(&largest);
  if (std::abs(v(largest)) > 0) v /= Complex(v(largest));
}

}  // namespace

QuadraticRoots roots_in_modal_basis(const Eigen::VectorXd& omega, const Eigen::MatrixXd& B,
                                    const Eigen::MatrixXd& K_loss) {
  const Eigen::Index n = omega.size();
  const double damping_scale = B.size() > 0 ? B.cwiseAbs().maxCoeff() : 0;
  std::vector<Eigen::Index> sprung, moving, resting;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double coupling = B.row(i).cwiseAbs().maxCoeff();
    if (omega(i) > 0) sprung.push_back(i);
    if (omega(i) > 0 || coupling > 64 * static_cast<double>(n) * epsilon * damping_scale) moving.push_back(i);
    else resting.push_back(i);
  }
  const auto s = to_index(sprung.size()), m = to_index(moving.size());
  Eigen::MatrixXcd state = Eigen::MatrixXcd::Zero(s + m, s + m);
  for (Eigen::Index i = 0; i < s; ++i)
    for (Eigen::Index j = 0; j < m; ++j)
      if (sprung[to_size(i)] == moving[to_size(j)]) {
        state(i, s + j) = omega(sprung[to_size(i)]);
        state(s + j, i) = -omega(sprung[to_size(i)]);
      }
  for (Eigen::Index i = 0; i < m; ++i) {
    const Eigen::Index row = moving[to_size(i)];
    for (Eigen::Index j = 0; j < m; ++j) state(s + i, s + j) = -B(row, moving[to_size(j)]);
    if (K_loss.size() > 0)
      for (Eigen::Index j = 0; j < s; ++j) {
        const Eigen::Index column = sprung[to_size(j)];
        state(s + i, j) -= Complex(0, K_loss(row, column) / omega(column));
      }
  }
  QuadraticRoots result;
  Eigen::VectorXcd values;
  Eigen::MatrixXcd vectors;
  if (s + m > 0) eigen(state, K_loss.size() == 0, values, vectors);
  const Eigen::Index drifting = n - s;  // each coordinate without stiffness has one zero root (constant displacement) …
  const auto resting_count = to_index(resting.size());  // … and, undamped, a second one (constant velocity)
  result.lambda = Eigen::VectorXcd::Zero(s + m + drifting + resting_count);
  result.vectors = Eigen::MatrixXcd::Zero(n, result.lambda.size());
  result.lambda.head(s + m) = values;
  const Eigen::VectorXd weight = Eigen::VectorXd::Ones(n);
  for (Eigen::Index k = 0; k < s + m; ++k) {
    for (Eigen::Index i = 0; i < m; ++i) result.vectors(moving[to_size(i)], k) = vectors(s + i, k);
    normalise_by_largest(result.vectors.col(k), weight);
  }
  Eigen::Index k = s + m;
  for (Eigen::Index i = 0; i < n; ++i)
    if (!(omega(i) > 0)) result.vectors(i, k++) = 1;
  for (const Eigen::Index i : resting) result.vectors(i, k++) = 1;
  return result;
}

QuadraticRoots roots_of_companion(const DynamicMatrices& given) {
  const Eigen::VectorXd d = unit_scale(given);
  const DynamicMatrices matrices = scaled(given, d);
  const Eigen::Index n = matrices.size();
  const PivotedLu<double> mass(matrices.A);
  const Eigen::MatrixXcd stiffness = mass.solve(Eigen::MatrixXd(matrices.complex_stiffness().real())).cast<Complex>() +
      Complex(0, 1) * mass.solve(Eigen::MatrixXd(matrices.complex_stiffness().imag())).cast<Complex>();
  const double speed = std::sqrt(std::max(stiffness.cwiseAbs().maxCoeff(), std::numeric_limits<double>::min()));
  Eigen::MatrixXcd state = Eigen::MatrixXcd::Zero(2 * n, 2 * n);
  state.topRightCorner(n, n) = speed * Eigen::MatrixXcd::Identity(n, n);
  state.bottomLeftCorner(n, n) = -stiffness / speed;
  state.bottomRightCorner(n, n) = -mass.solve(matrices.B).cast<Complex>();
  QuadraticRoots result;
  Eigen::MatrixXcd vectors;
  eigen(state, !matrices.lossy(), result.lambda, vectors);
  result.vectors = d.asDiagonal() * vectors.topRows(n);
  const Eigen::VectorXd weight = d.cwiseInverse();
  for (Eigen::Index k = 0; k < 2 * n; ++k) normalise_by_largest(result.vectors.col(k), weight);
  return result;
}

QuadraticRoots roots_with_massless(const DynamicMatrices& given) {
  const Eigen::VectorXd d = unit_scale(given);
  const DynamicMatrices m = scaled(given, d);
  const std::vector<Eigen::Index> p = massive_rows(m.A);
  std::vector<Eigen::Index> z;
  for (Eigen::Index i = 0; i < m.size(); ++i)
    if (!std::binary_search(p.begin(), p.end(), i)) z.push_back(i);
  const auto n = to_index(p.size()), k = to_index(z.size());
  const Eigen::MatrixXcd K = m.complex_stiffness();
  const double speed = std::sqrt(std::max(K.cwiseAbs().maxCoeff(), std::numeric_limits<double>::min()));
  const Eigen::MatrixXd no_lag = m.B(z, z), mass = m.A(p, p);
  const PivotedLu<Complex> lag(no_lag.cast<Complex>()), inertia(mass.cast<Complex>());
  // z' first, because it acts on v' through the coupling damping; v = speed · w balances the state matrix.
  Eigen::MatrixXcd z_rate(k, 2 * n + k), v_rate(n, 2 * n + k);
  z_rate << K(z, p), speed * m.B(z, p).cast<Complex>(), K(z, z);
  z_rate = -lag.solve(z_rate);
  v_rate << K(p, p), speed * m.B(p, p).cast<Complex>(), K(p, z);
  // The product is evaluated first: Eigen would add it to the sum in parts.
  const Eigen::MatrixXcd lag_rate = m.B(p, z).cast<Complex>() * z_rate;
  v_rate = -inertia.solve(Eigen::MatrixXcd(v_rate + lag_rate));
  Eigen::MatrixXcd state = Eigen::MatrixXcd::Zero(2 * n + k, 2 * n + k);
  state.block(0, n, n, n) = speed * Eigen::MatrixXcd::Identity(n, n);
  state.middleRows(n, n) = v_rate / speed;
  state.bottomRows(k) = z_rate;
  QuadraticRoots result;
  Eigen::MatrixXcd vectors;
  eigen(state, !m.lossy(), result.lambda, vectors);
  result.vectors.resize(m.size(), result.lambda.size());
  for (Eigen::Index i = 0; i < n; ++i) result.vectors.row(p[to_size(i)]) = vectors.row(i);
  for (Eigen::Index i = 0; i < k; ++i) result.vectors.row(z[to_size(i)]) = vectors.row(2 * n + i);
  result.vectors = (d.asDiagonal() * result.vectors).eval();
  const Eigen::VectorXd weight = d.cwiseInverse();
  for (Eigen::Index i = 0; i < result.lambda.size(); ++i) normalise_by_largest(result.vectors.col(i), weight);
  return result;
}

void refine_roots(const DynamicMatrices& given, QuadraticRoots& roots) {
  constexpr int steps = 3;
  const Eigen::VectorXd d = unit_scale(given);
  const DynamicMatrices matrices = scaled(given, d);
  const ExtendedMatrix A = matrices.A.cast<ExtendedComplex>(), B = matrices.B.cast<ExtendedComplex>();
  const ExtendedMatrix K = matrices.complex_stiffness().cast<ExtendedComplex>();
  const double scale = roots.lambda.size() ? roots.lambda.cwiseAbs().maxCoeff() : 0;
  const Eigen::VectorXd weight = d.cwiseInverse();
  const Eigen::VectorXcd starts = roots.lambda;
  for (Eigen::Index k = 0; k < roots.lambda.size(); ++k) {
    if (std::abs(roots.lambda(k)) == 0) continue;
    if (k > 0 && !matrices.lossy() && starts(k).imag() < 0 &&
        starts(k) == std::conj(starts(k - 1))) {  // the conjugate of the previous root
      roots.lambda(k) = std::conj(roots.lambda(k - 1));
      roots.vectors.col(k) = roots.vectors.col(k - 1).conjugate();
      continue;
    }
    const bool real = roots.lambda(k).imag() == 0 && !matrices.lossy();
    ExtendedComplex lambda = roots.lambda(k);
    ExtendedVector v = (weight.asDiagonal() * roots.vectors.col(k)).cast<ExtendedComplex>();
    v.normalize();
    Extended first = 0, last = 0;
    bool finite = true;
    for (int step = 0; step < steps && finite; ++step) {
      const ExtendedMatrix polynomial = lambda * lambda * A + lambda * B + K;
      const ExtendedVector derivative = Extended(2) * lambda * (A * v) + B * v;
      const ExtendedVector u = lu_solution(polynomial, derivative);
      const ExtendedComplex denominator = v.dot(u);
      if (!std::isfinite(std::abs(denominator)) || std::abs(denominator) == 0) {
        finite = last <= Extended(64) * std::numeric_limits<Extended>::epsilon() * std::abs(lambda);
        break;  // the matrix is singular to working precision: λ is already a root
      }
      const ExtendedComplex change = Extended(1) / denominator;
      lambda -= change;
      last = std::abs(change);
      if (step == 0) first = last;
      v = u.normalized();
    }
    const bool small = first <= Extended(1e-6) * Extended(scale);
    const bool converged =
        last <= Extended(1e-3) * first || last <= Extended(16) * Extended(epsilon) * std::abs(lambda);
    if (!finite || !small || !converged) continue;
    roots.lambda(k) = Complex(static_cast<double>(lambda.real()), real ? 0.0 : static_cast<double>(lambda.imag()));
    roots.vectors.col(k) = d.asDiagonal() * v.cast<Complex>();
    normalise_by_largest(roots.vectors.col(k), weight);
  }
}

}  // namespace trivet::numerics
