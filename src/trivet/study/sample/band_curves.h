// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

#include "trivet/foundation/index.h"
#include "trivet/project/project.h"
#include "trivet/study/family/design_batch.h"
#include "trivet/study/sample/sampled_band.h"

namespace trivet::study {

/// The curves of one case whose amplitudes are counted over all designs, at fixed frequencies: [analyses.sample] bands.
/// Amplitudes are listed curve by curve.
class BandCurves {
 public:
  /// @throws foundation::NotComputable if the response of the case as given has no result
  BandCurves(const project::Case& variant, const project::SampleRequest& request);

  [[nodiscard]] Eigen::Index values() const { return to_index(curves_.size() * frequencies_.size()); }
  /// Why amplitudes are computed from assembled models; empty if from the matrices of a batch.
  [[nodiscard]] const std::string& no_kernels() const { return no_kernels_; }
  /// Curves, frequencies, the given design and the limits; nothing is counted yet.
  [[nodiscard]] std::vector<SampledBand> empty(const std::vector<RequirementResult>& given) const;

  /// @param numbers  as of the batch that judges the requirements
  void fit(const DesignNumbers& numbers);
  /// Of designs within the ranges of the numbers, values × designs; NaN where only the model knows. @pre `no_kernels`
  /// is empty
  [[nodiscard]] Eigen::ArrayXXd amplitudes(const Eigen::MatrixXd& numbers) const;
  /// Of one model. @throws foundation::NotComputable, InvalidInput if it has no result
  [[nodiscard]] Eigen::ArrayXd amplitudes(const model::System& system) const;

 private:
  const project::Case& case_;
  const project::ResponseRequest& response_;
  std::vector<RequirementResult> curves_;  ///< each an amplitude without a limit
  std::vector<double> frequencies_;
  Eigen::ArrayXd given_;
  std::optional<DesignBatch> batch_;
  std::string no_kernels_ = "the requirements are judged by models";
};

}  // namespace trivet::study
