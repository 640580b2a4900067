// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/level.h"

#include <array>
#include <numbers>

namespace trivet::project {
namespace {

struct LevelWords {
  Level level;
  const char *name, *ending;
};
constexpr std::array<LevelWords, 3> level_words = {
    {{Level::amplitude, "amplitude", "0-p"}, {Level::peak_to_peak, "peak_to_peak", "p-p"}, {Level::rms, "rms", "rms"}}};

const LevelWords& words_of(Level level) { return level_words[static_cast<std::size_t>(level)]; }

}  // namespace

double level_factor(Level level) {
  return level == Level::amplitude ? 1 : level == Level::peak_to_peak ? 2 : 1 / std::numbers::sqrt2;
}

const char* level_name(Level level) { return words_of(level).name; }

const char* level_ending(Level level) { return words_of(level).ending; }

LevelledText split_level(std::string_view text) {
  const std::size_t last = text.find_last_not_of(" \t");
  const std::string_view trimmed = text.substr(0, last == std::string_view::npos ? 0 : last + 1);
  for (const LevelWords& words : level_words) {
    const std::string_view ending = words.ending;
    if (!trimmed.ends_with(ending)) continue;
    const std::string_view before = trimmed.substr(0, trimmed.size() - ending.size());
    const std::size_t end = before.find_last_not_of(" \t");
    if (end == std::string_view::npos || end + 1 == before.size()) continue;  // a blank is before the level
    return {std::string(before.substr(0, end + 1)), words.level};
  }
  return {std::string(text), std::nullopt};
}

std::optional<std::string> reason_against(Levels levels, Level level) {
  const std::string word = "\"" + std::string(level_ending(level)) + "\"";
  if (levels == Levels::none) return word + " follows amplitudes and limits of vibrations; this number is neither";
  if (levels == Levels::of_random && level != Level::rms)
    return "the level of a random vibration or a band is a root mean square, which " + word + " is not";
  if (levels == Levels::of_largest && level != Level::amplitude)
    return "it limits the largest magnitude over time, which is zero-to-peak; " + word + " does not determine it";
  return std::nullopt;
}

tl::expected<double, std::string> to_si_at_level(std::string_view text, Quantity quantity, Levels levels,
                                                 Level wanted) {
  const LevelledText split = split_level(text);
  if (!split.level) return to_si(text, quantity);
  if (const auto reason = reason_against(levels, *split.level)) return tl::make_unexpected(*reason);
  auto value = to_si(split.number, quantity);
  if (value && (levels == Levels::of_harmonic || levels == Levels::of_orders) && *split.level != wanted)
    *value *= level_factor(wanted) / level_factor(*split.level);
  return value;
}

}  // namespace trivet::project
