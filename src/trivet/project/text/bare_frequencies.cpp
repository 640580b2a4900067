// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/bare_frequencies.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/foundation/setting_words.h"

namespace trivet::project {
namespace {

/// Not a setting, whose numbers are in SI as those of every argument.
bool is_of_a_file(const Node& node) {
  return !node.origin.source.empty() && !node.origin.source.starts_with(foundation::setting_source);
}

bool is_number(const Node& node) { return node.kind == Node::Kind::integer || node.kind == Node::Kind::real; }

/// The numbers of a value, and of its lists, that were read in rad/s.
void add_bare(const Node& value, std::vector<double>& bare) {
  if (is_number(value) && value.quantity == Quantity::angular_frequency) bare.push_back(value.number);
  if (value.kind != Node::Kind::array) return;
  for (const Node& item : value.items) add_bare(item, bare);
}

/// 0 is 0 in every unit.
std::string with_unit(const Node& value, const char* unit) {
  if (is_number(value)) return value.number == 0 ? "0" : fmt::format("\"{} {}\"", toml_value(value), unit);
  if (value.kind != Node::Kind::array) return toml_value(value);
  std::vector<std::string> items;
  for (const Node& item : value.items) items.push_back(with_unit(item, unit));
  return fmt::format("[{}]", fmt::join(items, ", "));
}

void warn(const std::string& path, const Node& value, const std::vector<double>& bare, foundation::Problems& problems) {
  const bool is_range = bare.size() == 2 && !path.ends_with(".at");
  const bool is_speed = path.substr(path.rfind('.') + 1).find("speed") != std::string::npos;
  const char* unit = is_speed ? "rpm" : "Hz";
  std::vector<std::string> shown;
  for (const double omega : bare)
    shown.push_back(fmt::format("{:.3g}", is_speed ? omega * foundation::rpm_per_rad_s : omega / foundation::two_pi));
  foundation::Problem& problem = problems.warning(
      path, toml_value(value) + " without a unit",
      fmt::format("such a number is in rad/s, here {} {}", fmt::join(shown, is_range ? " … " : ", "), unit),
      fmt::format("write {} or {}; [display] with frequency = \"rad/s\" declares numbers in rad/s for all keys",
                  with_unit(value, unit), with_unit(value, "rad/s")));
  problem.origin = value.origin;
}

void visit(const Node& table, const std::string& path, foundation::Problems& problems) {
  for (std::size_t i = 0; i < table.items.size(); ++i) {
    const Node& item = table.items[i];
    const std::string inside = (path.empty() ? "" : path + ".") +
        (i < table.keys.size() ? foundation::path_key(table.keys[i]) : std::to_string(i));
    std::vector<double> bare;
    add_bare(item, bare);
    const bool any = std::ranges::any_of(bare, [](double omega) { return omega != 0; });
    if (any && is_of_a_file(item)) warn(inside, item, bare, problems);
    else if (item.kind == Node::Kind::table || item.kind == Node::Kind::array) visit(item, inside, problems);
  }
}

}  // namespace

void warn_of_bare_frequencies(const Node& document, const DisplayUnits& display, foundation::Problems& problems) {
  if (display.frequency != "rad/s") visit(document, "", problems);
}

}  // namespace trivet::project
