// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "trivet/design/design_outcome.h"
#include "trivet/design/missing_reasons.h"
#include "trivet/project/model_number.h"
#include "trivet/project/project.h"
#include "trivet/study/family/design_batch.h"

namespace trivet::study {

/// Evaluates the designs that result when two numbers of a case change.
class DesignEvaluation {
 public:
  /// @param frequencies  requirements on natural frequencies, judged for many designs at once if that is possible
  /// @throws foundation::NotComputable if the rules cannot be evaluated for this case
  DesignEvaluation(const project::Case& variant, const project::MapRequest& request,
                   const design::EvaluationOptions& options, const std::vector<RequirementResult>& frequencies);

  [[nodiscard]] const std::vector<design::MapRule>& rules() const { return rules_; }

  /// Outcomes of designs 0 … count − 1, the same for any number of threads. Designs without one are added to the
  /// report.
  [[nodiscard]] std::vector<design::DesignOutcome> evaluate(
      std::size_t count, const std::function<design::DesignPoint(std::size_t)>& point,
      const foundation::Progress& progress = {});

  /// Does a model have the same Z(ω) and load as the design at this point?
  [[nodiscard]] bool is_at(const model::System& system, const design::DesignPoint& point) const;

  /// A model judged by response::peaks. @throws foundation::NotComputable, InvalidInput
  [[nodiscard]] design::JudgedDesign judged_design(const model::System& system) const;

  /// Many designs are judged at once.
  [[nodiscard]] bool has_family() const { return batch_ && batch_->reason().empty(); }

  /// Margins of the requirements on natural frequencies, designs × requirements; NaN where the kernels prove nothing.
  /// @pre has_family()
  [[nodiscard]] Eigen::ArrayXXd frequency_margins(const std::vector<design::DesignPoint>& points) const;

  [[nodiscard]] const design::EvaluationReport& report() const { return report_; }

 private:
  struct NamedChannel {
    std::string name;
    assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement;
  };
  [[nodiscard]] std::size_t channel_of(const std::string& name, assembly::MotionQuantity quantity);
  [[nodiscard]] std::vector<assembly::Channel> channels(const model::System& system,
                                                        const assembly::Assembled& assembled) const;
  [[nodiscard]] foundation::Expected<model::System> system_at(const design::DesignPoint& point) const;
  [[nodiscard]] design::DesignOutcome assembled_outcome(std::size_t index, const design::DesignPoint& point);
  /// @param results  of the rules, then of the requirements on natural frequencies
  void fit_batch(const std::vector<RequirementResult>& results);
  /// Outcomes of designs first … , computed in lanes; designs that are not proven there are recomputed separately.
  void evaluate_in_lanes(std::size_t first, const std::vector<design::DesignPoint>& points,
                         design::DesignOutcome* outcomes);

  const project::Case& case_;
  const project::MapRequest& request_;
  design::EvaluationOptions options_;
  project::ModelNumber x_, y_;
  std::vector<NamedChannel> channels_;
  std::vector<design::MapRule> rules_;
  design::RuleSet set_;
  std::optional<DesignBatch> batch_;
  bool counts_modes_ = false;  // natural frequencies may cross the band of the amplitudes between designs
  std::mutex noting_;          // guards the report
  design::EvaluationReport report_;
  std::atomic<std::size_t> assembled_separately_ = 0;
  design::MissingReasons missing_;
};

}  // namespace trivet::study
