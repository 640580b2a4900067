// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/map/piece_report.h"

namespace trivet::study {
namespace {

constexpr auto counts = {&PieceReport::proven, &PieceReport::fallback, &PieceReport::assembled_separately,
                         &PieceReport::with_requirements};

}  // namespace

void PieceReport::add(const PieceReport& other) {
  for (const auto one : counts) this->*one += other.*one;
  missing.add(other.missing);
}

void PieceReport::store(foundation::StoredWords& words) const {
  for (const auto one : counts) words.whole(this->*one);
  missing.store(words);
}

PieceReport PieceReport::restored(foundation::WordReader& words) {
  PieceReport found;
  for (const auto one : counts) found.*one = words.whole();
  found.missing = design::MissingReasons::restored(words);
  return found;
}

}  // namespace trivet::study
