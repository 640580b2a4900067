// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/quadratic_roots.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/eigenvalues.h"
#include "trivet/numerics/linalg/generalized_modes.h"
#include "trivet/numerics/linalg/massless.h"

namespace trivet::numerics {
namespace {

using foundation::epsilon;

/// Extended-precision refinement costs n³ per root; larger systems use the double eigensolver alone.
constexpr Eigen::Index largest_refined = 60;

QuadraticRoots undamped_roots(const GeneralizedModes& modes, RootParts parts) {
  const Eigen::Index n = modes.lambda.size();
  QuadraticRoots result;
  result.lambda.resize(2 * n);
  result.vectors.resize(modes.shapes.rows(), parts == RootParts::values ? 0 : 2 * n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Complex root = std::sqrt(Complex(-modes.lambda(i), 0));
    result.lambda(2 * i) = root;
    result.lambda(2 * i + 1) = -root;
    if (parts == RootParts::values) continue;
    result.vectors.col(2 * i) = result.vectors.col(2 * i + 1) = modes.shapes.col(i).cast<Complex>();
  }
  return result;
}

/// Largest |λ| that counts as 0. The companion matrix splits a double zero root to about √ε of the largest root; but at
/// most `most` roots are zero, two per rigid-body mode, however large the largest root is.
double rest_limit(const QuadraticRoots& roots, Eigen::Index most) {
  if (most == 0) return 0;
  assert(most <= roots.lambda.size());
  Eigen::VectorXd size = roots.lambda.cwiseAbs();
  std::ranges::sort(size);
  return std::min(size(most - 1), 1e-7 * size(size.size() - 1));
}

/// φᵀ M φ with zeros for entries that are only round-off of their cancelling terms. Rigid-body modes may be mixed by
/// any rotation among them: their rows and columns use the largest terms of all of them.
Eigen::MatrixXd without_round_off(const Eigen::MatrixXd& phi, const Eigen::MatrixXd& m,
                                  const std::vector<Eigen::Index>& free) {
  Eigen::MatrixXd available = phi.cwiseAbs().transpose() * m.cwiseAbs() * phi.cwiseAbs();
  if (!free.empty()) {
    const Eigen::RowVectorXd most_of_rows = available(free, Eigen::all).colwise().maxCoeff();
    for (const Eigen::Index i : free) available.row(i) = most_of_rows;
    const Eigen::VectorXd most_of_columns = available(Eigen::all, free).rowwise().maxCoeff();
    for (const Eigen::Index i : free) available.col(i) = available.col(i).cwiseMax(most_of_columns);
  }
  const Eigen::MatrixXd projected = phi.transpose() * m * phi;
  return (projected.array().abs() <= 64 * static_cast<double>(m.rows()) * epsilon * available.array())
      .select(0.0, projected);
}

/// Rotates the rigid-body modes until their projected damping is diagonal: if dampers leave a combination free, single
/// entries of the damping then vanish exactly. Otherwise eigenvalues of round-off would become roots of 1e-18 1/s
/// instead of 0.
void part_free_motions(const DynamicMatrices& m, const std::vector<Eigen::Index>& free, Eigen::MatrixXd& phi) {
  if (free.size() < 2) return;
  const Eigen::MatrixXd motions = phi(Eigen::all, free);
  const Eigen::MatrixXd damping = without_round_off(phi, m.B, free)(free, free);
  if (damping.isDiagonal(0)) return;
  const SymmetricEigen<Eigen::MatrixXd> eigen = symmetric_eigen(Eigen::MatrixXd(0.5 * (damping + damping.transpose())));
  if (!eigen.converged) throw foundation::NotComputable("the symmetric eigensolver did not converge");
  phi(Eigen::all, free) = (motions * eigen.vectors).eval();
}

}  // namespace

SystemRoots system_roots(const DynamicMatrices& m, RootParts parts) {
  if (const PartedSystem parted = parted_system(m); parted.any) {
    SystemRoots result = system_roots(parted.matrices, parts);
    result.roots.vectors = (parted.basis * result.roots.vectors).eval();
    return result;
  }
  if (const ReducedSystem reduced = reduced_system(m); reduced.any) {
    SystemRoots result = system_roots(reduced.matrices, parts);
    result.roots.vectors = (reduced.recovery * result.roots.vectors).eval();
    return result;
  }
  const MassiveSystem massive = massive_system(m);
  const bool massless = massive.A.rows() < m.size();
  const GeneralizedModes modes = generalized_modes(massive.K, massive.A, m.symmetric);
  const bool complete = modes.complex_pairs == 0 && modes.lambda.size() == m.size();
  if (complete && m.B.cwiseAbs().maxCoeff() == 0 && !m.lossy()) return {undamped_roots(modes, parts), 0};
  QuadraticRoots result;
  const bool basis_is_orthonormal =
      !massless && modes.route == ModeRoute::definite_mass && modes.lambda.minCoeff() >= 0;
  if (basis_is_orthonormal) {
    std::vector<Eigen::Index> free;
    for (Eigen::Index i = 0; i < modes.lambda.size(); ++i)
      if (modes.lambda(i) == 0) free.push_back(i);
    Eigen::MatrixXd phi = modes.shapes;
    part_free_motions(m, free, phi);
    // The projected damping of a rigid-body mode that no damper resists is a difference that should vanish exactly.
    const Eigen::MatrixXd damping = without_round_off(phi, m.B, free);
    Eigen::MatrixXd loss;
    if (m.lossy()) loss = without_round_off(phi, m.K_loss, free);
    result = roots_in_modal_basis(modes.lambda.cwiseSqrt(), damping, loss, parts);
    result.vectors = (phi * result.vectors).eval();
  } else {
    result = roots_from_states(m, parts);
  }
  if (parts != RootParts::values && m.size() <= largest_refined) refine_roots(m, result);
  return {result, basis_is_orthonormal ? 0 : rest_limit(result, 2 * (modes.lambda.array() == 0).count())};
}

Eigen::VectorXcd poles(const SystemRoots& of) {
  return (of.roots.lambda.array().abs() <= of.at_rest).select(Complex(0), of.roots.lambda);
}

}  // namespace trivet::numerics
