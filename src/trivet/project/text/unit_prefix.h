// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/foundation/unit_prefix.h"

namespace trivet::project {

using foundation::unit_prefix;
using foundation::UnitPrefix;

}  // namespace trivet::project
