// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/model/system.h"
#include "trivet/project/text/table_reader.h"

namespace trivet::project {

/// Reads `solids = [{box = [x, y, z], density = 7850, at = […]}, {file = "housing.step", density = …}, …]` into mass,
/// centre and inertia of the body. Returns false after reporting errors.
[[nodiscard]] bool read_solids(TableReader& body, model::Body& result);

}  // namespace trivet::project
