// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/documents/shown_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "trivet/documents/text_table.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/significant_digits.h"

namespace trivet::documents {

DisplayUnit display_unit(const project::DisplayUnits& display, const std::string& si_unit) {
  const project::ShownUnit shown = project::shown_unit(display, si_unit);
  return {shown.unit, "", shown.factor, shown.unit == si_unit};
}

DisplayUnit amplitude_unit(const project::DisplayUnits& display, const std::string& si_unit) {
  DisplayUnit shown = display_unit(display, si_unit);
  static constexpr std::array with_level = {"m", "m/s", "m/s²", "rad", "rad/s", "rad/s²", "N", "N m"};
  if (std::ranges::find(with_level, si_unit) == with_level.end()) return shown;
  const project::Level level = project::shown_level(display, si_unit);
  shown.factor *= project::level_factor(level);
  shown.level = std::string(" ") + project::level_ending(level);
  return shown;
}

DisplayUnit root_mean_square_unit(const project::DisplayUnits& display, const std::string& si_unit) {
  DisplayUnit shown = display_unit(display, si_unit);
  if (si_unit != "1") shown.level = " rms";
  return shown;
}

DisplayUnit amplitude_unit_of_data(const project::DisplayUnits& display, const std::string& si_unit) {
  const bool zero_to_peak = display.level.value_or(project::Level::amplitude) == project::Level::amplitude;
  return zero_to_peak ? display_unit(display, si_unit) : amplitude_unit(display, si_unit);
}

const char* level_words(project::Level level) {
  if (level == project::Level::peak_to_peak) return "peak-to-peak";
  return level == project::Level::rms ? "rms" : "zero-to-peak";
}

UnitPrefix unit_prefix(double largest, const DisplayUnit& unit) {
  const UnitPrefix prefix = unit.si ? unit_prefix(largest * unit.factor, unit.unit) : UnitPrefix{1, unit.unit};
  return {prefix.factor * unit.factor, prefix.unit + unit.level};
}

std::string value_text(double value, const DisplayUnit& shown) {
  const UnitPrefix prefix = unit_prefix(std::abs(value), shown);
  return foundation::significant(value * prefix.factor) + " " + prefix.unit;
}

void LargestOfKind::add(const std::string& si_unit, double value) {
  if (std::isfinite(value)) largest_[si_unit] = std::max(largest_[si_unit], std::abs(value));
}

double LargestOfKind::shown(const std::string& si_unit, double value) const {
  const auto largest_of = [&](const std::string& unit) {
    const auto found = largest_.find(unit);
    return found == largest_.end() ? 0 : found->second;
  };
  double largest = largest_of(si_unit);
  if (si_unit.starts_with("rad")) largest = std::max(largest, largest_of("m" + si_unit.substr(3)));
  if (si_unit == "N m") largest = std::max(largest, largest_of("N"));
  return without_round_off(value, largest);
}

std::string frequency_unit(const project::DisplayUnits& display, const std::string& usual) {
  return display.frequency.empty() ? usual : display.frequency;
}

double shown_frequency(const project::DisplayUnits& display, double omega, const std::string& usual) {
  if (!display.frequency.empty()) return omega * project::shown_frequency(display).factor;
  return usual == "Hz" ? omega / foundation::two_pi : omega;
}

std::string name_in_unit(std::string name, const std::string& unit) {
  constexpr std::string_view angular = "angular_frequency", plain = "frequency";
  const std::size_t at = unit == "rad/s" ? std::string::npos : name.find(angular);
  if (at != std::string::npos) name.replace(at, angular.size(), plain);
  return name;
}

std::string frequency_heading(const project::DisplayUnits& display, const std::string& usual) {
  const std::string unit = frequency_unit(display, usual);
  return (unit == "rad/s" ? "ω [" : "f [") + unit + "]";
}

}  // namespace trivet::documents
