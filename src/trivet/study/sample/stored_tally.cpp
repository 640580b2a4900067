// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/sample/stored_tally.h"

namespace trivet::study {
namespace {

using foundation::StoredWords;
using foundation::WordReader;

void store_list(const std::vector<std::uint64_t>& list, StoredWords& words) {
  words.whole(list.size());
  for (const std::uint64_t one : list) words.whole(one);
  words.end_line();
}

void restore_list(WordReader& words, std::vector<std::uint64_t>& list) {
  if (words.whole() != list.size()) throw foundation::DamagedText("a list has another length");
  for (std::uint64_t& one : list) one = words.whole();
}

void store_requirement(const RequirementTally& tally, StoredWords& words) {
  store_list(tally.met, words);
  words.whole(tally.first);
  tally.extremes.store(words);
  tally.values.store(words);
  tally.squares.store(words);
  words.end_line();
  tally.margins.store(words);
  words.end_line();
}

void restore_requirement(WordReader& words, RequirementTally& tally) {
  restore_list(words, tally.met);
  tally.first = words.whole();
  tally.extremes = numerics::Extremes::restored(words);
  tally.values = numerics::ExactSum::restored(words);
  tally.squares = numerics::ExactSum::restored(words);
  tally.margins = numerics::LogHistogram::restored(words);
}

}  // namespace

void store_tally(const SampleTally& tally, StoredWords& words) {
  for (const auto* list : {&tally.designs, &tally.met, &tally.in_kernels, &tally.one_by_one}) store_list(*list, words);
  words.whole(tally.failed);
  words.whole(tally.first_failed);
  words.text(tally.first_failure);
  tally.least.store(words);
  words.end_line();
  tally.kept.store(words);
  for (const auto& requirements : tally.of)
    for (const RequirementTally& one : requirements) store_requirement(one, words);
  for (const BandTally& one : tally.bands) one.store(words);
}

void restore_tally(WordReader& words, SampleTally& tally) {
  for (auto* list : {&tally.designs, &tally.met, &tally.in_kernels, &tally.one_by_one}) restore_list(words, *list);
  tally.failed = words.whole();
  tally.first_failed = words.whole();
  tally.first_failure = words.text();
  tally.least = numerics::Extremes::restored(words);
  std::size_t requirements = 0;
  for (const auto& one : tally.of) requirements += one.size();
  tally.kept = KeptTally::restored(words, requirements);
  for (auto& of_case : tally.of)
    for (RequirementTally& one : of_case) restore_requirement(words, one);
  for (BandTally& one : tally.bands) one.restore(words);
}

}  // namespace trivet::study
