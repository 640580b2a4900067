// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/mount_selection.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>
#include <unordered_map>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/project/analyses/transmissibility_question.h"
#include "trivet/study/mount_combinations.h"
#include "trivet/study/mount_sums.h"
#include "trivet/study/requirement_values.h"
#include "trivet/study/transmissibility_answer.h"

namespace trivet::study {
namespace {

using foundation::infinity;

/// Margins within this of each other are equal: round-off does not choose, the order of the catalogue does.
constexpr double same_margin = 1e-9;

constexpr std::array<const char*, mount_tests> test_names = {"",           "price",      "mass",
                                                             "mount_load", "deflection", "natural_frequencies"};

/// Adds what the table shows of a case: loads and deflections of the mounts.
void add_loads(const CaseContext& context, MountDesign& design) {
  for (const response::RatedLoad& one : mounts_at_rest(context).loads) {
    design.deflection = std::max(design.deflection.value_or(0), std::abs(one.deflection));
    const auto& ranges = context.system.elements()[one.element].rating->load;
    for (std::size_t i = 0; i < ranges.size(); ++i)
      if (ranges[i]) design.load = std::max(design.load.value_or(0), share_of_range(one.load(to_index(i)), *ranges[i]));
  }
}

/// Judges one case and keeps the least margin.
void judge_case(const project::Case& variant, const model::System& system, MountDesign& design) {
  const foundation::Progress silent;
  const CaseContext context(system, silent);
  foundation::Problems warnings;
  const std::string of_case = variant.name.empty() ? "" : "case " + variant.name + ": ";
  for (const RequirementResult& result : requirement_values(context, variant.analyses, warnings)) {
    if (!result.value && design.reason.empty()) design.reason = of_case + result.words + ": " + result.reason;
    const double margin = result.value ? result.margin : 0;
    if (!design.governing.empty() && !(margin < design.margin * (1 - same_margin))) continue;
    design.margin = margin;
    design.governing = of_case + result.words;
  }
  add_loads(context, design);
  if (design.lowest) return;  // the first case
  for (const modal::Mode& mode : context.modes.list) {
    if (mode.angular_frequency.value_or(0) <= 0) continue;
    if (!design.lowest) design.lowest = mode.angular_frequency;
    design.highest = mode.angular_frequency;
  }
  if (const auto* asked = variant.analyses.find<project::TransmissibilityQuestion>("transmissibility"))
    design.transmissibility = largest_transmissibility(context, *asked);
  const MountSums sums = sums_of_mounts(system);
  design.price = sums.price;
  design.mass = sums.mass;
}

MountDesign judged(const std::vector<const project::Case*>& cases,
                   const std::function<model::System(const project::Case&)>& system_of) {
  MountDesign design;
  design.margin = infinity;
  try {
    for (const project::Case* variant : cases) judge_case(*variant, system_of(*variant), design);
  } catch (const foundation::NotComputable& refused) {
    design.reason = refused.what();
  }
  if (!design.reason.empty()) design.margin = 0;
  design.met = design.margin >= 1;
  return design;
}

/// Finds the best of sets of combinations, and judges no combination twice.
class RankedCombinations {
 public:
  RankedCombinations(const MountCombinations& all, const foundation::Progress& progress)
      : all_(all), progress_(progress), bounds_(all.bounds(progress)), order_(all.count()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::stable_sort(order_.begin(), order_.end(),
                     [&](std::size_t a, std::size_t b) { return bounds_[a].margin > bounds_[b].margin; });
  }

  /// The best `most` of the combinations that `belongs` admits, by descending margin.
  std::vector<MountDesign> best(std::size_t most, const std::function<bool(std::size_t)>& belongs) {
    std::vector<std::size_t> found;
    std::vector<std::size_t> batch;
    const auto by_margin = [&](std::size_t a, std::size_t b) {
      return judged_.at(a).margin > judged_.at(b).margin * (1 + same_margin);
    };
    const auto finish_batch = [&] {
      judge(batch);
      found.insert(found.end(), batch.begin(), batch.end());
      std::stable_sort(found.begin(), found.end(), by_margin);
      if (found.size() > most) found.resize(most);
      batch.clear();
    };
    for (const std::size_t combination : order_) {
      if (!belongs(combination)) continue;
      const bool full = found.size() == most;
      if (full && judged_.at(found.back()).margin >= bounds_[combination].margin) break;
      batch.push_back(combination);
      if (batch.size() == (found.size() < most ? most : batch_size)) finish_batch();
    }
    finish_batch();
    std::vector<MountDesign> designs;
    for (const std::size_t combination : found) designs.push_back(judged_.at(combination));
    return designs;
  }

  [[nodiscard]] std::size_t judged_count() const { return judged_.size(); }

  [[nodiscard]] std::vector<MountSelection::Failed> failed() const {
    std::array<std::size_t, mount_tests> counts = {};
    for (const MountCombinations::Bound& bound : bounds_) ++counts[static_cast<std::size_t>(bound.failed)];
    std::vector<MountSelection::Failed> result;
    for (std::size_t test = 1; test < mount_tests; ++test)
      if (counts[test] > 0) result.push_back({test_names[test], counts[test]});
    return result;
  }

 private:
  static constexpr std::size_t batch_size = 16;

  void judge(const std::vector<std::size_t>& batch) {
    std::vector<std::size_t> missing;
    std::copy_if(batch.begin(), batch.end(), std::back_inserter(missing),
                 [&](std::size_t combination) { return !judged_.contains(combination); });
    std::vector<MountDesign> designs(missing.size());
    foundation::parallel_for(missing.size(), {.progress = progress_, .task = "all requirements"},
                             [&](std::size_t first, std::size_t last) {
                               for (std::size_t i = first; i < last; ++i) designs[i] = judged_design(missing[i]);
                             });
    for (std::size_t i = 0; i < missing.size(); ++i) {
      constexpr double round_off = 1e-6;
      if (designs[i].margin > bounds_[missing[i]].margin * (1 + round_off))
        throw foundation::NotComputable(
            "select: the bound of a combination is below its margin, so that the best could be missed; please report "
            "this model");
      judged_.emplace(missing[i], std::move(designs[i]));
    }
  }

  [[nodiscard]] MountDesign judged_design(std::size_t combination) const {
    MountDesign design =
        judged(all_.cases(), [&](const project::Case& variant) { return all_.system(variant, combination); });
    design.mounts = all_.mounts(combination);
    return design;
  }

  const MountCombinations& all_;
  const foundation::Progress& progress_;
  std::vector<MountCombinations::Bound> bounds_;
  std::vector<std::size_t> order_;  ///< combinations by descending bound
  std::unordered_map<std::size_t, MountDesign> judged_;
};

}  // namespace

MountSelection mount_selection(const project::Project& project, std::size_t most,
                               const foundation::Progress& progress) {
  const project::Analyses& asked = project.base().analyses;
  if (!asked.requirements && asked.limits.empty() && asked.limit_lines.empty())
    throw foundation::InvalidInput(
        "select: neither requirements nor limits; add [requirements] with mount_load = \"catalogue\", limits = "
        "{\"BODY.x\" = \"1 mm\"}, natural_frequencies = {avoid = [[\"22 Hz\", \"28 Hz\"]]} …");
  const MountCombinations all(project, deciding_cases(project));
  MountSelection result;
  result.choices = all.choices();
  for (const project::Case* variant : all.cases()) result.cases.push_back(variant->name);
  result.combinations = all.count();
  result.without_bounds = all.without_bounds();
  result.given = judged(all.cases(), [](const project::Case& variant) { return variant.system; });
  if (!result.given.reason.empty()) throw foundation::NotComputable("select: " + result.given.reason);
  RankedCombinations ranked(all, progress);
  result.failed = ranked.failed();
  result.best = ranked.best(most, [](std::size_t) { return true; });
  for (std::size_t c = 0; c < all.choices().size(); ++c) {
    const std::size_t first = result.options.size();
    for (std::size_t m = 0; m < all.choices()[c].mounts.size(); ++m)
      result.options.push_back(
          {c, m, ranked.best(1, [&](std::size_t combination) { return all.mount(combination, c) == m; }).front()});
    std::stable_sort(result.options.begin() + static_cast<std::ptrdiff_t>(first), result.options.end(),
                     [](const MountOption& a, const MountOption& b) { return a.best.margin > b.best.margin; });
  }
  result.judged = ranked.judged_count();
  return result;
}

std::vector<project::Node> selection_changes(const MountSelection& found) {
  std::vector<project::Node> changes;
  for (std::size_t c = 0; c < found.choices.size(); ++c)
    changes.push_back(project::change_of(found.choices[c], found.best.front().mounts[c]));
  return changes;
}

}  // namespace trivet::study
