// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/steady/mounts.h"

namespace trivet::response {

std::vector<std::size_t> mounts(const model::System& system) {
  std::vector<std::size_t> result;
  for (std::size_t e = 0; e < system.elements().size(); ++e)
    if (!system.elements()[e].n.body && !system.elements()[e].is_foundation) result.push_back(e);
  return result;
}

}  // namespace trivet::response
