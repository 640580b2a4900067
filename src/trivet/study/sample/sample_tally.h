// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "trivet/numerics/sampling/exact_statistics.h"
#include "trivet/study/sample/band_tally.h"
#include "trivet/study/sample/kept_tally.h"
#include "trivet/study/sample/sampled_case.h"

namespace trivet::study {

/// The value that belongs to a margin: limit/margin, or limit × margin where more is better; none of requirements whose
/// margin is neither, and of a damping ratio with a margin of 0, which may be negative.
[[nodiscard]] std::optional<double> value_at_margin(const RequirementResult& requirement, double margin);

/// Magnitudes for which the sums of a requirement are made.
struct SumMagnitudes {
  double value = 1, square = 1;
};
using SampleMagnitudes = std::vector<std::vector<SumMagnitudes>>;  ///< per case and requirement

/// What is counted of one requirement.
struct RequirementTally {
  std::vector<std::uint64_t> met;  ///< per replicate
  std::uint64_t first = 0;         ///< violated designs in which it has the least margin
  numerics::LogHistogram margins;
  numerics::Extremes extremes;  ///< of the margins
  numerics::ExactSum values, squares;
};

/// What is counted over designs, in whole numbers: tallies of parts are merged in any order.
class SampleTally {
 public:
  SampleTally(const std::vector<SampledCase>& cases, std::size_t replicates, const SampleMagnitudes& magnitudes);

  /// @param first  number of the first design  @param margins  of each case
  void add(const DrawnDesigns& drawn, std::uint64_t first, const std::vector<SampledMargins>& margins);
  void merge(const SampleTally& other);

  std::vector<std::uint64_t> designs, met;            ///< per replicate
  std::vector<std::vector<RequirementTally>> of;      ///< per case and requirement
  std::vector<BandTally> bands;                       ///< per case
  std::vector<std::uint64_t> in_kernels, one_by_one;  ///< per case
  std::uint64_t failed = 0, first_failed = 0;         ///< designs; number of the first
  std::string first_failure;
  numerics::Extremes least;  ///< of the least margins of the judged designs
  KeptTally kept;

 private:
  /// Why a design fails; empty if it is judged.
  [[nodiscard]] static std::string failure(Eigen::Index row, const std::vector<SampledMargins>& margins);
  void add_judged(std::size_t replicate, std::uint64_t design, Eigen::Index row,
                  const std::vector<SampledMargins>& margins);
  const std::vector<SampledCase>& cases_;
};

}  // namespace trivet::study
