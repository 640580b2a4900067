// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/study/requirements/verdict.h"

namespace trivet::study {

/// A requirement among the results of all cases.
struct ResultPlace {
  std::size_t result_case = 0, result = 0;
};

/// The amplitudes, rms or magnitudes at rest that a search makes small: requirements that are added to those of each
/// case, where they are the last of their kind. A case may have more requirements than another.
class Objectives {
 public:
  explicit Objectives(const project::OptimizeRequest& request);

  /// Adds them to the requirements of a case.
  void add_to(project::Analyses& analyses);
  /// Finds them among the results of the next case.
  void find_in(const std::vector<RequirementResult>& given);
  /// @throws foundation::InvalidInput if the largest of them has no meaning, given by the results of the first case
  void refuse_unlike(const std::vector<RequirementResult>& given) const;

  [[nodiscard]] bool any() const { return count() > 0; }
  [[nodiscard]] std::size_t count() const { return names_.size(); }
  [[nodiscard]] bool contain(const ResultPlace& place) const;
  /// Which of them the result at a place is. @pre contain(place)
  [[nodiscard]] std::size_t number(const ResultPlace& place) const { return place.result - first_[place.result_case]; }
  /// One of them among the results of a case.
  [[nodiscard]] std::size_t result(std::size_t result_case, std::size_t number) const {
    return first_[result_case] + number;
  }

  /// Weights of their sum; empty: the largest counts.
  [[nodiscard]] const std::vector<double>& weights() const { return weights_; }
  /// Each is an objective of its own: a front or a sum.
  [[nodiscard]] bool are_separate() const { return separate_; }
  /// They count as shares of their limits.
  [[nodiscard]] bool have_limits() const { return any() && limited_.front() > 0; }

  /// Σ weight × largest value, or share of its limit, over the cases; none if one of them was not judged.
  [[nodiscard]] std::optional<double> weighted_sum(const std::vector<std::vector<RequirementResult>>& found) const;
  /// The largest value of one of them over the cases, SI.
  [[nodiscard]] double largest(std::size_t number, const std::vector<std::vector<RequirementResult>>& found) const;
  /// "the largest amplitude of machine.z"
  [[nodiscard]] std::string words(const RequirementResult& result) const;

 private:
  /// Objectives of a front keep their units and have no common measure.
  [[nodiscard]] bool are_of_front() const { return separate_ && weights_.empty(); }
  [[nodiscard]] RequirementKind requirement_kind() const;
  /// The transmissibilities of a case: all of the same forces and places as in the first one.
  void find_isolations_in(const std::vector<RequirementResult>& given);

  project::Minimized kind_;
  std::vector<std::string> names_;
  assembly::MotionQuantity quantity_;
  std::vector<double> weights_;
  bool separate_;
  std::vector<std::size_t> limited_;  ///< per case: those with a limit
  std::vector<std::size_t> first_;    ///< per case: number of the first among the results
};

}  // namespace trivet::study
