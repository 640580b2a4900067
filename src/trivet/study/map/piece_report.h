// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "trivet/design/missing_reasons.h"
#include "trivet/foundation/stored_words.h"

namespace trivet::study {

/// How some designs of a map were judged in one case; see design::EvaluationReport.
struct PieceReport {
  std::size_t proven = 0, fallback = 0, assembled_separately = 0, with_requirements = 0;
  design::MissingReasons missing;

  void add(const PieceReport& other);
  void store(foundation::StoredWords& words) const;
  /// @throws foundation::DamagedText
  [[nodiscard]] static PieceReport restored(foundation::WordReader& words);
};

}  // namespace trivet::study
