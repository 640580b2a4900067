// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/sample/band_tally.h"

#include <cmath>

#include "trivet/foundation/index.h"

namespace trivet::study {

void BandTally::add(const Eigen::Ref<const Eigen::ArrayXd>& amplitudes, std::uint64_t design) {
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const double amplitude = amplitudes(to_index(i));
    if (std::isnan(amplitude)) continue;
    values_[i].amplitudes.add(amplitude);
    values_[i].extremes.add(amplitude, design);
  }
}

void BandTally::merge(const BandTally& other) {
  for (std::size_t i = 0; i < values_.size(); ++i) {
    values_[i].amplitudes.merge(other.values_[i].amplitudes);
    values_[i].extremes.merge(other.values_[i].extremes);
  }
}

void BandTally::store(foundation::StoredWords& words) const {
  words.whole(values_.size());
  words.end_line();
  for (const Value& one : values_) {
    one.extremes.store(words);
    one.amplitudes.store(words);
    words.end_line();
  }
}

void BandTally::restore(foundation::WordReader& words) {
  if (words.whole() != values_.size()) throw foundation::DamagedText("bands of another number of values");
  for (Value& one : values_) {
    one.extremes = numerics::Extremes::restored(words);
    one.amplitudes = numerics::LogHistogram::restored(words);
  }
}

}  // namespace trivet::study
