// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <any>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/modal/modes.h"
#include "trivet/modal/roots.h"
#include "trivet/project/project.h"
#include "trivet/response/machinery/limit_line.h"
#include "trivet/response/machinery/load_sharing.h"
#include "trivet/response/steady/curve_model.h"
#include "trivet/response/steady/deep_check.h"
#include "trivet/response/steady/frequency_response.h"
#include "trivet/response/steady/peaks.h"
#include "trivet/response/steady/static_response.h"
#include "trivet/study/design_map.h"

/// Answers to what a project asks, case by case.
namespace trivet::study {

struct ResponseAnswer {
  response::FrequencyResponse curves;
  std::vector<Eigen::VectorXd> phase;  ///< per curve [rad]
  response::DeepCheck deep;
  response::Band band;
  assembly::Quantity quantity = assembly::Quantity::displacement;
  /// Where no frequencies were asked for: the curves between those of the table, their extrema, and whether phases are
  /// continuous.
  std::optional<response::CurveModel> model;
  std::vector<std::vector<response::Extremum>> extrema;
  bool continuous_phase = false;
};

struct PeaksAnswer {
  response::Peaks peaks;
  double min_prominence = 0;
  double peak_tolerance = 0;
};

/// A limit and the largest amplitude of its curve in the band and anywhere.
struct LimitAnswer {
  std::string name;
  std::string unit;
  double limit = 0;
  double in_band = 0;
  double in_band_at = 0;  ///< [rad/s]
  double anywhere = 0;
  bool kept = true;  ///< in_band ≤ limit, see response::on_the_limit
};

struct LimitLineResult {
  std::string of;
  response::LimitLine line;
  response::LimitComparison comparison;
};

struct Answers {
  std::string case_name;
  std::vector<std::string> changes;
  foundation::Problems warnings;  ///< of data, modes and roots: they belong to every answer
  std::vector<std::string> free_motions;
  modal::Modes modes;
  modal::Roots roots;
  std::optional<ResponseAnswer> response;
  std::optional<PeaksAnswer> peaks;
  std::optional<response::StaticResponse> statics;
  std::optional<response::LoadSharing> load_sharing;
  std::vector<LimitLineResult> limit_lines;
  std::vector<LimitAnswer> limits;
  std::optional<DesignMap> map;       ///< of the base model, where a run computes it
  std::vector<std::string> failures;  ///< what was asked for and could not be computed, and why
  std::map<std::string, std::any>
      of_questions;  ///< answers to the questions of project/analyses/question_table.h, by name

  /// The answer to such a question, whose type is that of its NAME_answer.cpp; none if there is no such answer. @throws
  /// std::bad_any_cast for another type
  template <typename Answer>
  [[nodiscard]] const Answer* find(const std::string& question) const {
    const auto found = of_questions.find(question);
    return found == of_questions.end() ? nullptr : &std::any_cast<const Answer&>(found->second);
  }
};

/// Everything a case asks for; what cannot be computed is listed in `failures` and in the warnings, the rest goes on.
/// `analyses` may differ from the case's own (a single answer from the command line).
[[nodiscard]] Answers answers(const project::Case& variant, const project::Analyses& analyses,
                              const foundation::Progress& progress = {});

/// The fast solver against a second one at 64 frequencies over the band of the case, under its harmonic forces, or
/// under a force on every coordinate if it has none.
[[nodiscard]] response::DeepCheck deep_check(const project::Case& variant);

}  // namespace trivet::study
