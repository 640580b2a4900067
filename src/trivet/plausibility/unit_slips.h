// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/plausibility/body_picture.h"
#include "trivet/plausibility/suspicion.h"

namespace trivet::plausibility {

/// Verdict on one body: the slip of unit that explains it best, or the most unusual feature.
struct BodyVerdict {
  std::size_t body = 0;
  Suspicion suspicion;
  std::optional<Slip> slip;  ///< empty: odd, but no single slip explains it
};

/// Deviation of a body alone from experience [nats]; 0 if every feature is usual.
[[nodiscard]] double oddness(const Features& found);

/// Compares the body with experience, as typed and after correction of each single slip. Empty if it is usual enough.
/// @param windows  frequency ranges in which resonances are expected
[[nodiscard]] std::optional<BodyVerdict> judge(const model::System& system, const BodyPicture& picture,
                                               const std::vector<Window>& windows);

}  // namespace trivet::plausibility
