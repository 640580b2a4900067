// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/project/analyses/analyses.h"
#include "trivet/project/text/table_reader.h"

namespace trivet::project {

/// Checks that a path leads to a number of the model, or to a key that is not written and has a default.
void check_model_path(TableReader& root, TableReader& reader, const std::string& key, const std::string& path);

/// Reads `from`, `to` and `spacing`.
void read_range(TableReader& reader, DesignAxis& axis);

/// Reads [parameters.NAME].
[[nodiscard]] std::vector<DesignAxis> read_parameters(TableReader& root);

}  // namespace trivet::project
