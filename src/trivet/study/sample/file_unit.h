// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <string>

namespace trivet::study {

/// The unit in which people read a number of the model: that of the number in the file, otherwise SI.
struct FileUnit {
  std::string name;  ///< empty: a pure number
  double si = 1;     ///< SI value of one unit

  /// "210 N/mm" of 210000 [SI].
  [[nodiscard]] std::string words(double value, int digits) const {
    return after(fmt::format("{:.{}g}", value / si, digits));
  }
  /// "210 N/mm" of "210".
  [[nodiscard]] std::string after(const std::string& number) const {
    return name.empty() ? number : number + " " + name;
  }
};

}  // namespace trivet::study
