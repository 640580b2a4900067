// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/sample/kept_tally.h"

#include <cmath>
#include <iterator>
#include <utility>

#include "trivet/foundation/index.h"
#include "trivet/study/sample/kept_designs.h"

namespace trivet::study {
namespace {

void store_designs(const KeptTally::Designs& designs, foundation::StoredWords& words) {
  words.whole(designs.size());
  for (const auto& [number, margins] : designs) {
    words.whole(number);
    words.whole(margins.size());
    for (const double one : margins) words.exact(one);
    words.end_line();
  }
}

/// @param most  designs  @param requirements  of all cases
KeptTally::Designs restored_designs(foundation::WordReader& words, std::size_t most, std::size_t requirements) {
  KeptTally::Designs designs;
  for (std::uint64_t left = words.at_most(most); left > 0; --left) {
    const std::uint64_t number = words.whole();
    std::vector<double> margins(words.at_most(requirements));
    if (!margins.empty() && margins.size() != requirements)
      throw foundation::DamagedText("a design has another number of margins");
    for (double& one : margins) {
      one = words.exact();
      if (std::isnan(one)) throw foundation::DamagedText("a margin is not a number");
    }
    designs.emplace(number, std::move(margins));
  }
  return designs;
}

}  // namespace

std::vector<double> margins_of_design(const std::vector<SampledMargins>& cases, Eigen::Index row) {
  std::vector<double> margins;
  for (const SampledMargins& one : cases) {
    if (!one.failures[to_size(row)].empty()) return {};
    for (const double margin : one.margins.row(row)) margins.push_back(margin);
  }
  return margins;
}

bool KeptTally::keeps(std::uint64_t design, bool meets_all) const {
  if (design < KeptDesigns::first) return true;
  return !meets_all && (failing_.size() < KeptDesigns::failing || design < failing_.rbegin()->first);
}

void KeptTally::add(std::uint64_t design, std::vector<double> margins) {
  (design < KeptDesigns::first ? first_ : failing_).emplace(design, std::move(margins));
  if (failing_.size() > KeptDesigns::failing) failing_.erase(std::prev(failing_.end()));
}

void KeptTally::merge(const KeptTally& other) {
  for (const auto& [number, margins] : other.first_) add(number, margins);
  for (const auto& [number, margins] : other.failing_)
    if (keeps(number, false)) add(number, margins);
}

void KeptTally::store(foundation::StoredWords& words) const {
  store_designs(first_, words);
  store_designs(failing_, words);
}

KeptTally KeptTally::restored(foundation::WordReader& words, std::size_t requirements) {
  KeptTally tally;
  tally.first_ = restored_designs(words, KeptDesigns::first, requirements);
  tally.failing_ = restored_designs(words, KeptDesigns::failing, requirements);
  return tally;
}

}  // namespace trivet::study
