// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <string>

#include "trivet/assembly/second_order.h"

namespace trivet::study {

/// ω², ascending, and modes of a stiffness on coordinates in which the inertia is the unit matrix.
struct UnitModes {
  Eigen::VectorXd squares;
  Eigen::MatrixXd shapes;
};
[[nodiscard]] UnitModes unit_modes(const Eigen::MatrixXd& stiffness);

/// Least share of the kinetic energy in the purest coordinate over the modes of a body. Modes that nearly agree are
/// left out: their shapes turn among themselves.
/// @param motion, momentum  of its centre of mass, six components, for unit coordinates
[[nodiscard]] double least_decoupling(const Eigen::MatrixXd& motion, const Eigen::MatrixXd& momentum,
                                      const UnitModes& modes);

/// A reason for which the requirements of combinations have no bound.
struct NoSum {
  std::string reason;
};

/// Inertia, stiffness and static load of one model, of which combinations of mounts are sums.
struct SummedModel {
  Eigen::MatrixXd inertia, stiffness;         ///< of vibration
  Eigen::MatrixXd first, rest_stiffness;      ///< of the first order: of vibration, of static results
  Eigen::VectorXd load, beside;               ///< at rest, and its part that meets the forces at rest; empty without
  assembly::SecondOrderForms forces_at_rest;  ///< empty without
};

/// @throws NoSum for models whose matrices are no sums
[[nodiscard]] SummedModel summed_model(const model::System& system, const assembly::Assembled& assembled);

/// Forces at rest on p of q = Φ p, n² × (1 + n): without displacements, and per displacement at rest.
[[nodiscard]] Eigen::MatrixXd on_shapes(const assembly::SecondOrderForms& forms, const Eigen::MatrixXd& shapes);

/// Entry by entry over √(M_ii M_jj), but for round-off of the largest entry: soft modes beside stiff ones have few
/// digits.
[[nodiscard]] bool equal(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
/// Of the largest entry.
[[nodiscard]] bool equal(const Eigen::VectorXd& a, const Eigen::VectorXd& b);

}  // namespace trivet::study
