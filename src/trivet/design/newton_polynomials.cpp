// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/design/sum_family.h"

#include <cassert>
#include <cmath>
#include <numbers>

#include "trivet/foundation/index.h"

namespace trivet::design {

const std::vector<double>& newton_nodes() {
  static const std::vector<double> all = [] {
    std::vector<double> nodes = {0.0618033988749895, 1, 0};
    constexpr int grid = 400;
    while (to_index(nodes.size()) <= most_degree) {
      double best = 0, largest = 0;
      for (int i = 1; i < grid; ++i) {
        const double t = 0.5 * (1 - std::cos(std::numbers::pi * i / grid));
        double product = 1;
        for (const double node : nodes) product *= std::abs(t - node);
        if (product > largest) largest = product, best = t;
      }
      assert(largest > 0 && "nodes differ, so that differences have a divisor");
      nodes.push_back(best);
    }
    return nodes;
  }();
  return all;
}

std::vector<double> newton_slopes(double t, int degree) {
  assert(degree >= 0 && degree <= most_degree);
  const std::vector<double>& nodes = newton_nodes();
  std::vector<double> slopes = {0};
  for (int k = 1; k <= degree; ++k) {
    double product = 1, slope = 0;
    for (int l = 0; l < k; ++l) {
      const double length = nodes[k] - nodes[l];
      slope = (slope * (t - nodes[l]) + product) / length;
      product *= (t - nodes[l]) / length;
    }
    slopes.push_back(slope);
  }
  return slopes;
}

}  // namespace trivet::design
