// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/study/analyses/case_context.h"
#include "trivet/study/requirements/requirement_list.h"
#include "trivet/study/requirements/verdict.h"

namespace trivet::study {

/// Values and margins of all requirements of a case: of [requirements], [limits] and [limit_lines].
[[nodiscard]] std::vector<RequirementResult> requirement_values(const CaseContext& context,
                                                                const project::Analyses& analyses,
                                                                foundation::Problems& warnings);

/// Each clearance of the model against how far its places approach: at rest, plus the largest harmonic amplitude in the
/// band of the requirements, plus the largest approach over the transient, if the file requests one. Those that cannot
/// be computed have the reason. @param warnings  of the transient
[[nodiscard]] std::vector<RequirementResult> clearance_results(const CaseContext& context,
                                                               const project::Analyses& analyses,
                                                               foundation::Problems& warnings);

/// Adds what limits curves over frequency, with values and margins: [limits], limits, no_peak, limit lines.
void add_curve_requirements(const CaseContext& context, const project::Analyses& analyses, RequirementList& list);

/// Sets the largest amplitudes over the band of the requirements, from result `first` of the list on.
void set_amplitudes(const CaseContext& context, const project::Analyses& analyses, std::size_t first,
                    const std::vector<project::AmplitudeLimit>& limits, RequirementList& list);

/// True if amplitudes, or levels in frequency bands, are limited at the speeds of the machine.
[[nodiscard]] bool judges_operation(const project::Analyses& analyses);

/// Adds the limits of [operation] at each of its speeds: amplitudes of all orders together.
void add_operation_requirements(const CaseContext& context, const project::Analyses& analyses, RequirementList& list);
/// Places whose amplitude is limited, by a number or a line, but by no limit at a speed of [operation]: each is a
/// requirement that is not judged there. They are part of a verdict, not of a search. Limits under excitations that do
/// not run at these speeds are left out.
[[nodiscard]] std::vector<RequirementResult> limits_that_miss_speeds(const model::System& system,
                                                                     const project::Analyses& analyses,
                                                                     const std::vector<RequirementResult>& judged);

/// Adds the limit lines over the frequency bands of [operation] at each of its speeds: root mean squares of the orders.
void add_operating_line_requirements(const CaseContext& context, const project::Analyses& analyses,
                                     RequirementList& list);

/// Adds what concerns free vibration, with values and margins: natural frequencies, damping ratios, decoupling.
void add_frequency_requirements(const CaseContext& context, const project::Requirements& required,
                                RequirementList& list);

/// Adds the isolation of forces from the ground, and of places from its motion: transmissibilities at a speed or over a
/// band, with the margin allowed / transmitted.
void add_isolation_requirements(const CaseContext& context, const project::Requirements& required,
                                RequirementList& list);

/// Sets value, place, margin and candidates of a requirement on a transmissibility.
/// @throws foundation::NotComputable, InvalidInput if the model does not have it
void judge_transmitted(const CaseContext& context, RequirementResult& result);

/// Adds bounds of motions and forces at rest, in random vibration and in a transient, with values and margins.
/// @param warnings  of the transient
void add_motion_requirements(const CaseContext& context, const project::Analyses& analyses,
                             foundation::Problems& warnings, RequirementList& list);

/// Sets the largest displacements over the transient, from result `first` of the list on.
void set_largest(const CaseContext& context, const project::Analyses& analyses, foundation::Problems& warnings,
                 std::size_t first, const std::vector<project::AmplitudeLimit>& limits, RequirementList& list);

/// Creep factor of a static result: of the element for its own deflection, otherwise 1.
[[nodiscard]] double creep_in(const model::System& system, const std::string& name);

/// What names the deflection of a mount along its axis after its own name.
inline constexpr const char* deflection_along_axis = ".deflection.z";

/// Adds what the makers of catalogue mounts allow: static loads and deflections, deflections under the harmonic
/// excitations and over the transient. A limit without an excitation that causes such a motion is noted.
void add_mount_requirements(const CaseContext& context, const project::Analyses& analyses,
                            foundation::Problems& warnings, RequirementList& list);

/// Adds what a nonlinear machine must not do in steady motion: jump, close a gap, or exceed an amplitude. Judged on the
/// branch of motions that is connected with the lower end of the band; and, for no_jump, of detached ones that a search
/// finds.
void add_steady_requirements(const CaseContext& context, const project::Analyses& analyses, RequirementList& list);

/// The same in words, for maps and searches, which do not judge them. Other requirements are left out.
[[nodiscard]] foundation::Problems missed_speed_warnings(const std::vector<RequirementResult>& missed);
/// The same of a case whose requirements are not judged yet; without [operation] it computes nothing.
[[nodiscard]] foundation::Problems missed_speed_warnings(const CaseContext& context, const project::Analyses& analyses);

}  // namespace trivet::study
