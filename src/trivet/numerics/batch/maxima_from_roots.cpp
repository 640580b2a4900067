// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trivet/numerics/batch/maxima_from_roots.cpp"
#include <hwy/foreach_target.h>

#include <vector>

#include "trivet/numerics/batch/curve_residues-inl.h"
#include "trivet/numerics/batch/maxima_from_roots.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

template <typename Size>
void maxima_of(Size n, const RootTable& table, const std::vector<double>& omega, int lane, TableMaxima& maxima) {
  PolePairs roots;
  SquarePoles<Size> poles;
  PoleProducts products;
  SquaredResponse f[Size::most];
  Pack best[Size::most], where[Size::most];
  PackOfResidues residues;
  LaneMask known = hn::Eq(all(0.0), all(0.0));
  roots_in_table(n, table, lane, roots, poles);
  residues_in_table(n, table, lane, roots, residues);
  form_products(roots, products);
  for (int j = 0; j < n; ++j) {
    PairPack r[most_pairs];
    Pack weight[most_pairs];
    for (int k = 0; k < n; ++k) r[k] = residues.r[k][j], weight[k] = hn::Mul(residues.unit[j], residues.unit[j]);
    known = hn::And(known, drop_round_off(n, residues, weight, r));
    form_squared_response(roots, products, r, 0, true, f[j]);
    best[j] = all(-1.0);
    where[j] = all(omega.front());
  }
  for (const double at : omega) {
    const Pack w = all(at), x = hn::Mul(w, w);
    PairPack inverse_distances[Size::most];
    each(n, [&](int k) TRIVET_LANES { inverse_distances[k] = inverse_distance(poles, k, x); });
    each(n, [&](int j) TRIVET_LANES {
      Pack one = hn::Zero(Lanes()), other = one;
      each(n, [&](int k) TRIVET_LANES {
        one = hn::MulAdd(f[j].C[k].first, inverse_distances[k].first, one);
        other = hn::MulAdd(f[j].C[k].second, inverse_distances[k].second, other);
      });
      const Pack value = hn::Add(one, other);
      where[j] = hn::IfThenElse(hn::Gt(value, best[j]), w, where[j]);
      best[j] = hn::Max(best[j], value);
    });
  }
  for (int j = 0; j < n; ++j) {
    hn::StoreU(hn::Sqrt(hn::Max(hn::Zero(Lanes()), hn::Add(best[j], best[j]))), Lanes(), maxima.amplitude[j] + lane);
    hn::StoreU(where[j], Lanes(), maxima.angular_frequency[j] + lane);
    known = hn::And(known,
                    has_digits(sum_of_moduli(poles, f[j], hn::Mul(where[j], where[j])),
                               from_table(table.round_off, lane), best[j]));
  }
  store_mask(known, maxima.known + lane);
}

void maxima_in_lanes(const RootTable& table, const std::vector<double>& omega, TableMaxima& maxima) {
  for (int lane = 0; lane < table_lanes; lane += lane_count())
    table.coordinates == 6 ? maxima_of(six_coordinates(), table, omega, lane, maxima)
                           : maxima_of(AtMostTwelve{table.coordinates}, table, omega, lane, maxima);
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "trivet/numerics/lanes/dispatch.h"

namespace trivet::numerics {

TRIVET_VARIANTS(maxima_in_lanes);

void maxima_from_roots(const RootTable& table, const std::vector<double>& omega, TableMaxima& maxima) {
  TRIVET_DISPATCH(maxima_in_lanes)(table, omega, maxima);
}

}  // namespace trivet::numerics
#endif
