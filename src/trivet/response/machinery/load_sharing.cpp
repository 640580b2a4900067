// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/machinery/load_sharing.h"

#include <algorithm>
#include <cassert>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/response/steady/at_rest.h"
#include "trivet/response/steady/mounts.h"
#include "trivet/response/steady/static_response.h"

namespace trivet::response {

LoadSharing load_sharing(const model::System& system, const assembly::Assembled& assembled) {
  const auto& gravity = system.description().gravity;
  if (!gravity || gravity->isZero(0))
    throw foundation::NotComputable(
        "load sharing: the direction of gravity is missing; give gravity = [0, 0, -9.80665]");
  const AtRest at_rest(system, assembled);
  LoadSharing result;
  std::vector<std::string> words;
  for (const std::size_t e : mounts(system)) {
    result.mounts.emplace_back().element = system.elements()[e].name;
    words.insert(words.end(), {result.mounts.back().element, result.mounts.back().element + ".deflection"});
  }
  const StaticResponse rest = static_response(at_rest.system(), at_rest.assembled(), words);
  const Eigen::Vector3d down = gravity->normalized();
  assert(rest.values.size() == 12 * result.mounts.size());
  // Per mount: six components of the wrench, then six of the deflection.
  double largest = 0;
  for (std::size_t m = 0; m < result.mounts.size(); ++m) {
    MountLoad& mount = result.mounts[m];
    for (std::size_t j = 0; j < 6; ++j) {
      if (j < 3) mount.force(to_index(j)) = rest.values[12 * m + j].value;
      mount.deflection(to_index(j)) = rest.values[12 * m + 6 + j].value;
    }
    mount.bearing = mount.force.dot(down);
    result.bearing_in_total += mount.bearing;
    largest = std::max(largest, mount.force.norm());
  }
  constexpr double round_off = 1e-12;
  if (!(result.bearing_in_total > round_off * largest))
    throw foundation::NotComputable("load sharing: the mounts carry no load in the direction of gravity");
  for (MountLoad& mount : result.mounts) mount.share = mount.bearing / result.bearing_in_total;
  return result;
}

}  // namespace trivet::response
