// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/documents/document.h"
#include "trivet/project/analyses/analyses.h"
#include "trivet/results/format/in_documents.h"

/// What the documents of the best design and of a front have in common.
namespace trivet::results {

struct SearchedParameter {
  const project::DesignAxis* axis;
  std::optional<double> given;  ///< value of the file; none if its places differ
};

/// Name, places, unit, range and given value, in the unit of the axis.
[[nodiscard]] std::vector<Column> parameter_columns(std::vector<SearchedParameter> parameters);

/// "--set 'PATH = VALUE'" for every place of a parameter, one per line.
[[nodiscard]] std::string parameter_settings(const project::DesignAxis& axis, double value);

/// How the search went, as the last notes.
void add_search_lines(const std::vector<std::string>& sentences, Document& document);
/// "12 designs computed, 2 of them without a result (why)."
[[nodiscard]] std::string computed_words(std::size_t evaluations, std::size_t failed, const std::string& first_failure);
/// Empty if all slopes are derivatives.
[[nodiscard]] std::string differences_words(const std::vector<std::string>& kinds, std::size_t differences);
/// Kinds of requirements whose slopes are differences of values. @param evaluations  designs computed for all of them
[[nodiscard]] Single differenced_part(const std::vector<std::string>& kinds, std::size_t evaluations);

/// Largest amplitudes in the unit of the row; arrays have them without a level.
/// @param kind  for people: amplitudes are harmonic, quantities are not
template <typename Row, typename Value>
void add_largest(const Rows<Row>& row, Kind kind, const std::string& name, const std::string& heading, Value value,
                 std::vector<Column>& columns) {
  columns.push_back(row(name, Kind::quantity, "", value, {.forms = for_programs}));
  columns.push_back(row(name, kind, heading, value, {.unit = "@unit", .forms = for_people}));
}

}  // namespace trivet::results
