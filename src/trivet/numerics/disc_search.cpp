// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/disc_search.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "trivet/numerics/axis_panels.h"
#include "trivet/numerics/generalized_modes.h"
#include "trivet/numerics/load.h"
#include "trivet/numerics/quadratic_roots.h"
#include "trivet/numerics/response_series.h"
#include "trivet/numerics/sign_changes.h"

namespace trivet::numerics {
namespace {

using Series = Eigen::RowVectorXcd;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int order = 36;           // 0.4³⁶ ≈ 5e-15
constexpr double overlap = 1e-6;    // panels are searched a little beyond their ends; repeats merge afterwards
constexpr double at_rest = 1e-7;    // of a panel's radius: an extremum nearer to ω = 0 stands there, and is no peak
constexpr double vanishing = 1e-12; // of what all coordinates together could give: ups and downs below are round-off

Eigen::VectorXcd poles_of(const DynamicMatrices& m) {
  const GeneralizedModes modes = generalized_modes(m.K, m.A, true);
  QuadraticRoots roots;
  if (modes.route == ModeRoute::definite_mass && modes.lambda.minCoeff() >= 0) {
    roots = roots_in_modal_basis(modes.lambda.cwiseSqrt(), modes.shapes.transpose() * m.B * modes.shapes, {});
    roots.vectors = (modes.shapes.cast<Complex>() * roots.vectors).eval();
  } else {
    roots = roots_of_companion(m);
  }
  refine_roots(m, roots);
  return roots.lambda;
}

std::complex<double> value(const ObservedRow& row, const Eigen::VectorXcd& q, double omega) {
  const Complex s(0, omega);
  Complex y = (row.on_displacement.transpose().cast<Complex>() * q).value();
  if (row.on_velocity.size() > 0) y += s * (row.on_velocity.transpose().cast<Complex>() * q).value();
  return integer_power(s, row.derivative) * y;
}

/// |y| if all coordinates worked together.
double possible_amplitude(const ObservedRow& row, const Eigen::VectorXd& q, double omega) {
  double reach = row.on_displacement.cwiseAbs().dot(q);
  if (row.on_velocity.size() > 0) reach += omega * row.on_velocity.cwiseAbs().dot(q);
  return std::pow(omega, row.derivative) * reach;
}

Series times_linear(const Series& s, Complex a, Complex b) {
  Series result = a * s;
  result.tail(s.size() - 1) += b * s.head(s.size() - 1);
  return result;
}

/// |y|² = s^(2 power) Σ square_k τᵏ; s = 1/ω at infinity, power 0 elsewhere.
struct Square {
  std::vector<double> coefficients;
  int power = 0;
};

Square squared(const Series& y, int power) {
  Square result{std::vector<double>(static_cast<std::size_t>(y.size()), 0.0), power};
  for (Eigen::Index k = 0; k < y.size(); ++k)
    for (Eigen::Index j = 0; j <= k; ++j) result.coefficients[static_cast<std::size_t>(k)] += (y(j) * std::conj(y(k - j))).real();
  return result;
}

Square square_of(const ObservedRow& row, const Panel& panel, const SeriesAtInfinity& q) {
  const Complex i(0, 1);
  Series y = row.on_displacement.transpose().cast<Complex>() * q.coefficients;
  const bool has_rate = row.on_velocity.size() > 0 && !row.on_velocity.isZero(0);
  const Series rate = has_rate ? Series(i * (row.on_velocity.transpose().cast<Complex>() * q.coefficients)) : Series();
  if (!panel.at_infinity) {
    if (has_rate) y += times_linear(rate, panel.centre, panel.radius);
    for (int d = 0; d < row.derivative; ++d) y = times_linear(y, i * panel.centre, i * panel.radius);
    return squared(y, 0);
  }
  int power = q.power - row.derivative;
  if (has_rate) {  // s y = s c0ᵀq + i c1ᵀq
    y = (times_linear(y, 0, panel.radius) + rate).eval();
    --power;
  }
  while (!y.isZero(0) && y(0) == Complex(0)) {
    y.head(y.size() - 1) = (y.tail(y.size() - 1) / panel.radius).eval();
    y(y.size() - 1) = 0;
    ++power;
  }
  return squared(y, power);
}

/// d|y|²/dτ, at infinity times s^(1 − 2 power).
std::vector<double> slope(const Square& square) {
  std::vector<double> g;
  for (std::size_t k = square.power == 0 ? 1 : 0; k < square.coefficients.size(); ++k)
    g.push_back((2.0 * square.power + static_cast<double>(k)) * square.coefficients[k]);
  return g;
}

double amplitude(const Square& square, const Panel& panel, double tau) {
  const double root = std::sqrt(std::max(polynomial_value(square.coefficients, tau), 0.0));
  return panel.at_infinity ? root * std::pow(panel.radius * tau, square.power) : root;
}

double size_of(const Square& square) {
  double largest = 0;
  for (const double c : square.coefficients) largest = std::max(largest, std::abs(c));
  return std::sqrt(largest);
}

void note_extrema(const Square& square, const Panel& panel, double from, double to, BandCurve& curve) {
  std::vector<SignChange> changes = sign_changes(slope(square), panel.at_infinity ? 0 : -1 - overlap, 1 + overlap);
  if (panel.at_infinity) std::reverse(changes.begin(), changes.end());
  for (const SignChange& change : changes) {
    if (panel.at_infinity && !(change.at > 0)) continue;
    const double omega = panel.at_infinity ? 1 / (panel.radius * change.at) : panel.centre + panel.radius * change.at;
    if (!panel.at_infinity && !(omega > at_rest * panel.radius)) continue;
    if (omega > from && omega < to) curve.extrema.push_back({omega, amplitude(square, panel, change.at), change.falling});
  }
}

/// Ascending, and of neighbours of one kind (an extremum seen from two panels) only the more extreme.
void let_alternate(std::vector<Extremum>& all) {
  std::stable_sort(all.begin(), all.end(), [](const Extremum& a, const Extremum& b) { return a.angular_frequency < b.angular_frequency; });
  std::vector<Extremum> result;
  for (const Extremum& e : all) {
    if (result.empty() || result.back().maximum != e.maximum) result.push_back(e);
    else if ((e.amplitude > result.back().amplitude) == e.maximum) result.back() = e;
  }
  all = result;
}

Eigen::VectorXcd response(const DynamicMatrices& m, const Eigen::VectorXd& load, double omega) {
  return m.at(omega).partialPivLu().solve(load.cast<Complex>());
}

/// Does |y| grow like 1/distance on both sides of an undamped pole?
bool is_unbounded(const DynamicMatrices& m, const Eigen::VectorXd& load, const ObservedRow& row, double pole) {
  const auto at = [&](double gaps) {
    const double omega = pole * (1 + gaps * gap_at_pole);
    return std::abs(value(row, response(m, load, omega), omega));
  };
  return at(-16) > 9 * at(-160) && at(16) > 9 * at(160);  // a pole in reach gives 10
}

/// |y|; infinite where Z is singular.
double height(const Complex& y) { return std::isnan(std::abs(y)) ? infinity : std::abs(y); }

}  // namespace

std::vector<BandCurve> search_by_discs(const DynamicMatrices& given, const Eigen::VectorXd& load, const std::vector<ObservedRow>& rows, double from,
                                       double to) {
  const Eigen::VectorXd scale = unit_scale(given);
  const PanelCover cover = cover_axis(poles_of(given));
  std::vector<BandCurve> curves(rows.size());
  if (load.isZero(0)) return curves;
  const Load constant(load.cast<Complex>());
  for (const Panel& panel : cover.panels) {
    if (!panel.at_infinity && (panel.centre + panel.radius < from || panel.centre - panel.radius > to)) continue;
    if (panel.at_infinity && to < 1 / panel.radius) continue;
    const SeriesAtInfinity q = panel.at_infinity ? response_series_at_infinity(given, constant, panel.radius, order)
                                                 : SeriesAtInfinity{response_series(given, constant, panel.centre, panel.radius, order), 0};
    if (!q.coefficients.allFinite()) {  // on a pole to the last digit
      for (BandCurve& curve : curves) curve.complete = false;
      continue;
    }
    const double level = q.coefficients.col(0).cwiseAbs().cwiseQuotient(scale).maxCoeff();
    for (std::size_t c = 0; c < rows.size(); ++c) {
      const Square square = square_of(rows[c], panel, q);
      if (panel.at_infinity) curves[c].at_end = square.power > 0 ? 0 : square.power < 0 && square.coefficients[0] > 0 ? infinity : amplitude(square, panel, 0);
      else if (!(size_of(square) > vanishing * possible_amplitude(rows[c], level * scale, panel.centre))) continue;
      note_extrema(square, panel, from, to, curves[c]);
    }
  }
  const double start = std::max(from, cover.lowest);
  const Eigen::VectorXcd at_start = response(given, load, start);
  for (std::size_t c = 0; c < rows.size(); ++c) {
    curves[c].at_start = height(value(rows[c], at_start, start));
    if (std::isfinite(to)) curves[c].at_end = height(value(rows[c], response(given, load, to), to));
    for (const double pole : cover.poles_on_axis)
      if (pole >= from && pole <= to && is_unbounded(given, load, rows[c], pole)) curves[c].extrema.push_back({pole, infinity, true});
    let_alternate(curves[c].extrema);
  }
  return curves;
}

}  // namespace trivet::numerics
