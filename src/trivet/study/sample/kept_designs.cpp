// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/sample/kept_designs.h"

#include <algorithm>
#include <utility>

#include "trivet/foundation/index.h"
#include "trivet/study/sample/named_numbers.h"
#include "trivet/study/sample/sample_result.h"

namespace trivet::study {
namespace {

/// Adds designs and finds what was drawn for them.
class KeepingDesigns {
 public:
  explicit KeepingDesigns(const SampleRun& run) : run_(run) {
    kept_.numbers = varied_numbers(run.project(), run.tolerances(), run.drawn());
  }

  void add(std::uint64_t number, KeptDesign::Reason reason, const std::vector<double>& margins) {
    const Eigen::MatrixXd draws = run_.drawn().draw(number, 1);
    KeptDesign one{.number = number, .reason = reason, .margins = margins};
    for (const VariedNumber& varied : kept_.numbers)
      one.numbers.push_back(
          run_.tolerances()[varied.tolerance].number(varied.place, varied.given, draws(0, to_index(varied.draw))));
    kept_.list.push_back(std::move(one));
  }
  void add(const KeptTally::Designs& designs, KeptDesign::Reason reason) {
    for (const auto& [number, margins] : designs) add(number, reason, margins);
  }
  /// A design with an extreme margin, which may be kept already.
  void add_extreme(std::uint64_t number, bool KeptDesign::* which) {
    if (std::ranges::find(kept_.list, number, &KeptDesign::number) == kept_.list.end())
      add(number, KeptDesign::Reason::extreme, run_.margins(number));
    (*std::ranges::find(kept_.list, number, &KeptDesign::number)).*which = true;
  }

  [[nodiscard]] KeptDesigns in_order() && {
    std::ranges::sort(kept_.list, {}, &KeptDesign::number);
    return std::move(kept_);
  }

 private:
  const SampleRun& run_;
  KeptDesigns kept_;
};

}  // namespace

std::size_t KeptDesign::governing() const { return to_size(std::ranges::min_element(margins) - margins.begin()); }

KeptDesigns kept_designs(const SampleRun& run, const SampleTally& all) {
  using enum KeptDesign::Reason;
  KeepingDesigns kept(run);
  kept.add(all.kept.first(), first);
  kept.add(all.kept.failing(), failing);
  if (all.least.any) {
    kept.add_extreme(all.least.largest_at, &KeptDesign::has_largest);
    kept.add_extreme(all.least.least_at, &KeptDesign::has_least_margin);
  }
  return std::move(kept).in_order();
}

}  // namespace trivet::study
