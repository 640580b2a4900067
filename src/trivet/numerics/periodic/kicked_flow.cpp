// SPDX-License-Identifier: BSD-3-Clause
// One column of the states per lane.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trivet/numerics/periodic/kicked_flow.cpp"
#include <hwy/foreach_target.h>

#include "trivet/numerics/lanes/lanes-inl.h"
#include "trivet/numerics/periodic/kicked_flow.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {
namespace {

/// A pack of columns, whose rows are `stride` numbers apart.
struct PackColumns {
  double* first;
  std::ptrdiff_t stride;
  [[nodiscard]] HWY_INLINE Pack load(std::ptrdiff_t row) const { return hn::Load(Lanes(), first + row * stride); }
  HWY_INLINE void store(Pack value, std::ptrdiff_t row) const { hn::Store(value, Lanes(), first + row * stride); }
};

HWY_INLINE void flow_on(const KickedFlow& flow, KickedFlow::Step step, PackColumns y) {
  for (std::ptrdiff_t i = 0; i < flow.states; ++i) {
    const Pack a = y.load(i);
    if (!flow.leads[i]) {
      y.store(hn::Mul(all(step.diagonal[i]), a), i);
      continue;
    }
    const Pack b = y.load(i + 1);
    y.store(hn::MulAdd(all(step.diagonal[i]), a, hn::Mul(all(step.beside[i]), b)), i);
    y.store(hn::MulAdd(all(step.beside[i + 1]), a, hn::Mul(all(step.diagonal[i + 1]), b)), i + 1);
    ++i;
  }
}

/// @param kicks  memory for a pack per force
HWY_INLINE void kick_on(const KickedFlow& flow, const double* tangents, PackColumns kicks, PackColumns y) {
  const std::ptrdiff_t n = flow.states, m = flow.forces;
  for (std::ptrdiff_t j = 0; j < m; ++j) {
    const double* const seen = flow.seen + j * n;
    Pack even = hn::Zero(Lanes()), odd = even;
    std::ptrdiff_t i = 0;
    for (; i + 1 < n; i += 2) {
      even = hn::MulAdd(all(seen[i]), y.load(i), even);
      odd = hn::MulAdd(all(seen[i + 1]), y.load(i + 1), odd);
    }
    if (i < n) even = hn::MulAdd(all(seen[i]), y.load(i), even);
    kicks.store(hn::Mul(all(tangents[j]), hn::Add(even, odd)), j);
  }
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const double* const kick = flow.kick + i * m;
    Pack sum = y.load(i);
    for (std::ptrdiff_t j = 0; j < m; ++j) sum = hn::MulAdd(all(kick[j]), kicks.load(j), sum);
    y.store(sum, i);
  }
}

void take_steps(const KickedFlow& flow, double* y, std::ptrdiff_t stride, double* kicks) {
  for (std::ptrdiff_t column = 0; column < stride; column += lane_count()) {
    const PackColumns pack{y + column, stride}, in_between{kicks, lane_count()};
    flow_on(flow, flow.half, pack);
    for (std::ptrdiff_t s = 0; s < flow.steps; ++s) {
      kick_on(flow, flow.tangents + s * flow.forces, in_between, pack);
      flow_on(flow, s + 1 < flow.steps ? flow.whole : flow.half, pack);
    }
  }
}

}  // namespace
}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "trivet/foundation/index.h"
#include "trivet/numerics/lanes/dispatch.h"
#include "trivet/numerics/lanes/line_memory.h"

namespace trivet::numerics {
namespace {

TRIVET_VARIANTS(take_steps);

}  // namespace

void take_kicked_steps(const KickedFlow& flow, double* y, std::ptrdiff_t stride) {
  LineMemory kicks;
  kicks.resize(to_size(flow.forces * longest_pack));
  TRIVET_DISPATCH(take_steps)(flow, y, stride, kicks.data());
}

}  // namespace trivet::numerics
#endif
