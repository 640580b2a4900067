// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/assembly/band.h"

namespace trivet::study {

/// "20 … 26 Hz", "16.3 Hz": a band in the words of a requirement.
[[nodiscard]] std::string hertz_words(const assembly::Band& band);

}  // namespace trivet::study
