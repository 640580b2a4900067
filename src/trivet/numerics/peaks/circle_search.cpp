// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/peaks/circle_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "trivet/foundation/hertz.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/peaks/axis_panels.h"
#include "trivet/numerics/peaks/response_series.h"

namespace trivet::numerics {
namespace {

using Complex = std::complex<double>;

/// Samples on a circle of radius `spread` panel radii. Its last `betraying` coefficients reveal a pole inside the
/// circle unless they are below the share `pole_free` of the curve.
constexpr int samples = 64;
constexpr double spread = 1.25;
constexpr int betraying = 8;
constexpr double pole_free = 1e-11;
/// Round-off of a curve as a share of its possible amplitude: a few ε times the condition number of Z, limited so that
/// a pole cannot hide in it.
double round_off_share(double condition) {
  constexpr double count = 16, most = 1e-6;
  return std::min(count * std::numeric_limits<double>::epsilon() * condition, most);
}
/// More consecutive gaps than this are not undamped poles: the element laws cannot be continued analytically here.
constexpr int most_gaps_in_a_row = 200;
/// Limit of panels tried, 64 solutions each: smooth laws take hundreds, a table some more for each of its rows.
constexpr std::size_t most_trials = 20'000, more_per_seam = 16;

/// Amplitudes of each curve on a circle.
struct Sizes {
  Eigen::VectorXd level;      ///< largest amplitude
  Eigen::VectorXd possible;   ///< see CurveSample
  Eigen::VectorXd round_off;  ///< amplitudes below this are round-off of the solutions
  Eigen::VectorXd doubt;      ///< the same if it exceeds the truncation error of the series, else 0
};

/// Taylor coefficients of every curve (rows) in τ, ω = centre + radius τ; empty if a pole is too close.
Eigen::MatrixXcd circle_series(const CurveSampler& sample, const Panel& panel, Sizes& sizes) {
  auto& [level, possible, noise, doubt] = sizes;
  std::vector<Eigen::VectorXcd> values;
  possible.resize(0);
  double condition = 0;
  for (int k = 0; k < samples; ++k) {
    const CurveSample at = sample(
        panel.centre + spread * panel.radius * std::polar(1.0, 2 * std::numbers::pi * k / samples), panel.centre);
    if (!at.values.allFinite()) return {};
    values.push_back(at.values);
    condition = std::max(condition, at.condition);
    possible = k == 0 ? at.possible : Eigen::VectorXd(possible.cwiseMax(at.possible));
    noise = k == 0 ? at.alike : Eigen::VectorXd(noise.cwiseMax(at.alike));
  }
  noise *= round_off_share(condition);
  const Eigen::Index curves = values[0].size();
  Eigen::MatrixXcd series = Eigen::MatrixXcd::Zero(curves, samples);
  level.setZero(curves);
  for (int j = 0; j < samples; ++j)
    for (int k = 0; k < samples; ++k)
      series.col(j) += values[k] * std::polar(1.0 / samples, -2 * std::numbers::pi * ((j * k) % samples) / samples);
  for (const auto& v : values) level = level.cwiseMax(v.cwiseAbs());
  // The last coefficients equal those of the first negative powers: the principal part of a pole inside the circle.
  doubt.setZero(curves);
  for (Eigen::Index c = 0; c < curves; ++c) {
    const double tail = series.row(c).tail(betraying).cwiseAbs().maxCoeff();
    if (level(c) <= noise(c) || tail <= std::max(pole_free * level(c), round_off_share(condition) * possible(c)))
      continue;
    if (tail > noise(c)) return {};
    doubt(c) = noise(c);
  }
  double power = 1;
  for (int j = 0; j < samples; ++j, power /= spread) series.col(j) *= power;
  return series.leftCols(samples - betraying);
}

/// Adds an extremum at a corner: between two smooth pieces a curve may have one that no derivative shows.
void note_corner(double before, double after, const CurveSeries& series, const Panel& panel,
                 std::vector<Extremum>& extrema) {
  constexpr double significant = 1e-9;
  const double height = amplitude(series, panel, -1);
  if (!(before * after < 0) ||
      !(std::min(std::abs(before), std::abs(after)) > significant * height * height / panel.radius))
    return;
  extrema.push_back({panel.centre - panel.radius, height, before > 0, panel.radius, 0});
}

double first_guess(const Eigen::VectorXcd& poles, double from) {
  constexpr double without_poles = 1e-2, least = 1e-6;
  if (poles.size() == 0) return without_poles * from;
  return std::max(panel_ratio * (poles.array() - Complex(0, from)).abs().minCoeff(), least * from);
}

/// Searches along the axis, panel by panel.
class CircleScan {
 public:
  CircleScan(const CurveSampler& sample, Eigen::Index curves, const CircleSearchOptions& options)
      : sample_(sample),
        options_(options),
        seams_(options.seams),
        doubt_(to_size(curves), 0.0),
        top_(to_size(curves), 0.0),
        rise_(to_size(curves), 0.0),
        found_{std::vector<SearchedCurve>(to_size(curves)), options.from, options.to, 0} {
    seams_.push_back(options.to);
    std::ranges::sort(seams_);
  }

  AxisSearch search() {
    constexpr double at_the_end = 1e-9;
    double from = options_.from, radius = first_guess(options_.near_poles, from);
    while (from < options_.to * (1 - at_the_end)) step(from, radius);
    refuse_doubts();
    note_ends();
    return std::move(found_);
  }

 private:
  /// Rejects curves with round-off close to their peaks: it must stay far below the smallest peak that counts, a
  /// millionth of the curve.
  void refuse_doubts() const {
    constexpr double negligible = 1e-7;
    for (std::size_t c = 0; c < top_.size(); ++c)
      if (doubt_[c] > negligible * top_[c])
        throw foundation::NotComputable(fmt::format(
            "peaks: {} is so small compared with the others that round-off hides its peaks: do not request it",
            options_.name ? options_.name(to_index(c)) : fmt::format("curve {}", c + 1)));
  }

  void step(double& from, double& radius) {
    constexpr double growth = 1.6, on_a_seam = 1e-10;  // below `at_the_end`, so that a seam is always ahead
    foundation::report_progress(options_.progress, "peaks", from / options_.to);
    if (++trials_ > most_trials + more_per_seam * seams_.size())
      throw foundation::NotComputable(
          fmt::format("peaks: after {} panels the search has only reached {}: request a lower band, or use tables with "
                      "fewer rows",
                      trials_, foundation::hertz_words(from, 6)));
    // The whole circle must be where the laws are defined: Re ω > 0.
    const double seam = *std::ranges::upper_bound(seams_, from * (1 + on_a_seam));
    radius = std::min({radius, 0.5 * (std::min(seam, options_.to) - from), from / (spread - 1) * 0.9});
    const Panel panel{from + radius, radius, false};
    Sizes sizes;
    const Eigen::MatrixXcd series = circle_series(sample_, panel, sizes);
    if (series.size() > 0) {
      gaps_ = 0;
      note_panel(series, panel, sizes);
      from += 2 * radius;
      radius *= growth;
    } else if (radius *= 0.5; !(radius > gap_at_pole * from)) {
      leave_gap(from);
      radius = 4 * gap_at_pole * from;
    }
  }

  void note_panel(const Eigen::MatrixXcd& series, const Panel& panel, const Sizes& sizes) {
    const auto& [level, possible, noise, doubt] = sizes;
    ++found_.panels;
    for (std::size_t c = 0; c < rise_.size(); ++c) {
      const auto row = to_index(c);
      if (!(level(row) > std::max(vanishing_share * possible(row), noise(row)))) {  // only round-off
        rise_[c] = 0;
        continue;
      }
      doubt_[c] = std::max(doubt_[c], doubt(row));
      top_[c] = std::max(top_[c], level(row));
      SearchedCurve& curve = found_.curves[c];
      curve.largest_share = std::max(curve.largest_share, level(row) / possible(row));
      const CurveSeries square = squared_modulus(series.row(row));
      note_corner(rise_[c], rise_of_square(square, panel, -1), square, panel, curve.extrema);
      rise_[c] = rise_of_square(square, panel, 1);
      add_extrema(square, panel, 0, std::numeric_limits<double>::infinity(), curve.extrema);
    }
  }

  void leave_gap(double& from) {
    std::ranges::fill(rise_, 0);
    if (++gaps_ > most_gaps_in_a_row)
      throw foundation::NotComputable(
          fmt::format("peaks: the laws of the elements give no smooth curve at {}", foundation::hertz_words(from, 6)));
    poles_.push_back(from * (1 + gap_at_pole));
    from *= 1 + 4 * gap_at_pole;
  }

  Eigen::VectorXd amplitudes(double omega) const { return sample_(omega, omega).values.cwiseAbs(); }

  void note_ends() {
    const Eigen::VectorXd start = amplitudes(options_.from), end = amplitudes(options_.to);
    for (std::size_t c = 0; c < rise_.size(); ++c) {
      found_.curves[c].at_start = start(to_index(c));
      found_.curves[c].at_end = end(to_index(c));
    }
    for (const double pole : poles_) {
      std::array<Eigen::VectorXd, 4> y;
      std::ranges::transform(around_pole(pole), y.begin(), [&](double omega) { return amplitudes(omega); });
      for (std::size_t c = 0; c < rise_.size(); ++c) {
        const auto row = to_index(c);
        if (is_unbounded({y[0](row), y[1](row), y[2](row), y[3](row)}))
          found_.curves[c].extrema.push_back(unbounded_at(pole));
      }
    }
    for (SearchedCurve& curve : found_.curves) curve.extrema = alternating(std::move(curve.extrema));
  }

  const CurveSampler& sample_;
  const CircleSearchOptions& options_;
  std::vector<double> seams_;
  std::vector<double> doubt_, top_;  ///< of each curve: round-off accepted in its series, and largest amplitude
  std::vector<double> rise_;         ///< d|y|²/dω at the end of the previous panel
  std::vector<double> poles_;        ///< undamped ones
  AxisSearch found_;
  int gaps_ = 0;
  std::size_t trials_ = 0;
};

}  // namespace

AxisSearch search_by_circles(const CurveSampler& sample, Eigen::Index curves, const CircleSearchOptions& options) {
  if (!(options.from > 0 && options.to > options.from && std::isfinite(options.to)))
    throw foundation::InvalidInput("peaks by circles: the band must satisfy 0 < from < to < ∞");
  return CircleScan(sample, curves, options).search();
}

}  // namespace trivet::numerics
