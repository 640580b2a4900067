// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "trivet/assembly/loads.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/study/analyses/case_results.h"
#include "trivet/study/analyses/solved_case.h"

namespace trivet::study {

// The data that every result for a case starts from.

/// The solved model of a case with the progress of one computation.
class CaseContext {
 public:
  CaseContext(const model::System& system_of_case, const foundation::Progress& shown_progress, int lowest = 0)
      : CaseContext(std::make_shared<const SolvedCase>(system_of_case, lowest), shown_progress) {}
  CaseContext(std::shared_ptr<const SolvedCase> solved_case, const foundation::Progress& shown_progress);

 private:
  std::shared_ptr<const SolvedCase> solved_;

 public:
  const model::System& system;
  const foundation::Progress& progress;
  const assembly::Assembled& assembled;
  const modal::Modes& modes;

  [[nodiscard]] const modal::Roots& roots() const { return solved_->roots(); }
  [[nodiscard]] const Eigen::VectorXcd& rough_poles() const { return solved_->rough_poles(); }
  /// Poles near which a response is checked: the damped roots, or the natural frequencies iω of a large model, whose
  /// roots would take longer than its response.
  [[nodiscard]] Eigen::VectorXcd resonances() const;
};

/// Band from 0 to 1.3 times the highest natural frequency, damped or not, within the tables of the elements.
[[nodiscard]] assembly::Band default_band(const CaseContext& context);
/// The same with these poles instead of the refined ones.
[[nodiscard]] assembly::Band default_band(const CaseContext& context, const Eigen::VectorXcd& poles);

/// True if the damped roots of so large a model are not computed, because only its lowest modes are requested.
[[nodiscard]] bool is_too_large_for_roots(const assembly::Assembled& assembled);
/// The warning of such a model whose stiffness or damping may feed energy.
[[nodiscard]] foundation::Problems warning_of_unknown_roots();

/// The error of an analysis for which the model has no excitation.
[[nodiscard]] foundation::NotComputable without_excitation(const std::string& analysis);

[[nodiscard]] std::vector<assembly::Channel> channels_of(const CaseContext& context,
                                                         const project::ChannelSelection& selection);

/// Frequencies in a band that resolve the curves and their peaks.
[[nodiscard]] std::vector<double> grid_over(const CaseContext& context, const std::vector<assembly::Channel>& channels,
                                            const assembly::Loading& loading, const response::Peaks& peaks,
                                            const assembly::Band& band);

/// @throws foundation::NotComputable if elements are mounted on a modal foundation, for which a rigid motion of the
/// ground is not defined
void require_rigid_ground(const CaseContext& context, const std::string& analysis);

/// The quantity that a limit line bounds, from its unit.
[[nodiscard]] assembly::MotionQuantity quantity_of(const assembly::LimitLine& line);

/// @throws foundation::NotComputable with the reason if there is no result
[[nodiscard]] std::vector<LimitLineResult> limit_line_results(const CaseContext& context,
                                                              const std::vector<project::LimitLineRequest>& requests,
                                                              const project::ChannelSelection& selection,
                                                              const assembly::Band& band);

/// The random vibration compared with a line over frequency bands: the root mean square in every band whose nominal
/// midband frequency the line covers, where the excitations have density, with the limit at that frequency.
/// @throws foundation::NotComputable, InvalidInput with the reason if there is no result
[[nodiscard]] LimitLineResult band_line_result(const CaseContext& context, const project::LimitLineRequest& request);

/// Warnings about results of a case that a user may misread: frequency-dependent elements in undamped modes, forces
/// of constraints, loads without effect, massless springs above their own first natural frequency.
/// @param search_to  upper end of the searched band [rad/s]; 0: the highest natural frequency
[[nodiscard]] foundation::Problems case_warnings(const CaseContext& context, const project::Analyses& analyses,
                                                 double search_to);

/// Warnings about static results that are requested or judged, of machines with laws: they use one stiffness for rest
/// and vibration, and leave out what the weight takes of the tilting stiffness of a body.
[[nodiscard]] foundation::Problems rest_warnings(const CaseContext& context, const project::Analyses& analyses);

}  // namespace trivet::study
