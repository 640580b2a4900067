// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "trivet/plausibility/body_picture.h"
#include "trivet/plausibility/suspicion.h"

namespace trivet::plausibility {

/// The slip that makes a body possible which is impossible as typed: products of inertia with the other sign, the
/// other point of reference,
/// one unit (all that do). None if no single one does, or the body is possible.
struct InertiaSlip {
  std::string kind;  ///< of the first one
  /// "suspicion "products of inertia": with the other sign of its products of inertia the body is possible"
  std::string words;
};
[[nodiscard]] std::optional<InertiaSlip> slip_behind(const spatial::MassProperties& mass, bool inertia_about_pole);

/// Products of inertia about the pole whose sign contradicts the place of the centre of mass.
[[nodiscard]] std::optional<Suspicion> doubtful_products(const std::string& body, const BodyPicture& picture);

}  // namespace trivet::plausibility
