// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/modal/modes.h"
#include "trivet/modal/roots.h"
#include "trivet/nonlinear/modes/backbone.h"
#include "trivet/nonlinear/rest/rest_position.h"
#include "trivet/project/project.h"
#include "trivet/response/machinery/deflection_shape.h"
#include "trivet/response/machinery/limit_line.h"
#include "trivet/response/machinery/load_sharing.h"
#include "trivet/response/machinery/power.h"
#include "trivet/response/steady/curve_model.h"
#include "trivet/response/steady/deep_check.h"
#include "trivet/response/steady/frequency_response.h"
#include "trivet/response/steady/peaks.h"
#include "trivet/response/steady/static_response.h"
#include "trivet/response/transient/earthquake.h"
#include "trivet/study/analyses/analysis_results.h"
#include "trivet/study/analyses/load_case.h"
#include "trivet/study/analyses/measurement_comparison.h"
#include "trivet/study/map/design_map.h"
#include "trivet/study/requirements/verdict.h"

namespace trivet::study {

class SolvedCase;
struct DesignFront;
struct Optimization;
struct Sample;

struct ResponseResult {
  response::FrequencyResponse curves;
  std::vector<Eigen::VectorXd> phase;  ///< per curve [rad]
  response::DeepCheck deep;
  assembly::Band band;
  assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement;
  /// Without given frequencies: a model of the curves between those of the table, their extrema, and whether phases are
  /// continuous.
  std::optional<response::CurveModel> model;
  std::vector<std::vector<response::Extremum>> extrema;
  bool continuous_phase = false;
};

struct PeaksResult {
  response::Peaks peaks;
  double min_prominence = 0;
  double peak_tolerance = 0;
};

/// A limit with the largest amplitude of its curve, in the band and at all frequencies.
struct LimitResult {
  std::string name;
  std::string unit;
  double limit = 0;
  double in_band = 0;
  double in_band_at = 0;  ///< [rad/s]
  double anywhere = 0;
  bool met = true;  ///< in_band ≤ limit, see design::on_the_limit
};

struct LimitLineResult {
  std::string of;
  assembly::LimitLine line;
  /// Of a line over bands: one margin per band at its nominal midband frequency; exceeded bands from edge to edge.
  response::LimitComparison comparison;
  std::vector<excitation::FrequencyBand> bands = {};  ///< empty: a line over the response
  std::string source = {};                            ///< of a named line
};

struct CaseResults {
  std::string case_name;
  std::vector<std::string> changes;
  project::DisplayUnits display;  ///< of its tables and pictures
  foundation::Problems warnings;  ///< of data, modes and roots: they concern every result
  std::vector<std::string> free_motions;
  std::vector<std::string> notes;  ///< directions of nodes that are left out
  modal::Modes modes;
  int lowest_modes = 0;  ///< if not 0, only so many modes are there
  modal::Roots roots;    ///< empty unless requested
  std::optional<ResponseResult> response;
  std::optional<PeaksResult> peaks;
  std::optional<response::StaticResponse> statics;
  std::optional<response::LoadSharing> load_sharing;
  std::vector<nonlinear::RestState> rest_states;  ///< if all were requested
  std::vector<LimitLineResult> limit_lines;
  std::vector<MeasurementComparison> measurements;
  std::vector<LimitResult> limits;
  std::optional<CaseVerdict> verdict;                ///< on the requirements of the file, if a run judges them
  std::optional<LoadCase> load_case;                 ///< for the envelope of a run with several cases
  std::optional<DesignMap> map;                      ///< map of the base model, if a run computes it
  std::vector<DesignMap> map_pairs;                  ///< instead of it, the maps of several pairs of parameters
  std::shared_ptr<const Optimization> optimization;  ///< of the base model, if the file has [analyses.optimize]
  std::shared_ptr<const DesignFront> front;          ///< the same with `front`
  std::shared_ptr<const Sample> sample;              ///< of the base model, if the file has [analyses.sample]
  std::vector<std::string> failures;                 ///< requests that could not be computed, with the reason
  // Those of analysis_table.h:
  std::optional<OperationResult> operation;
  std::optional<RandomResult> random;
  std::optional<TransientResult> transient;
  std::optional<OrdersResult> orders;
  std::optional<TransmissibilityResult> transmissibility;
  std::optional<response::PowerFlow> power, power_at;  ///< over the band; at single frequencies, if they are requested
  std::optional<std::vector<response::DeflectionShape>> shapes;
  std::optional<nonlinear::SteadyBranch> steady;
  std::optional<std::vector<nonlinear::Backbone>> backbone;
  std::optional<std::vector<ShockSpectrumResult>> shock_spectrum;
  std::optional<response::EarthquakeResponse> earthquake;
};

/// Computes everything that `analyses` requests of a case; failures are listed in `failures` and in the warnings, the
/// rest is computed. `analyses` may differ from the case's own (a single result from the command line).
/// @param solved  the model of the case, if it is solved already
[[nodiscard]] CaseResults case_results(const project::Case& variant, const project::Analyses& analyses,
                                       const foundation::Progress& progress = {},
                                       const std::shared_ptr<const SolvedCase>& solved = nullptr);

/// The modes, warnings and notes of a case that belong to every result of these analyses, without their results.
[[nodiscard]] CaseResults notices(const project::Case& variant, const project::Analyses& analyses,
                                  const std::shared_ptr<const SolvedCase>& solved);

/// Compares the fast solver with a second one at up to 64 frequencies over the band of the case, under its harmonic
/// forces, or under a force on every coordinate if it has none.
[[nodiscard]] response::DeepCheck deep_check(const project::Case& variant);

/// Limits and limit lines that no requirement of the case judges, over the band of the response. A requirement may have
/// another band; it then decides alone, also where requirements are not binding.
[[nodiscard]] std::vector<const LimitResult*> limits_alone(const CaseResults& results);
[[nodiscard]] std::vector<const LimitLineResult*> limit_lines_alone(const CaseResults& results);
/// The same of lines over bands at the speeds of the machine.
[[nodiscard]] std::vector<const OperatingLine*> operating_lines_alone(const CaseResults& results);

/// Does a connected curve of motions, or a nonlinear mode, end before the end that was requested? Its warning states
/// where and why.
[[nodiscard]] bool is_cut_short(const CaseResults& results);

}  // namespace trivet::study
