// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <unordered_map>
#include <vector>

#include "trivet/study/select/mount_curves.h"
#include "trivet/study/select/mount_selection.h"

namespace trivet::study {

/// Margins within this of each other are equal: round-off does not choose, the order of the catalogue does.
inline constexpr double same_margin = 1e-9;

/// Finds the best of sets of combinations: bounds from sums first, then exact amplitudes and peaks of those that may be
/// among the best, and all requirements last. No combination is judged twice.
class MountRanking {
 public:
  /// All requirements of one combination.
  using Judge = std::function<MountDesign(std::size_t)>;

  /// Computes the curves of those combinations that meet the other tests.
  /// @param all, curves, progress  used by the result
  MountRanking(const MountCombinations& all, const MountCurves& curves, std::vector<std::size_t> combinations,
               Judge judge, const foundation::Progress& progress);

  /// The best `most` of the combinations, by descending margin.
  [[nodiscard]] std::vector<MountDesign> best(std::size_t most) { return best_of(order_, most); }
  /// The first `most` of those that meet every requirement, in another order than by margin: fewer if fewer do.
  [[nodiscard]] std::vector<MountDesign> first_that_hold(MountOrder by, std::size_t most);
  /// The best combination with each mount of a choice.
  [[nodiscard]] std::vector<MountDesign> best_with_each(std::size_t choice);

  [[nodiscard]] std::size_t judged_count() const { return judged_.size(); }
  /// Combinations of which the curves were computed.
  [[nodiscard]] std::size_t curve_count() const { return curve_count_; }
  /// Combinations that fail each test first.
  [[nodiscard]] const std::array<std::size_t, mount_tests>& failed() const { return failed_; }

 private:
  using Combinations = std::vector<std::size_t>;  ///< places in `list_`

  /// @param ordered  by descending bound from the sums
  [[nodiscard]] std::vector<MountDesign> best_of(const Combinations& ordered, std::size_t most);
  /// Lowers bounds to the margins of the curves.
  void lower(const Combinations& batch);
  void judge(const Combinations& batch);

  const MountCombinations& all_;
  const MountCurves& curves_;
  std::vector<std::size_t> list_;
  Judge judge_;
  const foundation::Progress& progress_;
  std::vector<MountCombinations::Bound> sums_;  ///< bounds from the sums
  std::vector<double> bounds_;                  ///< the same, lowered by the curves where these are known
  std::vector<bool> has_curves_;
  Combinations order_;
  std::unordered_map<std::size_t, MountDesign> judged_;
  std::array<std::size_t, mount_tests> failed_ = {};
  std::size_t curve_count_ = 0;
};

}  // namespace trivet::study
