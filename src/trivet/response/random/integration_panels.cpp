// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/random/basis_integrals.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "trivet/foundation/hertz.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"

namespace trivet::response {
namespace {

/// ρ + 1/ρ for ρ = 2.8: sum of the distances of a pole from both ends, divided by the half width.
constexpr double ellipse = 2.8 + 1 / 2.8;
/// Largest half width times delay of e^{−iωτ} on a panel.
constexpr double most_turn = 6;
/// A lightly damped pole needs about 20 panels per decade of its damping ratio, the longest allowed delay 500,000.
constexpr std::size_t most_panels = 1'000'000;
/// Most turns of phase by a delay between inputs over the whole band.
constexpr double most_turns_in_all = 1e6;

double sum_of_distances(const Eigen::VectorXcd& poles, double from, double to) {
  const Eigen::ArrayXd real = poles.real().array().square();
  return ((real + (poles.imag().array() - from).square()).sqrt() + (real + (poles.imag().array() - to).square()).sqrt())
      .minCoeff();
}

double half_width(const Eigen::VectorXcd& poles, double from) {
  // 16 points of Gauss gain 2 · 16 lg ρ digits per pole outside the ellipse with foci at the ends of the panel and the
  // sum ρ + 1/ρ of distances. Certain: |λ − to| ≥ |λ − from| − 2h; most: ≤ |λ − from| + 2h.
  const double distance = 0.5 * sum_of_distances(poles, from, from);
  const double certain = 2 * distance / (ellipse + 2), most = 2 * distance / (ellipse - 2);
  for (const double share : {1.0, 0.8, 0.6, 0.4, 0.2}) {
    const double h = certain + share * (most - certain);
    if (sum_of_distances(poles, from, from + 2 * h) >= ellipse * h) return h;
  }
  return certain;
}

/// Nodes > 0, ascending, and weights. Boost computes them; as long double, so that each is the nearest double.
using Gauss16 = boost::math::quadrature::gauss<long double, 16>;
/// Nodes ≥ 0, ascending, and weights.
using Gauss7 = boost::math::quadrature::gauss<double, 7>;
using Kronrod15 = boost::math::quadrature::gauss_kronrod<double, 15>;

}  // namespace

std::vector<double> graded_panels(const Eigen::VectorXcd& poles, double from, double to, double longest_delay) {
  assert(from >= 0 && to > from && longest_delay >= 0);
  if (const double turns = (to - from) * longest_delay / (2 * std::numbers::pi); turns > most_turns_in_all)
    throw foundation::NotComputable(
        fmt::format("random response: a delay of {:.4g} s between inputs turns their phase {:.3g} times over the band; "
                    "the integration allows at most {:.0f} turns",
                    longest_delay, turns, most_turns_in_all));
  const double most = longest_delay > 0 ? most_turn / longest_delay : std::numeric_limits<double>::infinity();
  std::vector<double> ends = {from};
  while (ends.back() < to) {
    const double at = ends.back();
    double h = poles.size() > 0 ? std::min(half_width(poles, at), most) : most;
    h = std::max(h, 64 * std::numeric_limits<double>::epsilon() * at);
    if (!(at + 2 * h > at) || ends.size() > most_panels)
      throw foundation::NotComputable(fmt::format(
          "random response: the band of {} cannot be integrated in {} panels: the roots of the system lie too "
          "far apart, or one is too near {}",
          foundation::hertz_range(from, to), most_panels, foundation::hertz_words(at)));
    // No narrow last panel: the remainder becomes one panel or two halves.
    ends.push_back(at + 2 * h >= to ? to : at + 4 * h >= to ? 0.5 * (at + to) : at + 2 * h);
  }
  assert(std::ranges::adjacent_find(ends, std::greater_equal<>()) == ends.end() && "no panel is empty");
  return ends;
}

IntegrationNodes gauss_nodes(const std::vector<double>& ends) {
  const auto panels = to_index(std::max<std::size_t>(ends.size(), 1) - 1);
  IntegrationNodes nodes{Eigen::VectorXd(16 * panels), Eigen::VectorXd(16 * panels)};
  for (Eigen::Index p = 0; p < panels; ++p) {
    const double from = ends[p], to = ends[p + 1], h = 0.5 * (to - from), centre = from + h;
    for (Eigen::Index i = 0; i < 8; ++i) {
      const double reach = h * static_cast<double>(Gauss16::abscissa()[i]),
                   weight = h * static_cast<double>(Gauss16::weights()[i]);
      nodes.omega(16 * p + 7 - i) = centre - reach;
      nodes.omega(16 * p + 8 + i) = centre + reach;
      nodes.weight(16 * p + 7 - i) = nodes.weight(16 * p + 8 + i) = weight;
    }
  }
  return nodes;
}

KronrodRule kronrod_rule() {
  KronrodRule rule;
  rule.gauss.setZero();
  for (int i = 0; i < 8; ++i) {
    const double node = Kronrod15::abscissa()[i];
    rule.node(7 - i) = -node, rule.node(7 + i) = node;
    rule.kronrod(7 - i) = rule.kronrod(7 + i) = Kronrod15::weights()[i];
    if (i % 2 == 0) rule.gauss(7 - i) = rule.gauss(7 + i) = Gauss7::weights()[i / 2];
  }
  // Tables of Boost, rounded to double: both rules integrate 1 over −1 … 1 to round-off.
  assert(std::abs(rule.kronrod.sum() - 2) < 1e-14 && std::abs(rule.gauss.sum() - 2) < 1e-14);
  return rule;
}

}  // namespace trivet::response
