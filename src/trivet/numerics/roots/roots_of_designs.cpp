// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trivet/numerics/roots/roots_of_designs.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "trivet/numerics/roots/design_columns-inl.h"
#include "trivet/numerics/roots/poles-inl.h"
#include "trivet/numerics/roots/root_table.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

template <typename Size>
void roots_of(Size n, const Designs& designs, Eigen::Index first, int lane, RootTable& table) {
  constexpr double most_condition = 1e3, round_off = 2e-15;
  Pack a[Size::most * (Size::most + 1) / 2], b[Size::most * (Size::most + 1) / 2], k[Size::most * (Size::most + 1) / 2],
      h[Size::most];
  for (int entry = 0; entry < n * (n + 1) / 2; ++entry) {
    a[entry] = column_of(designs.A, entry, first);
    b[entry] = column_of(designs.B, entry, first);
    k[entry] = column_of(designs.K, entry, first);
  }
  for (int j = 0; j < n; ++j) h[j] = column_of(designs.load, j, first);
  PackOfModes<Size> modes;
  PackOfPoles<Size> poles;
  const LaneMask definite = modes_of_pack<true>(n, a, k, modes);
  poles_of_pack(n, modes, b, h, poles);
  Pack stiffest = all(0.0);
  for (int p = 0; p < n; ++p) stiffest = hn::Max(stiffest, modes.lambda[p]);
  const Pack held =
      hn::Mul(all(64 * n * 2.2e-16),
              stiffest);  // smaller λ may be round-off of no stiffness: 64 n ε, eight times the limit of definiteness
  LaneMask good = hn::And(hn::And(modes.settled, poles.good), hn::Le(poles.condition, all(most_condition)));
  for (int j = 0; j < n; ++j) hn::StoreU(a[packed(j, j)], Lanes(), table.mass[j] + lane);
  hn::StoreU(all(round_off), Lanes(), table.round_off + lane);
  for (int p = 0; p < n; ++p) {
    const LaneMask real = poles.real[p];
    const Pack slow = poles.lambda[p].re;
    good = hn::And(good, hn::And(hn::Gt(modes.lambda[p], held), hn::Lt(slow, all(0.0))));
    hn::StoreU(slow, Lanes(), table.first[p] + lane);
    hn::StoreU(hn::IfThenElse(real, poles.lambda[n + p].re, poles.lambda[p].im), Lanes(), table.second[p] + lane);
    hn::StoreU(hn::IfThenElseZero(real, all(1.0)), Lanes(), table.real[p] + lane);
    for (int j = 0; j < n; ++j) {
      const ComplexPack r = poles.residue[p * n + j], other = poles.residue[(n + p) * n + j];
      hn::StoreU(r.re, Lanes(), table.r_first[p][j] + lane);
      hn::StoreU(hn::IfThenElse(real, other.re, r.im), Lanes(), table.r_second[p][j] + lane);
    }
  }
  double verdict[2][table_lanes];
  hn::StoreU(hn::IfThenElseZero(definite, all(1.0)), Lanes(), verdict[0]);
  hn::StoreU(hn::IfThenElseZero(good, all(1.0)), Lanes(), verdict[1]);
  for (int i = 0; i < lane_count(); ++i) {
    table.definite[lane + i] = verdict[0][i] != 0;
    table.good[lane + i] = verdict[1][i] != 0;
  }
}

void roots_in_lanes(const Designs& designs, Eigen::Index first, RootTable& table) {
  const auto n = static_cast<int>(designs.coordinates());
  for (int lane = 0; lane < table_lanes; lane += lane_count())
    n == 6 ? roots_of(six_coordinates(), designs, first + lane, lane, table)
           : roots_of(AtMostTwelve{n}, designs, first + lane, lane, table);
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "trivet/numerics/lanes/dispatch.h"

namespace trivet::numerics {

TRIVET_VARIANTS(roots_in_lanes);

void roots_of_designs(const Designs& designs, Eigen::Index first, RootTable& table) {
  table.coordinates = static_cast<int>(designs.coordinates());
  TRIVET_DISPATCH(roots_in_lanes)(designs, first, table);
}

}  // namespace trivet::numerics
#endif
