// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/optimize/evaluation_counts.h"

namespace trivet::study {
namespace {

thread_local CountedHere* counted_here = nullptr;

constexpr auto numbers = {&EvaluationCounts::evaluations, &EvaluationCounts::failed, &EvaluationCounts::differences};

}  // namespace

void EvaluationCounts::add(const EvaluationCounts& other) {
  for (const auto one : numbers) this->*one += other.*one;
  if (first_failure.empty() || (!other.first_failure.empty() && other.first_failure < first_failure))
    first_failure = other.first_failure;
}

void EvaluationCounts::store(foundation::StoredWords& words) const {
  for (const auto one : numbers) words.whole(this->*one);
  words.text(first_failure);
}

EvaluationCounts EvaluationCounts::restored(foundation::WordReader& words) {
  EvaluationCounts found;
  for (const auto one : numbers) found.*one = words.whole();
  found.first_failure = words.text();
  return found;
}

CountedHere::CountedHere() : before_(counted_here) { counted_here = this; }

CountedHere::~CountedHere() { counted_here = before_; }

void CountedHere::add(const EvaluationCounts& counts) {
  for (CountedHere* one = counted_here; one; one = one->before_) one->counts_.add(counts);
}

}  // namespace trivet::study
