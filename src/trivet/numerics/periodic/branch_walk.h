// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "trivet/numerics/periodic/branch.h"

namespace trivet::numerics {

/// Walks along a branch, over its kinks too: where no step leads further, or short steps turn sharply again and again,
/// it returns to the last smooth point and hops from there over the kink.
class BranchWalk {
 public:
  /// @param branch          must outlive it
  /// @param control         shorter steps than `sharp_turns` are not smooth
  /// @param lowest,highest  parameters between which a hop may land
  BranchWalk(const Branch& branch, BranchPoint start, const StepControl& control, double first_step, double lowest,
             double highest);

  [[nodiscard]] const BranchPoint& now() const { return now_; }
  /// Can a later hop begin here? What was found since the last such point is not on the branch if it does.
  [[nodiscard]] bool is_smooth() const { return since_ == 0; }

  struct Step {
    BranchPoint to;
    double length = 0;
    bool hops = false;  ///< now() is the last smooth point again
  };
  /// The next step, not yet taken. Empty if none leads further.
  [[nodiscard]] std::optional<Step> next();
  /// Takes it.
  void go(Step step);
  /// Does not take it: the next one is at most as long as this.
  void shorten(double length) { step_ = length; }

 private:
  [[nodiscard]] std::optional<Step> advance();

  const Branch& branch_;
  StepControl control_;
  double first_step_, lowest_, highest_;
  double step_;
  BranchPoint now_, smooth_;
  double since_ = 0;     ///< length from the last smooth point
  double hopped_ = 0;    ///< of the last hop, until a smooth step follows it
  int sharp_turns_ = 0;  ///< since the last smooth point
};

}  // namespace trivet::numerics
