// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/report/page/shown_case.h"

namespace trivet::report {

/// Has the machine a body that the view in 3D can show?
[[nodiscard]] bool has_moving_machine(const std::vector<ShownCase>& cases);

/// What the view in 3D of the page shows: scenes, and of each case the number of its scene, its lowest modes, their
/// damped motions and its operating shapes, as `trivet scene`, `modes`, `roots` and `shapes` have them (docs/json.md),
/// to 7 digits. Scenes have, as `solids` of a body, the places of their surfaces in the list `surfaces`.
[[nodiscard]] std::string machine_json(const std::vector<ShownCase>& cases);

}  // namespace trivet::report
