// SPDX-License-Identifier: BSD-3-Clause
// A chain of bodies like the paper's. Each is connected to the previous one by an elastic element with discrete
// dampers, the first to the ground.
#pragma once

#include "paper_machine.h"
#include "trivet/numerics/linalg/dynamic_matrices.h"

namespace trivet::benchmarks {

inline numerics::DynamicMatrices chain_of(int bodies) {
  const PaperMachine m = paper_machine();
  const Eigen::Index n = 6 * bodies;
  numerics::DynamicMatrices all{
      Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, n), {}, true};
  for (Eigen::Index b = 0; b < bodies; ++b) {
    const double share = 1 + 0.1 * std::sin(3.0 * double(b));  // no two elements are equal
    all.A.block<6, 6>(6 * b, 6 * b) = m.A / share;
    for (const auto& [to, from] : {std::pair{&all.B, &m.B}, std::pair{&all.K, &m.K}}) {
      to->block<6, 6>(6 * b, 6 * b) += share * *from;
      if (b == 0) continue;
      to->block<6, 6>(6 * b - 6, 6 * b - 6) += share * *from;
      to->block<6, 6>(6 * b, 6 * b - 6) -= share * *from;
      to->block<6, 6>(6 * b - 6, 6 * b) -= share * *from;
    }
  }
  return all;
}

}  // namespace trivet::benchmarks
