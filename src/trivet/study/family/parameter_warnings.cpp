// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/family/parameter_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/project/model_number.h"

namespace trivet::study {
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
