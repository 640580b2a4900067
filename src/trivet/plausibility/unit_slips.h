// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/plausibility/body_picture.h"
#include "trivet/plausibility/suspicion.h"

namespace trivet::plausibility {

/// What is the matter with one body: the slip of unit that explains it best, or the feature that is farthest from all
/// experience.
struct BodyVerdict {
  std::size_t body = 0;
  Suspicion suspicion;
  std::optional<Slip> slip;  ///< none: odd, but no single slip explains it
};

/// How far from experience a body alone is [nats]; 0 if every feature is usual.
[[nodiscard]] double oddness(const Features& found);

/// Compares the body with experience as it is and after each single slip is undone. None if it is usual enough.
/// @param windows  where resonances are expected
[[nodiscard]] std::optional<BodyVerdict> judge(const model::System& system, const BodyPicture& picture,
                                               const std::vector<Window>& windows);

}  // namespace trivet::plausibility
