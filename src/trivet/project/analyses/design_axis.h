// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/project/text/units.h"

namespace trivet::project {

/// Where a parameter acts: the number at this path is `factor` times its value.
struct ParameterPlace {
  std::string path;  ///< as in --set
  double factor = 1;
  bool operator==(const ParameterPlace&) const = default;
};

/// A number that varies from design to design: an axis of a map, or [parameters.NAME].
struct DesignAxis {
  std::string parameter;    ///< dotted path of the first place
  std::string name;         ///< name in tables and pictures; the path by default
  double from = 0, to = 1;  ///< in `unit`
  std::string unit;         ///< as written with from and to; empty: that of a bare number (SI)
  bool logarithmic = false;
  int points = 101;                    ///< of a map
  std::vector<ParameterPlace> places;  ///< all of them
  std::optional<Quantity> quantity;    ///< of the number at the first place; none if it cannot be read

  [[nodiscard]] double at(double share) const;     ///< the value at 0 … 1 of the axis, ends exact
  [[nodiscard]] double share(double value) const;  ///< inverse of `at`, also beyond the ends
  bool operator==(const DesignAxis&) const = default;
};

}  // namespace trivet::project
