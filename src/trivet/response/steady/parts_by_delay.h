// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/assembly/loads.h"

namespace trivet::response {

/// All delays in a loading [s], ascending; only 0 without a load.
[[nodiscard]] std::vector<double> delays_of(const assembly::Loading& loading);

/// The terms of one delay, with the delay removed.
[[nodiscard]] assembly::Loading undelayed(const assembly::Loading& loading, double delay);

/// Curves from the responses to each delayed part of the load, stacked in `parts`: Σ_d e^{−iωd} parts_d.
[[nodiscard]] Eigen::VectorXcd summed(const Eigen::VectorXcd& parts, const std::vector<double>& delays,
                                      double angular_frequency);

}  // namespace trivet::response
