// SPDX-License-Identifier: BSD-3-Clause
// Roots of the designs of a table in lanes.
#if defined(TRIVET_NUMERICS_TABLED_ROOTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIVET_NUMERICS_TABLED_ROOTS_INL_H_
#undef TRIVET_NUMERICS_TABLED_ROOTS_INL_H_
#else
#define TRIVET_NUMERICS_TABLED_ROOTS_INL_H_
#endif

#include "trivet/numerics/batch/square_poles-inl.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

HWY_INLINE Pack from_table(const double* row, int lane) { return hn::LoadU(Lanes(), row + lane); }

/// The roots in s, and the poles in x = ω² that follow from them.
template <typename Size>
HWY_INLINE void roots_in_table(Size n, const RootTable& table, int lane, PolePairs& roots, SquarePoles<Size>& poles) {
  roots.count = poles.count = n;
  for (int k = 0; k < n; ++k) {
    roots.real[k] = poles.real[k] = hn::Ne(from_table(table.real[k], lane), hn::Zero(Lanes()));
    roots.lambda[k] = {from_table(table.first[k], lane), from_table(table.second[k], lane)};
    poles.z[k] = pole_in_square(roots.real[k], roots.lambda[k]);
  }
  place(poles);
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
