// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/random/integration_panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

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
  const double distance = 0.5 * sum_of_distances(poles, from, from);
  const double certain = 2 * distance / (ellipse + 2), most = 2 * distance / (ellipse - 2);
  for (const double share : {1.0, 0.8, 0.6, 0.4, 0.2}) {
    const double h = certain + share * (most - certain);
    if (sum_of_distances(poles, from, from + 2 * h) >= ellipse * h) return h;
  }
  return certain;
}

struct GaussRule {
  std::array<double, 8> node, weight;
};
/// Positive half of the 16-point rule. [Abramowitz and Stegun, table 25.4]
constexpr GaussRule gauss16{
    {0.0950125098376374402, 0.2816035507792589132, 0.4580167776572273863, 0.6178762444026437484, 0.7554044083550030339,
     0.8656312023878317439, 0.9445750230732325761, 0.9894009349916499326},
    {0.1894506104550684963, 0.1826034150449235889, 0.1691565193950025382, 0.1495959888165767321, 0.1246289712555338720,
     0.0951585116824927848, 0.0622535239386478929, 0.0271524594117540949}};

}  // namespace

std::vector<double> graded_panels(const Eigen::VectorXcd& poles, double from, double to, double longest_delay) {
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
      throw foundation::NotComputable(
          fmt::format("random response: the band from {:.4g} to {:.4g} rad/s cannot be integrated in {} panels: the "
                      "roots of the system lie too far apart, or one is too near {:.4g} rad/s",
                      from, to, most_panels, at));
    // No narrow last panel: the remainder becomes one panel or two halves.
    ends.push_back(at + 2 * h >= to ? to : at + 4 * h >= to ? 0.5 * (at + to) : at + 2 * h);
  }
  return ends;
}

IntegrationNodes gauss_nodes(const std::vector<double>& ends) {
  const auto panels = to_index(std::max<std::size_t>(ends.size(), 1) - 1);
  IntegrationNodes nodes{Eigen::VectorXd(16 * panels), Eigen::VectorXd(16 * panels)};
  for (Eigen::Index p = 0; p < panels; ++p) {
    const double from = ends[to_size(p)], to = ends[to_size(p) + 1], h = 0.5 * (to - from), centre = from + h;
    for (Eigen::Index i = 0; i < 8; ++i) {
      const double reach = h * gauss16.node[to_size(i)], weight = h * gauss16.weight[to_size(i)];
      nodes.omega(16 * p + 7 - i) = centre - reach;
      nodes.omega(16 * p + 8 + i) = centre + reach;
      nodes.weight(16 * p + 7 - i) = nodes.weight(16 * p + 8 + i) = weight;
    }
  }
  return nodes;
}

KronrodRule kronrod_rule() {
  constexpr std::array<double, 8> node = {0.991455371120812639206854697526329, 0.949107912342758524526189684047851,
                                          0.864864423359769072789712788640926, 0.741531185599394439863864773280788,
                                          0.586087235467691130294144691693190, 0.405845151377397166906606412076961,
                                          0.207784955007898467600689403773245, 0.0};
  constexpr std::array<double, 8> kronrod = {0.022935322010529224963732008058970, 0.063092092629978553290700663189204,
                                             0.104790010322250183839876322541518, 0.140653259715525918745189590510238,
                                             0.169004726639267902826583426598550, 0.190350578064785409913256402421014,
                                             0.204432940075298892414161999234649, 0.209482141084727828012999174891714};
  constexpr std::array<double, 4> gauss = {0.129484966168869693270611432679082, 0.279705391489276667901467771423780,
                                           0.381830050505118944950369775488975, 0.417959183673469387755102040816327};
  KronrodRule rule;
  rule.gauss.setZero();
  for (int i = 0; i < 8; ++i) {
    const auto at = to_size(i);
    rule.node(i) = -node[at], rule.node(14 - i) = node[at];
    rule.kronrod(i) = rule.kronrod(14 - i) = kronrod[at];
    if (i % 2 == 1) rule.gauss(i) = rule.gauss(14 - i) = gauss[at / 2];
  }
  return rule;
}

}  // namespace trivet::response
