// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/study/box/box_ends.h"
#include "trivet/study/box/solution_box.h"
#include "trivet/study/sample/worst_case.h"

namespace trivet::study {

/// A design that is in no solution box.
struct BoxViolation {
  Eigen::VectorXd draws;
  std::size_t in_case = 0, requirement = 0;
  double margin = 0;
  std::string failure;  ///< why it has no model or cannot be judged; empty: the margin is that of the requirement
};

/// Why an end does not move any more.
struct EndStop {
  BoxStop kind = BoxStop::most;
  BoxViolation beyond;     ///< with this end one step further
  bool is_corner = false;  ///< of that box
};

/// Moves the ends outward.
class BoxGrowth {
 public:
  /// @param ends  with their reach; live as long
  BoxGrowth(const project::Project& project, BoxEnds& ends, const project::BoxRequest& request,
            const foundation::Progress& progress);

  /// From the design of the file until every end is stopped. Boxes do not contain the designs in `known`.
  /// @throws foundation::NotComputable if box after box turns out to contain violations that its search had missed
  void run(const std::vector<BoxViolation>& known);

  [[nodiscard]] const EndStop& stop(std::size_t end) const { return *stops_[end]; }
  [[nodiscard]] std::uint64_t searched() const { return searched_; }

 private:
  using Ends = std::vector<std::size_t>;
  /// A violating design by its place in the smallest box that contains it.
  struct Blocker {
    Eigen::VectorXd place;
    BoxViolation found;
    bool is_known = false;  ///< of `known_`
  };

  [[nodiscard]] Ends growing() const;
  [[nodiscard]] Eigen::VectorXd moved(const Ends& movers, double to) const;
  void fit(double from, double& limit);
  /// Moves some ends from one distance to at most another. @return the distance they have then
  double grow(const Ends& movers, double from, double limit);
  /// The distance at which the box of these ends leaves a design.
  [[nodiscard]] double left_at(const Eigen::VectorXd& draws, const Ends& movers) const;
  /// The largest distance of these ends with which the box neither contains the design, nor one that violates at its
  /// place in smaller boxes.
  [[nodiscard]] double bounded(Blocker& one, const Ends& movers, double from, double to);
  void stop_at_reach();
  /// Stops those of the ends that cannot be moved alone. @return any
  bool stop_blocked(const Ends& movers, double margin);
  /// Stops those of the ends that move hardly further alone; the others stay where they are. @return any
  bool stop_stuck(const Ends& movers, double limit);
  /// Stops an end that has grown alone, by what blocked it.
  void stop_alone(std::size_t end);
  /// The worst design with an end moved alone of the places that blocked, if it is below a margin.
  [[nodiscard]] std::optional<EndStop> blocked(std::size_t end, double margin) const;
  [[nodiscard]] std::vector<Blocker> violations(const Eigen::VectorXd& times);
  /// Up to which distance the design at a place of the box meets all requirements.
  [[nodiscard]] double last_met(const Eigen::VectorXd& place, const Ends& movers, double from, double to);
  /// The least margin of each design over all requirements; failed designs have none.
  [[nodiscard]] std::vector<BoxViolation> judged(const Eigen::MatrixXd& designs) const;

  const project::Project& project_;
  BoxEnds& ends_;
  const project::BoxRequest& request_;
  const foundation::Progress& progress_;
  std::unique_ptr<BoxCases> cases_;
  std::vector<std::optional<EndStop>> stops_;
  std::vector<BoxViolation> known_;
  std::vector<Blocker> blockers_;                    ///< of the last growth
  std::vector<std::vector<Eigen::VectorXd>> worst_;  ///< draws of the last search, per case and requirement
  std::optional<BoxViolation> missed_;               ///< in a box that the search had taken for good
  std::uint64_t searched_ = 0;
  bool exhausted_ = false;  ///< the last growth found violations in box after box and was given up
  bool may_have_kernels_ = true;
};

}  // namespace trivet::study
