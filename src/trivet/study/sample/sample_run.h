// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/project/project.h"
#include "trivet/study/sample/drawn_designs.h"
#include "trivet/study/sample/sample_tally.h"
#include "trivet/study/sample/sampled_case.h"

namespace trivet::study {

/// The first designs of a sample, judged.
struct FirstDesigns {
  std::size_t count = 0, piece = 1;                  ///< designs; so many are judged at once
  std::vector<std::vector<SampledMargins>> margins;  ///< of each piece in all cases
  SampleMagnitudes magnitudes;

  void count_in(const DrawnDesigns& drawn, SampleTally& tally) const;
};

/// Draws and judges the designs of a project's sample in any pieces.
class SampleRun {
 public:
  /// @param project  lives as long as the run
  /// @throws foundation::InvalidInput without tolerances or requirements, NotComputable if a requirement cannot be
  /// judged in the design of the file
  explicit SampleRun(const project::Project& project);
  SampleRun(const SampleRun&) = delete;
  SampleRun& operator=(const SampleRun&) = delete;

  [[nodiscard]] const project::Project& project() const { return project_; }
  [[nodiscard]] const project::SampleRequest& request() const { return request_; }
  [[nodiscard]] const std::vector<project::Tolerance>& tolerances() const { return tolerances_; }
  [[nodiscard]] const DrawnDesigns& drawn() const { return drawn_; }
  /// Those in which the design has to hold.
  [[nodiscard]] const std::vector<SampledCase>& cases() const { return cases_; }
  /// True if kernels judge nearly all designs of all cases.
  [[nodiscard]] bool is_quick() const;
  /// Leaves out all designs after the first ones.
  void keep_first(std::size_t most) { request_.designs = std::min(request_.designs, most); }
  /// Designs that are judged at once: many by kernels, few by assembled models.
  [[nodiscard]] std::size_t piece() const;

  /// Judges the first designs, which set the magnitudes for the sums of all.
  [[nodiscard]] FirstDesigns first_designs(const foundation::Progress& progress) const;
  [[nodiscard]] SampleTally empty_tally(const SampleMagnitudes& magnitudes) const;
  /// Judges designs piece by piece and counts them.
  /// @param interruption  called between designs, may throw foundation::Interrupted; on the calling thread
  void count(std::uint64_t first, std::uint64_t number, SampleTally& into,
             const foundation::Progress& interruption = {}) const;
  /// Margins of one design in the order of the requirements of all cases; none if it cannot be judged.
  [[nodiscard]] std::vector<double> margins(std::uint64_t design) const;

 private:
  [[nodiscard]] std::vector<SampledMargins> judged(std::uint64_t first, std::size_t count,
                                                   const foundation::Progress& interruption) const;
  [[nodiscard]] SampleMagnitudes magnitudes_of(const std::vector<std::vector<SampledMargins>>& first) const;

  const project::Project& project_;
  project::SampleRequest request_;
  const std::vector<project::Tolerance>& tolerances_;
  DrawnDesigns drawn_;
  std::vector<SampledCase> cases_;
};

}  // namespace trivet::study
