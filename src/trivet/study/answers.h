// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/excitation/shock_spectrum.h"
#include "trivet/foundation/interruption.h"
#include "trivet/modal/modes.h"
#include "trivet/modal/roots.h"
#include "trivet/project/project.h"
#include "trivet/response/machinery/campbell.h"
#include "trivet/response/machinery/deflection_shape.h"
#include "trivet/response/machinery/load_sharing.h"
#include "trivet/response/machinery/power.h"
#include "trivet/response/machinery/run_up.h"
#include "trivet/response/random/random_response.h"
#include "trivet/response/steady/curve_model.h"
#include "trivet/response/steady/deep_check.h"
#include "trivet/response/steady/frequency_response.h"
#include "trivet/response/steady/peaks.h"
#include "trivet/response/steady/static_response.h"
#include "trivet/response/transient/earthquake.h"
#include "trivet/response/transient/transient.h"
#include "trivet/study/design_map.h"

/// Answers to what a project asks, case by case.
namespace trivet::study {

struct ResponseAnswer {
  response::FrequencyResponse curves;
  std::vector<Eigen::VectorXd> phase;   ///< per curve [rad]
  response::DeepCheck deep;
  response::Band band;
  assembly::Quantity quantity = assembly::Quantity::displacement;
  /// Where no frequencies were asked for: the curves between those of the table, their extrema, and whether phases are continuous.
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
  double in_band_at = 0;   ///< [rad/s]
  double anywhere = 0;
  bool kept = true;        ///< in_band ≤ limit, see response::on_the_limit
};

/// √Σ (k a_w)² over the axes that people feel, of one body or point. [ISO 2631-1:1997 section 8.2]
struct TotalValue {
  std::string name;
  double value = 0;                ///< [m/s²]
  std::vector<std::string> axes;   ///< "x" … "rz": x, y, z, and the rotations that were asked for and have a factor at this contact
};

struct RandomResult {
  response::RandomResponse response;
  response::RandomCurves curves;   ///< densities [unit²/(rad/s)]
  std::vector<std::string> inputs; ///< of the variance shares
  std::vector<TotalValue> total_values;   ///< where a contact with people is given
  assembly::Quantity quantity = assembly::Quantity::displacement;
};

struct TransientResult {
  response::TransientResponse response;
  assembly::Quantity quantity = assembly::Quantity::displacement;
};

struct OrdersResult {
  response::RunUp run_up;
  response::Campbell campbell;
  assembly::Quantity quantity = assembly::Quantity::displacement;
};

struct TransmissibilityResult {
  std::string words;               ///< "force on the ground over engine", "motion over a motion of the ground along z"
  response::FrequencyResponse curves;
  response::Peaks peaks;
  std::vector<response::Crossover> crossovers;
  response::Band band;
  bool of_force = false;           ///< forces on the ground, in total and of each mount; else motions

  /// The force of one of several mounts over the whole exciting force: a share, which says nothing of isolation.
  [[nodiscard]] bool is_share(std::size_t curve) const {
    return of_force && curve > 0 && curves.curves.size() > 2;
  }
};

/// Of one time excitation, over natural frequencies.
struct ShockSpectrumResult {
  std::string excitation;
  std::string unit;                ///< of the spectrum: m/s²
  double damping_ratio = 0;
  std::vector<excitation::ShockResponse> spectrum;
};

struct LimitLineResult {
  std::string of;
  response::LimitLine line;
  response::LimitComparison comparison;
};

struct Answers {
  std::string case_name;
  std::vector<std::string> changes;
  foundation::Problems warnings;       ///< of data, modes and roots: they belong to every answer
  std::vector<std::string> free_motions;
  modal::Modes modes;
  modal::Roots roots;
  std::optional<ResponseAnswer> response;
  std::optional<PeaksAnswer> peaks;
  std::optional<response::StaticResponse> statics;
  std::optional<response::LoadSharing> load_sharing;
  std::optional<RandomResult> random;
  std::optional<TransientResult> transient;
  std::optional<OrdersResult> orders;
  std::optional<TransmissibilityResult> transmissibility;
  std::optional<response::PowerFlow> power;
  std::vector<response::DeflectionShape> shapes;
  std::vector<ShockSpectrumResult> shock_spectra;
  std::optional<response::EarthquakeResponse> earthquake;
  std::vector<LimitLineResult> limit_lines;
  std::vector<LimitAnswer> limits;
  std::optional<DesignMap> map;        ///< of the base model, where a run computes it
  std::vector<std::string> failures;   ///< what was asked for and could not be computed, and why
};

/// Everything a case asks for; what cannot be computed is listed in `failures` and in the warnings, the rest goes on.
/// `analyses` may differ from the case's own (a single answer from the command line).
[[nodiscard]] Answers answers(const project::Case& variant, const project::Analyses& analyses, const foundation::Progress& progress = {});

/// The fast solver against a second one at 64 frequencies over the band of the case, under its harmonic forces, or under a
/// force on every coordinate if it has none.
[[nodiscard]] response::DeepCheck deep_check(const project::Case& variant);

}  // namespace trivet::study
