// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "trivet/numerics/search/max_min.h"
#include "trivet/study/family/design_batch.h"
#include "trivet/study/family/design_space.h"
#include "trivet/study/family/objectives.h"
#include "trivet/study/family/requirement_slopes.h"
#include "trivet/study/optimize/evaluation_counts.h"
#include "trivet/study/requirements/peak_absence.h"
#include "trivet/study/requirements/verdict.h"

namespace trivet::study {

/// The margins of a project's requirements as smooth functions of its parameters, for a search: ln(margin) of every
/// maximum, mode or value that may decide, each in a place of its own.
class DesignObjective {
 public:
  /// With how much effort requirements on steady motion are judged.
  enum class Effort : std::uint8_t {
    complete,
    quick  ///< upper bounds of the margins: motions that are not connected are not sought
  };
  /// What margins have to keep for what differs from machine to machine: ln(margin) per case and requirement that is
  /// not minimised, in the order of the results; empty: nothing.
  using Reserves = std::vector<std::vector<double>>;
  /// @throws foundation::InvalidInput if there is nothing to meet or to minimise, NotComputable if a requirement cannot
  /// be judged
  DesignObjective(const project::Project& project, const project::OptimizeRequest& request, Reserves reserves = {},
                  Effort effort = Effort::complete);

  [[nodiscard]] const DesignSpace& space() const { return space_; }
  [[nodiscard]] const std::vector<const project::Case*>& cases() const { return cases_; }

  using Place = ResultPlace;
  [[nodiscard]] const std::vector<Place>& places() const { return places_; }
  [[nodiscard]] const std::vector<bool>& is_objective() const { return is_objective_; }

  /// ln(margin) without its reserve at the places, at most `most`, or `unlimited`; designs without a model have
  /// `unusable` everywhere. If nothing but peaks could limit a case, and it has none, their places are above `most` by
  /// how far they are gone.
  /// @param ignored  a requirement that counts as met
  void evaluate(const Eigen::VectorXd& shares, Eigen::VectorXd& values, Eigen::MatrixXd* slopes,
                const std::optional<Place>& ignored = std::nullopt) const;
  static constexpr double most = 30, unlimited = 60, unusable = -30;
  /// Values further above the least objective, or constraints further above 0, have no slopes.
  static constexpr double far = 5;

  /// The requirements of one case at a design, with what is minimised.
  [[nodiscard]] std::vector<RequirementResult> results(std::size_t result_case, const model::System& system) const;
  /// The reserve of a requirement; 0 of what is minimised.
  [[nodiscard]] double reserve(const Place& place) const;
  [[nodiscard]] const Objectives& minimized() const { return minimized_; }
  /// Where curves without a peak are nearest to one, at a design that nothing else limits: per result, the nearest
  /// place.
  [[nodiscard]] std::vector<std::optional<AbsentPeak>> absent_peaks_at(std::size_t result_case,
                                                                       const model::System& system) const;
  /// The results at the given design.
  [[nodiscard]] const std::vector<std::vector<RequirementResult>>& given() const { return given_; }
  /// "machine.z ≤ 1 mm", or "the largest amplitude of machine.z"
  [[nodiscard]] std::string words(const Place& place) const;
  [[nodiscard]] std::string words_for_people(const Place& place) const;

  /// The cases as families, in which many designs are judged without their models; fitted when first needed.
  [[nodiscard]] const std::vector<DesignBatch>& families() const;

  /// Is a design judged by following branches of steady motions? Then it takes long, and its slopes longer.
  [[nodiscard]] bool is_expensive() const;
  /// The same with upper bounds of the margins that take a small part of the time; nullptr if there are none.
  [[nodiscard]] const DesignObjective* quick() const { return quick_.get(); }

  /// Of designs judged by this objective, also by `quick`.
  [[nodiscard]] EvaluationCounts counts() const;
  /// Adds those of another process.
  void add(const EvaluationCounts& of_others) const;
  /// Kinds of requirements without exact slopes.
  [[nodiscard]] std::vector<std::string> differenced() const;

 private:
  /// The places of one requirement that have slopes.
  struct Smooth {
    std::vector<RequirementResult::Candidate> candidates;
    std::vector<Eigen::Index> rows;  ///< of the values
    [[nodiscard]] double least(const Eigen::VectorXd& values) const;
    /// Drops values far above the least objective, or above 0: no step reaches them.
    void keep_near(const Eigen::VectorXd& values, const std::vector<bool>& is_objective, double least_objective);
  };
  static Smooth set_values(const RequirementResult& result, Eigen::Index place, Eigen::VectorXd& values);
  /// True if the slopes of a requirement are differences of its values in neighbouring designs.
  [[nodiscard]] bool is_differenced(std::size_t c, std::size_t r) const;
  /// Slopes of what is near deciding, per unit of the axes.
  void set_slopes(std::size_t c, const RequirementSlopes& exact, const std::vector<RequirementResult>& found,
                  const std::vector<Smooth>& smooth, Eigen::MatrixXd& slopes, EvaluationCounts& counts) const;
  /// A curve that is to have no peak, near to having one.
  struct Absence {
    std::size_t result = 0;
    Eigen::Index row = 0;  ///< of the values
    AbsentPeak place;
  };
  [[nodiscard]] std::vector<Absence> set_absences(std::size_t c, const CaseContext& context,
                                                  const std::vector<RequirementResult>& found, Eigen::Index first,
                                                  const std::optional<Place>& ignored, Eigen::VectorXd& values) const;
  static void add_absences(const std::vector<Absence>& absences, const std::vector<RequirementResult>& found,
                           const DesignNeighbours& neighbours, double reference, Eigen::MatrixXd& slopes);
  void add_differences(std::size_t c, const std::vector<RequirementResult>& found, const std::vector<Smooth>& smooth,
                       const DesignNeighbours& neighbours, Eigen::MatrixXd& slopes, EvaluationCounts& counts) const;
  void evaluate_case(std::size_t c, const Eigen::VectorXd& shares, Eigen::Index first, Eigen::VectorXd& values,
                     Eigen::MatrixXd* slopes, const std::optional<Place>& ignored, EvaluationCounts& counts) const;

  [[nodiscard]] bool has_quick(Effort effort) const;

  DesignSpace space_;
  Objectives minimized_;
  Reserves reserves_;
  std::unique_ptr<const DesignObjective> quick_;
  std::vector<const project::Case*> cases_;
  std::vector<project::Analyses> requests_;                  ///< per case: requirements with the objectives
  std::vector<project::Analyses> differenced_requirements_;  ///< those without exact slopes
  std::vector<double> references_;  ///< per case: lowest natural frequency of the given design, for peaks that are gone
  std::vector<std::vector<RequirementResult>> given_;
  std::vector<std::vector<std::size_t>> width_;  ///< per case and result: its places
  std::vector<Place> places_;
  std::vector<bool> is_objective_;
  mutable std::once_flag fitting_;
  mutable std::vector<DesignBatch> families_;
  mutable std::mutex noting_;
  mutable EvaluationCounts counts_;
  struct Known {
    Eigen::VectorXd values;
    EvaluationCounts counts;
  };
  mutable std::map<std::vector<double>, Known> known_;  ///< by shares, of designs that take long
};

}  // namespace trivet::study
