// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "trivet/study/explain/element_summary.h"
#include "trivet/study/explain/simplification.h"

namespace trivet::results {

/// {"name", "type", "stiffness": 12×12, "damping", "mass", "preload", "rigid_motion_residual": 12×6, "warnings", …}:
/// an element in its local frame, order N, K, scale included, and the effect of three springs in its place
/// (docs/json.md).
[[nodiscard]] std::string element_json(const project::Case& variant, std::size_t element,
                                       const study::ElementSummary& summary,
                                       const std::optional<study::Simplification>& simple);

/// One element as text: type, ends, how its law was determined, the 12×12, principal stiffnesses, elastic centre,
/// checks, energy, uncertainty, limits of validity, preload.
[[nodiscard]] std::string element_text(const project::Case& variant, std::size_t element,
                                       const study::ElementSummary& summary);

/// Natural frequencies and highest peaks with the full elements and with three springs in their place.
[[nodiscard]] std::string simplification_text(const study::Simplification& simple);

}  // namespace trivet::results
