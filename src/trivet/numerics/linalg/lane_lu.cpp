// SPDX-License-Identifier: BSD-3-Clause
// Four columns of L at a time are subtracted from four columns of the rest. Every column is followed by as many unused
// numbers as a pack has, so that packs may begin in any row.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trivet/numerics/linalg/lane_lu.cpp"
#include <hwy/foreach_target.h>

#include <cassert>
#include <cmath>
#include <cstdint>
#include <utility>

#include "trivet/numerics/lanes/lanes-inl.h"
#include "trivet/numerics/lanes/line_memory.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {
namespace {

static_assert(hn::MaxLanes(Lanes()) <= longest_pack);

constexpr std::ptrdiff_t panel = 4;

/// to −= factor · from, from one row to the last.
HWY_INLINE void subtract_column(double factor, const double* HWY_RESTRICT from, std::ptrdiff_t first,
                                std::ptrdiff_t rows, double* HWY_RESTRICT to) {
  const Pack f = all(factor);
  for (std::ptrdiff_t i = first; i < rows; i += lane_count())
    hn::StoreU(hn::NegMulAdd(hn::LoadU(Lanes(), from + i), f, hn::LoadU(Lanes(), to + i)), Lanes(), to + i);
}

/// The row from `first` on with the largest number.
HWY_INLINE std::ptrdiff_t largest_row(const double* column, std::ptrdiff_t first, std::ptrdiff_t rows) {
  Pack largest = hn::Zero(Lanes());
  for (std::ptrdiff_t i = first; i < rows; i += lane_count())
    largest = hn::Max(largest, hn::Abs(hn::LoadU(Lanes(), column + i)));
  const double value = hn::GetLane(hn::MaxOfLanes(Lanes(), largest));
  std::ptrdiff_t found = first;
  while (found + 1 < rows && std::abs(column[found]) != value) ++found;
  assert(found < rows && "of all NaN the last one");
  return found;
}

HWY_INLINE void scale_column(double factor, std::ptrdiff_t first, std::ptrdiff_t rows, double* column) {
  const Pack f = all(factor);
  for (std::ptrdiff_t i = first; i < rows; i += lane_count())
    hn::StoreU(hn::Mul(f, hn::LoadU(Lanes(), column + i)), Lanes(), column + i);
}

/// Subtracts from `columns` columns the products of the panel's columns and these columns' numbers in its rows.
template <std::ptrdiff_t columns>
HWY_INLINE void subtract_panel(const double* HWY_RESTRICT left, std::ptrdiff_t stride, std::ptrdiff_t rows,
                               const double* above, double* HWY_RESTRICT to) {
  Pack factor[columns][panel];
  TRIVET_UNROLL for (std::ptrdiff_t j = 0; j < columns; ++j) TRIVET_UNROLL for (std::ptrdiff_t k = 0; k < panel; ++k)
      factor[j][k] = all(above[j * stride + k]);
  for (std::ptrdiff_t i = 0; i < rows; i += lane_count()) {
    Pack l[panel];
    TRIVET_UNROLL for (std::ptrdiff_t k = 0; k < panel; ++k) l[k] = hn::LoadU(Lanes(), left + k * stride + i);
    TRIVET_UNROLL for (std::ptrdiff_t j = 0; j < columns; ++j) {
      Pack sum = hn::LoadU(Lanes(), to + j * stride + i);
      TRIVET_UNROLL for (std::ptrdiff_t k = 0; k < panel; ++k) sum = hn::NegMulAdd(l[k], factor[j][k], sum);
      hn::StoreU(sum, Lanes(), to + j * stride + i);
    }
  }
}

/// Pivots and factors the columns from `begin` to `end`, and exchanges the rows of all.
HWY_INLINE void factor_panel(double* a, std::ptrdiff_t n, std::ptrdiff_t stride, std::ptrdiff_t begin,
                             std::ptrdiff_t end, std::int32_t* pivots) {
  for (std::ptrdiff_t k = begin; k < end; ++k) {
    double* const column = a + k * stride;
    const std::ptrdiff_t largest = largest_row(column, k, n);
    pivots[k] = static_cast<std::int32_t>(largest);
    if (largest != k)
      for (std::ptrdiff_t j = 0; j < n; ++j) std::swap(a[j * stride + k], a[j * stride + largest]);
    scale_column(1 / column[k], k + 1, n, column);
    for (std::ptrdiff_t j = k + 1; j < end; ++j) subtract_column(a[j * stride + k], column, k + 1, n, a + j * stride);
  }
}

void factor_in_lanes(double* a, std::ptrdiff_t n, std::ptrdiff_t stride, std::int32_t* pivots) {
  assert(stride >= n + lane_count() && "packs that begin in the last row end before the next column");
  constexpr std::ptrdiff_t together = 4;
  for (std::ptrdiff_t begin = 0; begin < n; begin += panel) {
    const std::ptrdiff_t end = begin + panel < n ? begin + panel : n;
    factor_panel(a, n, stride, begin, end, pivots);
    const double* const left = a + begin * stride;
    for (std::ptrdiff_t j = end; j < n; ++j) {
      double* const above = a + j * stride;
      for (std::ptrdiff_t k = begin; k < end; ++k)
        for (std::ptrdiff_t i = k + 1; i < end; ++i) above[i] -= left[(k - begin) * stride + i] * above[k];
    }
    std::ptrdiff_t j = end;
    for (; j + together <= n; j += together)
      subtract_panel<together>(left + end, stride, n - end, a + j * stride + begin, a + j * stride + end);
    for (; j < n; ++j) subtract_panel<1>(left + end, stride, n - end, a + j * stride + begin, a + j * stride + end);
  }
}

/// b → A⁻¹ b; b is followed by unused numbers as the columns are.
void solve_in_lanes(const double* a, std::ptrdiff_t n, std::ptrdiff_t stride, const std::int32_t* pivots, double* b) {
  for (std::ptrdiff_t k = 0; k < n; ++k) std::swap(b[k], b[pivots[k]]);
  for (std::ptrdiff_t k = 0; k < n; ++k) subtract_column(b[k], a + k * stride, k + 1, n, b);
  for (std::ptrdiff_t k = n; k-- > 0;) {
    b[k] /= a[k * stride + k];
    const std::ptrdiff_t whole = k / lane_count() * lane_count();
    subtract_column(b[k], a + k * stride, 0, whole, b);
    for (std::ptrdiff_t i = whole; i < k; ++i) b[i] -= a[k * stride + i] * b[k];
  }
}

}  // namespace
}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <algorithm>

#include "trivet/foundation/index.h"
#include "trivet/numerics/lanes/dispatch.h"
#include "trivet/numerics/linalg/lane_lu.h"

namespace trivet::numerics {
namespace {

TRIVET_VARIANTS(factor_in_lanes);
TRIVET_VARIANTS(solve_in_lanes);

}  // namespace

namespace {

/// Room for a pack behind each column. Columns whole multiples of half a kibibyte apart would share few lines of the
/// first cache: 243 rows took three times as long as 240.
Eigen::Index stride_of(Eigen::Index rows) {
  constexpr Eigen::Index alias = 64;
  const Eigen::Index stride = (rows + 2 * longest_pack - 1) / longest_pack * longest_pack;
  return stride % alias == 0 ? stride + longest_pack : stride;
}

}  // namespace

LaneLu::LaneLu(const Eigen::MatrixXd& A) : rows_(A.rows()), stride_(stride_of(A.rows())), pivots_(to_size(rows_)) {
  assert(A.rows() == A.cols());
  assert(stride_ % longest_pack == 0 && stride_ - rows_ >= longest_pack && "room for a pack behind each column");
  factors_.resize(to_size(stride_ * rows_));
  for (Eigen::Index j = 0; j < rows_; ++j) {
    double* const column = factors_.data() + j * stride_;
    std::fill(std::copy_n(A.col(j).data(), rows_, column), column + stride_, 0.0);
  }
  TRIVET_DISPATCH(factor_in_lanes)(factors_.data(), rows_, stride_, pivots_.data());
}

Eigen::VectorXd LaneLu::solve(const Eigen::VectorXd& b) const {
  assert(b.size() == rows_);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(stride_);
  x.head(rows_) = b;
  TRIVET_DISPATCH(solve_in_lanes)(factors_.data(), rows_, stride_, pivots_.data(), x.data());
  x.conservativeResize(rows_);
  return x;
}

int LaneLu::determinant_sign() const {
  int sign = 1;
  for (Eigen::Index k = 0; k < rows_; ++k) {
    const double pivot = factors_.data()[k * stride_ + k];
    if (pivot == 0) return 0;
    if ((pivot < 0) != (pivots_[k] != k)) sign = -sign;
  }
  return sign;
}

}  // namespace trivet::numerics
#endif
