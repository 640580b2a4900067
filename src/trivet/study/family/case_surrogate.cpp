// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/family/case_surrogate.h"

#include <fmt/format.h>

#include <algorithm>

#include "trivet/foundation/invalid_input.h"

namespace trivet::study {

CaseSurrogate::CaseSurrogate(const DesignSpace& space, const project::Case& variant, const project::Analyses& request,
                             const std::vector<RequirementResult>& results)
    : packed_(variant, request, results), reason_(packed_.reason()) {
  bool any = false;
  for (std::size_t r = 0; r < results.size(); ++r) {
    judges_ = judges_ || packed_.covers(r);
    any = any || packed_.gives_slopes(r);
  }
  if (!any && reason_.empty()) reason_ = "no requirement of a kind that is judged for many designs at once";
  if (!reason_.empty()) return;
  std::vector<design::SumVariable> variables;
  for (const project::DesignAxis& axis : space.axes()) variables.push_back({axis.from, axis.to, axis.name});
  design::SumFamilyOrReason found = design::SumFamily::fitted(
      [&](const Eigen::VectorXd& values) -> design::PackedOrReason {
        try {
          return packed_.pack(space.system(variant, values));
        } catch (const foundation::NotComputable& refused) {
          return {{}, std::string("some designs have no valid model: ") + refused.what()};
        }
      },
      variables);
  family_ = std::move(found.family);
  reason_ = std::move(found.reason);
}

std::string CaseSurrogate::words() const {
  constexpr double least_shown = 1e-16;
  return fmt::format("a sum of {} terms from {} assembled designs, compared with {} others: largest deviation {:.0e}",
                     family_->terms(), family_->assembled(), design::SumFamily::compared_designs,
                     std::max(family_->worst_difference(), least_shown));
}

}  // namespace trivet::study
