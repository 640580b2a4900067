// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/assembly/loads.h"
#include "trivet/design/missing_reasons.h"
#include "trivet/numerics/roots/designs.h"

namespace trivet::design {

/// A design for `numerics::design_peaks`: real symmetric constant matrices, one real constant load, results that are
/// real combinations of displacements and velocities.
struct PlainDesign {
  Eigen::MatrixXd A, B, K;                 ///< n × n
  Eigen::VectorXd load;                    ///< n
  Eigen::MatrixXd rows, rows_on_velocity;  ///< results × n
  std::vector<int> derivative;             ///< order of the time derivative of each result
};

[[nodiscard]] DesignOrReason<PlainDesign> plain_design(const assembly::Assembled& assembled,
                                                       const std::vector<assembly::Channel>& channels,
                                                       const assembly::Loading& loading);

// What DesignFamily interpolates.

/// Packed lower triangles of A, B, K, then the load.
[[nodiscard]] Eigen::VectorXd packed(const PlainDesign& design);
/// Reference magnitude of each packed entry.
[[nodiscard]] Eigen::VectorXd scales(const PlainDesign& design);
/// Reason why two designs cannot be in one family; empty if they can.
[[nodiscard]] std::string reason_for_separate_families(const PlainDesign& a, const PlainDesign& b);
/// Designs from packed entries, one row each.
[[nodiscard]] numerics::Designs unpacked_like(const PlainDesign& first, const Eigen::MatrixXd& entries);

}  // namespace trivet::design
