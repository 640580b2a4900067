// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/level_slips.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "trivet/foundation/problems.h"

namespace trivet::project {
namespace {

constexpr const char* between_words = " \t";

/// The level that a word means: "RMS", "rmss", "peak-to-peak", "pk"; empty if it is unknown.
std::string meant_level(std::string word) {
  std::ranges::transform(word, word.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  constexpr std::array whole = {"peak-to-peak", "pk-pk", "pp", "pkpk"}, half = {"zero-to-peak", "peak", "pk", "0p"};
  if (std::ranges::find(whole, word) != whole.end()) return "p-p";
  if (std::ranges::find(half, word) != half.end()) return "0-p";
  return foundation::nearest_name(word, {"rms", "0-p", "p-p"});
}

}  // namespace

std::optional<LevelSlip> level_slip(std::string_view text, Quantity quantity) {
  const std::size_t last = text.find_last_not_of(between_words), blank = text.find_last_of(between_words, last);
  if (last == std::string_view::npos || blank == std::string_view::npos) return std::nullopt;
  const std::size_t end = text.find_last_not_of(between_words, blank);
  if (end == std::string_view::npos) return std::nullopt;
  const std::string number(text.substr(0, end + 1)), word(text.substr(blank + 1, last - blank));
  if (number.find_first_of(between_words) == std::string::npos || !to_si(number, quantity)) return std::nullopt;
  const std::string meant = meant_level(word);
  return LevelSlip{"\"" + word + "\" is no level; levels are rms, 0-p (zero-to-peak) and p-p (peak-to-peak)",
                   meant.empty() ? "give one of them, or none" : "did you mean \"" + number + " " + meant + "\"?"};
}

}  // namespace trivet::project
