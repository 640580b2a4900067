// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/family/design_space.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/foundation/first_error.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/judging/changed_case.h"
#include "trivet/project/model_number.h"

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

std::vector<project::Node> DesignSpace::changes(const Eigen::VectorXd& shares) const {
  std::vector<project::Node> list;
  for (std::size_t j = 0; j < axes_.size(); ++j) list.push_back(numbers_[j].change(axes_[j].at(shares(to_index(j)))));
  return list;
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

Eigen::VectorXd DesignSpace::towards(const Eigen::VectorXd& values) const {
  Eigen::VectorXd result(values.size());
  for (Eigen::Index j = 0; j < values.size(); ++j)
    result(j) = (axes_[j].share(values(j)) <= 0.5 ? axes_[j].to : axes_[j].from) - values(j);
  return result;
}

model::System DesignSpace::system(const project::Case& variant, const Eigen::VectorXd& values) const {
  project::Design design;
  for (std::size_t j = 0; j < numbers_.size(); ++j) design.emplace_back(numbers_[j], values(to_index(j)));
  auto changed = judging::changed_system(variant, design);
  if (changed) return std::move(*changed);
  throw foundation::NotComputable(foundation::first_reason(changed.error()));
}

DesignNumbers DesignSpace::numbers(const project::Case& variant) const {
  DesignNumbers numbers{{}, [&](const Eigen::VectorXd& values) { return system(variant, values); }};
  for (const project::DesignAxis& axis : axes_) numbers.variables.push_back({axis.from, axis.to, axis.name});
  return numbers;
}

namespace {

std::string in_unit(double value, const project::DesignAxis& axis) {
  return fmt::format("{:.6g}{}", value, axis.unit.empty() ? "" : " " + axis.unit);
}

/// "0.3 m and -0.3 m"; empty if a place has no number.
std::string values_of_places(const project::Project& project, const project::DesignAxis& axis) {
  std::string words;
  std::vector<double> named;
  for (const auto& value : project::ModelNumber(axis).values(project.base())) {
    if (!value) return "";
    constexpr double same = 1e-9;  // relative, as for one value of all places
    const bool known =
        std::ranges::any_of(named, [&](double other) { return std::abs(other - *value) <= same * std::abs(other); });
    if (known) continue;
    words += (named.empty() ? "" : " and ") + in_unit(*value, axis);
    named.push_back(*value);
  }
  return words;
}

}  // namespace

foundation::Problems parameter_warnings(const project::Project& project, const DesignSpace& space) {
  foundation::Problems warnings;
  for (std::size_t j = 0; j < space.size(); ++j) {
    const project::DesignAxis& axis = space.axes()[j];
    const std::string subject = "parameters." + axis.name;
    const auto warn = [&](const std::string& finding, const char* rule, const char* remedy) {
      warnings.warning(subject, finding, rule, remedy).origin =
          project::deepest(project.base().written, subject).origin;
    };
    const std::optional<double>& given = space.given()[j];
    if (given && !space.given_share(j))
      warn(fmt::format("{} in the file is outside its range, {} … {}", in_unit(*given, axis), in_unit(axis.from, axis),
                       in_unit(axis.to, axis)),
           "the search stays within the range, so its optimum may be worse than the given design",
           "widen the range, or give the number a value within it");
    if (given) continue;
    if (const std::string values = values_of_places(project, axis); !values.empty())
      warn("its places have different values in the file: " + values, "the search sets all of them to one value",
           "give a path its factor, such as {PATH = -1} for a mirrored place, or make them parameters of their own");
  }
  return warnings;
}

}  // namespace trivet::study
