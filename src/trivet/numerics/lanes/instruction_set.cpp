// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trivet/numerics/lanes/instruction_set.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {
const char* name_of_target() { return hwy::TargetName(HWY_TARGET); }
}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <atomic>

#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/lanes/dispatch.h"
#include "trivet/numerics/lanes/instruction_set.h"

namespace trivet::numerics {
namespace {

TRIVET_VARIANTS(name_of_target);
constexpr int variants = 3;

/// Whether this processor supports the instructions that a variant was compiled for.
bool has_instructions(int variant) {
  if (name_of_target_variants[variant] == nullptr) return false;
#if HWY_ARCH_X86
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("aes") &&
      __builtin_cpu_supports("pclmul") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("f16c") &&
      __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
  const bool avx3 = avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd");
  const bool has[variants] = {avx3, avx2, true};
  return has[variant];
#else
  return true;
#endif
}

int best_variant() {
  int variant = 0;
  while (variant + 1 < variants && !has_instructions(variant)) ++variant;
  return variant;
}

std::atomic<int>& variant_in_use() {
  static std::atomic<int> variant = best_variant();
  return variant;
}

}  // namespace

int chosen_variant() { return variant_in_use().load(std::memory_order_relaxed); }

std::string instruction_set() { return TRIVET_DISPATCH(name_of_target)(); }

std::vector<std::string> instruction_sets() {
  std::vector<std::string> names;
  for (int variant = 0; variant < variants; ++variant)
    if (const auto name = name_of_target_variants[variant]; name != nullptr && has_instructions(variant))
      names.emplace_back(name());
  return names;
}

void use_instruction_set(const std::string& name) {
  if (name.empty()) {
    variant_in_use() = best_variant();
    return;
  }
  for (int variant = 0; variant < variants; ++variant)
    if (has_instructions(variant) && name == name_of_target_variants[variant]()) {
      variant_in_use() = variant;
      return;
    }
  throw foundation::InvalidInput("instruction set '" + name + "': not available on this processor");
}

}  // namespace trivet::numerics
#endif
