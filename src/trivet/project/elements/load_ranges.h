// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "trivet/project/text/table_reader.h"

namespace trivet::project {

/// Lowest and highest static load along x, y, z [N]; signs: `model::Rating::load`.
using LoadRanges = std::array<std::optional<Eigen::Vector2d>, 3>;

/// `load = {x = [lowest, highest], y = …, z = …}` and `static_load`, which is the range along z.
[[nodiscard]] LoadRanges read_load_ranges(TableReader& mount);

/// `temperature = ["-30 °C", "80 °C"]` [K].
[[nodiscard]] std::optional<Eigen::Vector2d> read_temperature(TableReader& mount);

}  // namespace trivet::project
