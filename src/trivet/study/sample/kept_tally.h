// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <map>
#include <vector>

#include "trivet/foundation/stored_words.h"
#include "trivet/study/sample/sampled_case.h"

namespace trivet::study {

/// Margins of one design for all requirements of all cases in their order; none if it could not be judged in a case.
[[nodiscard]] std::vector<double> margins_of_design(const std::vector<SampledMargins>& cases, Eigen::Index row);

/// Designs of a sample that are kept, see KeptDesigns: a bounded number, the same for any order in which they are added
/// and parts are merged.
class KeptTally {
 public:
  using Designs = std::map<std::uint64_t, std::vector<double>>;  ///< margins by the number of the design

  [[nodiscard]] const Designs& first() const { return first_; }
  [[nodiscard]] const Designs& failing() const { return failing_; }

  /// @param meets_all  it is judged and meets every requirement
  [[nodiscard]] bool keeps(std::uint64_t design, bool meets_all) const;
  /// Only of a design that it keeps.
  void add(std::uint64_t design, std::vector<double> margins);
  void merge(const KeptTally& other);

  void store(foundation::StoredWords& words) const;
  /// @param requirements  of all cases  @throws foundation::DamagedText
  [[nodiscard]] static KeptTally restored(foundation::WordReader& words, std::size_t requirements);

 private:
  Designs first_, failing_;
};

}  // namespace trivet::study
