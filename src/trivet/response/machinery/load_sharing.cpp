// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/machinery/load_sharing.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/response/steady/at_rest.h"
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

Eigen::Matrix3d mount_axes(const model::System& system, const model::Element& element) {
  return model::end_in_ground(system.bodies(), element.n).rotation;
}

std::vector<RatedLoad> rated_loads(const model::System& moving, const assembly::Assembled& assembled_moving) {
  std::vector<RatedLoad> result;
  for (std::size_t e = 0; e < moving.elements().size(); ++e)
    if (moving.elements()[e].rating) result.push_back({e});
  if (result.empty()) return result;
  const AtRest at_rest(moving, assembled_moving);
  const model::System& system = at_rest.system();
  const Eigen::VectorXd rest = static_solution(system, at_rest.assembled()).coordinates();
  const assembly::Assembled& assembled = at_rest.assembled().first_order();  // loads along the axes of the mounts
  for (RatedLoad& one : result) {  // one after another: the rows of all mounts of a large system take gigabytes
    const model::Element& element = system.elements()[one.element];
    const std::vector<assembly::Channel> channels = assembly::channels(
        system, assembled, {element.name, element.name + ".deflection"}, assembly::MotionQuantity::displacement);
    assert(channels.size() == 12 && "a wrench and a deflection");
    const auto value = [&](const assembly::Channel& channel) -> double {
      return value_at_rest(channel, assembled, rest) + channel.at_rest;
    };
    const Eigen::Vector3d force(value(channels[0]), value(channels[1]), value(channels[2]));  // on the N side
    one.load = -(mount_axes(system, element).transpose() * force);
    constexpr std::size_t deflection_along_axis = 8;  // after six of the wrench
    one.deflection = element.creep * value(channels[deflection_along_axis]);
  }
  remove_round_off(result);
  return result;
}

void remove_round_off(std::vector<RatedLoad>& loads) {
  constexpr double round_off = 1e-9;  // results have nine digits
  double largest = 0;
  for (const RatedLoad& one : loads) largest = std::max(largest, one.load.cwiseAbs().maxCoeff());
  for (RatedLoad& one : loads)
    one.load =
        one.load.unaryExpr([&](double load) { return std::abs(load) <= round_off * largest ? 0.0 : load; }).eval();
}

bool is_within(double load, const Eigen::Vector2d& range) {
  constexpr double on_the_end = 1e-9;
  return load <= range(1) + on_the_end * std::abs(range(1)) && load >= range(0) - on_the_end * std::abs(range(0));
}

}  // namespace trivet::response
