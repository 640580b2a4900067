// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "trivet/project/text/table_reader.h"

namespace trivet::project {

inline constexpr std::size_t fewest_measured = 20;

/// The numbers of `file = "batch.csv"` [SI]: one column, a unit in its heading or that of the SI, without a gap, at
/// least `fewest_measured` rows. Problems are at their rows.
[[nodiscard]] std::optional<std::vector<double>> read_batch_file(TableReader& reader,
                                                                 const std::optional<Quantity>& quantity);

}  // namespace trivet::project
