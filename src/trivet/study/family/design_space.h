// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

#include "trivet/foundation/problems.h"
#include "trivet/project/model_number.h"
#include "trivet/project/project.h"
#include "trivet/study/family/design_batch.h"

namespace trivet::study {

/// The parameters of a search, each as a share 0 … 1 of its range (of its logarithm with logarithmic spacing).
class DesignSpace {
 public:
  /// @param names  in [parameters]; empty: all
  DesignSpace(const project::Project& project, const std::vector<std::string>& names);

  [[nodiscard]] std::size_t size() const { return axes_.size(); }
  [[nodiscard]] const std::vector<project::DesignAxis>& axes() const { return axes_; }

  [[nodiscard]] Eigen::VectorXd values(const Eigen::VectorXd& shares) const;  ///< in the units of the axes
  /// Of the file, that set them.
  [[nodiscard]] std::vector<project::Node> changes(const Eigen::VectorXd& shares) const;
  /// d value / d share of one parameter.
  [[nodiscard]] double slope(std::size_t axis, double share) const;

  /// How far each parameter may still move from these values: to the farther end of its range, with the sign.
  [[nodiscard]] Eigen::VectorXd towards(const Eigen::VectorXd& values) const;

  /// The model of a case with these values. @throws foundation::NotComputable with the first reason if it is not valid
  [[nodiscard]] model::System system(const project::Case& variant, const Eigen::VectorXd& values) const;

  /// Its designs of a case; used as long as both exist.
  [[nodiscard]] DesignNumbers numbers(const project::Case& variant) const;

  /// Values that the file has; none for a parameter whose places differ.
  [[nodiscard]] const std::vector<std::optional<double>>& given() const { return given_; }
  /// One of them as a share; none if it is missing or outside its range by more than the round-off of units.
  [[nodiscard]] std::optional<double> given_share(std::size_t axis) const;
  /// All of them; none if one is missing or outside its range.
  [[nodiscard]] std::optional<Eigen::VectorXd> given_shares() const;

 private:
  std::vector<project::DesignAxis> axes_;
  std::vector<project::ModelNumber> numbers_;
  std::vector<std::optional<double>> given_;
};

/// Warnings of parameters whose value in the file lies outside their range, or whose places have different values
/// there: a search then cannot start at the design of the file.
[[nodiscard]] foundation::Problems parameter_warnings(const project::Project& project, const DesignSpace& space);

}  // namespace trivet::study
