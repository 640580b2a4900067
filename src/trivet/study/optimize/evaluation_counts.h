// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "trivet/foundation/stored_words.h"

namespace trivet::study {

/// How many designs a search has judged.
struct EvaluationCounts {
  std::size_t evaluations = 0;  ///< also of designs that were judged before
  std::size_t failed = 0;       ///< of them: without a valid model or values
  std::size_t differences = 0;  ///< models solved for differences of values, besides `evaluations`
  std::string first_failure;    ///< why, the first in the alphabet, so that the order does not matter

  void add(const EvaluationCounts& other);
  void store(foundation::StoredWords& words) const;
  /// @throws foundation::DamagedText
  [[nodiscard]] static EvaluationCounts restored(foundation::WordReader& words);
};

/// While it exists: the counts of designs that this thread judges. May be nested.
class CountedHere {
 public:
  CountedHere();
  ~CountedHere();
  CountedHere(const CountedHere&) = delete;
  CountedHere& operator=(const CountedHere&) = delete;

  [[nodiscard]] const EvaluationCounts& counts() const { return counts_; }
  /// Adds to what exists on this thread.
  static void add(const EvaluationCounts& counts);

 private:
  EvaluationCounts counts_;
  CountedHere* before_;
};

}  // namespace trivet::study
