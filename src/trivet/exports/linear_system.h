// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace trivet::exports {

/// A state, an input or an output.
struct Signal {
  std::string name;         ///< unique among all signals of the system
  std::string unit;         ///< coherent SI: "m", "rad/s", "N m", "m/s²"; empty if it has none
  std::string description;  ///< may be empty
  double nominal = 1;       ///< typical size, > 0, in this unit; the integrator of an importer needs it for states
};

/// x' = A x + B u, y = C x + D u, with n states, m inputs and p outputs, in SI units.
struct LinearSystem {
  std::string title;
  std::vector<Signal> states, inputs, outputs;
  Eigen::MatrixXd A;        ///< n × n
  Eigen::MatrixXd B;        ///< n × m
  Eigen::MatrixXd C;        ///< p × n
  Eigen::MatrixXd D;        ///< p × m
  Eigen::VectorXd initial;  ///< states at the start, n; zero if it is empty
};

/// Initial states, zero if the system names none.
[[nodiscard]] Eigen::VectorXd initial_states(const LinearSystem& system);

/// @throws foundation::InvalidInput if a matrix has another size or an entry that is not finite, a name is empty, not
/// printable or used twice, a nominal is not above 0, or a text is not printable
void check(const LinearSystem& system);

}  // namespace trivet::exports
