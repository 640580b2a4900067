// SPDX-License-Identifier: BSD-3-Clause
// Reads numbers of designs into lanes.
#if defined(TRIVET_NUMERICS_DESIGN_COLUMNS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIVET_NUMERICS_DESIGN_COLUMNS_INL_H_
#undef TRIVET_NUMERICS_DESIGN_COLUMNS_INL_H_
#else
#define TRIVET_NUMERICS_DESIGN_COLUMNS_INL_H_
#endif

#include <Eigen/Core>
#include <algorithm>

#include "trivet/numerics/lanes/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

/// One column of designs first … first + lanes − 1; past the end, the last design is repeated. A single row holds for
/// all designs.
HWY_INLINE Pack column_of(const Eigen::ArrayXXd& numbers, Eigen::Index column, Eigen::Index first) {
  constexpr int most_lanes = 8;
  const double* at = numbers.data() + column * numbers.rows();
  if (numbers.rows() == 1) return all(at[0]);
  if (first + lane_count() <= numbers.rows()) return hn::LoadU(Lanes(), at + first);
  HWY_ALIGN double buffer[most_lanes];
  for (int lane = 0; lane < lane_count(); ++lane)
    buffer[lane] = at[std::min<Eigen::Index>(first + lane, numbers.rows() - 1)];
  return hn::Load(Lanes(), buffer);
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
