// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exchange/universal/universal_contents.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "trivet/exchange/universal/universal_descriptions.h"
#include "trivet/exchange/universal/universal_lines.h"
#include "trivet/exchange/universal/universal_units.h"

namespace trivet::exchange {
namespace {

constexpr std::array node_widths{10, 10, 10, 10, 13, 13, 13};
constexpr std::array line_widths{10, 10, 10};
constexpr std::array labels_widths{10, 10, 10, 10, 10, 10, 10, 10};
constexpr std::array part_node_widths{10, 10, 10, 10};
constexpr std::array part_position_widths{25, 25, 25};

std::optional<UniversalNode> node_of(const std::vector<double>& numbers, double length_unit) {
  const auto label = as_whole_number(numbers[0]);
  const auto definition = as_whole_number(numbers[1]), displacement = as_whole_number(numbers[2]);
  if (!label || *label < 1 || !definition || !displacement) return std::nullopt;
  const Eigen::Vector3d position = Eigen::Vector3d(numbers[4], numbers[5], numbers[6]) * length_unit;
  if (!position.allFinite()) return std::nullopt;
  return UniversalNode{*label, position, *definition, *displacement};
}

std::optional<std::vector<int>> as_labels(const std::optional<std::vector<double>>& numbers) {
  if (!numbers) return std::nullopt;
  std::vector<int> labels;
  for (const double value : *numbers) {
    const auto label = as_whole_number(value);
    if (!label || *label < 0) return std::nullopt;
    labels.push_back(*label);
  }
  return labels;
}

/// The labels of a line, between blanks or else in columns; nullopt if one is not a label.
std::optional<std::vector<int>> labels_of_line(std::string_view line) {
  const auto separated = as_labels(numbers_between_blanks(line));
  return separated ? separated : as_labels(numbers_in_columns(line, labels_widths, BlankFields::end_the_line));
}

/// The labels of all remaining lines; nullopt with an error if one is not a label.
std::optional<std::vector<int>> labels_of_set(Lines& lines, int first_line, SetProblems& problems) {
  std::vector<int> nodes;
  while (lines.next()) {
    const auto labels = labels_of_line(lines.line());
    if (!labels) {
      problems.error(first_line + lines.number(), "nodes", in_quotes(lines.line()),
                     "labels of nodes are whole numbers > 0, or 0 to move without drawing", "correct the line");
      return std::nullopt;
    }
    nodes.insert(nodes.end(), labels->begin(), labels->end());
  }
  return nodes;
}

}  // namespace

std::vector<UniversalNode> read_universal_nodes(const UniversalSet& set, const UniversalUnits& units,
                                                SetProblems& problems) {
  std::vector<UniversalNode> nodes;
  const double length_unit = unit_value(units, {.length = 1});
  for (Lines lines(set.body); lines.next();) {
    if (trimmed(lines.line()).empty()) continue;
    const auto numbers = numbers_of_record(lines.line(), node_widths, node_widths.size());
    const auto node = numbers ? node_of(*numbers, length_unit) : std::nullopt;
    if (!node) {
      problems.error(set.line + lines.number(), "node", in_quotes(lines.line()),
                     "a node is a label > 0, three whole numbers and three finite coordinates",
                     set.closed ? "correct the line" : "was the file cut off?");
      return nodes;
    }
    nodes.push_back(*node);
  }
  check_end(set, problems);
  return nodes;
}

std::vector<UniversalNode> read_universal_part_nodes(const UniversalSet& set, const UniversalUnits& units,
                                                     SetProblems& problems) {
  std::vector<UniversalNode> nodes;
  const double length_unit = unit_value(units, {.length = 1});
  for (Lines lines(set.body); lines.next();) {
    if (trimmed(lines.line()).empty()) continue;
    auto numbers = numbers_of_record(lines.line(), part_node_widths, part_node_widths.size());
    const auto position = numbers && lines.next()
        ? numbers_of_record(lines.line(), part_position_widths, part_position_widths.size())
        : std::nullopt;
    if (position) numbers->insert(numbers->end(), position->begin(), position->end());
    auto node = position ? node_of(*numbers, length_unit) : std::nullopt;
    if (!node) {
      problems.error(set.line + lines.number(), "node", in_quotes(lines.line()),
                     "a node is a label > 0 and three whole numbers, then a line with three finite coordinates",
                     set.closed ? "correct the line" : "was the file cut off?");
      return nodes;
    }
    node->in_part = true;
    nodes.push_back(*node);
  }
  check_end(set, problems);
  return nodes;
}

std::optional<UniversalLine> read_universal_line(const UniversalSet& set, SetProblems& problems) {
  Lines lines(set.body);
  const auto numbers = lines.next() ? whole_numbers_of_record(lines.line(), line_widths, 2) : std::nullopt;
  if (!numbers || (*numbers)[1] < 0) {
    problems.error(set.line + 1, "trace line", in_quotes(lines.line()),
                   "it begins with its number and the number of its nodes", "correct the line");
    return std::nullopt;
  }
  UniversalLine line{.number = (*numbers)[0]};
  if (lines.next()) line.name = unless_none(readable_line(lines.line()));
  auto nodes = labels_of_set(lines, set.line, problems);
  if (!nodes) return std::nullopt;
  const auto announced = static_cast<std::size_t>((*numbers)[1]);
  while (nodes->size() > announced && nodes->back() == 0) nodes->pop_back();  // the last line may be filled with zeros
  if (nodes->size() < announced) {
    problems.error(set.line + 1, "nodes", fmt::format("{} announced, {} found", announced, nodes->size()),
                   "both must be equal", set.closed ? "correct the number" : "was the file cut off?");
    return std::nullopt;
  }
  if (nodes->size() > announced)
    problems.warning(set.line + 1, "nodes", fmt::format("{} announced, {} found", announced, nodes->size()),
                     "both must be equal", "all that were found are used");
  line.nodes = std::move(*nodes);
  check_end(set, problems);
  return line;
}

}  // namespace trivet::exchange
