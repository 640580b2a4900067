// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/numerics/linalg/dynamic_matrices.h"
#include "trivet/numerics/linalg/eigenvalues.h"

namespace trivet::numerics {

/// First-order form of A q̈ + B q̇ + (K + iK_loss) q = h: ẋ = state · x + input, q = output · x.
struct StateForm {
  Eigen::MatrixXcd state, input, output;
  bool real = true;  ///< the state matrix has no imaginary part
};

/// States (q, q̇, z), scaled; z are the coordinates without mass, which need a regular block of B.
/// Not finite if that block or the mass matrix of the others is singular.
[[nodiscard]] StateForm state_form(const DynamicMatrices& matrices, const Eigen::MatrixXcd& right_sides);

/// What is wanted of an eigenproblem: λ alone takes less than half of the time.
enum class RootParts { values, values_and_vectors };

/// @throws foundation::NotComputable if the eigensolver does not converge
[[nodiscard]] GeneralEigen eigen_of_states(const StateForm& form, RootParts parts = RootParts::values_and_vectors);

/// Roots λ and vectors v of a quadratic eigenproblem (λ²A + λB + K + iK_loss) v = 0.
struct QuadraticRoots {
  Eigen::VectorXcd lambda;
  Eigen::MatrixXcd vectors;  ///< n × count, largest component (A-weighted) equal to 1; n × 0 if not wanted
};

/// Roots from the state matrix in coordinates where A = 1 and K = diag(ω²): [0 Ω; −Ω − iK_loss Ω⁻¹, −B]. Coordinates
/// with ω = 0 give exact zero roots; if also undamped, they give two each and are excluded from the state matrix.
[[nodiscard]] QuadraticRoots roots_in_modal_basis(const Eigen::VectorXd& omega, const Eigen::MatrixXd& B,
                                                  const Eigen::MatrixXd& K_loss,
                                                  RootParts parts = RootParts::values_and_vectors);

/// Roots of general matrices (unsymmetric or indefinite allowed) from the states (q, q̇, z): one root for each
/// coordinate z without mass (internal ones of elements, with a regular block of B), two for each other coordinate.
[[nodiscard]] QuadraticRoots roots_from_states(const DynamicMatrices& matrices,
                                               RootParts parts = RootParts::values_and_vectors);

/// Refines each nonzero root by Newton steps in extended precision (long double): with light damping a double
/// eigensolver leaves few digits of Re λ. Roots without small, convergent steps (clusters, defective pairs) are
/// unchanged. Cost O(count n³): meant for n ≤ 60.
void refine_roots(const DynamicMatrices& matrices, QuadraticRoots& roots);

/// All roots of λ²A + λB + K + iK_loss. Roots with |λ| ≤ at_rest belong to rigid-body modes; at_rest is 0 if the solver
/// separates these modes exactly.
struct SystemRoots {
  QuadraticRoots roots;
  double at_rest = 0;
};

/// The method depends on the matrices: undamped modes alone, states in undamped modes, or states of the matrices
/// themselves. With vectors, refined in extended precision up to 60 coordinates; λ alone has the digits of the
/// eigensolver, of which light damping leaves few in Re λ. Some coordinates may have no mass.
/// @throws foundation::NotComputable if an eigensolver does not converge, or a coordinate without mass has no stiffness
[[nodiscard]] SystemRoots system_roots(const DynamicMatrices& matrices,
                                       RootParts parts = RootParts::values_and_vectors);

/// Poles of any response at iω = λ; those of rigid-body modes are exactly 0.
[[nodiscard]] Eigen::VectorXcd poles(const SystemRoots& of);

}  // namespace trivet::numerics
