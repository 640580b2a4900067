// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "trivet/design/design_family.h"
#include "trivet/design/design_outcome.h"
#include "trivet/design/missing_reasons.h"
#include "trivet/numerics/batch/design_peaks.h"
#include "trivet/project/model_number.h"
#include "trivet/project/project.h"

namespace trivet::design {

/// Evaluates the designs that result when two numbers of a case change.
class DesignEvaluation {
 public:
  /// @throws foundation::NotComputable if the rules cannot be evaluated for this case
  DesignEvaluation(const project::Case& variant, const project::MapRequest& request)
      : DesignEvaluation(variant, request, EvaluationOptions()) {}
  DesignEvaluation(const project::Case& variant, const project::MapRequest& request, const EvaluationOptions& options);

  [[nodiscard]] const std::vector<MapRule>& rules() const { return rules_; }

  /// Outcomes of designs 0 … count − 1, the same for any number of threads. Designs without one are added to the
  /// report.
  [[nodiscard]] std::vector<DesignOutcome> evaluate(std::size_t count,
                                                    const std::function<DesignPoint(std::size_t)>& point,
                                                    const foundation::Progress& progress = {});

  /// Does a model have the same Z(ω) and load as the design at this point?
  [[nodiscard]] bool is_at(const model::System& system, const DesignPoint& point) const;

  /// A model judged by response::peaks. @throws foundation::NotComputable, InvalidInput
  [[nodiscard]] JudgedDesign judged_design(const model::System& system) const;

  /// The matrices of the designs are interpolated.
  [[nodiscard]] bool has_family() const { return plain_family_ || driven_family_; }

  /// Undamped natural frequencies of designs, ω² in a row each; none if the matrices could not be interpolated.
  [[nodiscard]] std::optional<Eigen::ArrayXXd> squared_frequencies(const std::vector<DesignPoint>& points) const;

  [[nodiscard]] const EvaluationReport& report() const { return report_; }

 private:
  struct NamedChannel {
    std::string name;
    assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement;
  };
  [[nodiscard]] std::size_t channel_of(const std::string& name, assembly::MotionQuantity quantity);
  [[nodiscard]] std::vector<assembly::Channel> channels(const model::System& system,
                                                        const assembly::Assembled& assembled) const;
  [[nodiscard]] foundation::Expected<model::System> system_at(const DesignPoint& point) const;
  [[nodiscard]] DesignOutcome assembled_outcome(std::size_t index, const DesignPoint& point);
  void fit_family(const project::Case& variant);
  template <typename Design, typename Form>
  [[nodiscard]] FamilyOrReason<Design> fitted(const project::Case& variant, const Form& form) const;
  void plan_searches();
  [[nodiscard]] numerics::DesignPeaks peaks_of_family(const std::vector<FamilyPoint>& places,
                                                      const numerics::DesignPeakOptions& search) const;
  [[nodiscard]] Eigen::ArrayXXd modes_of_family(const std::vector<FamilyPoint>& places) const;
  [[nodiscard]] std::vector<std::size_t> highest_outside_band(const numerics::DesignPeaks& found) const;
  /// Outcomes of designs first … , computed in lanes; designs that are not proven there are recomputed separately.
  void evaluate_in_lanes(std::size_t first, const std::vector<DesignPoint>& points, DesignOutcome* outcomes);

  const project::Case& case_;
  const project::MapRequest& request_;
  EvaluationOptions options_;
  project::ModelNumber x_, y_;
  std::vector<NamedChannel> channels_;
  std::vector<MapRule> rules_;
  RuleSet set_;
  std::optional<DesignFamily<PlainDesign>> plain_family_;
  std::optional<DesignFamily<DrivenDesign>> driven_family_;  // if there is no plain one
  numerics::DesignPeakOptions
      search_;                 // for a family: over all frequencies if there are no-peak rules, else over the band
  bool beyond_band_ = false;   // search_ also finds amplitudes outside the band
  bool counts_modes_ = false;  // natural frequencies may cross the band of the amplitudes between designs
  std::mutex noting_;          // guards the report
  EvaluationReport report_;
  std::atomic<std::size_t> assembled_separately_ = 0;
  MissingReasons missing_;
};

}  // namespace trivet::design
