// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/damping_force.h"

#include <cmath>

namespace trivet::elements {

ForceOfRate force_of_rate(const DampingForce& law, double rate) {
  if (const auto* quadratic = std::get_if<QuadraticDamping>(&law)) {
    const double c = rate < 0 ? quadratic->below : quadratic->above, by_rate = c * std::abs(rate);
    return {by_rate * rate, 2 * by_rate};
  }
  const KnotCurve::ValueAndSlope found = std::get<DampingCurve>(law).force.at(rate);
  return {found.value, found.slope};
}

double damping_at_rest(const DampingForce& law) {
  constexpr double beside = 1e-12;  // of the largest rate of the table: either side of a knot at 0
  const auto* curve = std::get_if<DampingCurve>(&law);
  if (!curve) return 0;
  const double rate = beside * (curve->force.knots().back() - curve->force.knots().front());
  return (force_of_rate(law, rate).by_rate + force_of_rate(law, -rate).by_rate) / 2;
}

bool is_piecewise_linear(const DampingForce& law) {
  const auto* curve = std::get_if<DampingCurve>(&law);
  return curve && curve->force.is_linear();
}

bool is_piecewise_quadratic(const DampingForce& law) {
  return std::holds_alternative<QuadraticDamping>(law) || is_piecewise_linear(law);
}

double curvature(const DampingForce& law, double rate) {
  const auto* quadratic = std::get_if<QuadraticDamping>(&law);
  if (!quadratic) return 0;
  return rate < 0 ? -2 * quadratic->below : 2 * quadratic->above;
}

std::vector<double> kinks(const DampingForce& law) {
  if (const auto* curve = std::get_if<DampingCurve>(&law)) return curve->force.knots();
  return {0};
}

}  // namespace trivet::elements
