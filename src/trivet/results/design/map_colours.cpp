// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/design/map_colours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

namespace trivet::results {
namespace {

// Okabe and Ito's colours mixed with white; neighbours differ in lightness too.
constexpr std::array<const char*, MapColours::different_rules> palette = {"#f2bd66", "#8cc8ee", "#e08a66", "#66c4ab",
                                                                          "#dba6c6", "#f5ec8e", "#7aa9cf"};

}  // namespace

std::uint8_t governing_of(const design::DesignOutcome& outcome) {
  return std::isinf(outcome.margin) ? MapColours::unlimited : outcome.governing;
}

MapColours::MapColours(std::span<const study::DesignMap> maps) {
  std::map<std::size_t, std::size_t> designs;
  for (const study::DesignMap& map : maps)
    for (const design::DesignOutcome& outcome : map.outcomes)
      if (outcome.known()) ++designs[governing_of(outcome)];
  for (const auto& [governing, count] : designs) order_.push_back(governing);
  std::ranges::stable_sort(order_, std::ranges::greater{}, [&](std::size_t governing) { return designs[governing]; });
}

const char* MapColours::of(std::size_t governing) const {
  const auto rank = static_cast<std::size_t>(std::ranges::find(order_, governing) - order_.begin());
  return rank < palette.size() ? palette[rank] : other_rules;
}

}  // namespace trivet::results
