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

static_assert(hn::MaxLanes(Lanes()) <= longest_pack);

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

/// A row of a matrix times packs of rows.
HWY_INLINE Pack product(const double* HWY_RESTRICT row, std::ptrdiff_t columns, PackColumns y) {
  Pack even = hn::Zero(Lanes()), odd = even;
  std::ptrdiff_t i = 0;
  for (; i + 1 < columns; i += 2) {
    even = hn::MulAdd(all(row[i]), y.load(i), even);
    odd = hn::MulAdd(all(row[i + 1]), y.load(i + 1), odd);
  }
  if (i < columns) even = hn::MulAdd(all(row[i]), y.load(i), even);
  return hn::Add(even, odd);
}

/// @param seen, kicks  memory for a pack per value and per force
HWY_INLINE void kick_on(const KickedFlow& flow, const double* answer, PackColumns seen, PackColumns kicks,
                        PackColumns y) {
  for (std::ptrdiff_t r = 0; r < flow.values; ++r) seen.store(product(flow.seen + r * flow.states, flow.states, y), r);
  for (std::ptrdiff_t j = 0; j < flow.forces; ++j) kicks.store(product(answer + j * flow.values, flow.values, seen), j);
  for (std::ptrdiff_t i = 0; i < flow.states; ++i)
    y.store(hn::Add(y.load(i), product(flow.kick + i * flow.forces, flow.forces, kicks)), i);
}

void take_steps(const KickedFlow& flow, double* y, std::ptrdiff_t stride, double* memory) {
  const PackColumns seen{memory, lane_count()}, kicks{memory + flow.values * lane_count(), lane_count()};
  for (std::ptrdiff_t column = 0; column < stride; column += lane_count()) {
    const PackColumns pack{y + column, stride};
    flow_on(flow, flow.half, pack);
    for (std::ptrdiff_t s = 0; s < flow.steps; ++s) {
      kick_on(flow, flow.answers + s * flow.forces * flow.values, seen, kicks, pack);
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
  LineMemory memory;
  memory.resize(to_size((flow.values + flow.forces) * longest_pack));
  TRIVET_DISPATCH(take_steps)(flow, y, stride, memory.data());
}

}  // namespace trivet::numerics
#endif
