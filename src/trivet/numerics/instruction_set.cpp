// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trivet/numerics/instruction_set.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {
long long this_target() { return HWY_TARGET; }
}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/instruction_set.h"

namespace trivet::numerics {

HWY_EXPORT(this_target);

std::string instruction_set() { return hwy::TargetName(HWY_DYNAMIC_DISPATCH(this_target)()); }

std::vector<std::string> instruction_sets() {
  std::vector<std::string> names;
  for (const auto target : hwy::SupportedAndGeneratedTargets()) names.emplace_back(hwy::TargetName(target));
  return names;
}

void use_instruction_set(const std::string& name) {
  hwy::SetSupportedTargetsForTest(0);
  if (name.empty()) return;
  for (const auto target : hwy::SupportedAndGeneratedTargets())
    if (name == hwy::TargetName(target)) return hwy::SetSupportedTargetsForTest(target);
  throw foundation::InvalidInput("instruction set '" + name + "': this processor does not have it");
}

}  // namespace trivet::numerics
#endif
