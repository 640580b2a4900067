// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "trivet/design/missing_reasons.h"
#include "trivet/study/map/design_evaluation.h"
#include "trivet/study/map/map_requirements.h"

namespace trivet::study {

/// Judges designs by all rules of a map: limits and peaks of many designs at once, the other requirements design by
/// design, both in the case of the map and in those of `hold_in`.
class MapJudge {
 public:
  /// @throws foundation::NotComputable if the rules cannot be evaluated
  MapJudge(const project::Project& project, const project::Case& variant, const project::MapRequest& request,
           const design::EvaluationOptions& options);

  [[nodiscard]] const std::vector<design::MapRule>& rules() const { return rules_; }

  /// Outcomes of designs 0 … count − 1, the same for any number of threads.
  [[nodiscard]] std::vector<design::DesignOutcome> evaluate(
      std::size_t count, const std::function<design::DesignPoint(std::size_t)>& point,
      const foundation::Progress& progress);

  /// Does a model have the same Z(ω) and load as the design at this point?
  [[nodiscard]] bool is_at(const model::System& system, const design::DesignPoint& point) const;

  /// One model judged in the case of the map. If it is a design, then also that design in the cases of `hold_in`; other
  /// models have no values there.
  [[nodiscard]] design::JudgedDesign judged_design(const model::System& system,
                                                   const std::optional<design::DesignPoint>& design) const;

  [[nodiscard]] design::EvaluationReport report() const;
  [[nodiscard]] foundation::Problems warnings() const;

 private:
  /// One case with its rules.
  struct Part {
    Part(const project::Case& of_case, project::MapRequest requested, const design::EvaluationOptions& options);
    const project::Case& variant;
    const project::MapRequest request;
    DesignEvaluation evaluation;  ///< limits and peaks
    MapRequirements requirements;
    std::size_t first_rule = 0;
    [[nodiscard]] std::size_t first_requirement() const { return first_rule + evaluation.rules().size(); }
  };
  using Outcomes = std::vector<design::DesignOutcome>;
  using Points = std::vector<design::DesignPoint>;
  void add_part(const project::Case& variant, const project::MapRequest& request,
                const design::EvaluationOptions& options);
  /// A case of `hold_in`. @throws foundation::NotComputable  naming the case
  void add_further(const project::Case& variant, const project::MapRequest& request,
                   const design::EvaluationOptions& options);
  enum class Kinds { frequencies, others };  // natural frequencies, judged for many designs at once; all others
  void judge_frequencies(const Part& part, const Points& points, Outcomes& outcomes);
  void judge_separately(const Part& part, std::size_t index, const design::DesignPoint& point, Kinds kinds,
                        design::DesignOutcome& outcome);
  static void append(const Part& part, const model::System& system, design::JudgedDesign& result);

  std::vector<std::unique_ptr<Part>> parts_;
  std::vector<design::MapRule> rules_;
  foundation::Problems warnings_;
  int threads_ = 0;
  std::atomic<std::size_t> separately_ = 0;
  design::MissingReasons missing_;
};

}  // namespace trivet::study
