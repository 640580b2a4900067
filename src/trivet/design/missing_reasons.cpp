// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/design/missing_reasons.h"

#include <algorithm>

#include "trivet/foundation/index.h"

namespace trivet::design {

void MissingReasons::note(std::size_t design, const std::string& rule, const std::string& words) {
  const std::string kind = without_numbers(rule);
  const std::lock_guard lock(noting_);
  const auto known = to_size(std::ranges::find(kinds_, kind) - kinds_.begin());
  if (known == kinds_.size()) {
    kinds_.push_back(kind);
    reasons_.push_back({words, 0, design});
  }
  MissingReason& reason = reasons_[known];
  ++reason.designs;
  if (design < reason.first) {
    reason.first = design;
    reason.words = words;
  }
}

std::vector<MissingReason> MissingReasons::list() const {
  const std::lock_guard lock(noting_);
  std::vector<MissingReason> sorted = reasons_;
  std::ranges::sort(sorted, {}, &MissingReason::first);
  return sorted;
}

}  // namespace trivet::design
