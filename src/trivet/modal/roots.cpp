// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/modal/roots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/modal/foundation_feet.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/quadratic_roots.h"

namespace trivet::modal {

namespace {

using Complex = std::complex<double>;
using foundation::epsilon;

/// A double real root splits into a pair with |Im λ| ≈ √ε |λ|: within this it is critical, not oscillating.
const double critical_split = 8 * std::sqrt(epsilon);

Root classified(const Complex& lambda, double scale, double at_rest) {
  Root root;
  root.eigenvalue = lambda;
  const double size = std::abs(lambda);
  if (size <= at_rest) root.kind = RootKind::rigid;
  else if (lambda.real() > 1e-12 * scale) root.kind = RootKind::growing;
  else if (std::abs(lambda.imag()) <= critical_split * size) root.kind = RootKind::overdamped;
  if (root.kind == RootKind::oscillating) {
    root.angular_frequency = size;
    root.damped_angular_frequency = std::abs(lambda.imag());
    root.damping_ratio = std::abs(lambda.real()) <= epsilon * size ? 0.0 : -lambda.real() / size;
  }
  return root;
}

/// |λ| to twelve digits, so that conjugate pairs stay neighbours whatever their last digit.
double sort_key(const Complex& lambda) {
  const double size = std::abs(lambda);
  if (size == 0) return 0;
  const double unit = std::pow(10.0, std::floor(std::log10(size)) - 11);
  return std::round(size / unit) * unit;
}

/// Moves every oscillating root to one of the exact Z; pairs stay conjugate. Roots that do not converge are marked.
void make_exact(const assembly::Assembled& assembled, double at_rest, numerics::QuadraticRoots& roots,
                foundation::Problems& warnings, std::vector<bool>& inexact) {
  assert(roots.vectors.cols() == roots.lambda.size() && roots.vectors.rows() >= assembled.constant.size());
  assert(to_index(inexact.size()) == roots.lambda.size());
  constexpr double distinct = 1e-6, same = 1e-9;
  const Eigen::VectorXcd starts = roots.lambda;
  const Eigen::Index n = assembled.constant.size();
  int settled = 0, left = 0;
  for (Eigen::Index k = 0; k < roots.lambda.size(); ++k) {
    const Complex start = roots.lambda(k);
    const bool lossy = assembled.matrices.lossy();
    if (std::abs(start) <= at_rest) continue;  // a rigid-body mode
    if (std::abs(start.imag()) <= critical_split * std::abs(start) && lossy) continue;
    if (std::abs(start.imag()) <= critical_split * std::abs(start)) {
      inexact[k] = true;
      ++left;
      continue;
    }
    const bool lower = start.imag() < 0;
    if (lower && lossy) continue;  // has no meaning with a loss factor, and is not listed
    const Eigen::VectorXcd shape =
        lower ? Eigen::VectorXcd(roots.vectors.col(k).conjugate()) : Eigen::VectorXcd(roots.vectors.col(k));
    const ExactRoot root = exact_root(assembled, lower ? std::conj(start) : start, shape);
    // Two different starts end on one root: the second root is lost.
    bool lost = false;
    for (Eigen::Index j = 0; j < k; ++j)
      lost = lost ||
          (std::abs(starts(j) - start) > distinct * std::abs(start) &&
           std::abs(roots.lambda(j) - (lower ? std::conj(root.eigenvalue) : root.eigenvalue)) < same * std::abs(start));
    const bool kept = root.converged && !lost;
    inexact[k] = !kept;
    ++(kept ? settled : left);
    if (!kept) continue;
    roots.lambda(k) = lower ? std::conj(root.eigenvalue) : root.eigenvalue;
    const Eigen::VectorXcd exact = lower ? Eigen::VectorXcd(root.shape.conjugate()) : root.shape;
    roots.vectors.col(k).head(n) = exact;
  }
  if (left > 0)
    warnings.warning("roots",
                     fmt::format("{} of {} roots are those of the nearest linear system", left, settled + left),
                     "with frequency-dependent elements, exact roots are found only if the motion oscillates and the "
                     "iteration converges",
                     "if these roots matter, use the frequency response, which is exact");
}

/// Contributions |φᵀAv|² of every mode (rows) to every root (columns).
Eigen::MatrixXd contributions(const Modes& modes, const Eigen::MatrixXd& A, const Eigen::MatrixXcd& vectors) {
  Eigen::MatrixXd shapes(A.rows(), to_index(modes.list.size()));
  for (std::size_t m = 0; m < modes.list.size(); ++m) shapes.col(to_index(m)) = modes.list[m].coordinates;
  const Eigen::MatrixXd momentum = A.transpose() * shapes, real = vectors.real(), imaginary = vectors.imag();
  return (momentum.transpose() * real).cwiseAbs2() + (momentum.transpose() * imaginary).cwiseAbs2();
}

/// @param parts  contributions of the modes to the root, whose |λ| is `size`
/// @param all    |v|² of all coordinates, scaled; a relaxation inside elements moves only those without mass
std::optional<int> mode_like(const Modes& modes, const Eigen::VectorXd& parts, double all, double size,
                             Eigen::Index massive) {
  constexpr double round_off = 1e-20;  // of squares
  if (modes.list.empty() || !(parts.sum() > round_off * all)) return std::nullopt;
  assert(parts.size() == to_index(modes.list.size()) && "one contribution of each mode");
  Eigen::Index largest = 0;
  if (parts.maxCoeff(&largest) > 0.5 * parts.sum()) return modes.list[largest].number;
  return nearest_mode(modes, size, massive);
}

}  // namespace

const char* name(RootKind kind) {
  switch (kind) {
    case RootKind::oscillating:
      return "oscillating";
    case RootKind::overdamped:
      return "overdamped";
    case RootKind::growing:
      return "growing";
    case RootKind::rigid:
      return "rigid";
  }
  return "";
}

Roots roots(const model::System& system, const assembly::Assembled& assembled, const Modes& modes) {
  const numerics::DynamicMatrices& m = assembled.matrices;
  numerics::SystemRoots all = numerics::system_roots(m);
  numerics::QuadraticRoots& raw = all.roots;
  std::vector<bool> inexact(to_size(raw.lambda.size()), false);
  const auto massive = to_index(numerics::massive_rows(m.A).size());
  const double scale = raw.lambda.size() ? raw.lambda.cwiseAbs().maxCoeff() : 0;
  Roots result;
  if (assembled.frequency_dependent()) make_exact(assembled, all.at_rest, raw, result.remarks, inexact);
  result.poles = numerics::poles(all);
  const Eigen::MatrixXd parts = contributions(modes, m.A, raw.vectors);
  const Eigen::VectorXd per_unit = numerics::unit_scale(m).cwiseInverse();
  for (Eigen::Index k = 0; k < raw.lambda.size(); ++k) {
    Root root = classified(raw.lambda(k), scale, all.at_rest);
    // With a loss factor only the half plane of ω > 0 has a meaning.
    if (m.lossy() && root.kind != RootKind::rigid && !(raw.lambda(k).imag() > 0)) continue;
    root.exact = !inexact[k];
    root.shape.resize(6 * to_index(system.bodies().size()));
    for (std::size_t b = 0; b < system.bodies().size(); ++b)
      root.shape.segment<6>(6 * to_index(b)) = assembled.layout.of_body(b, raw.vectors.col(k));
    root.feet = foundation_feet(system, assembled.layout, raw.vectors.col(k));
    root.nearest_mode = mode_like(modes, parts.col(k), (per_unit.asDiagonal() * raw.vectors.col(k)).squaredNorm(),
                                  std::abs(raw.lambda(k)), massive);
    result.list.push_back(std::move(root));
  }
  std::ranges::stable_sort(result.list, [](const Root& a, const Root& b) {
    return std::make_pair(sort_key(a.eigenvalue), a.eigenvalue.imag()) <
        std::make_pair(sort_key(b.eigenvalue), b.eigenvalue.imag());
  });
  const auto growing = std::ranges::count(result.list, RootKind::growing, &Root::kind);
  if (growing > 0)
    result.warnings.warning(
        "roots", fmt::format("{} root{} with Re λ > 0", growing, growing == 1 ? "" : "s"),
        "the free vibration grows and hides every steady vibration",
        "amplitudes computed for this model have no physical meaning; correct the mass, stiffness or damping data");
  return result;
}

bool cannot_grow(const assembly::Assembled& assembled, const Modes& modes) {
  const numerics::DynamicMatrices& m = assembled.matrices;
  if (assembled.frequency_dependent()) return false;  // the matrices are those of the nearest linear system
  const bool stable_modes = m.symmetric && modes.route == numerics::ModeRoute::definite_mass &&
      (modes.lowest_only || to_index(modes.list.size()) == m.size()) &&
      std::ranges::all_of(modes.list, [](const Mode& mode) { return mode.eigenvalue_squared >= 0; });
  return stable_modes && numerics::is_positive_semidefinite(m.B) &&
      (!m.lossy() || numerics::is_positive_semidefinite(m.K_loss));
}

Roots roots(const model::System& system) {
  const assembly::Assembled assembled = assembly::assemble(system);
  return roots(system, assembled, modes(system, assembled));
}

namespace {

/// True if all elements have a dynamic stiffness at this frequency.
bool is_defined(const assembly::Assembled& assembled, double omega) {
  return omega > 0 && std::ranges::all_of(assembled.elements, [&](const assembly::ElementMap& map) {
           return omega >= map.defined_from && omega <= map.defined_to;
         });
}

}  // namespace

Eigen::MatrixXcd stiffness_slope(const assembly::Assembled& assembled, Complex lambda) {
  assert(std::abs(lambda) > 0 && "the step of the difference is a share of λ");
  // A central difference along the real axis of λ; Z is analytic, so the step may be as coarse as ε^(1/3).
  const double step = 6e-6 * std::abs(lambda), near = lambda.imag();
  const Complex minus_i(0, -1);
  return (assembled.dynamic_stiffness(minus_i * (lambda + step), near) -
          assembled.dynamic_stiffness(minus_i * (lambda - step), near)) /
      (2 * step);
}

ExactRoot exact_root(const assembly::Assembled& assembled, Complex start, const Eigen::VectorXcd& shape) {
  assert(start.imag() > 0 && "D(ω) of the elements is that of a positive frequency");
  assert(assembled.frequency_dependent() && shape.size() >= assembled.constant.size());
  constexpr int most_steps = 25;
  constexpr double settled = 1e-12, strayed = 0.3;
  ExactRoot root{start, shape.head(assembled.constant.size()), false};
  const Eigen::VectorXd scale = numerics::unit_scale(assembled.constant);
  Eigen::VectorXcd v = root.shape.cwiseQuotient(scale.cast<Complex>());
  if (v.norm() == 0) return root;
  v.normalize();
  for (int i = 0; i < most_steps && !root.converged; ++i) {
    const Complex lambda = root.eigenvalue;
    if (!is_defined(assembled, lambda.imag()) || std::abs(lambda - start) > strayed * std::abs(start))
      return {start, shape, false};
    const Eigen::MatrixXcd z =
        scale.asDiagonal() * assembled.dynamic_stiffness(Complex(0, -1) * lambda, lambda.imag()) * scale.asDiagonal();
    const Eigen::MatrixXcd rate = scale.asDiagonal() * stiffness_slope(assembled, lambda) * scale.asDiagonal();
    const Eigen::VectorXcd right = rate * v, u = numerics::lu_solution(z, right);
    const Complex share = v.dot(u);
    if (!std::isfinite(std::abs(share))) {
      root.converged = true;  // singular to the last digit: λ is a root already
      break;
    }
    const Complex change = 1.0 / share;
    root.eigenvalue -= change;
    v = u.normalized();
    root.converged = std::abs(change) <= settled * std::abs(lambda);
  }
  root.shape = scale.asDiagonal() * v;
  Eigen::Index largest = 0;
  v.cwiseAbs().maxCoeff(&largest);
  root.shape *= scale(largest) / root.shape(largest);
  return root;
}

}  // namespace trivet::modal
