// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "trivet/assembly/band.h"
#include "trivet/project/text/table_reader.h"

namespace trivet::project {

/// `key = [from, to]` in rad/s or with units, 0 ≤ from < to.
[[nodiscard]] std::optional<assembly::Band> read_band(TableReader& reader, const std::string& key);

}  // namespace trivet::project
