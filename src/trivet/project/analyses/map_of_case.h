// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/analyses/analyses.h"

namespace trivet::project {

/// The map of a case whose own one cannot be read, such as one whose axes that model does not have: numbers,
/// frequencies and own rules are those of the base map, limits and requirements of the file those of the case.
[[nodiscard]] MapRequest map_of_case(const Analyses& of_case, const MapRequest& base);

}  // namespace trivet::project
