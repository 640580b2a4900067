// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/machinery/campbell.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "trivet/foundation/invalid_input.h"

namespace trivet::response {
namespace {

std::vector<NaturalLine> natural_lines(const modal::Roots& roots) {
  std::vector<NaturalLine> lines;
  for (const modal::Root& root : roots.list)
    if (root.damped_angular_frequency && root.eigenvalue.imag() > 0)
      lines.push_back({root.eigenvalue.imag(), root.damping_ratio.value_or(0), root.nearest_mode});
  std::ranges::sort(lines, {}, &NaturalLine::angular_frequency);
  return lines;
}

}  // namespace

Campbell campbell(const std::vector<OrderLoading>& order_loadings, const modal::Modes& modes, const modal::Roots& roots,
                  const assembly::Band& speed) {
  if (!(speed.from >= 0 && speed.to > speed.from && std::isfinite(speed.to)))
    throw foundation::InvalidInput("campbell: the speed range must satisfy 0 ≤ from < to");
  Campbell result{speed, {}, natural_lines(roots), {}};
  for (const OrderLoading& order : order_loadings) {
    result.orders.push_back(order.order);
    assert(order.order > 0 && "the speed is the frequency over the order");
    for (std::size_t i = 0; i < result.natural.size(); ++i) {
      const NaturalLine& line = result.natural[i];
      Interference point{
          i, order.order, line.angular_frequency / order.order, line.angular_frequency, line.nearest_mode, {}, false};
      if (point.speed < speed.from || point.speed > speed.to) continue;
      const Eigen::VectorXd forces =
          modal::modal_forces(modes, order.loading.force.at(line.angular_frequency)).cwiseAbs();
      const auto mode = std::ranges::find(modes.list, point.mode, &modal::Mode::number);
      if (mode != modes.list.end() && forces.squaredNorm() > 0) {
        point.modal_force_share = std::pow(forces(mode - modes.list.begin()), 2) / forces.squaredNorm();
        point.excited = *point.modal_force_share >= excited_from;
      }
      result.points.push_back(point);
    }
  }
  std::ranges::stable_sort(result.points, {}, &Interference::speed);
  return result;
}

}  // namespace trivet::response
