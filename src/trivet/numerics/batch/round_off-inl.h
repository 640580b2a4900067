// SPDX-License-Identifier: BSD-3-Clause
// Distinguishes residues from round-off, one design per lane.
#if defined(TRIVET_NUMERICS_ROUND_OFF_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIVET_NUMERICS_ROUND_OFF_INL_H_
#undef TRIVET_NUMERICS_ROUND_OFF_INL_H_
#else
#define TRIVET_NUMERICS_ROUND_OFF_INL_H_
#endif

#include "trivet/numerics/batch/squared_response-inl.h"
#include "trivet/numerics/peaks/extremum.h"
#include "trivet/numerics/roots/root_table.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

HWY_INLINE Pack squared_size(const PairPack& r) { return hn::MulAdd(r.first, r.first, hn::Mul(r.second, r.second)); }

/// Sets the residues of a curve to zero if it takes part in the motion of its coordinates by round-off only.
/// @param allowed  lanes in which that may be done
/// @param visible  squares, by pole: residues of a curve far below mean resonances far below the motion of other
/// coordinates, at that pole, or at rest from any pole
/// @param possible  squares, by pole: residues far below lose digits under this load
/// @param weight  of every pole: the square of the largest residue that the row could have if all coordinates, each
/// weighted by its mass, moved alike
/// @return lanes in which the residues are accurate, or were set to zero
template <typename Size>
HWY_INLINE LaneMask drop_round_off(Size n, const LaneMask& allowed, const Pack* visible, const Pack* possible,
                                   const Pack* weight, PairPack* r) {
  constexpr double least_known = 1e-6;  // residues have errors of some 1e-15 of `possible`
  LaneMask none = allowed, little = hn::Eq(all(0.0), all(0.0));
  each(n, [&](int k) TRIVET_LANES {
    const Pack size = squared_size(r[k]);
    none = hn::And(none, hn::Le(size, hn::Mul(hn::Mul(all(vanishing_share * vanishing_share), weight[k]), visible[k])));
    little = hn::And(little, hn::Le(size, hn::Mul(hn::Mul(all(least_known * least_known), weight[k]), possible[k])));
  });
  each(n, [&](int k) TRIVET_LANES {
    r[k] = {hn::IfThenZeroElse(none, r[k].first), hn::IfThenZeroElse(none, r[k].second)};
  });
  return hn::Or(none, hn::Not(little));
}

/// Errors of a square whose root, an amplitude, has so many digits.
constexpr double nine_digits = 2e-10, seven_digits = 2e-8;

/// Lanes in which a value of terms with these moduli keeps its digits.
/// @param of_sums  round-off of a sum relative to its terms
HWY_INLINE LaneMask has_digits(const Pack& moduli, const Pack& of_sums, const Pack& value, double digits) {
  return hn::Le(hn::Mul(of_sums, moduli), hn::Mul(all(digits), value));
}

HWY_INLINE void store_mask(const LaneMask& mask, bool* to) {
  double numbers[table_lanes];
  hn::StoreU(hn::IfThenElseZero(mask, all(1.0)), Lanes(), numbers);
  for (int lane = 0; lane < lane_count(); ++lane) to[lane] = numbers[lane] != 0;
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
