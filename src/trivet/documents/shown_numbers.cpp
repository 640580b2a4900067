// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/documents/shown_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/documents/text_table.h"
#include "trivet/foundation/constants.h"

namespace trivet::documents {

DisplayUnit display_unit(const project::DisplayUnits& display, const std::string& si_unit) {
  const project::ShownUnit shown = project::shown_unit(display, si_unit);
  return {shown.unit, "", shown.factor, shown.unit == si_unit};
}

DisplayUnit amplitude_unit(const project::DisplayUnits& display, const std::string& si_unit) {
  DisplayUnit shown = display_unit(display, si_unit);
  if (si_unit == "1") return shown;
  shown.factor *= project::level_factor(display.level);
  if (display.level == project::Level::peak_to_peak) shown.level = " p-p";
  if (display.level == project::Level::rms) shown.level = " rms";
  return shown;
}

const char* level_words(project::Level level) {
  if (level == project::Level::peak_to_peak) return "peak-to-peak";
  return level == project::Level::rms ? "rms" : "zero-to-peak";
}

std::string sentence_note(const project::DisplayUnits& display) {
  return display.level == project::Level::amplitude ? "" : " (Amplitudes in this sentence are zero-to-peak.)";
}

UnitPrefix unit_prefix(double largest, const std::string& unit) {
  static const char* const names[] = {"n", "µ", "m", "", "k", "M"};
  if (!(largest > 0) || !std::isfinite(largest)) return {1, unit};
  int n = static_cast<int>(std::floor(std::log10(largest) / 3 + 1e-9));
  n = std::max(-3,
               std::min(unit.starts_with("N") || unit.starts_with("W") ? 2 : 0, n));  // "km/s²" and "krad" are unusual
  return {std::pow(10.0, -3 * n), names[n + 3] + unit};
}

UnitPrefix unit_prefix(double largest, const DisplayUnit& unit) {
  const UnitPrefix prefix = unit.si ? unit_prefix(largest * unit.factor, unit.unit) : UnitPrefix{1, unit.unit};
  return {prefix.factor * unit.factor, prefix.unit + unit.level};
}

std::string value_text(double value, const DisplayUnit& shown) {
  const UnitPrefix prefix = unit_prefix(std::abs(value), shown);
  const double shown_value = value * prefix.factor;
  constexpr double four_digits = 9999.5, in_full = 1e7;  // four digits would make 12000 kg 1.2e+04 kg
  if (std::abs(shown_value) >= four_digits && std::abs(shown_value) < in_full)
    return fmt::format("{:.0f} {}", shown_value, prefix.unit);
  return fmt::format("{:.4g} {}", shown_value, prefix.unit);
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

std::vector<std::string> frequency_units(const project::DisplayUnits& display) { return {frequency_unit(display)}; }

std::string frequency_heading(const project::DisplayUnits& display, const std::string& usual) {
  const std::string unit = frequency_unit(display, usual);
  return (unit == "rad/s" ? "ω [" : "f [") + unit + "]";
}

}  // namespace trivet::documents
