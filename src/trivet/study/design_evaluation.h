// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "trivet/numerics/design_peaks.h"
#include "trivet/response/design_family.h"
#include "trivet/response/design_rules.h"
#include "trivet/study/project.h"

namespace trivet::study {

/// One rule of a map in words.
struct MapRule {
  response::DesignRule::Kind kind = response::DesignRule::Kind::amplitude;
  std::string answer;    ///< "aggregate.rz"
  std::string unit;      ///< of the answer, SI
  double allowed = 0;    ///< amplitude [SI], or relative prominence
  std::string words;     ///< "aggregate.rz ≤ 0.08 rad", "no peak of aggregate.rz"
};

/// Values of the two parameters, in the units of the axes.
struct DesignPoint {
  double x = 0, y = 0;
};

/// All that a map keeps of a design.
struct DesignOutcome {
  static constexpr std::uint8_t no_model = 255, not_computed = 254;
  static constexpr std::size_t most_rules = 250;
  float margin = 0;             ///< of the governing rule, 1 on its limit; 0 without a model
  std::uint8_t governing = 0;   ///< the rule with the least margin, or one of the two above

  [[nodiscard]] bool known() const { return governing < not_computed; }
  [[nodiscard]] bool kept() const { return known() && margin >= 1; }
};

/// Why some designs have no outcome, as often as it was met.
struct MissingReason {
  std::uint8_t outcome = DesignOutcome::no_model;
  std::string words;            ///< with the figures of the first such design
  std::size_t designs = 0;
  std::size_t first = 0;        ///< index of that design
};

/// One design with everything that was found.
struct JudgedDesign {
  std::vector<double> values;   ///< of the rules, see response::rule_values
  response::Governing governing;
  response::Peaks peaks;        ///< of the answers that have rules
};

/// How designs were evaluated, for the reader.
struct EvaluationReport {
  std::size_t in_lanes = 0;     ///< designs judged by poles and residues, many at once
  std::size_t one_by_one = 0;   ///< designs assembled from the changed project and searched by themselves
  std::string family;           ///< how the matrices of the first were found, or why there are none
  std::vector<MissingReason> missing;

  [[nodiscard]] std::string words() const;
};

/// The designs of a case when two of its numbers change.
class DesignEvaluation {
 public:
  struct Options {
    int threads = 0;            ///< 0: as many as the machine has
    bool fast = true;           ///< false: every design assembled and searched by itself
  };

  /// @throws foundation::NotComputable if the rules cannot be asked of this case
  DesignEvaluation(const Case& variant, const MapRequest& request) : DesignEvaluation(variant, request, Options()) {}
  DesignEvaluation(const Case& variant, const MapRequest& request, const Options& options);

  [[nodiscard]] const std::vector<MapRule>& rules() const { return rules_; }

  /// Outcomes of designs 0 … count − 1, the same for any number of threads. What has none adds to the report.
  [[nodiscard]] std::vector<DesignOutcome> evaluate(std::size_t count, const std::function<DesignPoint(std::size_t)>& point,
                                                    const foundation::Progress& progress = {});

  /// Is a model the design at this point: does it answer with the same Z(ω) and load?
  [[nodiscard]] bool is_at(const model::System& system, const DesignPoint& point) const;

  /// A model by response::peaks. @throws foundation::NotComputable, InvalidInput
  [[nodiscard]] JudgedDesign judged(const model::System& system) const;

  [[nodiscard]] const EvaluationReport& report() const { return report_; }

 private:
  struct Answer {
    std::string name;
    assembly::Quantity quantity = assembly::Quantity::displacement;
  };
  [[nodiscard]] std::size_t channel_of(const std::string& name, assembly::Quantity quantity);
  [[nodiscard]] std::vector<assembly::Channel> channels(const model::System& system, const assembly::Assembled& assembled) const;
  [[nodiscard]] foundation::Expected<model::System> system_at(const DesignPoint& point) const;
  [[nodiscard]] DesignOutcome assembled_outcome(std::size_t index, const DesignPoint& point);
  void fit_family(const Case& variant);
  void plan_searches();
  /// Of designs first … : outcomes in lanes; where they are not proven, one by one.
  void evaluate_in_lanes(std::size_t first, const std::vector<DesignPoint>& points, DesignOutcome* outcomes);
  void note_missing(std::size_t index, std::uint8_t outcome, const std::string& kind, const std::string& words);

  const Case& case_;
  const MapRequest& request_;
  Options options_;
  std::vector<std::string> x_keys_, y_keys_;
  std::vector<Answer> answers_;
  std::vector<MapRule> rules_;
  response::RuleSet set_;
  std::optional<response::DesignFamily> family_;
  std::vector<numerics::DesignPeakOptions> searches_;  // of the family: amplitudes in the band, peaks anywhere
  std::vector<std::pair<std::size_t, Eigen::Index>> place_of_rule_;  // which search, and the channel in it
  EvaluationReport report_;
  std::vector<std::string> missing_kinds_;   // of report_.missing
};

}  // namespace trivet::study
