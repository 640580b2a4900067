// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trivet/numerics/periodic/harmonic_receptance.cpp"
#include <hwy/foreach_target.h>

#include <cstddef>

#include "trivet/numerics/lanes/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {
namespace {

/// sums += own · course + other · exchanged for each of `count` receptances, whose columns follow one another.
void add_responses_in_lanes(const double* own, const double* other, std::ptrdiff_t count, std::ptrdiff_t coefficients,
                            const double* course, const double* exchanged, double* sums) {
  const std::ptrdiff_t whole = coefficients / lane_count() * lane_count();
  for (std::ptrdiff_t c = 0; c < whole; c += lane_count()) {
    const Pack x = hn::LoadU(Lanes(), course + c), y = hn::LoadU(Lanes(), exchanged + c);
    for (std::ptrdiff_t i = 0; i < count; ++i) {
      const std::ptrdiff_t at = i * coefficients + c;
      const Pack sum = hn::MulAdd(hn::LoadU(Lanes(), own + at), x, hn::LoadU(Lanes(), sums + at));
      hn::StoreU(hn::MulAdd(hn::LoadU(Lanes(), other + at), y, sum), Lanes(), sums + at);
    }
  }
  for (std::ptrdiff_t c = whole; c < coefficients; ++c)
    for (std::ptrdiff_t i = 0; i < count; ++i) {
      const std::ptrdiff_t at = i * coefficients + c;
      sums[at] += own[at] * course[c] + other[at] * exchanged[c];
    }
}

}  // namespace
}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <cassert>

#include "trivet/numerics/lanes/dispatch.h"
#include "trivet/numerics/periodic/fourier_products.h"

namespace trivet::numerics {
namespace {

TRIVET_VARIANTS(add_responses_in_lanes);

}  // namespace

void add_responses(const HarmonicReceptance& receptances, Eigen::Index first, Eigen::Index count,
                   const Eigen::Ref<const Eigen::MatrixXd>& courses, Eigen::Ref<Eigen::MatrixXd> sums) {
  const Eigen::Index coefficients = courses.rows();
  assert(receptances.on_own.rows() == coefficients && sums.rows() == count * coefficients &&
         sums.cols() == courses.cols());
  const auto add = TRIVET_DISPATCH(add_responses_in_lanes);
  const double* const own = &receptances.on_own.coeffRef(0, first);
  const double* const other = &receptances.on_other.coeffRef(0, first);
  Eigen::VectorXd exchanged = Eigen::VectorXd::Zero(coefficients);  // sines and cosines
  for (Eigen::Index j = 0; j < courses.cols(); ++j) {
    const double* const course = &courses.coeffRef(0, j);
    for (Eigen::Index k = 1; k + 1 < coefficients; k += 2) {
      exchanged(k) = course[k + 1];
      exchanged(k + 1) = course[k];
    }
    add(own, other, count, coefficients, course, exchanged.data(), &sums.coeffRef(0, j));
  }
}

}  // namespace trivet::numerics
#endif
