// SPDX-License-Identifier: BSD-3-Clause
// The machine of the small questions: the paper's body with corrected inertia and its suspension
// (examples/paper/corrected.toml), with three discrete dampers instead of B = δK, so that damping is general and
// couples all modes.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace trivet::benchmarks {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

struct PaperMachine {
  Matrix6 A, B, K;
  Vector6 load;
};

/// Matrix of a damper c [N s/m] along `direction` at a point: c d dᵀ with d = (direction, point × direction).
inline Matrix6 damper(double c, const Eigen::Vector3d& point, const Eigen::Vector3d& direction) {
  Vector6 d;
  d << direction, point[1] * direction[2] - point[2] * direction[1], point[2] * direction[0] - point[0] * direction[2],
      point[0] * direction[1] - point[1] * direction[0];
  return c * d * d.transpose();
}

inline PaperMachine paper_machine() {
  constexpr double mass = 205.176, x = -0.624 * mass, y = -0.502 * mass, z = -0.226 * mass;
  PaperMachine m;
  m.A << mass, 0, 0, 0, z, -y,  //
      0, mass, 0, -z, 0, x,     //
      0, 0, mass, y, -x, 0,     //
      0, -z, y, 66.289, -65.194, -28.935, z, 0, -x, -65.194, 91.643, -23.973, -y, x, 0, -28.935, -23.973, 135.853;
  m.K << 50250, 0, 0, 0, -19500, 49700,  //
      0, 50250, 0, 19500, 0, -59600,     //
      0, 0, 50250, -49700, 59600, 0,     //
      0, 19500, -49700, 57500, -58900, -23600, -19500, 0, 59600, -58900, 79400, -19600, 49700, -59600, 0, -23600,
      -19600, 120600;
  m.load << 80, 111.8034, 60, -33.541, 37.818, -66.657;
  m.B = damper(150, {-1.2, -0.4, -0.1}, {0, 0, 1}) + damper(120, {-0.2, -1.1, -0.3}, {0.6, 0.8, 0}) +
      damper(100, {-0.1, -0.2, 0.4}, {1, 0, 0}) + 2e-4 * m.K;
  return m;
}

/// `count` evenly spaced frequencies on (0, to] rad/s.
inline std::vector<double> even_frequencies(std::size_t count, double to = 200) {
  std::vector<double> omega(count);
  for (std::size_t i = 0; i < count; ++i) omega[i] = to * static_cast<double>(i + 1) / static_cast<double>(count);
  return omega;
}

}  // namespace trivet::benchmarks
