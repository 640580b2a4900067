// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/format/quantity_name.h"

#include <array>
#include <utility>

namespace trivet::results {

std::string quantity_name(const std::string& unit) {
  static constexpr std::array<std::pair<const char*, const char*>, 8> names = {{{"m", "displacement"},
                                                                                {"m/s", "velocity"},
                                                                                {"m/s²", "acceleration"},
                                                                                {"rad", "rotation"},
                                                                                {"rad/s", "angular velocity"},
                                                                                {"rad/s²", "angular acceleration"},
                                                                                {"N", "force"},
                                                                                {"N m", "moment"}}};
  for (const auto& [of, name] : names)
    if (unit == of) return name;
  return unit;
}

}  // namespace trivet::results
