// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/batch/design_peaks.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/numerics/batch/peak_request.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/generalized_modes.h"
#include "trivet/numerics/linalg/quadratic_roots.h"
#include "trivet/numerics/peaks/disc_search.h"
#include "trivet/numerics/peaks/peak_count.h"

namespace trivet::numerics {
namespace {

constexpr std::size_t designs_per_piece = 512;

void check(const Designs& designs, const DesignPeakOptions& options) {
  require_shapes(designs, "peaks of designs");
  const Eigen::Index n = designs.coordinates();
  const auto refuse = [](const char* rule) {
    throw foundation::InvalidInput(std::string("peaks of designs: ") + rule);
  };
  if (!(options.from >= 0) || !(options.to > options.from) || std::isinf(options.from))
    refuse("the band must satisfy 0 ≤ from < to");
  if (!(options.min_prominence >= 0)) refuse("the prominence must be a share ≥ 0");
  if (options.rows.size() > 0 && options.rows.cols() != n) refuse("a row must have one number for every coordinate");
  if (options.rows_on_velocity.size() > 0 &&
      (options.rows_on_velocity.rows() != options.rows.rows() || options.rows_on_velocity.cols() != n))
    refuse("rows on velocity must have the same shape as rows on displacement");
  if (!options.derivative.empty() &&
      to_index(options.derivative.size()) != (options.rows.size() > 0 ? options.rows.rows() : n))
    refuse("derivatives must have one number for every channel");
  for (const int d : options.derivative)
    if (d < 0 || d > 2) refuse("a derivative must be 0, 1 or 2");
}

std::vector<ObservedRow> observed_rows(Eigen::Index n, const DesignPeakOptions& options) {
  const Eigen::MatrixXd rows = options.rows.size() > 0 ? Eigen::MatrixXd(options.rows.matrix())
                                                       : Eigen::MatrixXd(Eigen::MatrixXd::Identity(n, n));
  std::vector<ObservedRow> result;
  for (Eigen::Index c = 0; c < rows.rows(); ++c) {
    const auto at = to_size(c);
    // A row of zeros counts as empty, because rows on velocity decide whether a curve falls towards ω = ∞.
    const bool on_velocity = options.rows_on_velocity.size() > 0 && (options.rows_on_velocity.row(c) != 0).any();
    result.push_back({rows.row(c),
                      on_velocity ? Eigen::VectorXd(options.rows_on_velocity.row(c).matrix()) : Eigen::VectorXd(),
                      options.derivative.empty() ? 0 : options.derivative[at]});
  }
  return result;
}

ChannelPeaks peaks_of_curve(const SearchedCurve& curve, const AxisSearch& search, const PeakRequest& request) {
  if (curve.largest_share <= vanishing_share) return {0, request.band.from, 0, 0};
  const bool beside_free_motion = search.from > request.band.from;
  const CurveHeights heights = heights_of(curve, search.from, search.to, !beside_free_motion);
  ChannelPeaks of_channel{heights.highest, heights.highest_at, 0, 0};
  if (!request.band.count_peaks) return of_channel;
  const PeakCount count = prominent_peaks(heights.along, request.band.min_prominence * heights.finite_top);
  of_channel.peaks = count.peaks;
  of_channel.largest_rise = count.largest_rise;
  return of_channel;
}

/// Solves the designs of one piece.
class Piece {
 public:
  Piece(const Designs& designs, const PeakRequest& request, DesignPeaks& result)
      : designs_(designs), request_(request), result_(result) {}

  void work_through(Eigen::Index first, Eigen::Index last) {
    std::vector<Eigen::Index> open =
        designs_.coordinates() <= most_pairs ? by_lanes(first, last) : all_definite(first, last);
    std::erase_if(open, [&](Eigen::Index d) { return !is_finite(d); });
    if (designs_.coordinates() <= most_pairs) open = by_states(open);
    for (const Eigen::Index d : open) by_discs(d);
  }

 private:
  Eigen::VectorXd load(Eigen::Index d) const {
    return designs_.load.row(designs_.load.rows() == 1 ? 0 : d).matrix().transpose();
  }
  bool is_finite(Eigen::Index d) const {
    return designs_.A.row(d).allFinite() && designs_.B.row(d).allFinite() && designs_.K.row(d).allFinite() &&
        load(d).allFinite();
  }
  DesignStatus& status(Eigen::Index d) { return result_.status[d]; }

  void store(Eigen::Index d, std::size_t channel, const ChannelPeaks& of_channel) {
    assert(channel < request_.rows.size() && d < designs_.count());
    const auto c = to_index(channel);
    result_.highest(d, c) = of_channel.highest;
    result_.highest_at(d, c) = of_channel.highest_at;
    if (!request_.band.count_peaks) return;
    result_.peaks(d, c) = of_channel.peaks;
    result_.largest_rise(d, c) = of_channel.largest_rise;
  }

  /// Takes the results of one lane of a table if their proof is complete.
  bool accept(Eigen::Index d, int lane, DesignStatus as) {
    if (!table_peaks_.complete[lane]) return false;
    assert(table_peaks_.channels.size() == request_.rows.size() * table_lanes && lane < table_lanes);
    for (std::size_t c = 0; c < request_.rows.size(); ++c)
      if (table_peaks_.channels[c * table_lanes + to_size(lane)].has_few_digits) return false;
    for (std::size_t c = 0; c < request_.rows.size(); ++c)
      store(d, c, table_peaks_.channels[c * table_lanes + to_size(lane)]);
    status(d) = as;
    return true;
  }

  std::vector<Eigen::Index> by_lanes(Eigen::Index first, Eigen::Index last) {
    std::vector<Eigen::Index> open;
    for (; first < last; first += table_lanes) {
      roots_of_designs(designs_, first, table_);
      peaks_from_roots(table_, request_, table_peaks_);
      for (int lane = 0; lane < table_lanes && first + lane < last; ++lane)
        if (table_.definite[lane] && !(table_.good[lane] && accept(first + lane, lane, DesignStatus::proven)))
          open.push_back(first + lane);
    }
    return open;
  }

  std::vector<Eigen::Index> by_states(const std::vector<Eigen::Index>& designs) {
    std::vector<Eigen::Index> open;
    for (std::size_t first = 0; first < designs.size(); first += table_lanes) {
      const std::size_t count = std::min<std::size_t>(table_lanes, designs.size() - first);
      for (std::size_t i = 0; i < table_lanes; ++i)
        table_.good[i] = i < count &&
            roots_of_states(matrices_of(designs_, designs[first + i]), load(designs[first + i]), table_,
                            static_cast<int>(i));
      peaks_from_roots(table_, request_, table_peaks_);
      for (std::size_t i = 0; i < count; ++i)
        if (!(table_.good[i] && accept(designs[first + i], static_cast<int>(i), DesignStatus::fallback)))
          open.push_back(designs[first + i]);
    }
    return open;
  }

  std::vector<Eigen::Index> all_definite(Eigen::Index first, Eigen::Index last) const {
    std::vector<Eigen::Index> open;
    for (; first < last; ++first)
      if (is_positive_definite(unpacked(designs_.A, first))) open.push_back(first);
    return open;
  }

  void by_discs(Eigen::Index d) {
    std::vector<ObservedCurve> rows;
    std::ranges::transform(request_.rows, std::back_inserter(rows), observed_curve);
    const DynamicMatrices m = matrices_of(designs_, d);
    const Load h(load(d).cast<Complex>()), nothing(Eigen::Index{0});
    AxisSearch search;
    try {
      search = search_by_discs({m, h, nothing}, rows, poles(system_roots(m)),
                               {.from = request_.band.from, .to = request_.band.to});
    } catch (const foundation::NotComputable&) {  // one failed design must not stop the others
      status(d) = DesignStatus::undecided;
      return;
    }
    status(d) = DesignStatus::fallback;
    for (std::size_t c = 0; c < search.curves.size(); ++c) {
      store(d, c, peaks_of_curve(search.curves[c], search, request_));
      if (!search.curves[c].complete) status(d) = DesignStatus::undecided;
    }
  }

  const Designs& designs_;
  const PeakRequest& request_;
  DesignPeaks& result_;
  RootTable table_{};
  TablePeaks table_peaks_;
};

}  // namespace

DesignPeaks design_peaks(const Designs& designs, const DesignPeakOptions& options) {
  check(designs, options);
  const Eigen::Index n = designs.coordinates(), count = designs.count();
  const PeakRequest request{observed_rows(n, options),
                            {options.from, options.to, options.count_peaks, options.min_prominence}};
  const auto channels = to_index(request.rows.size());
  DesignPeaks result{Eigen::ArrayXXd::Zero(count, channels),
                     Eigen::ArrayXXd::Zero(count, channels),
                     {},
                     {},
                     std::vector<DesignStatus>(to_size(count), DesignStatus::impossible)};
  if (options.count_peaks) {
    result.peaks.setZero(count, channels);
    result.largest_rise.setZero(count, channels);
  }
  foundation::parallel_for(
      to_size(count),
      {.size = designs_per_piece, .threads = options.threads, .progress = options.progress, .task = "peaks of designs"},
      [&](std::size_t first, std::size_t last) {
        Piece(designs, request, result).work_through(to_index(first), to_index(last));
      });
  return result;
}

}  // namespace trivet::numerics
