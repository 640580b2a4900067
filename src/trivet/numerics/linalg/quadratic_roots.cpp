// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/quadratic_roots.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/pivoted_lu.h"
#include "trivet/numerics/linalg/state_form.h"

namespace trivet::numerics {
namespace {

using foundation::epsilon;
using Extended = long double;
using ExtendedComplex = std::complex<Extended>;

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
  GeneralEigen found;
  if (s + m > 0) found = eigen_of_states({state, {}, {}, K_loss.size() == 0});
  const Eigen::Index drifting = n - s;  // each coordinate without stiffness has one zero root (constant displacement) …
  const auto resting_count = to_index(resting.size());  // … and, undamped, a second one (constant velocity)
  result.lambda = Eigen::VectorXcd::Zero(s + m + drifting + resting_count);
  result.vectors = Eigen::MatrixXcd::Zero(n, result.lambda.size());
  result.lambda.head(s + m) = found.values;
  const Eigen::VectorXd weight = Eigen::VectorXd::Ones(n);
  for (Eigen::Index k = 0; k < s + m; ++k) {
    for (Eigen::Index i = 0; i < m; ++i) result.vectors(moving[to_size(i)], k) = found.vectors(s + i, k);
    normalise_by_largest(result.vectors.col(k), weight);
  }
  Eigen::Index k = s + m;
  for (Eigen::Index i = 0; i < n; ++i)
    if (!(omega(i) > 0)) result.vectors(i, k++) = 1;
  for (const Eigen::Index i : resting) result.vectors(i, k++) = 1;
  return result;
}

QuadraticRoots roots_from_states(const DynamicMatrices& matrices) {
  const StateForm form = state_form(matrices, Eigen::MatrixXcd::Zero(matrices.size(), 0));
  const GeneralEigen found = eigen_of_states(form);
  QuadraticRoots result{found.values, form.output * found.vectors};
  const Eigen::VectorXd weight = unit_scale(matrices).cwiseInverse();
  for (Eigen::Index k = 0; k < result.lambda.size(); ++k) normalise_by_largest(result.vectors.col(k), weight);
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
