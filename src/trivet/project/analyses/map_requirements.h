// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/analyses/analyses.h"

namespace trivet::project {

/// The map of a case whose own one cannot be read, such as one whose axes that model does not have: numbers,
/// frequencies and own rules are those of the base map, limits and requirements of the file those of the case.
[[nodiscard]] MapRequest map_of_case(const Analyses& of_case, const MapRequest& base);

/// Adds [requirements] to the rules of the map. Limits and no_peak of the map replace those of the requirements. Those
/// that have the band and the excitations of the map become rules of the map, which many designs at once are judged by;
/// the rest stays in `requirements` of the request. Call it after all of these are read.
void use_requirements(Analyses& analyses);

}  // namespace trivet::project
