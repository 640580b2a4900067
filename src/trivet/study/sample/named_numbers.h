// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "trivet/project/project.h"
#include "trivet/study/sample/drawn_designs.h"
#include "trivet/study/sample/sample.h"

namespace trivet::study {

/// Temperatures are read in SI: the zero of their units is not that of SI.
[[nodiscard]] FileUnit unit_in_file(const project::Project& project, const std::string& path);

/// The numbers of the model that tolerances move, in the order of the tolerances and their places.
[[nodiscard]] std::vector<VariedNumber> varied_numbers(const project::Project& project,
                                                       const std::vector<project::Tolerance>& tolerances,
                                                       const DrawnDesigns& drawn);

/// The numbers of the model that the draws of a design set.
/// @param draws  ratios or deviations, see project::Tolerance; none: no design
[[nodiscard]] std::vector<NamedNumber> named_numbers(const project::Project& project,
                                                     const std::vector<project::Tolerance>& tolerances,
                                                     const DrawnDesigns& drawn, const Eigen::VectorXd& draws);

}  // namespace trivet::study
