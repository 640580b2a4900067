// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/exports/linear_system.h"

namespace trivet::test {

/// Ground, spring and damper, mass, spring and damper, mass. Inputs: a force on the second mass, displacement and
/// velocity of the ground. Outputs: acceleration of the second mass, force of the second spring and damper.
inline exports::LinearSystem two_masses() {
  const double m1 = 20, m2 = 3, k1 = 8e5, k2 = 3e5, c1 = 150, c2 = 40;
  exports::LinearSystem system;
  system.title = "Two masses";
  system.states = {{"x1", "m", "", 1e-3}, {"x2", "m", "", 1e-3}, {"v1", "m/s", "", 0.1}, {"v2", "m/s", "", 0.1}};
  system.inputs = {{"force", "N", "on \"mass 2\" <&>"}, {"ground", "m", ""}, {"ground velocity", "m/s", ""}};
  system.outputs = {{"acceleration", "m/s2", ""}, {"spring force", "N", ""}};
  system.A.resize(4, 4);
  system.A.topRows(2) << 0, 0, 1, 0, 0, 0, 0, 1;
  system.A.row(2) << -(k1 + k2) / m1, k2 / m1, -(c1 + c2) / m1, c2 / m1;
  system.A.row(3) << k2 / m2, -k2 / m2, c2 / m2, -c2 / m2;
  system.B = Eigen::MatrixXd::Zero(4, 3);
  system.B(2, 1) = k1 / m1;
  system.B(2, 2) = c1 / m1;
  system.B(3, 0) = 1 / m2;
  system.C.resize(2, 4);
  system.C.row(0) = system.A.row(3);
  system.C.row(1) << -k2, k2, -c2, c2;
  system.D = Eigen::MatrixXd::Zero(2, 3);
  system.D(0, 0) = 1 / m2;
  system.initial.resize(4);
  system.initial << 1e-3, 0, 0.05, 1.0 / 3;
  return system;
}

}  // namespace trivet::test
