// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "trivet/project/text/units.h"

namespace trivet::project {

/// Level of a harmonic quantity: zero-to-peak, peak-to-peak or root mean square.
enum class Level { amplitude, peak_to_peak, rms };

/// Share of an amplitude: 2 for peak-to-peak, 1/√2 for an effective value.
[[nodiscard]] double level_factor(Level level);
/// "amplitude", "peak_to_peak" or "rms": the words of [display].
[[nodiscard]] const char* level_name(Level level);
/// "0-p", "p-p" or "rms": the word after a unit.
[[nodiscard]] const char* level_ending(Level level);

/// What a number is in the program, and so which levels may follow its unit in the file.
enum class Levels {
  none,         ///< no vibration, or one without a level
  of_harmonic,  ///< an amplitude: it is converted from every level
  of_orders,    ///< the same of several orders together, whose levels are not shares of one another: each is judged
  of_random,    ///< the root mean square of a random vibration or of a band: only "rms"
  of_largest    ///< the largest magnitude over time: only "0-p"
};

/// A text and the level at its end: "4.5 mm/s rms" is "4.5 mm/s" and rms.
struct LevelledText {
  std::string number;
  std::optional<Level> level;
};
[[nodiscard]] LevelledText split_level(std::string_view text);

/// The reason why such a number has not this level; none if it may have it.
[[nodiscard]] std::optional<std::string> reason_against(Levels levels, Level level);

/// SI value of a text with a unit and perhaps a level, or the reason why it has none. A text without a level is at
/// `wanted`, as is the result.
[[nodiscard]] tl::expected<double, std::string> to_si_at_level(std::string_view text, Quantity quantity, Levels levels,
                                                               Level wanted = Level::amplitude);

}  // namespace trivet::project
