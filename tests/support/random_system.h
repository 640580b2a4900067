// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>

#include "trivet/model/system.h"

namespace trivet::test {

/// Kind of damping of the elements of a random system.
enum class RandomDamping { none, proportional, viscous, loss };

/// Draws bodies, poses and elements with skew axes everywhere; the same seed gives the same system.
class RandomSystem {
 public:
  explicit RandomSystem(unsigned seed) : generator_(seed) {}

  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator_); }
  Eigen::Vector3d vector(double size);
  Eigen::Matrix3d rotation();
  /// A physically possible body: the mass properties of a cloud of points.
  model::Body body(const std::string& name);
  /// A positive definite 6×6 in N/m … N m/rad, full.
  spatial::Matrix6 stiffness(double translation, double length);
  model::Element element(const std::string& name, std::optional<std::size_t> from, std::size_t on,
                         const std::vector<model::Body>& bodies, RandomDamping damping);
  /// `bodies` bodies in a chain from the ground, two elements per joint, one harmonic force with random phases.
  model::Description description(std::size_t bodies, RandomDamping damping, bool grounded = true);

 private:
  std::mt19937 generator_;
};

/// The checked system; fails the running test if the description is rejected.
[[nodiscard]] model::System checked(const model::Description& description);

}  // namespace trivet::test
