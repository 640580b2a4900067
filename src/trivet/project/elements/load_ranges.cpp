// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/elements/load_ranges.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "trivet/foundation/plain_text.h"

namespace trivet::project {
namespace {

constexpr const char* load_directions[] = {"x", "y", "z"};

/// Two ascending numbers; anything else is a problem with this rule.
std::optional<Eigen::Vector2d> read_ascending(TableReader& reader, const std::string& key, Quantity quantity,
                                              const char* rule, const char* example) {
  const auto range = reader.numbers(key, quantity);
  if (!range) return std::nullopt;
  if (range->size() == 2 && (*range)[0] < (*range)[1]) return Eigen::Vector2d((*range)[0], (*range)[1]);
  reader.error(key,
               range->size() == 2 ? fmt::format("{:.6g} {}, then {:.6g} {}", (*range)[0], si_unit(quantity),
                                                (*range)[1], si_unit(quantity))
                                  : fmt::format("{} numbers", range->size()),
               rule, std::string("for instance ") + example);
  return std::nullopt;
}

}  // namespace

LoadRanges read_load_ranges(TableReader& mount) {
  LoadRanges ranges;
  ranges[2] = read_ascending(mount, "static_load", Quantity::force,
                             "it is the lowest and the highest compression along the axis, ascending",
                             "static_load = [\"0 N\", \"800 N\"]");
  const Node* table = mount.table("load");
  if (!table) return ranges;
  TableReader reader(*table, mount.path() + ".load", mount.problems());
  if (table->keys.empty())
    mount.error("load", "an empty table", "it has a range for at least one of x, y, z",
                "for instance load = {z = [\"0 N\", \"800 N\"]}");
  for (const std::string& key : table->keys)
    if (std::find(std::begin(load_directions), std::end(load_directions), key) == std::end(load_directions)) {
      static_cast<void>(reader.node(key));
      reader.error(key, foundation::quoted(key), "a mount has loads along its axes x, y and z",
                   "write load = {x = [\"-300 N\", \"300 N\"], z = [\"0 N\", \"800 N\"]}");
    }
  for (std::size_t i = 0; i < ranges.size(); ++i)
    if (const auto range = read_ascending(reader, load_directions[i], Quantity::force,
                                          "it is the lowest and the highest load along this axis, ascending",
                                          "load = {x = [\"-300 N\", \"300 N\"], z = [\"0 N\", \"800 N\"]}"))
      ranges[i] = range;
  if (reader.has("z") && mount.has("static_load"))
    mount.error("static_load", "static_load and load.z", "both are the range along z", "remove one");
  reader.finish();
  return ranges;
}

std::optional<Eigen::Vector2d> read_temperature(TableReader& mount) {
  const Node* node = mount.node("temperature");
  if (!node) return std::nullopt;
  const bool bare = node->kind == Node::Kind::array && std::ranges::any_of(node->items, [](const Node& n) {
                      return n.kind == Node::Kind::integer || n.kind == Node::Kind::real;
                    });
  constexpr const char* example = "temperature = [\"-30 °C\", \"80 °C\"]";
  if (!bare)
    return read_ascending(mount, "temperature", Quantity::temperature,
                          "it is the lowest and the highest temperature, ascending", example);
  mount.error("temperature", "a number without a unit", "it may be °C or K",
              std::string("write the unit, for instance ") + example);
  return std::nullopt;
}

}  // namespace trivet::project
