// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

namespace trivet::numerics {

/// A zero of a periodic motion minus a level in a bracket of phases, by Newton's method inside it.
[[nodiscard]] double crossing_between(const Eigen::VectorXd& motion, double level, double low, double high);

/// Phases at which a periodic motion passes any of the levels, ascending in [0, 2π). Each extremum between two samples
/// is found first, so that two passages between them are not missed.
/// @param motion   Fourier coefficients (fourier_basis.h)
/// @param samples  evenly spaced phases × coefficients: rows of the basis
[[nodiscard]] std::vector<double> level_crossings(const Eigen::VectorXd& motion, const std::vector<double>& levels,
                                                  const Eigen::Ref<const Eigen::MatrixXd>& samples);

/// Smallest and largest value of a periodic motion.
[[nodiscard]] std::pair<double, double> range_of_motion(const Eigen::VectorXd& motion);

}  // namespace trivet::numerics
