// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/design/missing_reasons.h"

#include <algorithm>

namespace trivet::design {

void MissingReasons::note(std::size_t design, const std::string& rule, const std::string& words) {
  add(without_numbers(rule), {words, 1, design});
}

void MissingReasons::add(const MissingReasons& others) {
  for (const auto& [kind, reason] : others.reasons_) add(kind, reason);
}

void MissingReasons::add(const std::string& kind, const MissingReason& reason) {
  const auto [known, is_new] = reasons_.try_emplace(kind, reason);
  if (is_new) return;
  MissingReason& all = known->second;
  all.designs += reason.designs;
  if (reason.first < all.first) {
    all.first = reason.first;
    all.words = reason.words;
  }
}

std::vector<MissingReason> MissingReasons::list() const {
  std::vector<MissingReason> sorted;
  for (const auto& [kind, reason] : reasons_) sorted.push_back(reason);
  std::ranges::stable_sort(sorted, {}, &MissingReason::first);
  return sorted;
}

void MissingReasons::store(foundation::StoredWords& words) const {
  words.whole(reasons_.size());
  for (const auto& [kind, reason] : reasons_) {
    words.text(kind);
    words.text(reason.words);
    words.whole(reason.designs);
    words.whole(reason.first);
  }
}

MissingReasons MissingReasons::restored(foundation::WordReader& words) {
  MissingReasons found;
  for (std::uint64_t left = words.whole(); left > 0; --left) {
    MissingReason& reason = found.reasons_[words.text()];
    reason.words = words.text();
    reason.designs = words.whole();
    reason.first = words.whole();
  }
  return found;
}

}  // namespace trivet::design
