// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

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

}  // namespace trivet::study
