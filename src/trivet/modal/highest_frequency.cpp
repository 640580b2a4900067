// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/modal/highest_frequency.h"

#include <algorithm>
#include <cmath>

#include "trivet/modal/modes.h"

namespace trivet::modal {

double highest_natural_frequency(const model::System& system, const assembly::Assembled& assembled) {
  double highest = 0;
  for (const Mode& mode : modes(system, assembled).list)
    highest = std::max(highest, std::sqrt(std::abs(mode.eigenvalue_squared)));
  return highest > 0 ? highest : 1;
}

}  // namespace trivet::modal
