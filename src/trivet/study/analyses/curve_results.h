// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "trivet/study/analyses/case_results.h"

namespace trivet::study {

/// The response of the file over a band, with all coordinates, points and the forces on the ground beside its results;
/// the peaks of the same curves; limits and limit lines. @throws foundation::InvalidInput without an excitation
[[nodiscard]] project::Analyses curve_request(const project::Case& variant);

/// The same as `case_results`, but of the response only its model, the exact extrema, and the values at the lower end
/// of the band: no table over frequency, and no second solver. If the request has no peaks, there are no extrema
/// either.
[[nodiscard]] CaseResults curve_results(const project::Case& variant, const project::Analyses& request,
                                        const foundation::Progress& progress,
                                        const std::shared_ptr<const SolvedCase>& solved);

}  // namespace trivet::study
