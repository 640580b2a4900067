// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/model/system.h"

namespace trivet::results {

/// " Deflections of preloaded elements …": what their deflection at rest is measured from; empty without preloads.
[[nodiscard]] std::string preload_words(const model::System& system);

}  // namespace trivet::results
