// SPDX-License-Identifier: BSD-3-Clause
// The machine of the small questions: the paper's body and suspension, with three discrete dampers instead of B = δK, so that damping is
// general: no two of its modes stay uncoupled.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/assembly/loads.h"
#include "trivet/study/project.h"

namespace trivet::benchmarks {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

struct PaperMachine {
  Matrix6 A, B, K;
  Vector6 load;
};

/// Of a damper c [N s/m] along `direction` at a point: c d dᵀ with d = (direction, point × direction).
inline Matrix6 damper(double c, const Eigen::Vector3d& point, const Eigen::Vector3d& direction) {
  Vector6 d;
  d << direction, point[1] * direction[2] - point[2] * direction[1], point[2] * direction[0] - point[0] * direction[2],
      point[0] * direction[1] - point[1] * direction[0];
  return c * d * d.transpose();
}

inline PaperMachine paper_machine() {
  const study::Project project = study::read_project(TRIVET_PAPER).value();
  const auto& system = project.base().system;
  const assembly::Assembled assembled = assembly::assemble(system);
  PaperMachine m;
  m.A = assembled.matrices.A;
  m.K = assembled.matrices.K;
  m.load = assembly::harmonic_loading(system, assembled).force.at(0).real();
  m.B = damper(900, {-1.2, -0.4, -0.1}, {0, 0, 1}) + damper(700, {-0.2, -1.1, -0.3}, {0.6, 0.8, 0}) + damper(800, {-0.1, -0.2, 0.4}, {1, 0, 0}) +
        2e-4 * m.K;
  return m;
}

/// count frequencies evenly on (0, 200] rad/s.
inline std::vector<double> even_frequencies(std::size_t count, double to = 200) {
  std::vector<double> omega(count);
  for (std::size_t i = 0; i < count; ++i) omega[i] = to * static_cast<double>(i + 1) / static_cast<double>(count);
  return omega;
}

}  // namespace trivet::benchmarks
