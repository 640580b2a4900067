// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/family/design_batch.h"

#include "trivet/foundation/invalid_input.h"

namespace trivet::study {

DesignBatch::DesignBatch(const DesignNumbers& numbers, const project::Case& variant, const project::Analyses& request,
                         const std::vector<RequirementResult>& results)
    : packed_(variant, request, results, numbers.any_size) {
  fit(numbers);
  if (!reason_.empty() && packed_.has_orders()) {  // of loads of orders that are no such sums
    packed_ = CaseVector(variant, request, results, numbers.any_size, false);
    fit(numbers);
  }
}

void DesignBatch::fit(const DesignNumbers& numbers) {
  reason_ = packed_.reason();
  judges_ = false;
  bool any = false;
  for (std::size_t r = 0; r < packed_.results().size(); ++r) {
    judges_ = judges_ || packed_.covers(r);
    any = any || packed_.covers(r) || packed_.gives_slopes(r);
  }
  if (!any && reason_.empty()) reason_ = "no requirement of a kind that is judged for many designs at once";
  if (!reason_.empty()) return;
  design::SumFamilyOrReason found = design::SumFamily::fitted(
      [&](const Eigen::VectorXd& values) -> design::PackedOrReason {
        try {
          return packed_.pack(numbers.model(values));
        } catch (const foundation::NotComputable& refused) {
          return {{}, std::string("some designs have no valid model: ") + refused.what()};
        }
      },
      numbers.variables, numbers.compared);
  family_ = std::move(found.family);
  reason_ = std::move(found.reason);
}

}  // namespace trivet::study
