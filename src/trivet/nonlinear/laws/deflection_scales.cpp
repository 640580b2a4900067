// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/laws/deflections.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "trivet/foundation/index.h"

namespace trivet::nonlinear {

using Eigen::Index;
using Eigen::VectorXd;

DeflectionScales::DeflectionScales(const std::vector<Deflection>& deflections, const Eigen::MatrixXd& receptance)
    : per_root_energy_(receptance.diagonal().cwiseAbs().cwiseSqrt()) {
  for (const Deflection& one : deflections) is_rotation_.push_back(one.is_rotation);
}

VectorXd DeflectionScales::largest_of_kind(const VectorXd& of) const {
  constexpr double least = 1e-2;
  std::array<double, 2> largest = {0, 0}, per_root_energy = {0, 0};
  assert(of.size() == to_index(is_rotation_.size()));
  for (Index j = 0; j < of.size(); ++j) {
    const bool kind = is_rotation_[j];
    largest[kind] = std::max(largest[kind], of(j));
    per_root_energy[kind] = std::max(per_root_energy[kind], per_root_energy_(j));
  }
  std::array<double, 2> size = largest;
  for (const int kind : {0, 1}) {
    const double as_other = largest[1 - kind] * per_root_energy[kind] / per_root_energy[1 - kind];
    if (std::isfinite(as_other)) size[kind] = std::max(largest[kind], least * as_other);
  }
  VectorXd found(of.size());
  for (Index j = 0; j < of.size(); ++j) found(j) = size[is_rotation_[j]];
  return found;
}

}  // namespace trivet::nonlinear
