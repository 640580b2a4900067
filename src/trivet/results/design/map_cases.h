// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/documents/document.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/study/map/design_map.h"

namespace trivet::results {

/// The verdict on every case of a map, with its findings.
[[nodiscard]] Group cases_on_map(const study::DesignMap& map);

/// One row for each case with the rule that governs it, what concerns them together, and where the findings are.
[[nodiscard]] Group governing_on_map(const study::DesignMap& map);

}  // namespace trivet::results
