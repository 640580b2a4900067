// SPDX-License-Identifier: BSD-3-Clause
// The fractional Zener law as a sum of Maxwell branches: its relaxation spectrum is positive, so non-negative least
// squares on a grid of times keeps the sum passive and drops the branches that are not needed.
#include <fmt/format.h>

#include <cmath>

#include "trivet/elements/viscoelastic.h"
#include "trivet/foundation/first_error.h"
#include "trivet/foundation/hertz.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/nonnegative_least_squares.h"

namespace trivet::elements {
namespace {

using Complex = std::complex<double>;

struct Band {
  double from = 0, to = 0;  // [rad/s]
};

double decades(const Band& band) { return std::log10(band.to / band.from); }

/// `count` logarithmically equal steps over the band, both ends included.
std::vector<double> grid(const Band& band, int count) {
  std::vector<double> points;
  for (int i = 0; i <= count; ++i)
    points.push_back(band.from * std::pow(band.to / band.from, static_cast<double>(i) / count));
  return points;
}

/// Candidate times: to three decades beyond the band at both ends, for the tails of the spectrum, and the time of the
/// law itself.
std::vector<double> candidate_times(const FractionalZener& law, const Band& band, double per_decade) {
  const Band wide{1e-3 / band.to, 1e3 / band.from};
  std::vector<double> times = grid(wide, static_cast<int>(std::ceil(per_decade * decades(wide))));
  times.push_back(law.time);
  return times;
}

double worst_error(const FractionalZener& law, const RationalForm& form, const Band& band) {
  constexpr int points_per_decade = 50;
  double worst = 0;
  for (const double w : grid(band, static_cast<int>(std::ceil(points_per_decade * decades(band))))) {
    const Complex exact = relative_modulus(Viscoelastic(law), w);
    worst = std::max(worst, std::abs(relative_modulus(form, w) - exact) / std::abs(exact));
  }
  return worst;
}

/// Rows: real and imaginary part of the relative error at each frequency. Columns: the candidates and a dashpot.
RationalForm fit(const FractionalZener& law, const Band& band, double per_decade) {
  constexpr int points_per_decade = 12;
  const std::vector<double> frequencies = grid(band, static_cast<int>(std::ceil(points_per_decade * decades(band))));
  const std::vector<double> times = candidate_times(law, band, per_decade);
  const auto rows = to_index(frequencies.size()), columns = to_index(times.size()) + 1;
  const double dashpot = 1 / band.to;  // unit of the dashpot column: of the size of the others
  Eigen::MatrixXd a(2 * rows, columns);
  Eigen::VectorXd b(2 * rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const double w = frequencies[i];
    const Complex exact = relative_modulus(Viscoelastic(law), w);
    const auto set = [&](Eigen::Index j, Complex value) { a(2 * i, j) = value.real(), a(2 * i + 1, j) = value.imag(); };
    for (Eigen::Index j = 0; j + 1 < columns; ++j) set(j, (relative_modulus(Zener{1, times[j]}, w) - 1.0) / exact);
    set(columns - 1, Complex(0, w * dashpot) / exact);
    const Complex target = (exact - 1.0) / exact;
    b(2 * i) = target.real(), b(2 * i + 1) = target.imag();
  }
  const Eigen::VectorXd x = numerics::nonnegative_least_squares(a, b);
  RationalForm form;
  form.viscous_time = x(columns - 1) * dashpot;
  for (Eigen::Index j = 0; j + 1 < columns; ++j)
    if (x(j) > 0) form.ratios.push_back(x(j)), form.times.push_back(times[j]);
  form.worst_error = worst_error(law, form, band);
  return form;
}

RationalForm fitted(const FractionalZener& law, const Band& band, double accuracy) {
  RationalForm best;
  for (const double per_decade : {1.0, 1.5, 2.0, 3.0, 4.0, 6.0}) {
    const RationalForm form = fit(law, band, per_decade);
    if (per_decade == 1.0 || form.worst_error < best.worst_error) best = form;
    if (best.worst_error <= accuracy) break;
  }
  return best;
}

}  // namespace

RationalForm rational_form(const Viscoelastic& law, double from, double to, double accuracy) {
  if (!(from > 0 && to > from && std::isfinite(to)))
    throw foundation::InvalidInput(
        fmt::format("band of a rational form: {}, must be 0 < from < to", foundation::hertz_range(from, to, 6)));
  foundation::refuse_errors(check(law));
  if (const auto* l = std::get_if<KelvinVoigt>(&law)) return {.viscous_time = l->time, .ratios = {}, .times = {}};
  if (const auto* l = std::get_if<Zener>(&law)) return {.ratios = {l->ratio}, .times = {l->time}};
  if (const auto* l = std::get_if<GeneralizedMaxwell>(&law)) return {.ratios = l->ratios, .times = l->times};
  const auto& fractional = std::get<FractionalZener>(law);
  if (fractional.order == 1) return {.ratios = {fractional.ratio}, .times = {fractional.time}};
  return fitted(fractional, {from, to}, accuracy);
}

}  // namespace trivet::elements
