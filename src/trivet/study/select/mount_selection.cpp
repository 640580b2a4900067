// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/select/mount_selection.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/study/requirements/amplification.h"
#include "trivet/study/requirements/mount_loads.h"
#include "trivet/study/requirements/requirement_values.h"
#include "trivet/study/requirements/single_mount_forces.h"
#include "trivet/study/requirements/verdict.h"

namespace trivet::study {
namespace {

using foundation::infinity;

constexpr std::array<const char*, mount_tests> test_names = {
    "", "price", "mass", "mount_load", "deflection", "natural_frequencies", "decoupling", "amplitudes_and_peaks"};

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
  const std::vector<RequirementResult> results = requirement_values(context, variant.analyses, warnings);
  for (const RequirementResult& result : results) {
    if (!result.value && design.reason.empty())
      design.reason = of_case + result.words_for_people(variant.display) + ": " + result.reason;
    const double margin = result.value ? result.margin : 0;
    if (result.kind == RequirementKind::isolation && result.value)
      design.isolation_share = std::max(design.isolation_share.value_or(0), *result.value / result.allowed);
    if (!design.governing.empty() && !(margin < design.margin * (1 - same_margin))) continue;
    design.margin = margin;
    design.governing = of_case + result.words.text();
    design.governing_for_people = of_case + result.words_for_people(variant.display);
  }
  add_loads(context, design);
  if (design.lowest) return;  // the first case
  for (const modal::Mode& mode : context.modes.list) {
    if (mode.angular_frequency.value_or(0) <= 0) continue;
    if (!design.lowest) design.lowest = mode.angular_frequency;
    design.highest = mode.angular_frequency;
  }
  design.transmissibility = operating_transmissibility(context, variant.analyses, results);
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

std::vector<MountSelection::Failed> failed_tests(const MountRanking& ranking) {
  std::vector<MountSelection::Failed> result;
  for (std::size_t test = 1; test < mount_tests; ++test)
    if (ranking.failed()[test] > 0) result.push_back({test_names[test], ranking.failed()[test]});
  return result;
}

/// The best combinations, and the best with each mount of each choice.
MountSelection ranked(MountRanking& ranking, std::size_t choices, std::size_t most, MountOrder by) {
  MountSelection result;
  result.failed = failed_tests(ranking);
  if (by != MountOrder::margin) result.best = ranking.first_that_hold(by, most);
  if (result.best.empty()) result.best = ranking.best(most);
  for (std::size_t c = 0; c < choices; ++c) {
    const std::size_t first = result.options.size();
    for (MountDesign& best : ranking.best_with_each(c))
      result.options.push_back({c, result.options.size() - first, std::move(best)});
    std::stable_sort(result.options.begin() + static_cast<std::ptrdiff_t>(first), result.options.end(),
                     [](const MountOption& a, const MountOption& b) { return a.best.margin > b.best.margin; });
  }
  result.curves = ranking.curve_count();
  result.judged = ranking.judged_count();
  return result;
}

}  // namespace

MountSelection mount_selection(const project::Project& project, std::size_t most, const foundation::Progress& progress,
                               MountOrder by) {
  if (std::ranges::none_of(project.cases, has_something_to_judge))
    throw foundation::InvalidInput(
        "select: neither requirements nor limits; add [requirements] with mount_load = \"catalogue\", limits = "
        "{\"BODY.x\" = \"1 mm\"}, natural_frequencies = {avoid = [[\"22 Hz\", \"28 Hz\"]]} …");
  const MountCombinations all(project, deciding_cases(project));
  const MountCurves curves(all);
  const auto judged_combination = [&](std::size_t combination) {
    MountDesign design =
        judged(all.cases(), [&](const project::Case& variant) { return all.system(variant, combination); });
    design.mounts = all.mounts(combination);
    return design;
  };
  MountSelection result;
  if (all.count() > most_judged_combinations) {
    if (by != MountOrder::margin)
      throw foundation::InvalidInput(fmt::format(
          "select by {}: {:.3g} combinations, more than the {} that can all be judged; let more places share one "
          "choice, name fewer mounts in choices, or rank by margin",
          name(by), static_cast<double>(all.count()), most_judged_combinations));
    result = MountExchange(all, curves, judged_combination, most, progress).run();
  } else {
    MountRanking ranking(all, curves, all.all(), judged_combination, progress);
    result = ranked(ranking, all.choices().size(), most, by);
    result.by = by;
    result.combinations = all.count();
  }
  result.choices = all.choices();
  for (const project::Case* variant : all.cases()) result.cases.push_back(variant->name);
  result.all_combinations = all.count();
  result.without_bounds = all.without_bounds();
  result.without_curves = curves.reason();
  result.given = judged(all.cases(), [](const project::Case& variant) { return variant.system; });
  if (const std::string& reason = result.best.front().reason; !reason.empty())
    throw foundation::NotComputable("select: no combination of mounts can be judged: " + reason);
  const foundation::Progress silent;
  const project::Case& first = *all.cases().front();
  std::size_t best = 0;
  for (std::size_t c = 0; c < all.choices().size(); ++c) best = all.with(best, c, result.best.front().mounts[c]);
  const model::System system = all.system(first, best);
  const CaseContext context(system, silent);
  result.transmissibility = operating_transmissibility_words(first.analyses);
  result.warnings = amplification_warnings(context, first.analyses);
  result.warnings.add(single_mount_warnings(context, first.analyses));
  result.warnings.add(missed_speed_warnings(context, first.analyses));
  return result;
}

std::vector<project::Node> selection_changes(const MountSelection& found) {
  std::vector<project::Node> changes;
  for (std::size_t c = 0; c < found.choices.size(); ++c)
    changes.push_back(project::change_of(found.choices[c], found.best.front().mounts[c]));
  return changes;
}

}  // namespace trivet::study
