// SPDX-License-Identifier: BSD-3-Clause
// One column of the states per lane.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trivet/numerics/periodic/kicked_flow.cpp"
#include <hwy/foreach_target.h>

#include "trivet/numerics/lanes/lanes-inl.h"
#include "trivet/numerics/periodic/linear_flow.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {
namespace {

static_assert(hn::MaxLanes(Lanes()) <= longest_pack);

/// Packs of columns side by side, whose rows are `stride` numbers apart.
struct PackColumns {
  double* first;
  std::ptrdiff_t stride;
  [[nodiscard]] HWY_INLINE Pack load(std::ptrdiff_t row, std::ptrdiff_t pack) const {
    return hn::Load(Lanes(), first + row * stride + pack * lane_count());
  }
  HWY_INLINE void store(Pack value, std::ptrdiff_t row, std::ptrdiff_t pack) const {
    hn::Store(value, Lanes(), first + row * stride + pack * lane_count());
  }
};

/// Numbers of the matrices, loaded once, act on all packs p.
template <std::ptrdiff_t... p>
struct Packs {
  static HWY_INLINE void flow_on(const KickedFlow& flow, KickedFlow::Step step, PackColumns y) {
    for (std::ptrdiff_t i = 0; i < flow.states; ++i) {
      const Pack diagonal = all(step.diagonal[i]);
      if (!flow.leads[i]) {
        (y.store(hn::Mul(diagonal, y.load(i, p)), i, p), ...);
        continue;
      }
      const Pack a[] = {y.load(i, p)...}, b[] = {y.load(i + 1, p)...};
      const Pack beside = all(step.beside[i]), beside_next = all(step.beside[i + 1]),
                 diagonal_next = all(step.diagonal[i + 1]);
      (y.store(hn::MulAdd(diagonal, a[p], hn::Mul(beside, b[p])), i, p), ...);
      (y.store(hn::MulAdd(beside_next, a[p], hn::Mul(diagonal_next, b[p])), i + 1, p), ...);
      ++i;
    }
  }

  /// A matrix, by rows, times columns.
  /// @param adds  to what is there
  static HWY_INLINE void multiply(const double* HWY_RESTRICT matrix, std::ptrdiff_t rows, std::ptrdiff_t columns,
                                  PackColumns from, PackColumns to, bool adds) {
    for (std::ptrdiff_t row = 0; row < rows; ++row, matrix += columns) {
      Pack sums[] = {(adds ? to.load(row, p) : hn::Zero(Lanes()))...};
      for (std::ptrdiff_t i = 0; i < columns; ++i) {
        const Pack number = all(matrix[i]);
        ((sums[p] = hn::MulAdd(number, from.load(i, p), sums[p])), ...);
      }
      (to.store(sums[p], row, p), ...);
    }
  }

  /// @param memory  for a row of y for each value and each force
  static void step_all(const KickedFlow& flow, double* y, std::ptrdiff_t stride, double* memory) {
    const PackColumns states{y, stride}, seen{memory, stride}, kicks{memory + flow.values * stride, stride};
    flow_on(flow, flow.half, states);
    const double* jacobians = flow.jacobians;
    for (std::ptrdiff_t s = 0; s < flow.steps; ++s, jacobians += flow.forces * flow.values) {
      multiply(flow.seen, flow.values, flow.states, states, seen, false);
      multiply(jacobians, flow.forces, flow.values, seen, kicks, false);
      multiply(flow.kick, flow.states, flow.forces, kicks, states, true);
      flow_on(flow, s + 1 < flow.steps ? flow.whole : flow.half, states);
    }
  }
};

void take_steps(const KickedFlow& flow, double* y, std::ptrdiff_t columns, std::ptrdiff_t stride, double* memory) {
  std::ptrdiff_t left = (columns + lane_count() - 1) / lane_count();
  for (; left >= 4; left -= 4, y += 4 * lane_count()) Packs<0, 1, 2, 3>::step_all(flow, y, stride, memory);
  if (left == 3) Packs<0, 1, 2>::step_all(flow, y, stride, memory);
  if (left == 2) Packs<0, 1>::step_all(flow, y, stride, memory);
  if (left == 1) Packs<0>::step_all(flow, y, stride, memory);
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

void take_kicked_steps(const KickedFlow& flow, double* y, std::ptrdiff_t columns, std::ptrdiff_t stride) {
  LineMemory memory;
  memory.resize(to_size((flow.values + flow.forces) * stride));
  TRIVET_DISPATCH(take_steps)(flow, y, columns, stride, memory.data());
}

}  // namespace trivet::numerics
#endif
