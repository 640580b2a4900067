// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/project/analyses/design_axis.h"
#include "trivet/project/text/document.h"

namespace trivet::project {

/// Reports a parameter that moves a number of an element whose type has the same number, if a parameter moves that too.
/// @param document  as written, so that elements name their types
void refuse_derived_numbers(const Node& document, const std::vector<DesignAxis>& parameters,
                            foundation::Problems& problems);

}  // namespace trivet::project
