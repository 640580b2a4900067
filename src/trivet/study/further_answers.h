// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/study/answers.h"

/// Answers beyond one harmonic load: random, in time, over shaft speed, as ratios and powers.
namespace trivet::study {

/// What every answer to a case starts from.
struct CaseContext {
  const model::System& system;
  const assembly::Assembled& assembled;
  const modal::Modes& modes;
  const modal::Roots& roots;
  const foundation::Progress& progress;
};

/// Up to well above the natural frequencies, but not beyond the tables of elements.
[[nodiscard]] response::Band default_band(const CaseContext& context);

/// Each throws foundation::NotComputable with the reason where there is no answer; warnings of a computation go to the list.
[[nodiscard]] RandomResult random_answer(const CaseContext& context, const project::RandomRequest& request);
[[nodiscard]] TransientResult transient_answer(const CaseContext& context, const project::TransientRequest& request, foundation::Problems& warnings);
[[nodiscard]] OrdersResult orders_answer(const CaseContext& context, const project::OrdersRequest& request);
[[nodiscard]] TransmissibilityResult transmissibility_answer(const CaseContext& context, const project::TransmissibilityRequest& request);
[[nodiscard]] response::PowerFlow power_answer(const CaseContext& context, const project::PowerRequest& request);
[[nodiscard]] std::vector<response::DeflectionShape> shapes_answer(const CaseContext& context, const project::ShapesRequest& request);
[[nodiscard]] std::vector<ShockSpectrumResult> shock_spectrum_answer(const CaseContext& context, const project::ShockSpectrumRequest& request,
                                                                     foundation::Problems& warnings);
[[nodiscard]] response::EarthquakeResponse earthquake_answer(const CaseContext& context, const project::EarthquakeRequest& request, foundation::Problems& warnings);
[[nodiscard]] std::vector<LimitLineResult> limit_line_answer(const CaseContext& context, const std::vector<project::LimitLineRequest>& requests, const project::Wanted& wanted,
                                                             const response::Band& band);

}  // namespace trivet::study
