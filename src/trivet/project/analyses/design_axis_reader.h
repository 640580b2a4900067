// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/project/analyses/analyses.h"
#include "trivet/project/text/table_reader.h"

namespace trivet::project {

/// Checks that a path leads to a number of the model, or to a key that is not written and has a default.
void check_model_path(TableReader& root, TableReader& reader, const std::string& key, const std::string& path);

/// The places of `path`: a text, a list of texts, or {path = factor}. @param noun  what has the path: "parameter"
[[nodiscard]] std::vector<ParameterPlace> read_places(TableReader& root, TableReader& reader, const std::string& noun);

/// What moves the numbers at some places.
struct NamedPlaces {
  std::string name;
  std::vector<ParameterPlace> places;
};
/// Reports numbers that two of them move. @param table  "parameters"  @param noun  "parameter"
void refuse_shared_numbers(const std::vector<NamedPlaces>& all, const std::string& table, const std::string& noun,
                           TableReader& root);

/// Reads `from`, `to` and `spacing`.
void read_range(TableReader& reader, DesignAxis& axis);

/// Reads [parameters.NAME].
[[nodiscard]] std::vector<DesignAxis> read_parameters(TableReader& root);

}  // namespace trivet::project
