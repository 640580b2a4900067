// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

#include "trivet/project/project.h"
#include "trivet/study/sample/drawn_designs.h"
#include "trivet/study/sample/margin_descent.h"
#include "trivet/study/sample/sampled_case.h"

namespace trivet::study {

/// One end of the range of a tolerance while it grows. Distances are those from the number in the file over that of the
/// same end of the tolerance.
struct GrowingEnd {
  std::size_t tolerance = 0;
  bool upper = false;
  double given = 0, width = 0;  ///< draws: that of the file, and the distance of the end of the tolerance
  double reach = 0;             ///< distance up to which there are models
  double last = 0;              ///< the draw there, exact
  std::string beyond;           ///< why there are none further; empty: it is the largest that is tried
  double times = 0;             ///< distance

  [[nodiscard]] double draw(double at) const {
    if (at >= reach) return last;
    return given + (upper ? width : -width) * at;
  }
};

/// The ends of all tolerances, lower and upper one of each.
class BoxEnds {
 public:
  /// @param tolerances  live as long
  /// @throws foundation::InvalidInput if the number of the file is not inside the range of a measured batch
  BoxEnds(const std::vector<project::Tolerance>& tolerances, double most);

  [[nodiscard]] std::size_t size() const { return ends_.size(); }
  [[nodiscard]] GrowingEnd& operator[](std::size_t i) { return ends_[i]; }
  [[nodiscard]] const GrowingEnd& operator[](std::size_t i) const { return ends_[i]; }
  [[nodiscard]] const std::vector<project::Tolerance>& tolerances() const { return tolerances_; }

  /// The distance of every end.
  [[nodiscard]] Eigen::VectorXd times() const;
  /// The ranges of all draws with these distances, one per end.
  [[nodiscard]] DrawBox box(const Eigen::VectorXd& times) const;
  /// Tolerances with exactly these ranges, and the draws of the file in their middle.
  [[nodiscard]] std::vector<project::Tolerance> ranges(const Eigen::VectorXd& times) const;

 private:
  const std::vector<project::Tolerance>& tolerances_;
  std::vector<GrowingEnd> ends_;
};

/// The cases of a box, with kernels for designs within some ranges.
class BoxCases {
 public:
  BoxCases(const project::Project& project, const BoxEnds& ends, const Eigen::VectorXd& times);
  BoxCases(const BoxCases&) = delete;
  BoxCases& operator=(const BoxCases&) = delete;

  [[nodiscard]] const std::vector<SampledCase>& list() const { return list_; }
  [[nodiscard]] std::size_t draw_of(std::size_t tolerance, std::size_t place) const {
    return drawn_.draw_of(tolerance, place);
  }
  [[nodiscard]] std::size_t draws() const { return drawn_.draws(); }
  [[nodiscard]] const DrawnDesigns& drawn() const { return drawn_; }
  [[nodiscard]] bool has_kernels() const;
  /// Designs that are judged at once.
  [[nodiscard]] std::size_t piece() const {
    return has_kernels() ? SampledCase::kernel_piece : SampledCase::model_piece;
  }

 private:
  std::vector<project::Tolerance> tolerances_;
  DrawnDesigns drawn_;
  std::vector<SampledCase> list_;
};

/// Sets how far each end can go with all others as in the file: where designs have models that can be judged, less
/// `box_distance_kept` of it.
/// @param cases  of any ranges
void set_reach(const BoxCases& cases, BoxEnds& ends, double most);

}  // namespace trivet::study
