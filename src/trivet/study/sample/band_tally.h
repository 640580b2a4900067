// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

#include "trivet/foundation/stored_words.h"
#include "trivet/numerics/sampling/exact_statistics.h"

namespace trivet::study {

/// What is counted of the amplitudes of one case, for each of its values: curves at frequencies.
class BandTally {
 public:
  struct Value {
    numerics::LogHistogram amplitudes;
    numerics::Extremes extremes;
  };

  explicit BandTally(Eigen::Index values = 0) : values_(static_cast<std::size_t>(values)) {}

  [[nodiscard]] const std::vector<Value>& values() const { return values_; }
  /// @param amplitudes  one for each value; NaN, of a design that has none, is not counted
  void add(const Eigen::Ref<const Eigen::ArrayXd>& amplitudes, std::uint64_t design);
  void merge(const BandTally& other);

  void store(foundation::StoredWords& words) const;
  /// Sets a tally of as many values to the one stored. @throws foundation::DamagedText
  void restore(foundation::WordReader& words);

 private:
  std::vector<Value> values_;
};

}  // namespace trivet::study
