// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/model/harmonic_force.h"
#include "trivet/response/steady/frequency_response.h"
#include "trivet/response/steady/peaks.h"

namespace trivet::response {

/// Transmissibilities: a unit load and the channels to compute, unit "1".
struct Transmission {
  assembly::Loading loading;
  std::vector<assembly::Channel> channels;
};

/// Total force on the ground ("ground"), then that of each mount on the ground (by its name), per unit force, in its
/// direction or along `transmitted`. Moments of the total are about the ground origin, of a mount about its foot. On a
/// flexible foundation: the force on that foundation.
/// @throws foundation::InvalidInput for a direction of length 0, or if only one of `applied` and `transmitted` is a
/// moment: the units differ
[[nodiscard]] Transmission force_transmission(const model::System& system, const assembly::Assembled& assembled,
                                              const model::AppliedForce& applied,
                                              const std::optional<model::Direction>& transmitted = {});

/// Total force on the ground per unit of a harmonic force excitation of the model, whatever its course over frequency.
/// A force along one direction has one channel, along it. A rotating force (an unbalance) has two: along the axes of
/// the ellipse that it describes, or of the plane of its circle (spatial::axes_along its normal), both over its largest
/// magnitude.
/// @throws foundation::InvalidInput as `applied_force`, except for rotating forces
struct ExcitationTransmission : Transmission {
  std::vector<model::Direction> directions;  ///< of the channels
  double exciting = 0;  ///< largest magnitude of the force [N], or moment [N m], over a period; that of its course is 1
};
[[nodiscard]] ExcitationTransmission excitation_transmission(const model::System& system,
                                                             const assembly::Assembled& assembled,
                                                             const std::string& excitation);
/// The same of a force that need not be an excitation of the model, such as one order of a shaft.
[[nodiscard]] ExcitationTransmission excitation_transmission(const model::System& system,
                                                             const assembly::Assembled& assembled,
                                                             const model::HarmonicForce& force);

/// Why the force on the ground is not known: a constraint of the body carries a part of it. Empty if none does.
/// @param along  of the force, ground frame
[[nodiscard]] std::string carried_by_constraint(const model::Body& body, const model::Direction& along);

/// Absolute motion of bodies (at their poles) and of their points per unit rigid motion of the whole ground about
/// `base_at` (ground frame).
/// @param of  names BODY or BODY.POINT
/// @throws foundation::InvalidInput for a direction of length 0, for different units, or for an unknown body or point
[[nodiscard]] Transmission displacement_transmission(const model::System& system, const assembly::Assembled& assembled,
                                                     const std::vector<std::string>& of, const model::Direction& moved,
                                                     const std::optional<model::Direction>& moved_direction = {},
                                                     const Eigen::Vector3d& base_at = Eigen::Vector3d::Zero());

/// Frequency above which a curve isolates.
struct Crossover {
  std::string name;
  /// Above it |T| < 1 always [rad/s]: root of the exact response, not of a grid.
  /// 0 if |T| ≤ 1 everywhere; empty if |T| does not tend to less than 1 at high frequency.
  std::optional<double> angular_frequency;
  double proven_to = 0;  ///< frequency up to which this is proven [rad/s]; infinite if the whole axis was searched
};

/// Crossovers, one per channel; `peaks` must be of the same channels and loading.
[[nodiscard]] std::vector<Crossover> crossovers(const assembly::Assembled& assembled, const Transmission& transmission,
                                                const Peaks& peaks);

/// Transmissibility level 20 lg |T| [dB]; −∞ for 0.
[[nodiscard]] double transmissibility_level(double transmissibility);

/// Level of isolation −20 lg |T| [dB]: positive isolates, negative amplifies; ∞ for 0. Requirements, verdicts and
/// operating speeds speak of it, only the analysis of the transmissibility itself of the level above.
[[nodiscard]] double isolation_level(double transmissibility);

/// Isolation efficiency 1 − |T|, a fraction; negative if the mounts amplify. [VDI 2062-1]
[[nodiscard]] double isolation_efficiency(double transmissibility);

}  // namespace trivet::response
