// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/text/document.h"

namespace trivet::project {

/// Problems of names and texts that tables, pictures or file names cannot contain: control characters, and names too
/// long for file names.
[[nodiscard]] foundation::Problems check_names_and_texts(const Node& document);

}  // namespace trivet::project
