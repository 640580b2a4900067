// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/machinery/rated_loads.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

#include "trivet/foundation/index.h"
#include "trivet/response/steady/at_rest.h"
#include "trivet/response/steady/static_solution.h"

namespace trivet::response {

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
