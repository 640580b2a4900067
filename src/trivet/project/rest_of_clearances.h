// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/project.h"

namespace trivet::project {

/// The error of a case that has clearances and no static answer: without one, how far they close at rest is not known.
[[nodiscard]] foundation::Problems without_rest(const Case& variant);

}  // namespace trivet::project
