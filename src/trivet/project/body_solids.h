// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/project/text/document.h"
#include "trivet/solids/rigid_solid.h"

namespace trivet::project {

/// The solids of a body as its table in `Case::document` gives them, in body axes, for a drawing. Empty if its mass and
/// inertia are given as numbers. Reports nothing: reading the project has.
[[nodiscard]] std::vector<solids::Part> body_solids(const Node& body);

}  // namespace trivet::project
