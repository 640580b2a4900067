// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "trivet/assembly/assembled.h"
#include "trivet/numerics/peaks/extremum.h"

namespace trivet::assembly {

enum class MotionQuantity { displacement, velocity, acceleration };
inline constexpr std::array motion_quantities = {MotionQuantity::displacement, MotionQuantity::velocity,
                                                 MotionQuantity::acceleration};

/// "displacement", "velocity", "acceleration"
[[nodiscard]] const char* motion_name(MotionQuantity quantity);
/// The names of all quantities, in their order.
[[nodiscard]] std::vector<std::string> motion_names();
/// @param name  one of `motion_names`
[[nodiscard]] MotionQuantity motion_quantity(std::string_view name);

/// Contribution of a frequency-dependent element to a force: row · D(ω) · (displacements of its ends).
struct DynamicForce {
  std::size_t element = 0;
  Eigen::Matrix<double, 1, 12> row;
};

/// One result as a linear function of the coordinates: y = (iω)^derivative (on_displacement + iω on_velocity − ω²
/// on_acceleration)ᵀ q, and the same of the ground coordinates g. With loss factors `on_displacement` is complex (ω >
/// 0); static results use its real part. Only elements with mass have `on_acceleration`.
struct Channel : numerics::CurveTerms {
  std::string name;  ///< "body.x", "body.point.rz", "element.force.x", "ground.moment.z"
  std::string unit;  ///< SI
  int derivative = 0;
  std::vector<DynamicForce> dynamic_forces;  ///< of frequency-dependent elements; not contained in the terms above
  numerics::CurveTerms ground;               ///< contribution of the ground motion; empty if zero
  double at_rest = 0;  ///< contribution of preload and of gravity on the element's own mass to a static force

  /// All but the dynamic forces.
  [[nodiscard]] numerics::ObservedCurve curve() const { return {*this, ground, derivative}; }
};

/// The curves of all channels.
[[nodiscard]] std::vector<numerics::ObservedCurve> curves(const std::vector<Channel>& channels);

/// Channels for the names in a project file: "coordinates" (all free ones), BODY, BODY.POINT, ELEMENT, "ground", "base"
/// (the rigid motion of the whole foundation), BODY.relative and BODY.POINT.relative (relative to that motion),
/// ELEMENT.deflection (end K relative to N beyond a rigid motion, in the element's axes at N), ELEMENT.foot (motion of
/// end N, ground axes), a relative motion, a section, a clearance, or one full channel name. A force is what the
/// element exerts on its N side (the ground, or the body given by `from`), in ground axes, its moment about the
/// reference point of that end; "ground" is the total on the ground about its origin.
/// @throws foundation::InvalidInput for an unknown name
[[nodiscard]] std::vector<Channel> channels(const model::System& system, const Assembled& assembled,
                                            const std::vector<std::string>& of, MotionQuantity quantity);

/// Names of groups of results that `channels` accepts for this model; a full channel name is GROUP.COMPONENT.
[[nodiscard]] std::vector<std::string> channel_words(const model::Description& description);

}  // namespace trivet::assembly
