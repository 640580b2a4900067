// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/text/display_units.h"
#include "trivet/project/text/document.h"

namespace trivet::project {

/// Warns once for each key of a file that has been read with frequencies or speeds without a unit, which are in
/// rad/s: what they are in Hz. None if [display] has frequencies in rad/s: then they are meant so.
void warn_of_bare_frequencies(const Node& document, const DisplayUnits& display, foundation::Problems& problems);

}  // namespace trivet::project
