// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/optimize/kept_margin_climb.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "trivet/foundation/first_error.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/judging/changed_case.h"
#include "trivet/study/requirements/verdict.h"

namespace trivet::study {

project::Project with_changes(const project::Project& project, const std::vector<project::Node>& changes) {
  project::Project changed = project;
  const std::vector<std::string> hold_in = cases_to_hold(project);
  for (project::Case& variant : changed.cases) {
    if (std::ranges::find(hold_in, variant.name) == hold_in.end()) continue;
    auto one = judging::changed_case(variant, changes);
    if (!one)
      throw foundation::NotComputable("optimize: the optimum has no model: " + foundation::first_message(one.error()));
    variant = std::move(*one);
  }
  return changed;
}

KeptMarginClimb::KeptMarginClimb(project::Project machines, const DesignSpace& space, double wanted,
                                 const foundation::Progress& progress, const std::function<bool()>& enough)
    : machines_(std::make_unique<Machines>(std::move(machines), space)),
      space_(space),
      wanted_(wanted),
      progress_(progress),
      enough_(enough) {}

bool KeptMarginClimb::has_kernels() const {
  return std::ranges::all_of(machines_->run.cases(), [](const SampledCase& one) { return one.no_kernels().empty(); });
}

double KeptMarginClimb::kept_at(const Eigen::VectorXd& shares, double least) {
  ++looked_at_;
  const foundation::Progress progress =
      !progress_ ? foundation::Progress() : [this](std::string_view task, double fraction) {
        progress_(fmt::format("design {} around the optimum: {}", looked_at_, task), fraction);
      };
  try {
    if (const auto kept = machines_->family.kept_least(shares, wanted_, least, progress)) return *kept;
    const project::Project there = with_changes(machines_->of, space_.changes(shares));
    return kept_least(SampleRun(there), wanted_, least, progress);
  } catch (const foundation::NotComputable&) {
    return 0;
  }
}

void KeptMarginClimb::raise(Eigen::VectorXd& best, double& least) {
  // Starts that lie apart by 0.1 of the ranges climb for themselves (sampled_starts): steps begin below, and end
  // after eight halvings, where a range of one decade changes margins by less than the rounds do: 3e-4 ln 10 <
  // same_reserves.
  constexpr double first_step = 0.08, last_step = 3e-4;
  for (double step = first_step; step >= last_step && !(enough_ && enough_()); step /= 2) {
    for (bool better = true; better;) {
      const Eigen::VectorXd from = best;
      better = steps(step, best, least);
      if (better) take(2 * best - from, best, least);
    }
  }
}

bool KeptMarginClimb::steps(double step, Eigen::VectorXd& best, double& least) {
  bool better = false;
  for (Eigen::Index j = 0; j < best.size(); ++j)
    for (const double change : {step, -step}) {
      Eigen::VectorXd trial = best;
      trial(j) += change;
      better = take(std::move(trial), best, least) || better;
    }
  return better;
}

bool KeptMarginClimb::take(Eigen::VectorXd trial, Eigen::VectorXd& best, double& least) {
  trial = trial.cwiseMax(0).cwiseMin(1);
  if (trial == best) return false;
  constexpr double better = 1e-6;
  const double there = kept_at(trial, least * (1 + better));
  if (!(there > least * (1 + better))) return false;
  best = std::move(trial);
  least = there;
  return true;
}

}  // namespace trivet::study
