// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "trivet/excitation/frequency_bands.h"
#include "trivet/project/text/table_reader.h"

namespace trivet::project {

/// `key = "third-octave"` or "octave", if it is there.
[[nodiscard]] std::optional<excitation::BandWidth> read_bands(TableReader& reader, const std::string& key);

}  // namespace trivet::project
