// SPDX-License-Identifier: BSD-3-Clause
// One pair of states per lane: eight oscillators advance in the time of one.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trivet/numerics/recurrence/pair_steps.cpp"
#include <hwy/foreach_target.h>

#include "trivet/numerics/lanes/lanes-inl.h"
#include "trivet/numerics/recurrence/pair_steps.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {
namespace {

/// Columns, `stride` numbers apart.
template <typename Number>
struct Columns {
  Number* first;
  std::ptrdiff_t stride;
};

/// All steps of the pairs in one pack, from the one at `first` on.
void step_pack(const PairSteps& steps, std::ptrdiff_t first, Columns<const double> w, std::ptrdiff_t count,
               Columns<double> states) {
  const std::ptrdiff_t pairs = steps.pairs;
  const Lanes lanes;
  const Pack a = hn::LoadU(lanes, steps.matrix + first), b = hn::LoadU(lanes, steps.matrix + pairs + first),
             c = hn::LoadU(lanes, steps.matrix + 2 * pairs + first),
             d = hn::LoadU(lanes, steps.matrix + 3 * pairs + first);
  double* at = states.first + first;
  Pack x = hn::LoadU(lanes, at), y = hn::LoadU(lanes, at + pairs);
  for (std::ptrdiff_t i = 0; i < count; ++i, w.first += w.stride) {
    Pack input_x = hn::Zero(lanes), input_y = input_x;
    for (const StepInput* input = steps.begin; input != steps.end; ++input) {
      const Pack value = all(w.first[input->row]);
      input_x = hn::MulAdd(hn::LoadU(lanes, input->gamma + first), value, input_x);
      input_y = hn::MulAdd(hn::LoadU(lanes, input->gamma + pairs + first), value, input_y);
    }
    const Pack before = x;
    x = hn::MulAdd(a, x, hn::MulAdd(b, y, input_x));
    y = hn::MulAdd(d, y, hn::MulAdd(c, before, input_y));
    at += states.stride;
    hn::StoreU(x, lanes, at);
    hn::StoreU(y, lanes, at + pairs);
  }
}

void step_pairs(const PairSteps& steps, const double* w, std::ptrdiff_t w_stride, std::ptrdiff_t count, double* states,
                std::ptrdiff_t stride) {
  for (std::ptrdiff_t first = 0; first < steps.pairs; first += lane_count())
    step_pack(steps, first, {w, w_stride}, count, {states, stride});
}

}  // namespace
}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <cassert>

#include "trivet/numerics/lanes/dispatch.h"

namespace trivet::numerics {
namespace {

TRIVET_VARIANTS(step_pairs);

}  // namespace

void take_pair_steps(const PairSteps& steps, const Eigen::Ref<const Eigen::MatrixXd>& w,
                     Eigen::Ref<Eigen::MatrixXd> states) {
  assert(steps.pairs % lane_group == 0 && states.rows() >= 2 * steps.pairs && states.cols() > w.cols());
  TRIVET_DISPATCH(step_pairs)(steps, w.data(), w.outerStride(), w.cols(), states.data(), states.outerStride());
}

}  // namespace trivet::numerics
#endif
