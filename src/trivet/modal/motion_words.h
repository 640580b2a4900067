// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/model/system.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::modal {

struct Mode;

/// Characteristic length of a body [m]: its largest radius of gyration about the pole, 1 if it has none.
[[nodiscard]] double body_size(const model::Body& body);

/// "z" or "(0.30, 0.40, 0.87)".
[[nodiscard]] std::string direction_words(const Eigen::Vector3d& direction);

/// "rotation about z through (0.10, 0.20, 0.00) m", "translation along x", "screw motion …".
[[nodiscard]] std::string motion_words(const spatial::Screw& screw, double size);

/// A one-line name from the body with most of the kinetic energy: "machine: mostly rotation about z through …".
[[nodiscard]] std::string mode_name(const model::System& system, const Mode& mode);

}  // namespace trivet::modal
