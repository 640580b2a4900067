// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "trivet/study/map/map_case.h"
#include "trivet/study/map/piece_report.h"
#include "trivet/study/shared/shared_work.h"

namespace trivet::study {

/// Judges designs by all rules of a map, in the case of the map and in those of `hold_in`.
class MapJudge {
 public:
  /// @param shared  judges designs together with other processes where each takes milliseconds; null: alone
  /// @throws foundation::NotComputable if the rules cannot be evaluated
  MapJudge(const project::Project& project, const project::Case& variant, const project::MapRequest& request,
           const design::EvaluationOptions& options, SharedWork* shared = nullptr);

  [[nodiscard]] const std::vector<design::MapRule>& rules() const { return rules_; }

  /// Outcomes of designs 0 … count − 1, the same for any number of threads.
  [[nodiscard]] std::vector<design::DesignOutcome> evaluate(
      std::size_t count, const std::function<design::DesignPoint(std::size_t)>& point,
      const foundation::Progress& progress);

  /// Does a model have the same Z(ω) and load as the design at this point?
  [[nodiscard]] bool is_at(const model::System& system, const design::DesignPoint& point) const {
    return cases_.front()->is_at(system, point);
  }

  /// One model judged in the case of the map. If it is a design, then also that design in the cases of `hold_in`; other
  /// models have no values there.
  [[nodiscard]] design::JudgedDesign judged_design(const model::System& system,
                                                   const std::optional<design::DesignPoint>& design) const;

  [[nodiscard]] design::EvaluationReport report() const;
  [[nodiscard]] foundation::Problems warnings() const;

 private:
  void add_case(const project::Case& variant, const project::MapRequest& request,
                const design::EvaluationOptions& options);
  /// A case of `hold_in`. @throws foundation::NotComputable  naming the case
  void add_further(const project::Case& variant, const project::MapRequest& request,
                   const design::EvaluationOptions& options);

  /// Designs in a row, with a report of each case.
  struct Piece {
    std::vector<design::DesignOutcome> outcomes;
    std::vector<PieceReport> reports;

    [[nodiscard]] std::string text() const;
    [[nodiscard]] static Piece of_text(const std::string& text);
  };
  [[nodiscard]] Piece judged(std::size_t first, const std::vector<design::DesignPoint>& points) const;

  std::vector<std::unique_ptr<MapCase>> cases_;
  std::vector<design::MapRule> rules_;  ///< of all cases
  std::vector<PieceReport> reports_;    ///< of each case
  foundation::Problems warnings_;
  int threads_ = 0;
  SharedWork* shared_ = nullptr;
};

}  // namespace trivet::study
