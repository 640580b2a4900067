// SPDX-License-Identifier: BSD-3-Clause
// Peak rate of the machine, measured in the same run as the benchmarks.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "machine_limits.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace trivet::benchmarks::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Lanes = hn::CappedTag<double, 8>;

/// Twelve independent chains of multiply-adds. They are separate variables, so that each stays in a register, and have
/// different start values, or the compiler would merge them.
double multiply_adds(int rounds, double start) {
  const Lanes d;
  const auto a = hn::Set(d, 0.999), b = hn::Set(d, 1e-3);
  const auto from = [&](int chain) HWY_ATTR { return hn::Set(d, start + chain); };
  auto x0 = from(0), x1 = from(1), x2 = from(2), x3 = from(3), x4 = from(4), x5 = from(5), x6 = from(6), x7 = from(7),
       x8 = from(8), x9 = from(9), x10 = from(10), x11 = from(11);
  for (int i = 0; i < rounds; ++i) {
    x0 = hn::MulAdd(x0, a, b), x1 = hn::MulAdd(x1, a, b), x2 = hn::MulAdd(x2, a, b), x3 = hn::MulAdd(x3, a, b);
    x4 = hn::MulAdd(x4, a, b), x5 = hn::MulAdd(x5, a, b), x6 = hn::MulAdd(x6, a, b), x7 = hn::MulAdd(x7, a, b);
    x8 = hn::MulAdd(x8, a, b), x9 = hn::MulAdd(x9, a, b), x10 = hn::MulAdd(x10, a, b), x11 = hn::MulAdd(x11, a, b);
  }
  const auto sum = hn::Add(hn::Add(hn::Add(x0, x1), hn::Add(x2, x3)), hn::Add(hn::Add(x4, x5), hn::Add(x6, x7)));
  return hn::GetLane(hn::Add(sum, hn::Add(hn::Add(x8, x9), hn::Add(x10, x11))));
}

double multiply_adds_per_round() { return 12.0 * static_cast<double>(hn::Lanes(Lanes())); }

}  // namespace trivet::benchmarks::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "measure.h"
#include "trivet/numerics/lanes/dispatch.h"

namespace trivet::benchmarks {

using numerics::chosen_variant;
TRIVET_VARIANTS(multiply_adds);
TRIVET_VARIANTS(multiply_adds_per_round);

double peak_flops() {
  constexpr int rounds = 40000;
  static volatile double start = 0.5;
  const double from = thread_seconds();
  start = TRIVET_DISPATCH(multiply_adds)(rounds, start) * 0.05;
  return 2.0 * rounds * TRIVET_DISPATCH(multiply_adds_per_round)() / (thread_seconds() - from);
}

}  // namespace trivet::benchmarks
#endif
