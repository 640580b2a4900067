// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/identification/load_cases.h"

#include <fmt/format.h>

#include <cmath>
#include <set>

namespace trivet::identification {

LoadCase moved_end_case(std::string name, const Vector6& displacement, const Vector6& wrench) {
  LoadCase load_case;
  load_case.name = std::move(name);
  load_case.displacement << Vector6::Zero(), displacement;
  load_case.wrench.tail<6>() = wrench;
  return load_case;
}

std::string channel_words(int channel) {
  return fmt::format("{} {} at {}", channel % 6 < 3 ? "force" : "moment", "xyz"[channel % 3], channel < 6 ? 'N' : 'K');
}

std::string coordinate_words(int coordinate) {
  return fmt::format("{}_{} {}", coordinate % 6 < 3 ? "u" : "θ", coordinate < 6 ? 'N' : 'K', "xyz"[coordinate % 3]);
}

foundation::Problems load_case_problems(const std::vector<LoadCase>& cases) {
  foundation::Problems problems;
  if (cases.empty())
    problems.error("load_cases", "no load case", "a matrix needs readings", "give at least six independent load cases");
  std::set<std::string> names;
  bool moved = cases.empty();
  for (const LoadCase& one : cases) {
    const std::string subject = fmt::format("load case '{}'", one.name);
    for (int i = 0; i < 12; ++i) {
      if (!std::isfinite(one.displacement(i)))
        problems.error(subject, fmt::format("displacement {} = {}", coordinate_words(i), one.displacement(i)),
                       "every imposed displacement must be a number", "give 0 for a coordinate that was fixed");
      if (std::isinf(one.wrench(i)))
        problems.error(subject, fmt::format("{} = {}", channel_words(i), one.wrench(i)), "a reading must be a number",
                       "omit a channel that was not measured");
    }
    if (one.wrench.array().isNaN().all())
      problems.error(subject, "no channel was measured", "a load case must have at least one reading",
                     "remove the case, or give its wrench");
    moved = moved || one.displacement.cwiseAbs().maxCoeff() > 0;
    if (!names.insert(one.name).second)
      problems.warning(subject, "the name is used twice", "outliers are reported by name",
                       "give every load case a different name");
  }
  if (!moved)
    problems.error("load_cases", "every displacement is 0", "a stiffness can be measured only if the element is moved",
                   "check the columns");
  return problems;
}

}  // namespace trivet::identification
