// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/assembly/loads.h"

namespace trivet::response {

/// Every delay that occurs in a loading [s], ascending; 0 alone where nothing acts.
[[nodiscard]] std::vector<double> delays_of(const assembly::Loading& loading);

/// The terms of one delay, without it.
[[nodiscard]] assembly::Loading undelayed(const assembly::Loading& loading, double delay);

/// Curves out of what each delayed part of the load does, one part after another: Σ_d e^{−iωd} parts_d.
[[nodiscard]] Eigen::VectorXcd summed(const Eigen::VectorXcd& parts, const std::vector<double>& delays,
                                      double angular_frequency);

}  // namespace trivet::response
