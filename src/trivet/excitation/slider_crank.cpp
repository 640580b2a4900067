// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/excitation/slider_crank.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "trivet/excitation/refusal.h"
#include "trivet/foundation/first_error.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"

namespace trivet::excitation {

namespace {

constexpr double negligible = 1e-18;

void require_rod_ratio(double lambda) {
  if (!(lambda > 0 && lambda < 1))
    throw foundation::InvalidInput(
        fmt::format("rod ratio λ = {:.6g}: crank radius over length of the rod must be > 0 and < 1", lambda));
}

/// √(1 − λ² sin²φ) = α |1 + q e^{2iφ}|.
struct Factors {
  double alpha, q;
};

Factors factors(double lambda) {
  const double root = std::sqrt((1 - lambda) * (1 + lambda));
  return {(1 + root) / 2, lambda * lambda / ((1 + root) * (1 + root))};
}

/// Coefficient c_k of cos 2kφ, k ≥ 1, from both binomial series (1 + qz)^½ (1 + q/z)^½.
double root_coefficient(const Factors& f, int k) {
  double binomial = 1;  // C(½, j) q^j
  const auto next = [&f](double value, int j) { return value * f.q * (0.5 - j) / (j + 1); };
  double shifted = 1;
  for (int j = 0; j < k; ++j) shifted = next(shifted, j);
  double sum = 0;
  for (int j = 0; std::abs(binomial) > negligible; ++j) {
    sum += binomial * shifted;
    binomial = next(binomial, j);
    shifted = next(shifted, j + k);
  }
  return 2 * f.alpha * sum;
}

}  // namespace

int negligible_order(double lambda) {
  require_rod_ratio(lambda);
  return 2 * static_cast<int>(std::ceil(std::log(negligible) / std::log(factors(lambda).q))) + 2;
}

std::vector<double> inertia_coefficients(double lambda, int highest) {
  require_rod_ratio(lambda);
  if (highest < 1) throw foundation::InvalidInput(fmt::format("highest order {}: it must be ≥ 1", highest));
  std::vector<double> a(to_size(highest) + 1, 0);
  a[1] = 1;
  const Factors f = factors(lambda);
  for (int n = 2; n <= std::min(highest, negligible_order(lambda)); n += 2)
    a[n] = static_cast<double>(n) * n / lambda * root_coefficient(f, n / 2);
  return a;
}

std::vector<double> inertia_torque_coefficients(double lambda, int highest) {
  const int count = negligible_order(lambda);
  const std::vector<double> a = inertia_coefficients(lambda, count);
  std::vector<double> g(to_size(highest) + 1, 0);
  for (int m = 1; m <= count; ++m)
    for (int n = 1; n <= count; ++n) {
      const double share = 0.5 * a[m] / m * a[n];
      if (m + n <= highest) g[m + n] += share;
      if (const int difference = std::abs(m - n); difference <= highest && m != n)
        g[difference] += m > n ? share : -share;
    }
  return g;
}

namespace {

using Complex = std::complex<double>;
using std::numbers::pi;
constexpr double largest_gap = 30 * pi / 180;  // a longer closing line means an incomplete trace
constexpr double accepted_overlap = 1e-9;      // [rad] for a last point at the end of the cycle, in rounded degrees

/// (1/cycle) ∫ p e^{−iνφ} dφ of the closed polygon, in closed form.
Complex fourier_coefficient(const PressureTrace& trace, double cycle, double order) {
  const std::size_t count = trace.angles.size();
  Complex sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const bool closing = i + 1 == count;
    const double a = trace.angles[i], b = closing ? trace.angles[0] + cycle : trace.angles[i + 1];
    const double p = trace.pressures[i], q = trace.pressures[closing ? 0 : i + 1];
    if (b - a <= accepted_overlap) continue;
    if (order == 0) {
      sum += 0.5 * (p + q) * (b - a);
    } else {
      const Complex at_a = std::polar(1.0, -order * a), at_b = std::polar(1.0, -order * b);
      sum += Complex(0, 1 / order) * (q * at_b - p * at_a) + (q - p) / ((b - a) * order * order) * (at_b - at_a);
    }
  }
  return sum / cycle;
}

}  // namespace

foundation::Problems check(const PressureTrace& trace, double cycle, const std::string& subject) {
  foundation::Problems problems;
  const std::vector<double>&phi = trace.angles, &p = trace.pressures;
  if (phi.size() != p.size())
    problems.error(subject, fmt::format("{} angles and {} pressures", phi.size(), p.size()),
                   "each angle has one pressure", "complete the rows");
  if (phi.size() < 3)
    problems.error(subject, fmt::format("{} points", phi.size()), "a trace has three or more",
                   "give the pressure over a whole cycle");
  for (const auto* column : {&phi, &p})
    for (std::size_t i = 0; i < column->size(); ++i)
      if (!std::isfinite((*column)[i])) {
        problems.error(subject, fmt::format("row {}: {}", i + 1, (*column)[i]), "numbers must be finite",
                       "fill the gap or remove the row");
        break;
      }
  for (std::size_t i = 1; i < phi.size() && !problems.has_errors(); ++i)
    if (!(phi[i] > phi[i - 1]))
      problems.error(subject,
                     fmt::format("row {}: {:.6g}° after {:.6g}°", i + 1, phi[i] * 180 / pi, phi[i - 1] * 180 / pi),
                     "angles must increase", "sort the rows and remove repeats");
  if (problems.has_errors()) return problems;
  const double gap = cycle - (phi.back() - phi.front());
  if (gap < -accepted_overlap)
    problems.error(subject, fmt::format("{:.6g}° from first to last", (phi.back() - phi.front()) * 180 / pi),
                   fmt::format("a cycle has {:.6g}°", cycle * 180 / pi), "cut the trace to one cycle");
  if (gap > largest_gap)
    problems.error(subject, fmt::format("{:.6g}° from first to last", (phi.back() - phi.front()) * 180 / pi),
                   fmt::format("a cycle has {:.6g}°; a straight line closes gaps of up to 30° only", cycle * 180 / pi),
                   "complete the trace, or set the strokes of the engine");
  if (std::abs(gap) <= accepted_overlap && p.back() != p.front())
    problems.warning(subject,
                     fmt::format("{:.6g} Pa at the start of the cycle and {:.6g} Pa at its end", p.front(), p.back()),
                     "a periodic pressure returns to its start; here it jumps", "average cycles, or correct the end");
  return problems;
}

std::vector<TorqueHarmonic> gas_harmonics(const PressureTrace& trace, const Engine& engine, double bore,
                                          double highest_order) {
  foundation::refuse_errors(check(engine, "engine"));
  foundation::refuse_errors(check(trace, engine.cycle(), "pressure"));
  require_positive(bore, "bore", "m");
  require_not_negative(highest_order, "highest order", "");
  const int per_turn = engine.strokes / 2, terms = negligible_order(engine.rod_ratio);
  const auto highest = static_cast<int>(std::floor(highest_order * per_turn + 1e-9));  // in steps of 1/per_turn
  const std::vector<double> a = inertia_coefficients(engine.rod_ratio, terms);
  std::vector<Complex> pressure;
  for (int k = 0; k <= highest + terms * per_turn; ++k)
    pressure.push_back(fourier_coefficient(trace, engine.cycle(), static_cast<double>(k) / per_turn));
  const auto at = [&](int k) { return k >= 0 ? pressure[k] : std::conj(pressure[-k]); };
  const double force_radius = pi * bore * bore / 4 * engine.crank_radius;
  std::vector<TorqueHarmonic> harmonics;
  for (int k = 0; k <= highest; ++k) {
    Complex sum = 0;  // −s′/r = Σ (aₘ/m) sin mφ times the pressure
    for (int m = 1; m <= terms; ++m) sum += a[m] / m * (at(k - m * per_turn) - at(k + m * per_turn)) / Complex(0, 2);
    harmonics.push_back({static_cast<double>(k) / per_turn, force_radius * (k == 0 ? Complex(sum.real()) : 2.0 * sum)});
  }
  return harmonics;
}

}  // namespace trivet::excitation
