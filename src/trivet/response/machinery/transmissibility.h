// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/response/steady/frequency_response.h"
#include "trivet/response/steady/peaks.h"

namespace trivet::response {

/// Along which axis two like quantities are compared, ground axes.
struct Direction {
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< any length > 0
  bool rotation = false;  ///< moment about the axis, or rotation, instead of force and translation
};

/// A force (or moment) with which force transmissibility is measured.
struct AppliedForce {
  std::size_t body = 0;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< body frame [m]
  Direction direction;
};

/// The place and direction of a harmonic force excitation of the model.
/// @throws foundation::InvalidInput in words if it names none, or is a base motion, force and moment at once, or turns
/// (phases that differ)
[[nodiscard]] AppliedForce applied_force(const model::System& system, const std::string& excitation);

/// Like per like as a load and the channels to look at, unit "1".
struct Transmission {
  assembly::Loading loading;
  std::vector<assembly::Channel> channels;
};

/// Force on the ground in total ("ground"), then by each mount that stands on it (its name), in the direction of a unit
/// force. Moments of the total are about the ground origin, of a mount about its foot. On a foundation that gives, the
/// force on that foundation.
/// @throws foundation::InvalidInput for a direction of no length, or if `transmitted` is a moment and the force is
/// none: the units differ
[[nodiscard]] Transmission force_transmission(const model::System& system, const assembly::Assembled& assembled,
                                              const AppliedForce& applied,
                                              const std::optional<Direction>& transmitted = {});

/// Absolute motion of bodies (at their poles) and of their points over a unit rigid motion of the whole ground about
/// `base_at` (ground frame).
/// @param of  words BODY or BODY.POINT
/// @throws foundation::InvalidInput likewise, or for a word that names no body or point
[[nodiscard]] Transmission displacement_transmission(const model::System& system, const assembly::Assembled& assembled,
                                                     const std::vector<std::string>& of, const Direction& moved,
                                                     const std::optional<Direction>& answered = {},
                                                     const Eigen::Vector3d& base_at = Eigen::Vector3d::Zero());

/// From where a curve isolates.
struct Crossover {
  std::string name;
  /// Above it |T| < 1 for good [rad/s]: root of the exact response, not of a grid.
  /// 0 if |T| ≤ 1 everywhere, none if it does not end below 1.
  std::optional<double> angular_frequency;
  double proven_to = 0;  ///< [rad/s], infinite where the search for extrema was
};

/// One entry per channel. `peaks` of the same channels and loading.
[[nodiscard]] std::vector<Crossover> crossovers(const assembly::Assembled& assembled, const Transmission& transmission,
                                                const Peaks& peaks);

/// 20 lg |T| [dB]; −∞ for 0.
[[nodiscard]] double transmissibility_level(double transmissibility);

/// (1 − |T|), a fraction; negative where the mounts amplify. [VDI 2062-1]
[[nodiscard]] double isolation_efficiency(double transmissibility);

}  // namespace trivet::response
