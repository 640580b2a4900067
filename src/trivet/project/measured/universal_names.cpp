// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/measured/universal_names.h"

#include <fmt/format.h>

#include <cstdlib>

#include "trivet/foundation/index.h"
#include "trivet/model/system.h"

namespace trivet::project {

std::string point_name(const exchange::UniversalPoint& point) {
  const int direction = std::abs(point.direction);
  if (direction < 1 || direction > 6) return fmt::format("{}:scalar", point.node);
  return fmt::format("{}:{}{}", point.node, point.direction < 0 ? "-" : "+",
                     model::coordinate_names[to_size(direction - 1)]);
}

}  // namespace trivet::project
