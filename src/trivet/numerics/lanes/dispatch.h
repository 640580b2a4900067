// SPDX-License-Identifier: BSD-3-Clause
// Variants of a kernel, one per instruction set, and their selection. Highway's own selection needs its run-time
// library, which measures its clock for 4 ms at the start of every process. Include after hwy/highway.h, within
// HWY_ONCE.
#pragma once

namespace trivet::numerics {

/// Index of the variant that every kernel uses: the best one that is compiled and that this processor supports, or the
/// one set by `use_instruction_set`.
[[nodiscard]] int chosen_variant();

}  // namespace trivet::numerics

/// Once for each kernel, in its namespace: best first; the last one runs on every processor of this kind.
#define TRIVET_VARIANTS(kernel)                                           \
  constexpr decltype(HWY_CHOOSE_FALLBACK(kernel)) kernel##_variants[] = { \
      HWY_CHOOSE_AVX3(kernel), HWY_CHOOSE_AVX2(kernel), HWY_CHOOSE_FALLBACK(kernel)}
#define TRIVET_DISPATCH(kernel) (kernel##_variants[chosen_variant()])
