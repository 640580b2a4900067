// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/drawing/axis_ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace trivet::report {

std::vector<Tick> linear_ticks(double from, double to, int wanted) {
  std::vector<Tick> ticks;
  const double span = to - from;
  if (!(span > 0) || !std::isfinite(span)) return ticks;
  const double raw = span / wanted;
  const double decade = std::pow(10.0, std::floor(std::log10(raw)));
  const double ratio = raw / decade;
  const double step = decade * (ratio < 1.5 ? 1 : ratio < 3.5 ? 2 : ratio < 7.5 ? 5 : 10);
  const double first = std::ceil(from / step - 1e-9);
  for (double k = first; k * step <= to + 1e-9 * span; k += 1) {
    const double value = std::abs(k) < 0.5 ? 0 : k * step;
    ticks.push_back({value, fmt::format("{:.10g}", value)});
  }
  return ticks;
}

namespace {

/// digit · 10^exponent in its most readable form: "0.02", "500", "2·10⁻⁶".
std::string power_label(int digit, int exponent) {
  if (exponent >= -3 && exponent <= 3) return fmt::format("{:g}", digit * std::pow(10.0, exponent));
  static const char* const raised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string label = digit == 1 ? "10" : fmt::format("{}·10", digit);
  for (const char sign : std::to_string(exponent)) label += sign == '-' ? "⁻" : raised[sign - '0'];
  return label;
}

/// The digits times powers of ten inside [from, to].
std::vector<Tick> ticks_of_digits(double from, double to, const std::vector<int>& digits) {
  std::vector<Tick> ticks;
  const int first = static_cast<int>(std::floor(std::log10(from))), last = static_cast<int>(std::ceil(std::log10(to)));
  const int step = 1 + (last - first) / 12;
  for (int decade = first; decade <= last; decade += step)
    for (const int digit : digits) {
      const double value = digit * std::pow(10.0, decade);
      if (value >= from * (1 - 1e-9) && value <= to * (1 + 1e-9)) ticks.push_back({value, power_label(digit, decade)});
    }
  return ticks;
}

}  // namespace

std::vector<Tick> decade_ticks(double from, double to) {
  constexpr std::size_t enough = 3;
  std::vector<Tick> ticks = ticks_of_digits(from, to, {1});
  if (ticks.size() < enough || std::log10(to / from) < 2) ticks = ticks_of_digits(from, to, {1, 2, 5});
  if (ticks.size() < enough) ticks = linear_ticks(from, to, 5);  // at least three are inside
  return ticks;
}

std::vector<Tick> angle_ticks(double from, double to) {
  std::vector<Tick> ticks;
  double step = 30;
  for (const double candidate : {45.0, 90.0, 180.0, 360.0, 720.0, 1440.0})
    if ((to - from) / step > 8) step = candidate;
  for (double value = std::ceil(from / step - 1e-9) * step; value <= to + 1e-9; value += step)
    ticks.push_back({value, fmt::format("{:.0f}", value + 0.0)});
  return ticks;
}

}  // namespace trivet::report
