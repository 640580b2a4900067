// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace trivet::study {

/// A number in a sentence of a study, SI; people see it in the units and at the level of [display].
struct StatedNumber {
  enum class Kind { frequency, amplitude };
  double value = 0;
  std::string unit;
  Kind kind = Kind::amplitude;
};

/// A sentence whose numbers are still numbers.
using StatedWords = std::vector<std::variant<std::string, StatedNumber>>;

/// The words in SI, amplitudes zero-to-peak and frequencies in both units: "m1.x: 8.4 mm at 2.77 rad/s (0.441 Hz)".
[[nodiscard]] std::string words_in_si(const StatedWords& words);

}  // namespace trivet::study
