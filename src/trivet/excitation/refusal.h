// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/foundation/problems.h"

namespace trivet::excitation {

/// @throws foundation::InvalidInput with the message of the first error, if there is one
void refuse_errors(const foundation::Problems& problems);

}  // namespace trivet::excitation
