// SPDX-License-Identifier: BSD-3-Clause
// One row of results per lane, several times at once: their sums stay in registers while all states are added.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trivet/numerics/recurrence/rows_over_time.cpp"
#include <hwy/foreach_target.h>

#include <cstddef>

#include "trivet/foundation/constants.h"
#include "trivet/numerics/lanes/lanes-inl.h"
#include "trivet/numerics/recurrence/pair_steps.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {
namespace {

using Index = std::ptrdiff_t;

/// One pack of rows: largest, smallest, bend, squares, last value, the value before it.
struct RowSummary {
  Pack largest, smallest, bend, squares, last, before;

  explicit RowSummary(const double* from)
      : largest(all(-foundation::infinity)),
        smallest(all(foundation::infinity)),
        bend(hn::Zero(Lanes())),
        squares(hn::Zero(Lanes())),
        last(hn::LoadU(Lanes(), from + 4 * lane_group)),
        before(hn::LoadU(Lanes(), from + 5 * lane_group)) {}

  HWY_INLINE void add(const Pack& y) {
    largest = hn::Max(largest, y);
    smallest = hn::Min(smallest, y);
    bend = hn::Max(bend, hn::Abs(hn::Sub(hn::Sub(y, last), hn::Sub(last, before))));
    squares = hn::MulAdd(y, y, squares);
    before = last;
    last = y;
  }
  void store(double* to) const {
    const Pack* packs[] = {&largest, &smallest, &bend, &squares, &last, &before};
    for (const Pack* each : packs) hn::StoreU(*each, Lanes(), to), to += lane_group;
  }
};

template <int times>
HWY_INLINE void evaluate_tile(const double* HWY_RESTRICT coefficients, const Index* HWY_RESTRICT used, Index count,
                              const double* HWY_RESTRICT states, Index stride, double* HWY_RESTRICT values,
                              RowSummary& summary) {
  Pack sum[times];
  TRIVET_UNROLL for (Pack& each : sum) each = hn::Zero(Lanes());
  for (Index n = 0; n < count; ++n, coefficients += lane_group) {
    const Pack c = hn::LoadU(Lanes(), coefficients);
    const double* state = states + used[n];
    TRIVET_UNROLL for (int t = 0; t < times; ++t) sum[t] = hn::MulAdd(c, all(state[t * stride]), sum[t]);
  }
  TRIVET_UNROLL for (int t = 0; t < times; ++t) {
    hn::StoreU(sum[t], Lanes(), values + t * lane_group);
    summary.add(sum[t]);
  }
}

/// All times of one group of rows.
void evaluate_rows(const double* coefficients, const Index* used, Index count, const double* states, Index stride,
                   Index times, double* values, double* summaries) {
  constexpr Index tile = 8;
  for (Index lane = 0; lane < lane_group; lane += lane_count()) {
    RowSummary summary(summaries + lane);
    Index i = 0;
    for (; i + tile <= times; i += tile)
      evaluate_tile<tile>(coefficients + lane, used, count, states + i * stride, stride, values + i * lane_group + lane,
                          summary);
    for (; i < times; ++i)
      evaluate_tile<1>(coefficients + lane, used, count, states + i * stride, stride, values + i * lane_group + lane,
                       summary);
    summary.store(summaries + lane);
  }
}

}  // namespace
}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <algorithm>
#include <cassert>

#include "trivet/foundation/index.h"
#include "trivet/numerics/lanes/dispatch.h"
#include "trivet/numerics/recurrence/rows_over_time.h"

namespace trivet::numerics {
namespace {

TRIVET_VARIANTS(evaluate_rows);

constexpr Eigen::Index summary_rows = 6;

}  // namespace

RowsOverTime::RowsOverTime(const Eigen::MatrixXd& rows, Eigen::Index most_times)
    : rows_(rows.rows()), groups_((rows.rows() + lane_group - 1) / lane_group), most_times_(most_times) {
  for (Eigen::Index n = 0; n < rows.cols(); ++n)
    if (!rows.col(n).isZero(0)) used_.push_back(n);
  coefficients_.resize(to_size(groups_ * lane_group) * used_.size());
  values_.resize(to_size(groups_ * lane_group * most_times));
  summary_.resize(to_size(groups_ * lane_group * summary_rows));
  double* at = coefficients_.data();
  for (Eigen::Index first = 0; first < rows_; first += lane_group)
    for (const Eigen::Index n : used_)
      for (Eigen::Index row = first; row < first + lane_group; ++row) *at++ = row < rows_ ? rows(row, n) : 0;
}

double* RowsOverTime::values(Eigen::Index group) const { return values_.data() + group * most_times_ * lane_group; }

void RowsOverTime::evaluate(const Eigen::Ref<const Eigen::MatrixXd>& states) {
  assert(states.cols() <= most_times_ && states.cols() > 0);
  times_ = states.cols();
  const auto count = to_index(used_.size());
  for (Eigen::Index group = 0; group < groups_; ++group) {
    const double* coefficients = coefficients_.data() + group * count * lane_group;
    double* summary = summary_.data() + group * summary_rows * lane_group;
    const auto evaluate = [&](Eigen::Index times) {
      TRIVET_DISPATCH(evaluate_rows)(coefficients, used_.data(), count, states.data(), states.outerStride(), times,
                                     values(group), summary);
    };
    if (!begun_) {
      std::fill(summary, summary + summary_rows * lane_group, 0.0);
      evaluate(1);
      std::copy(values(group), values(group) + lane_group, summary + 4 * lane_group);
      std::copy(values(group), values(group) + lane_group, summary + 5 * lane_group);
    }
    evaluate(times_);
  }
  begun_ = true;
}

void RowsOverTime::copy_row(Eigen::Index row, Eigen::Ref<Eigen::VectorXd> to) const {
  const double* from = values(row / lane_group) + row % lane_group;
  for (Eigen::Index i = 0; i < times_; ++i) to[i] = from[i * lane_group];
}

RowBlock RowsOverTime::block(Eigen::Index row) const {
  const double* from = summary_.data() + row / lane_group * summary_rows * lane_group + row % lane_group;
  return {from[0], from[lane_group], from[2 * lane_group], from[3 * lane_group]};
}

}  // namespace trivet::numerics
#endif
