// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace trivet::study {

/// A number that is drawn for each design, or several.
struct DrawnName {
  std::string tolerance;
  std::string which;  ///< of a tolerance that draws for each place: "at PATH"; of several numbers: what they are

  /// "rubber", or "rubber at elements.left.scale".
  [[nodiscard]] std::string words() const { return which.empty() ? tolerance : tolerance + " " + which; }
};

}  // namespace trivet::study
