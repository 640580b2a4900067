// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/quadratic_roots.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/thread_progress.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/sparse_system.h"

namespace trivet::numerics {

StateForm state_form(const DynamicMatrices& given, const Eigen::MatrixXcd& given_sides) {
  assert(given_sides.rows() == given.size());
  const Eigen::VectorXd d = unit_scale(given);
  const DynamicMatrices m = scaled(given, d);
  const Eigen::MatrixXcd h = d.asDiagonal() * given_sides;
  const std::vector<Eigen::Index> p = massive_rows(m.A), z = rows_without(m.size(), p);
  const auto n = to_index(p.size()), k = to_index(z.size());
  assert(n + k == m.size() && "each coordinate has mass or none");
  const Eigen::MatrixXcd K = m.complex_stiffness();
  const double speed = std::sqrt(std::max(K.cwiseAbs().maxCoeff(), std::numeric_limits<double>::min()));
  const Eigen::MatrixXd no_lag = m.B(z, z), mass = m.A(p, p);
  const PivotedLu<Complex> lag(no_lag.cast<Complex>()), inertia(mass.cast<Complex>());
  // z' first, because it acts on v' through the coupling damping; v = speed · w balances the state matrix.
  Eigen::MatrixXcd z_rate(k, 2 * n + k), v_rate(n, 2 * n + k);
  z_rate << K(z, p), speed * m.B(z, p).cast<Complex>(), K(z, z);
  Eigen::MatrixXcd z_input = h(z, Eigen::all), v_input = h(p, Eigen::all);
  if (k > 0) {
    z_rate = -lag.solve(z_rate);
    z_input = lag.solve(z_input);
  }
  v_rate << K(p, p), speed * m.B(p, p).cast<Complex>(), K(p, z);
  // Products are evaluated first: Eigen would add them to the sums in parts.
  const Eigen::MatrixXcd lag_rate = m.B(p, z).cast<Complex>() * z_rate, lag_input = m.B(p, z).cast<Complex>() * z_input;
  v_rate = -inertia.solve(Eigen::MatrixXcd(v_rate + lag_rate));
  v_input = inertia.solve(Eigen::MatrixXcd(v_input - lag_input));
  StateForm form;
  form.real = !m.lossy();
  form.state = Eigen::MatrixXcd::Zero(2 * n + k, 2 * n + k);
  form.state.block(0, n, n, n) = speed * Eigen::MatrixXcd::Identity(n, n);
  form.state.middleRows(n, n) = v_rate / speed;
  form.state.bottomRows(k) = z_rate;
  form.input = Eigen::MatrixXcd::Zero(2 * n + k, h.cols());
  form.input.middleRows(n, n) = v_input / speed;
  form.input.bottomRows(k) = z_input;
  form.output = Eigen::MatrixXcd::Zero(m.size(), 2 * n + k);
  for (Eigen::Index i = 0; i < n; ++i) form.output(p[i], i) = d(p[i]);
  for (Eigen::Index i = 0; i < k; ++i) form.output(z[i], 2 * n + i) = d(z[i]);
  return form;
}

GeneralEigen eigen_of_states(const StateForm& form, RootParts parts) {
  assert(form.state.rows() == form.state.cols());
  const auto solve = [&](const auto& state) {
    return parts == RootParts::values ? general_eigenvalues(state) : general_eigen(state);
  };
  GeneralEigen found = form.real ? solve(Eigen::MatrixXd(form.state.real())) : solve(form.state);
  if (!found.converged) throw foundation::NotComputable("the eigensolver of the state matrix did not converge");
  return found;
}

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
                                    const Eigen::MatrixXd& K_loss, RootParts parts) {
  const Eigen::Index n = omega.size();
  assert((omega.array() >= 0).all() && B.rows() == n && B.cols() == n && (K_loss.size() == 0 || K_loss.rows() == n));
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
      if (sprung[i] == moving[j]) {
        state(i, s + j) = omega(sprung[i]);
        state(s + j, i) = -omega(sprung[i]);
      }
  for (Eigen::Index i = 0; i < m; ++i) {
    const Eigen::Index row = moving[i];
    for (Eigen::Index j = 0; j < m; ++j) state(s + i, s + j) = -B(row, moving[j]);
    if (K_loss.size() > 0)
      for (Eigen::Index j = 0; j < s; ++j) {
        const Eigen::Index column = sprung[j];
        state(s + i, j) -= Complex(0, K_loss(row, column) / omega(column));
      }
  }
  QuadraticRoots result;
  GeneralEigen found;
  if (s + m > 0) found = eigen_of_states({state, {}, {}, K_loss.size() == 0}, parts);
  const Eigen::Index drifting = n - s;  // each coordinate without stiffness has one zero root (constant displacement) …
  const auto resting_count = to_index(resting.size());  // … and, undamped, a second one (constant velocity)
  result.lambda = Eigen::VectorXcd::Zero(s + m + drifting + resting_count);
  result.vectors = Eigen::MatrixXcd::Zero(n, parts == RootParts::values ? 0 : result.lambda.size());
  result.lambda.head(s + m) = found.values;
  if (parts == RootParts::values) return result;
  const Eigen::VectorXd weight = Eigen::VectorXd::Ones(n);
  for (Eigen::Index k = 0; k < s + m; ++k) {
    for (Eigen::Index i = 0; i < m; ++i) result.vectors(moving[i], k) = found.vectors(s + i, k);
    normalise_by_largest(result.vectors.col(k), weight);
  }
  Eigen::Index k = s + m;
  for (Eigen::Index i = 0; i < n; ++i)
    if (!(omega(i) > 0)) result.vectors(i, k++) = 1;
  for (const Eigen::Index i : resting) result.vectors(i, k++) = 1;
  assert(k == 2 * n && k == result.lambda.size() && "every coordinate has two roots");
  return result;
}

QuadraticRoots roots_from_states(const DynamicMatrices& matrices, RootParts parts) {
  const StateForm form = state_form(matrices, Eigen::MatrixXcd::Zero(matrices.size(), 0));
  if (!form.state.allFinite())
    throw foundation::NotComputable("a coordinate without mass is not supported by stiffness or damping");
  const GeneralEigen found = eigen_of_states(form, parts);
  if (parts == RootParts::values) return {found.values, Eigen::MatrixXcd(matrices.size(), 0)};
  QuadraticRoots result{found.values, form.output * found.vectors};
  const Eigen::VectorXd weight = unit_scale(matrices).cwiseInverse();
  for (Eigen::Index k = 0; k < result.lambda.size(); ++k) normalise_by_largest(result.vectors.col(k), weight);
  return result;
}

namespace {

/// (λ²A + λB + K) v = 0 in extended precision, solved by Newton's method with the factors of a double Jacobian.
class RootRefinement {
 public:
  explicit RootRefinement(const DynamicMatrices& m) : m_(m), stiffness_(m.complex_stiffness()), entries_(m) {}

  struct Root {
    ExtendedComplex lambda;
    ExtendedVector v;              ///< of norm about 1
    Extended first = 0, last = 0;  ///< first and last change of λ
    bool finite = true;
  };

  /// Three steps from a start. The Jacobian is that of the start, which is near enough: each step gains some ten
  /// digits.
  [[nodiscard]] Root refined(const Complex& start, ExtendedVector v) const {
    assert(std::abs(start) > 0 && v.size() == m_.size() && "the Jacobian is scaled by |λ|");
    constexpr int steps = 3;
    Root root{start, std::move(v)};
    const PivotedLu<Complex> jacobian(bordered(start, root.v.cast<Complex>()));
    const Eigen::Index n = m_.size();
    for (int step = 0; step < steps; ++step) {
      const ExtendedVector residual = entries_.polynomial(root.lambda, root.v);
      Eigen::VectorXcd right = Eigen::VectorXcd::Zero(n + 1);
      right.head(n) = -residual.cast<Complex>();
      const Eigen::VectorXcd change = jacobian.solve(right);
      if (!change.allFinite()) {
        root.finite = root.last <= Extended(64) * std::numeric_limits<Extended>::epsilon() * std::abs(root.lambda);
        break;  // the Jacobian is singular to working precision: a double root
      }
      const ExtendedComplex change_of_lambda = ExtendedComplex(change(n)) * Extended(std::abs(start));
      root.lambda += change_of_lambda;
      root.v += change.head(n).cast<ExtendedComplex>();
      root.last = std::abs(change_of_lambda);
      if (step == 0) root.first = root.last;
    }
    return root;
  }

 private:
  /// [Q(λ), Q'(λ)v |λ|; |λ|² vᴴ, 0] for the unknowns v and λ/|λ|: all blocks have the size of Q.
  [[nodiscard]] Eigen::MatrixXcd bordered(const Complex& lambda, const Eigen::VectorXcd& v) const {
    const Eigen::Index n = m_.size();
    const double size = std::abs(lambda);
    Eigen::MatrixXcd j = Eigen::MatrixXcd::Zero(n + 1, n + 1);
    j.topLeftCorner(n, n) = stiffness_ + lambda * m_.B + lambda * lambda * m_.A;
    j.col(n).head(n) = size * (Complex(2) * lambda * (m_.A * v) + m_.B * v);
    j.row(n).head(n) = size * size * v.adjoint();
    return j;
  }

  const DynamicMatrices& m_;
  Eigen::MatrixXcd stiffness_;
  SparseSystem entries_;
};

}  // namespace

void refine_roots(const DynamicMatrices& given, QuadraticRoots& roots) {
  const Eigen::VectorXd d = unit_scale(given);
  const DynamicMatrices matrices = scaled(given, d);
  const RootRefinement refinement(matrices);
  const double scale = roots.lambda.size() ? roots.lambda.cwiseAbs().maxCoeff() : 0;
  const Eigen::VectorXd weight = d.cwiseInverse();
  const Eigen::VectorXcd starts = roots.lambda;
  for (Eigen::Index k = 0; k < roots.lambda.size(); ++k) {
    if (std::abs(roots.lambda(k)) == 0) continue;
    foundation::report_progress(foundation::thread_progress(), "roots",
                                static_cast<double>(k) / static_cast<double>(roots.lambda.size()));
    // With loss factors these are no motions, and as poles of a response farther from every ω > 0 than ω itself.
    if (matrices.lossy() && starts(k).imag() < 0) continue;
    if (k > 0 && !matrices.lossy() && starts(k).imag() < 0 &&
        starts(k) == std::conj(starts(k - 1))) {  // the conjugate of the previous root
      roots.lambda(k) = std::conj(roots.lambda(k - 1));
      roots.vectors.col(k) = roots.vectors.col(k - 1).conjugate();
      continue;
    }
    const bool real = roots.lambda(k).imag() == 0 && !matrices.lossy();
    const RootRefinement::Root found = refinement.refined(
        starts(k), (weight.asDiagonal() * roots.vectors.col(k)).normalized().cast<ExtendedComplex>());
    const bool small = found.first <= Extended(1e-6) * Extended(scale);
    const bool converged = found.last <= Extended(1e-3) * found.first ||
        found.last <= Extended(16) * Extended(epsilon) * std::abs(found.lambda);
    if (!found.finite || !small || !converged) continue;
    roots.lambda(k) =
        Complex(static_cast<double>(found.lambda.real()), real ? 0.0 : static_cast<double>(found.lambda.imag()));
    roots.vectors.col(k) = d.asDiagonal() * found.v.cast<Complex>();
    normalise_by_largest(roots.vectors.col(k), weight);
  }
}

}  // namespace trivet::numerics
