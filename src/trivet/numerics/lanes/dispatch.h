// SPDX-License-Identifier: BSD-3-Clause
// The variants of a kernel, one for each instruction set, and the choice among them. Highway's own choice needs its
// run-time library, which measures its clock for 4 ms at the start of every process. Include after hwy/highway.h,
// within HWY_ONCE.
#pragma once

namespace trivet::numerics {

/// Which variant of every kernel runs: the best that was compiled and that this processor has, or what
/// `use_instruction_set` says.
[[nodiscard]] int chosen_variant();

}  // namespace trivet::numerics

/// Once for each kernel, in its namespace: best first; the last is what every processor of this kind has.
#define TRIVET_VARIANTS(kernel)                                           \
  constexpr decltype(HWY_CHOOSE_FALLBACK(kernel)) kernel##_variants[] = { \
      HWY_CHOOSE_AVX3(kernel), HWY_CHOOSE_AVX2(kernel), HWY_CHOOSE_FALLBACK(kernel)}
#define TRIVET_DISPATCH(kernel) (kernel##_variants[chosen_variant()])
