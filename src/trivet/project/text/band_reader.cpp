// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/band_reader.h"

#include <fmt/format.h>

#include "trivet/project/text/admissible_range.h"

namespace trivet::project {
namespace {

/// 0 is 0 in every unit.
bool has_mixed_units(const Node& list) {
  bool bare = false, with_unit = false;
  for (const Node& item : list.items) {
    if (item.kind == Node::Kind::text) with_unit = true;
    else if (item.number != 0) bare = true;
  }
  return bare && with_unit;
}

}  // namespace

std::optional<assembly::Band> read_band(TableReader& reader, const std::string& key) {
  const auto band = reader.numbers(key, Quantity::angular_frequency);
  if (!band) return std::nullopt;
  if (has_mixed_units(*reader.node(key))) {
    reader.error(key, "one end has a unit, the other has none", "both ends have a unit, or neither (rad/s)",
                 "give both a unit");
    return std::nullopt;
  }
  const std::string kind = key == "band" ? "band" : "range";
  const auto broken = band->size() == 2 ? wrong_band((*band)[0], (*band)[1])
                                        : std::optional<std::string>("[from, to] with 0 ≤ from < to");
  if (!broken) return assembly::Band{(*band)[0], (*band)[1]};
  const bool near = band->size() == 2 && (*band)[0] >= 0 && (*band)[1] > (*band)[0];
  reader.error(key,
               fmt::format("{} numbers{}", band->size(),
                           band->size() == 2 ? fmt::format(", {:.{}g} to {:.{}g} rad/s", (*band)[0], near ? 17 : 6,
                                                           (*band)[1], near ? 17 : 6)
                                             : ""),
               "a " + kind + " is [from, to] with 0 ≤ from < to" + (near ? ", and " + *broken : ""),
               key == "band" ? "for instance [\"0 Hz\", \"50 Hz\"]" : "for instance [\"600 rpm\", \"3000 rpm\"]");
  return std::nullopt;
}

}  // namespace trivet::project
