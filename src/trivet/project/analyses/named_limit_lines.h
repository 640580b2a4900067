// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace trivet::project {

/// A published limit of the root mean square of a velocity in each third octave, over its nominal midband frequency.
struct NamedLimitLine {
  std::string name;
  std::vector<std::pair<double, double>> points;  ///< frequency [Hz] and velocity [m/s rms], straight on log axes
  std::string source;
};

/// All of them, in the order of the documentation.
[[nodiscard]] const std::vector<NamedLimitLine>& named_limit_lines();

/// nullptr if there is none of this name.
[[nodiscard]] const NamedLimitLine* named_limit_line(const std::string& name);

/// "VC-A, VC-B … and workshop"
[[nodiscard]] std::string names_of_limit_lines();

}  // namespace trivet::project
