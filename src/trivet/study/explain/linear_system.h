// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "trivet/assembly/assembled.h"
#include "trivet/foundation/problems.h"
#include "trivet/numerics/linalg/dynamic_matrices.h"
#include "trivet/numerics/linalg/load.h"
#include "trivet/project/project.h"

namespace trivet::study {

/// A q̈ + B q̇ + (K + iK_loss) q = h of the whole system in its free coordinates, SI.
struct SystemMatrices {
  std::vector<std::string> coordinates;  ///< "machine.x", …, then coordinates inside foundations and elements
  std::vector<std::string> units;        ///< "m", "rad"; "1" for coordinates inside elements and modal ones
  numerics::DynamicMatrices matrices;
  bool exact = true;  ///< false: elements depend on frequency, and B and K are of their nearest linear system
  /// h of all harmonic excitations together, motions of the ground included; vanishes without any
  numerics::Load load = numerics::Load(Eigen::Index{0});
};

[[nodiscard]] SystemMatrices system_matrices(const project::Case& variant);

/// Names of the free coordinates in the order of the rows.
[[nodiscard]] std::vector<std::string> row_names(const model::System& system, const assembly::Assembled& assembled);

/// Units of these: "m", "rad", or "1".
[[nodiscard]] std::vector<std::string> row_units(const model::System& system, const assembly::Assembled& assembled);

/// A state, an input or an output.
struct Signal {
  std::string name;
  std::string unit;              ///< coherent SI: "m", "rad/s", "N m", "m/s²"; empty for a pure number
  std::string description = {};  ///< may be empty
  double nominal = 1;            ///< typical size, > 0, in this unit; integrators take their tolerances from it
};

/// ẋ = A x + B u, y = C x + D u of a case, for control design and simulators.
///
/// Inputs are the places and directions of the excitations, whatever their course: NAME.force.x [N] and NAME.moment.x
/// [N m] in body axes for each direction in which the excitation acts; NAME.x [m], NAME.rx [rad] for a moving ground,
/// and their derivatives NAME.x.velocity, NAME.x.acceleration where the equations contain them. Delays are left to the
/// caller. States are displacements and velocities of the free coordinates, or combinations of them where coordinates
/// have no mass.
struct LinearSystem {
  std::string title;
  std::vector<Signal> states, inputs, outputs;
  Eigen::MatrixXd A;             ///< n × n
  Eigen::MatrixXd B;             ///< n × m
  Eigen::MatrixXd C;             ///< p × n
  Eigen::MatrixXd D;             ///< p × m
  Eigen::VectorXd initial = {};  ///< states at the start, n; zero if it is empty
  foundation::Problems warnings = {};
};

/// @param of  outputs, as in `response`  @param quantity  of the motions among them
/// @param nearest  elements that depend on frequency are replaced by their nearest linear system, with a warning
/// @throws foundation::NotComputable for loss factors, for frequency-dependent elements unless `nearest`, and for a
/// travelling wave; InvalidInput for an unknown output
[[nodiscard]] LinearSystem linear_system(const project::Case& variant, const std::vector<std::string>& of,
                                         assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement,
                                         bool nearest = false);

}  // namespace trivet::study
