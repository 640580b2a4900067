// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/family/design_space.h"

#include <algorithm>
#include <cmath>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/judging/changed_case.h"

namespace trivet::study {

DesignSpace::DesignSpace(const project::Project& project, const std::vector<std::string>& names) {
  for (const project::DesignAxis& axis : project.base().analyses.parameters) {
    if (!names.empty() && std::ranges::find(names, axis.name) == names.end()) continue;
    axes_.push_back(axis);
    numbers_.emplace_back(axis);
    given_.push_back(numbers_.back().read(project.base()));
  }
  if (axes_.empty() && !project.base().analyses.choices.empty())
    throw foundation::InvalidInput(
        "optimize: only mounts vary, no numbers; trivet select judges every combination of mounts");
  if (axes_.empty())
    throw foundation::InvalidInput("optimize: the file has no parameters; write [parameters.NAME] with path, from, to");
}

Eigen::VectorXd DesignSpace::values(const Eigen::VectorXd& shares) const {
  Eigen::VectorXd result(shares.size());
  for (Eigen::Index j = 0; j < shares.size(); ++j) result(j) = axes_[j].at(shares(j));
  return result;
}

std::optional<double> DesignSpace::given_share(std::size_t axis) const {
  if (!given_[axis]) return std::nullopt;
  constexpr double round_off = 1e-9;  // 0.285 m as 285 mm
  const double share = axes_[axis].share(*given_[axis]);
  if (!(share >= -round_off && share <= 1 + round_off)) return std::nullopt;
  return std::clamp(share, 0.0, 1.0);
}

std::optional<Eigen::VectorXd> DesignSpace::given_shares() const {
  Eigen::VectorXd shares(to_index(axes_.size()));
  for (std::size_t j = 0; j < axes_.size(); ++j) {
    const std::optional<double> share = given_share(j);
    if (!share) return std::nullopt;
    shares(to_index(j)) = *share;
  }
  return shares;
}

double DesignSpace::slope(std::size_t axis, double share) const {
  const project::DesignAxis& a = axes_[axis];
  return a.logarithmic ? a.at(share) * std::log(a.to / a.from) : a.to - a.from;
}

model::System DesignSpace::system(const project::Case& variant, const Eigen::VectorXd& values) const {
  project::Design design;
  for (std::size_t j = 0; j < numbers_.size(); ++j) design.emplace_back(numbers_[j], values(to_index(j)));
  auto changed = judging::changed_system(variant, design);
  if (changed) return std::move(*changed);
  for (const foundation::Problem& problem : changed.error().list())
    if (problem.severity == foundation::Severity::error)
      throw foundation::NotComputable(problem.subject + ": " + problem.finding + "; " + problem.rule);
  throw foundation::NotComputable("the model cannot be read");
}

}  // namespace trivet::study
