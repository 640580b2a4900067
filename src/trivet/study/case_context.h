// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/assembly/loads.h"
#include "trivet/study/answers.h"

/// What every answer to a case starts from, and what several of them need.
namespace trivet::study {

struct CaseContext {
  const model::System& system;
  const assembly::Assembled& assembled;
  const modal::Modes& modes;
  const modal::Roots& roots;
  const foundation::Progress& progress;
};

/// Up to well above the natural frequencies, but not beyond the tables of elements.
[[nodiscard]] response::Band default_band(const CaseContext& context);

/// Is an excitation of this name among those selected? None selected: all.
[[nodiscard]] bool selected(const std::vector<std::string>& names, const std::string& name);

[[nodiscard]] std::vector<assembly::Channel> channels_of(const CaseContext& context, const project::Wanted& wanted);

/// Frequencies that show curves and their peaks in a band.
[[nodiscard]] std::vector<double> grid_over(const CaseContext& context, const std::vector<assembly::Channel>& channels,
                                            const assembly::Loading& loading, const response::Peaks& peaks,
                                            const response::Band& band);

/// @throws foundation::NotComputable where elements stand on modes, which do not say how they follow a rigid motion of
/// the ground
void require_rigid_ground(const CaseContext& context, const std::string& question);

/// @throws foundation::NotComputable with the reason where there is no answer
[[nodiscard]] std::vector<LimitLineResult> limit_line_answer(const CaseContext& context,
                                                             const std::vector<project::LimitLineRequest>& requests,
                                                             const project::Wanted& wanted, const response::Band& band);

}  // namespace trivet::study
