// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace trivet::study {

/// A number that is drawn for each design.
struct DrawnName {
  std::string tolerance;
  std::string place;  ///< its path, of a tolerance that draws for each place; otherwise empty

  /// "rubber", or "rubber at elements.left.scale".
  [[nodiscard]] std::string words() const { return place.empty() ? tolerance : tolerance + " at " + place; }
};

}  // namespace trivet::study
