// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/text/document.h"

namespace trivet::project {

/// Names and texts that no table, picture or file name could carry: control characters, and names too long for the file
/// names made of them.
[[nodiscard]] foundation::Problems check_names_and_texts(const Node& document);

}  // namespace trivet::project
