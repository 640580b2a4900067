// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/units.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "trivet/foundation/plain_text.h"

namespace trivet::project {
namespace {

bool is_letter_of_unit(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 0x80 || c == '_';
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

}  // namespace

std::string with_word_replaced(std::string_view unit, std::string_view word, std::string_view by) {
  std::string result;
  for (std::size_t at = 0; at < unit.size();) {
    if (!is_letter_of_unit(unit[at])) {
      result += unit[at++];
      continue;
    }
    std::size_t end = at;
    while (end < unit.size() && is_letter_of_unit(unit[end])) ++end;
    const std::string_view found = unit.substr(at, end - at);
    result += found == word ? by : found;
    at = end;
  }
  return result;
}

std::string one_spelling(std::string_view unit, std::string_view si) {
  static constexpr std::array<std::pair<const char*, const char*>, 12> signs = {{{"⁻", "-"},
                                                                                 {"¹", "1"},
                                                                                 {"²", "2"},
                                                                                 {"³", "3"},
                                                                                 {"⁴", "4"},
                                                                                 {"⋅", "·"},
                                                                                 {"short ton", "short_ton"},
                                                                                 {"long ton", "long_ton"},
                                                                                 {"metric ton", "metric_ton"},
                                                                                 {"short_tons", "short_ton"},
                                                                                 {"long_tons", "long_ton"},
                                                                                 {"metric_tons", "metric_ton"}}};
  std::string text(unit);
  for (const auto& [from, to] : signs) replace_all(text, from, to);
  static constexpr std::array<std::string_view, 6> of_speeds = {"1/min", "/min", "min-1", "min^-1", "U/min", "r/min"};
  if (si == "rad/s" && std::ranges::find(of_speeds, text) != of_speeds.end()) return "rpm";
  return text;
}

std::string reason_against_ambiguous(std::string_view unit, std::string_view si) {
  for (const char* word : {"ton", "tons"})
    if (with_word_replaced(unit, word, "t") != unit)
      return foundation::quoted(std::string(word)) +
          " has several meanings; write \"t\" for 1000 kg, \"short ton\" for 907.185 kg or \"long ton\" for 1016.05 kg";
  static constexpr std::array<std::string_view, 5> of_time = {"1/s", "/s", "s-1", "s^-1", "1/sec"};
  if (si == "rad/s" && std::ranges::find(of_time, unit) != of_time.end())
    return foundation::quoted(std::string(unit)) + " may be cycles or radians per second; write \"Hz\" or \"rad/s\"";
  return "";
}

const std::vector<MassForForce>& masses_for_forces() {
  static const std::vector<MassForForce> list = {{"kg", "kgf"},     {"lb", "lbf"}, {"lbs", "lbf"}, {"pound", "lbf"},
                                                 {"pounds", "lbf"}, {"g", "gf"},   {"oz", "ozf"}};
  return list;
}

}  // namespace trivet::project
