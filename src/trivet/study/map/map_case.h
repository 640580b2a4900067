// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/design/design_outcome.h"
#include "trivet/project/model_number.h"
#include "trivet/project/project.h"
#include "trivet/study/family/design_batch.h"
#include "trivet/study/map/piece_report.h"

namespace trivet::study {

/// One case with the rules of a map: its own limits and peaks, then the requirements. Limits, peaks and natural
/// frequencies are judged for many designs at once where that is possible, all others design by design.
class MapCase {
 public:
  /// @param further  a case of `hold_in`: its name is part of the words
  /// @throws foundation::NotComputable if the rules cannot be evaluated for this case
  MapCase(const project::Case& variant, project::MapRequest request, const design::EvaluationOptions& options,
          bool further);

  [[nodiscard]] const std::string& name() const { return case_.name; }
  [[nodiscard]] const std::vector<design::MapRule>& rules() const { return rules_; }

  /// Designs that one thread judges in a row.
  [[nodiscard]] std::size_t piece() const;

  /// Margins of designs first …, designs × rules. A design that has none has an outcome that says so, and the report
  /// its reason. Outcomes also count the natural frequencies in the case of the map.
  [[nodiscard]] PieceReport judge(std::size_t first, const std::vector<design::DesignPoint>& points,
                                  Eigen::Ref<Eigen::ArrayXXd> margins, design::DesignOutcome* outcomes) const;
  /// Do kernels judge all rules of most designs, in microseconds each?
  [[nodiscard]] bool is_quick() const { return has_family() && own() + at_once_ == rules_.size(); }

  /// Does a model have the same Z(ω) and load as the design at this point?
  [[nodiscard]] bool is_at(const model::System& system, const design::DesignPoint& point) const;
  [[nodiscard]] foundation::Expected<model::System> system_at(const design::DesignPoint& point) const;

  /// Adds values and margins of all rules from a model. @throws foundation::NotComputable, InvalidInput
  void add_judged(const model::System& system, design::JudgedDesign& result) const;

  /// How designs were judged. @param judged  the reports of all of them
  [[nodiscard]] design::EvaluationReport report(const PieceReport& judged) const;
  /// What the judgement of the model itself warns of.
  [[nodiscard]] const foundation::Problems& warnings() const { return warnings_; }

 private:
  struct NamedChannel {
    std::string name;
    assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement;
  };
  [[nodiscard]] bool has_family() const { return batch_ && batch_->reason().empty(); }
  [[nodiscard]] std::size_t own() const { return set_.rules.size(); }
  [[nodiscard]] std::vector<RequirementResult> add_own_rules();
  [[nodiscard]] std::size_t channel_of(const std::string& name, assembly::MotionQuantity quantity);
  void fit_batch(const std::vector<RequirementResult>& results);
  [[nodiscard]] std::vector<RequirementResult> requirements(const model::System& system,
                                                            foundation::Problems& warnings) const;
  /// Own limits and peaks of a model, by response::peaks.
  [[nodiscard]] design::JudgedDesign own_rules(const model::System& system) const;
  void count_mode(double squared, design::DesignOutcome& outcome) const;
  using Margins = Eigen::Ref<Eigen::ArrayXXd>;
  /// NaN where the kernels prove nothing; if that is one of the own rules of a design, in all of them.
  void judge_at_once(const std::vector<design::DesignPoint>& points, Margins margins, design::DesignOutcome* outcomes,
                     PieceReport& report) const;
  /// The rules of a design, row d, that have no margin yet.
  void judge_from_model(std::size_t index, const design::DesignPoint& point, Margins margins, Eigen::Index d,
                        design::DesignOutcome& outcome, PieceReport& report) const;

  const project::Case& case_;
  const project::MapRequest request_;
  const std::string of_case_;  ///< " in case \"soft\""; empty for the case of the map
  project::ModelNumber x_, y_;
  std::vector<NamedChannel> channels_;
  std::vector<design::MapRule> rules_;
  design::RuleSet set_;         ///< own limits and peaks
  project::Analyses required_;  ///< requirements alone
  std::size_t at_once_ = 0;     ///< number of the last rules, on natural frequencies, that the batch judges
  std::optional<DesignBatch> batch_;
  bool counts_modes_ = false;  ///< natural frequencies may cross the band of the amplitudes between designs
  foundation::Problems warnings_;
  std::string no_family_;  ///< why designs are not judged many at once; otherwise empty
};

}  // namespace trivet::study
