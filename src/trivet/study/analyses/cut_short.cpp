// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/analyses/case_results.h"

#include <algorithm>

#include "trivet/nonlinear/branch/steady_branch.h"
#include "trivet/nonlinear/modes/backbone.h"

namespace trivet::study {

bool is_cut_short(const CaseResults& results) {
  const auto& steady = results.steady;
  const auto& modes = results.backbone;
  const auto ends = [](const auto& curve) { return !curve.ended.empty(); };
  return (steady && ends(*steady)) || (modes && std::ranges::any_of(*modes, ends));
}

}  // namespace trivet::study
