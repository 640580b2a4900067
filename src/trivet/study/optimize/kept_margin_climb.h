// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/project/project.h"
#include "trivet/study/optimize/kept_margins.h"

namespace trivet::study {

/// The project with another design in the cases in which it has to hold.
/// @throws foundation::NotComputable if it has no model
[[nodiscard]] project::Project with_changes(const project::Project& project, const std::vector<project::Node>& changes);

/// A search by steps of the numbers (Hooke and Jeeves) for the margin that a share of the machines keeps.
class KeptMarginClimb {
 public:
  /// @param machines  those of a design within the ranges, with the numbers that are drawn for the search
  KeptMarginClimb(project::Project machines, const DesignSpace& space, double wanted,
                  const foundation::Progress& progress, const std::function<bool()>& enough);

  /// False: models judge the machines, which takes too long for many designs.
  [[nodiscard]] bool has_kernels() const;
  /// The margin that the machines of a design keep; 0 if it is not above `least`, or they cannot be judged.
  [[nodiscard]] double kept_at(const Eigen::VectorXd& shares, double least);
  /// Steps from a design to the largest margin kept around it. @param least  of it
  void raise(Eigen::VectorXd& best, double& least);
  [[nodiscard]] std::size_t looked_at() const { return looked_at_; }

 private:
  struct Machines {
    Machines(project::Project one, const DesignSpace& space) : of(std::move(one)), run(of), family(run, space) {}
    project::Project of;
    SampleRun run;
    MachineFamily family;
  };

  /// Steps of every number, up and down. @return whether one was better
  bool steps(double step, Eigen::VectorXd& best, double& least);
  /// Takes a trial within the ranges if it is better.
  bool take(Eigen::VectorXd trial, Eigen::VectorXd& best, double& least);

  std::unique_ptr<const Machines> machines_;
  const DesignSpace& space_;
  double wanted_;
  const foundation::Progress& progress_;
  const std::function<bool()>& enough_;
  std::size_t looked_at_ = 0;
};

}  // namespace trivet::study
