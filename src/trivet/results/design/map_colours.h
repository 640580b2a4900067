// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "trivet/study/map/design_map.h"

namespace trivet::results {

/// Colours of what governs the designs of maps, the same in the report and on the page: the rule that governs most
/// designs has the first one. They are for designs that violate a rule; those that meet all rules are drawn lighter.
class MapColours {
 public:
  /// Stands for no rule, as a governing rule: no motion or no peak.
  static constexpr std::uint8_t unlimited = design::DesignOutcome::not_computed - 1;
  static constexpr std::size_t different_rules = 7;       ///< with a colour of their own
  static constexpr const char* other_rules = "#d8d8d8";   ///< of all further rules
  static constexpr const char* not_computed = "#8f8f8f";  ///< of designs without a result

  /// @param maps  that are shown together, with the same rules
  explicit MapColours(std::span<const study::DesignMap> maps);

  /// Rules that govern designs, and `unlimited` among them, that with most designs first.
  [[nodiscard]] const std::vector<std::size_t>& order() const { return order_; }
  /// Of one of them.
  [[nodiscard]] const char* of(std::size_t governing) const;

 private:
  std::vector<std::size_t> order_;
};

/// What governs a design: a rule or `MapColours::unlimited`, or why it has no result (DesignOutcome).
[[nodiscard]] std::uint8_t governing_of(const design::DesignOutcome& outcome);

}  // namespace trivet::results
