// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "trivet/response/steady/steady_motion.h"

namespace trivet::response {

/// A point that moves as Re(motion · e^{iωt}).
struct MovingPlace {
  std::string name;  ///< BODY, BODY.POINT, ELEMENT.foot (its end N) or ELEMENT.head (its end K)
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< at rest, ground frame [m]
  /// translation [m] and rotation [rad], ground axes
  Eigen::Matrix<std::complex<double>, 6, 1> motion = Eigen::Matrix<std::complex<double>, 6, 1>::Zero();
  std::optional<std::size_t> body = {};  ///< body that it moves with; empty on the ground or a foundation
};

/// Operating deflection shape: motion of all points at one ω.
struct DeflectionShape {
  double angular_frequency = 0;     ///< [rad/s]
  std::vector<MovingPlace> bodies;  ///< poles
  std::vector<MovingPlace> points;
  std::vector<MovingPlace> feet;   ///< one per element
  std::vector<MovingPlace> heads;  ///< one per element
  double largest_excursion = 0;    ///< over all places [m]
};

/// All places under a motion of the coordinates.
[[nodiscard]] DeflectionShape deflection_shape(const model::System& system, const assembly::Assembled& assembled,
                                               const SteadyMotion& motion);

/// @throws foundation::NotComputable if Z(ω) is singular
[[nodiscard]] DeflectionShape deflection_shape(const model::System& system, const assembly::Assembled& assembled,
                                               const assembly::Loading& loading, double angular_frequency);

/// Largest distance from rest on the ellipse Re(u e^{iωt}): √(½(|u|² + |u·u|)) [m].
[[nodiscard]] double excursion(const Eigen::Vector3cd& translation);

/// Position at the phase ωt [rad], motion enlarged by `scale`.
[[nodiscard]] Eigen::Vector3d displaced(const MovingPlace& place, double phase, double scale);

}  // namespace trivet::response
