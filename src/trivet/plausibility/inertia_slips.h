// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "trivet/plausibility/body_picture.h"
#include "trivet/plausibility/suspicion.h"

namespace trivet::plausibility {

/// The slip that explains an impossible body: products of inertia with the other sign, the other point of reference,
/// one unit (all that do). Empty if no single one does, or if the body is possible.
struct InertiaSlip {
  std::string kind;  ///< of the first one
  /// "suspicion "products of inertia": the body is possible with the opposite sign of its products of inertia"
  std::string words;
};
[[nodiscard]] std::optional<InertiaSlip> slip_behind(const spatial::MassProperties& mass, bool inertia_about_pole);

/// Products of inertia about the pole with a sign that contradicts the position of the centre of mass.
[[nodiscard]] std::optional<Suspicion> doubtful_products(const std::string& body, const BodyPicture& picture);

}  // namespace trivet::plausibility
