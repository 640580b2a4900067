// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/machinery/rated_loads.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "trivet/foundation/index.h"
#include "trivet/response/steady/static_response.h"

namespace trivet::response {

Eigen::Matrix3d mount_axes(const model::System& system, const model::Element& element) {
  return model::end_in_ground(system.bodies(), element.n).rotation;
}

std::vector<RatedLoad> rated_loads(const model::System& system, const assembly::Assembled& assembled) {
  std::vector<RatedLoad> result;
  std::vector<std::string> words;
  for (std::size_t e = 0; e < system.elements().size(); ++e) {
    const model::Element& element = system.elements()[e];
    if (!element.rating) continue;
    result.push_back({e});
    words.insert(words.end(), {element.name, element.name + ".deflection"});
  }
  if (result.empty()) return result;
  const StaticResponse rest = static_response(
      system, assembled, assembly::channels(system, assembled, words, assembly::MotionQuantity::displacement));
  constexpr std::size_t values_per_mount = 12, deflection_along_axis = 8;  // six of the wrench, six of the deflection
  for (std::size_t m = 0; m < result.size(); ++m) {
    const model::Element& element = system.elements()[result[m].element];
    const std::size_t first = values_per_mount * m;
    Eigen::Vector3d force;  // on the N side, ground axes
    for (std::size_t j = 0; j < 3; ++j) force(to_index(j)) = rest.values[first + j].value;
    result[m].load = -(mount_axes(system, element).transpose() * force);
    result[m].deflection = element.creep * rest.values[first + deflection_along_axis].value;
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
