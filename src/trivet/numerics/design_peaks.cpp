// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/design_peaks.h"

#include <algorithm>
#include <cmath>

#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/pieces.h"
#include "trivet/numerics/disc_search.h"
#include "trivet/numerics/generalized_modes.h"
#include "trivet/numerics/peak_count.h"

namespace trivet::numerics {
namespace {

constexpr std::size_t piece = 512;

Eigen::MatrixXd full(const Eigen::ArrayXXd& packed, Eigen::Index design, Eigen::Index n) {
  Eigen::MatrixXd matrix(n, n);
  for (Eigen::Index i = 0, k = 0; i < n; ++i)
    for (Eigen::Index j = 0; j <= i; ++j, ++k) matrix(i, j) = matrix(j, i) = packed(design, k);
  return matrix;
}

void check(const Designs& designs, const DesignPeakOptions& options) {
  const Eigen::Index n = designs.coordinates(), entries = n * (n + 1) / 2;
  const auto refuse = [](const char* rule) { throw foundation::InvalidInput(std::string("peaks of designs: ") + rule); };
  if (n < 1) refuse("at least one coordinate is needed");
  for (const Eigen::ArrayXXd* m : {&designs.A, &designs.B, &designs.K})
    if (m->rows() != designs.count() || m->cols() != entries) refuse("A, B and K need a row of n(n + 1)/2 entries for every design");
  if (designs.load.rows() != 1 && designs.load.rows() != designs.count()) refuse("the load needs one row, or one for every design");
  if (!(options.from >= 0) || !(options.to > options.from) || std::isinf(options.from)) refuse("a band needs 0 ≤ from < to");
  if (!(options.min_prominence >= 0)) refuse("a prominence is a share ≥ 0");
  if (options.rows.size() > 0 && options.rows.cols() != n) refuse("a row needs one number for every coordinate");
  if (options.rows_on_velocity.size() > 0 && (options.rows_on_velocity.rows() != options.rows.rows() || options.rows_on_velocity.cols() != n))
    refuse("rows on velocity need the shape of the rows on displacement");
  if (!options.derivative.empty() && static_cast<Eigen::Index>(options.derivative.size()) != (options.rows.size() > 0 ? options.rows.rows() : n))
    refuse("derivatives need one number for every channel");
  for (const int d : options.derivative)
    if (d < 0 || d > 2) refuse("a derivative is 0, 1 or 2");
}

std::vector<ObservedRow> observed_rows(Eigen::Index n, const DesignPeakOptions& options) {
  const Eigen::MatrixXd rows = options.rows.size() > 0 ? Eigen::MatrixXd(options.rows.matrix()) : Eigen::MatrixXd(Eigen::MatrixXd::Identity(n, n));
  std::vector<ObservedRow> result;
  for (Eigen::Index c = 0; c < rows.rows(); ++c) {
    const auto at = static_cast<std::size_t>(c);
    result.push_back({rows.row(c), options.rows_on_velocity.size() > 0 ? Eigen::VectorXd(options.rows_on_velocity.row(c).matrix()) : Eigen::VectorXd(),
                      options.derivative.empty() ? 0 : options.derivative[at]});
  }
  return result;
}

void note(const BandCurve& curve, const DesignPeakOptions& options, Eigen::Index design, Eigen::Index channel, DesignPeaks& peaks) {
  double highest = curve.at_start, at = options.from, top = std::isfinite(curve.at_start) ? curve.at_start : 0;
  const auto see = [&](double amplitude, double omega) {
    if (std::isfinite(amplitude)) top = std::max(top, amplitude);
    if (!(amplitude > highest)) return;
    highest = amplitude;
    at = omega;
  };
  std::vector<double> heights = {curve.at_start};
  for (const Extremum& e : curve.extrema) {
    heights.push_back(e.amplitude);
    if (e.maximum) see(e.amplitude, e.angular_frequency);
  }
  see(curve.at_end, options.to);
  heights.push_back(curve.at_end);
  peaks.highest(design, channel) = highest;
  peaks.highest_at(design, channel) = at;
  if (!options.count_peaks) return;
  const PeakCount count = prominent_peaks(heights, options.min_prominence * top);
  peaks.peaks(design, channel) = count.peaks;
  peaks.largest_rise(design, channel) = count.largest_rise;
}

}  // namespace

DesignPeaks design_peaks(const Designs& designs, const DesignPeakOptions& options) {
  check(designs, options);
  const Eigen::Index n = designs.coordinates(), count = designs.count();
  const std::vector<ObservedRow> rows = observed_rows(n, options);
  const auto channels = static_cast<Eigen::Index>(rows.size());
  DesignPeaks result{Eigen::ArrayXXd::Zero(count, channels), Eigen::ArrayXXd::Zero(count, channels), {}, {},
                     std::vector<DesignStatus>(static_cast<std::size_t>(count), DesignStatus::impossible)};
  if (options.count_peaks) {
    result.peaks.setZero(count, channels);
    result.largest_rise.setZero(count, channels);
  }
  foundation::for_each_piece(static_cast<std::size_t>(count), {piece, options.threads, options.progress, "peaks of designs"}, [&](std::size_t first, std::size_t last) {
    for (std::size_t at = first; at < last; ++at) {
      const auto d = static_cast<Eigen::Index>(at);
      const DynamicMatrices m{full(designs.A, d, n), full(designs.B, d, n), full(designs.K, d, n), {}, true};
      if (!is_positive_definite(m.A)) continue;
      const std::vector<BandCurve> curves = search_by_discs(m, designs.load.row(designs.load.rows() == 1 ? 0 : d).matrix().transpose(), rows, options.from, options.to);
      for (Eigen::Index c = 0; c < channels; ++c) note(curves[static_cast<std::size_t>(c)], options, d, c, result);
      result.status[at] = DesignStatus::redone;
    }
  });
  return result;
}

}  // namespace trivet::numerics
