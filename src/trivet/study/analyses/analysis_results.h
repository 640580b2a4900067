// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/design/design_rules.h"
#include "trivet/excitation/shock_spectrum.h"
#include "trivet/nonlinear/branch/steady_branch.h"
#include "trivet/project/analyses/analysis_types.h"
#include "trivet/response/machinery/run_up.h"
#include "trivet/response/machinery/transmissibility.h"
#include "trivet/response/random/random_bands.h"
#include "trivet/response/random/random_response.h"
#include "trivet/response/steady/frequency_grid.h"
#include "trivet/response/steady/frequency_response.h"
#include "trivet/response/steady/peaks.h"
#include "trivet/response/transient/transient.h"
#include "trivet/study/analyses/operation_types.h"

namespace trivet::study {

class CaseContext;

/// Share of the highest peak of the same result above which tables for people list a critical speed.
inline constexpr double listed_height = 0.01;

struct OrdersResult {
  response::RunUp run_up;
  response::Campbell campbell;
  assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement;
  std::vector<std::vector<OperatingValue>> at = {};  ///< every result at single speeds, if they are requested
};

/// Vibration total value √Σ (k a_w)² of one body or point, over the axes with a factor k. [ISO 2631-1:1997 section 8.2]
struct TotalValue {
  std::string name;
  double value = 0;  ///< [m/s²]
  std::vector<std::string>
      axes;  ///< "x" … "rz": x, y, z, and the requested rotations that have a factor at this contact
};

struct RandomResult {
  response::RandomResponse response;
  response::RandomCurves curves;         ///< densities [unit²/(rad/s)]
  std::vector<std::string> inputs;       ///< inputs of the variance shares
  std::vector<TotalValue> total_values;  ///< if a contact with people is given
  std::optional<response::RandomBands> bands;
  assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement;
};

/// Shock response spectrum of one time excitation.
struct ShockSpectrumResult {
  std::string excitation;
  std::string unit;  ///< of the spectrum: m/s²
  double damping_ratio = 0;
  std::vector<excitation::ShockResponse> spectrum;
};

struct TransientResult {
  response::TransientResponse response;
  assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement;
};

struct TransmissibilityResult {
  std::string words;  ///< "force on the ground over engine", "motion over a motion of the ground along z"
  response::FrequencyResponse curves;
  response::Peaks peaks;
  std::vector<response::Crossover> crossovers;
  assembly::Band band;
  std::vector<design::LargestAmplitude> in_band;  ///< per curve
  bool of_force = false;                ///< forces on the ground, in total and of each mount; otherwise motions
  response::FrequencyResponse at = {};  ///< the same curves at single frequencies, if they are requested

  /// True for the force of one of several mounts over the whole exciting force: a share, not a measure of isolation.
  [[nodiscard]] bool is_share(std::size_t curve) const { return of_force && curve > 0 && curves.curves.size() > 2; }
};

/// Computes what happens at the speeds of the machine.
/// @throws foundation::NotComputable if nothing runs at a speed, foundation::InvalidInput for an unknown result
[[nodiscard]] OperationResult operation_result(const CaseContext& context, const project::OperationAnalysis& request,
                                               foundation::Problems& warnings);

/// Largest magnitude over the band of the analysis: of the total force on the ground, or of the first wanted motion.
/// @throws foundation::NotComputable, InvalidInput if the model does not have it
[[nodiscard]] double largest_transmissibility(const CaseContext& context,
                                              const project::TransmissibilityAnalysis& request);

/// The motions that an analysis requests, with as many harmonics as it needs.
/// @throws foundation::InvalidInput for a linear machine, foundation::NotComputable if there is no motion to begin with
/// @param quantities  of points, one per result requested; empty: the one of the analysis
[[nodiscard]] nonlinear::SteadyBranch steady_motions(const CaseContext& context, const project::SteadyAnalysis& request,
                                                     const std::vector<assembly::MotionQuantity>& quantities = {});

/// @throws foundation::NotComputable if nothing moves
[[nodiscard]] TransientResult transient_result(const CaseContext& context, const project::TransientAnalysis& request,
                                               foundation::Problems& warnings);

/// What may be wrong about such motions.
void warn_of_motions(const CaseContext& context, const project::SteadyAnalysis& request,
                     const nonlinear::SteadyBranch& motions, foundation::Problems& warnings);

}  // namespace trivet::study
