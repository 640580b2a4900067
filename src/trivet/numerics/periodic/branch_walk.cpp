// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/periodic/branch.h"

#include <algorithm>
#include <utility>

namespace trivet::numerics {

BranchWalk::BranchWalk(const Branch& branch, BranchPoint start, const StepControl& control, double first_step,
                       double lowest, double highest)
    : branch_(branch),
      control_(control),
      first_step_(first_step),
      lowest_(lowest),
      highest_(highest),
      step_(first_step),
      now_(std::move(start)),
      smooth_(now_) {}

std::optional<BranchWalk::Step> BranchWalk::advance() {
  std::optional<Branch::Advance> found = branch_.advance(now_, step_, control_);
  if (!found) return std::nullopt;
  return Step{std::move(found->to), found->length, false};
}

std::optional<BranchWalk::Step> BranchWalk::next() {
  // Directions after sharp turns may be wrong: after so many, the branch is sought from the last smooth point.
  constexpr int most_sharp_turns = 6;
  const bool is_crowded = sharp_turns_ == most_sharp_turns;
  if (!is_crowded)
    if (std::optional<Step> found = advance()) return found;
  // A hop that led to no smooth step was too short.
  if (std::optional<Branch::Advance> beyond =
          branch_.beyond_kink(smooth_, std::max(since_, 2 * hopped_), lowest_, highest_)) {
    now_ = smooth_;
    hopped_ = beyond->length;
    step_ = first_step_;
    return Step{std::move(beyond->to), beyond->length, true};
  }
  if (!is_crowded) return std::nullopt;
  sharp_turns_ = 0;
  return advance();
}

void BranchWalk::go(Step step) {
  const bool is_smooth = step.hops || step.length >= control_.sharp_turns;
  if (is_smooth) {
    since_ = 0;
    sharp_turns_ = 0;
    if (!step.hops) hopped_ = 0;
  } else {
    since_ += step.length;
    if (step.to.tangent.dot(now_.tangent) < control_.least_cosine) ++sharp_turns_;
  }
  now_ = std::move(step.to);
  if (is_smooth) smooth_ = now_;
}

}  // namespace trivet::numerics
