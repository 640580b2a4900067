// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <vector>

#include "trivet/numerics/search/max_min.h"
#include "trivet/study/optimize/design_objective.h"

namespace trivet::study {

// Points of a front, with each objective as a share from 0 at its least to 1 at its most.

/// Divisions of the triangle between the ends of three objectives: 21 points.
inline constexpr int points_of_three_objectives = 6;

/// Weights ≥ 0 of sum 1, evenly over the line (`along` points) or the triangle (`along` points on each side).
[[nodiscard]] std::vector<Eigen::VectorXd> even_weights(std::size_t objectives, int along);

/// Scale of the objectives by the ends of the front.
class FrontScale {
 public:
  FrontScale() = default;
  /// @param ends  amplitudes at the design with the least of each objective
  explicit FrontScale(const std::vector<Eigen::VectorXd>& ends);

  [[nodiscard]] bool has_width() const { return has_width_; }  ///< false: one end has the least of everything
  [[nodiscard]] const Eigen::VectorXd& width() const { return width_; }
  [[nodiscard]] Eigen::VectorXd shares(const Eigen::VectorXd& amplitudes) const;
  [[nodiscard]] Eigen::VectorXd amplitudes(const Eigen::VectorXd& shares) const;
  /// The point with these weights of the ends, in shares.
  [[nodiscard]] Eigen::VectorXd between_ends(const Eigen::VectorXd& weights) const;
  /// Distance of a point from the line or plane through the ends; positive towards less of all.
  [[nodiscard]] double beyond_ends(const Eigen::VectorXd& shares) const;

 private:
  Eigen::VectorXd least_, width_;
  std::vector<Eigen::VectorXd> ends_;  ///< in shares
  bool has_width_ = false;
};

/// Longest over shortest distance between neighbours.
[[nodiscard]] double longest_over_shortest(const std::vector<Eigen::VectorXd>& points);

/// Parameters along a curve at which its points would be equally far apart, by linear interpolation of its length.
/// @param at  parameters of the points, monotone
[[nodiscard]] std::vector<double> equally_spaced(const std::vector<double>& at,
                                                 const std::vector<Eigen::VectorXd>& points);

enum class PlaceOnFront { on, dominated, repeated };
/// A point is dominated if another is better in all objectives, or as good with some better; of equal ones the first
/// one is on the front.
[[nodiscard]] std::vector<PlaceOnFront> places_on_front(const std::vector<Eigen::VectorXd>& points);

// The searches of which a front consists. Amplitudes are in units of their limits, or SI without limits.

/// The largest amplitude of each objective, and the least ln(margin) of the requirements, at a design.
struct FrontValues {
  Eigen::VectorXd x;
  Eigen::VectorXd amplitudes;  ///< infinite for designs without a model
  double constraint = 0;
};
[[nodiscard]] FrontValues front_values(const DesignObjective& objective, const Eigen::VectorXd& x);

/// The smallest amplitude of one objective.
[[nodiscard]] numerics::MaxMinProblem least_amplitude(const DesignObjective& objective, std::size_t wanted);

/// The smallest amplitude of one objective while others stay below these.
/// @param held  per objective; infinite: free
[[nodiscard]] numerics::MaxMinProblem least_amplitude_below(const DesignObjective& objective, std::size_t wanted,
                                                            const Eigen::VectorXd& held);

/// The largest t with amplitude_i ≤ from_i − t · width_i for all objectives: from a point straight towards less of all.
[[nodiscard]] numerics::MaxMinProblem towards_less(const DesignObjective& objective, const Eigen::VectorXd& from,
                                                   const Eigen::VectorXd& width);

}  // namespace trivet::study
