// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trivet/numerics/batch/peaks_from_roots.cpp"
#include <hwy/foreach_target.h>

#include <cassert>
#include <vector>

#include "trivet/numerics/batch/curve_residues-inl.h"
#include "trivet/numerics/batch/curve_search-inl.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

template <typename Size>
void form(Size n, const RootTable& table, const PeakRequest& request, int lane, FormedCurves<Size>& formed) {
  double wanted[table_lanes];
  for (int i = 0; i < lane_count(); ++i) wanted[i] = table.good[lane + i];
  formed.pack.wanted = hn::Gt(hn::LoadU(Lanes(), wanted), hn::Zero(Lanes()));
  PolePairs roots;
  roots_in_table(n, table, lane, roots, formed.pack.poles);
  formed.round_off = from_table(table.round_off, lane);
  PackOfResidues residues;
  residues_in_table(n, table, lane, roots, residues);
  PoleProducts products;
  form_products(roots, products);
  formed.complete = hn::Eq(formed.round_off, formed.round_off);
  for (std::size_t c = 0; c < request.rows.size(); ++c) {
    const ObservedRow& row = request.rows[c];
    PairPack r[most_pairs];
    formed.complete = hn::And(formed.complete, residues_of(n, residues, roots, row, r));
    form_squared_response(roots, products, r, row.derivative, row.on_velocity.size() == 0, formed.curves[c].f);
  }
}

/// |y|² of a row falls like x^−2 or x^−1 towards x = ∞ unless it is differentiated, and starts like x^derivative.
std::vector<CurveEnds> ends_of(const PeakRequest& request) {
  std::vector<CurveEnds> ends;
  for (const ObservedRow& row : request.rows)
    ends.push_back({.zero_at_start = request.band.from == 0 && row.derivative > 0,
                    .flat_at_infinity = row.derivative == 0 && row.on_velocity.size() == 0,
                    .powers_of_x = row.derivative});
  return ends;
}

template <typename Size>
void search_curves(Size n, const RootTable& table, const PeakRequest& request, int lane, TablePeaks& peaks) {
  FormedCurves<Size> formed(ends_of(request));
  form(n, table, request, lane, formed);
  CurveSearch<Size> curves(formed, request.band, lane);
  curves.search();
  curves.write_peaks(peaks);
}

void peaks_in_lanes(const RootTable& table, const PeakRequest& request, TablePeaks& peaks) {
  peaks.channels.resize(request.rows.size() * table_lanes);
  assert(table.coordinates >= 1 && table.coordinates <= most_pairs && request.band.squared);
  for (int lane = 0; lane < table_lanes; lane += lane_count())
    table.coordinates == 6 ? search_curves(six_coordinates(), table, request, lane, peaks)
                           : search_curves(AtMostTwelve{table.coordinates}, table, request, lane, peaks);
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "trivet/numerics/lanes/dispatch.h"

namespace trivet::numerics {

TRIVET_VARIANTS(peaks_in_lanes);

void peaks_from_roots(const RootTable& table, const PeakRequest& request, TablePeaks& peaks) {
  TRIVET_DISPATCH(peaks_in_lanes)(table, request, peaks);
}

}  // namespace trivet::numerics
#endif
