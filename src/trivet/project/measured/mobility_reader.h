// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "trivet/foundation/problems.h"
#include "trivet/project/measured/ground_mobility.h"
#include "trivet/project/text/table_reader.h"

namespace trivet::project {

/// Mobility of one ground point from the CSV table at `file`: columns frequency_hz and, per entry, y_I_J and y_I_J_im
/// with I, J out of x, y, z, rx, ry, rz [(m/s)/N, (rad/s)/(N m) …], of the upper triangle of the symmetric Y. The
/// directions without a column are rigid.
[[nodiscard]] std::optional<GroundMobility> read_mobility_table(TableReader& reader);

/// Mobility of several ground points from the universal file at `file`: frequency responses of set 58, receptance,
/// mobility or accelerance, between nodes of the file. Directions of a node without a driving-point function are rigid.
/// A coupling that was measured both ways is averaged; one that was not measured is zero, with a warning.
/// @param nodes  of the points, in this order
[[nodiscard]] std::optional<GroundMobility> read_universal_mobility(TableReader& reader, const std::vector<int>& nodes);

/// Problems of a mobility, and how far each driving point is from causality: rows that feed energy (Re Y must be
/// positive semidefinite), points that move as one rigid part (Y⁻¹ does not exist), driving points that no passive,
/// causal ground has, rows too far apart.
[[nodiscard]] foundation::Problems judge_mobility(GroundMobility& mobility);

}  // namespace trivet::project
