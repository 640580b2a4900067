// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/foundation/problems.h"
#include "trivet/study/design_map.h"

namespace trivet::study {

/// What a reader must know before trusting a map: bodies that cannot be, marks that contradict the designs around them, answers that do not move, axes that change nothing,
/// limits that no design can keep at rest.
/// @param variant  whose model it is
[[nodiscard]] foundation::Problems map_warnings(const Case& variant, const DesignMap& map);

}  // namespace trivet::study
