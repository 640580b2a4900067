// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/dimension_checks.h"

#include <fmt/format.h>

#include <cmath>

#include "trivet/foundation/invalid_input.h"

namespace trivet::elements {

bool check_length(foundation::Problems& problems, const std::string& key, double value) {
  if (value > 0 && std::isfinite(value)) return true;
  problems.error(key, fmt::format("{} = {:.6g} m", key, value), "it must be > 0", "give a length in metres");
  return false;
}

bool check_lengths(foundation::Problems& problems, std::initializer_list<std::pair<const char*, double>> lengths) {
  bool sound = true;
  for (const auto& [key, value] : lengths) sound = check_length(problems, key, value) && sound;
  return sound;
}

void check_factor(foundation::Problems& problems, double dynamic_factor) {
  constexpr double usual_from = 1, usual_to = 4;
  const std::string value = fmt::format("dynamic_factor = {:.6g}", dynamic_factor);
  if (!(dynamic_factor > 0) || !std::isfinite(dynamic_factor))
    problems.error("dynamic_factor", value, "it must be > 0", "1 is the static stiffness");
  else if (dynamic_factor < usual_from || dynamic_factor > usual_to)
    problems.warning("dynamic_factor", value, "dynamic over static stiffness of rubber lies between 1 and 4",
                     "check the number against a test");
}

void check_shape_factor(foundation::Problems& problems, double shape_factor) {
  constexpr double lowest = 0.25, highest = 20;
  if (shape_factor < lowest || shape_factor > highest)
    problems.warning("thickness", fmt::format("the shape factor is {:.4g}", shape_factor),
                     "the formulas were measured for shape factors from 0.25 to 20", "use a finite-element mount or check the dimensions");
}

void require_sound(const foundation::Problems& problems) {
  for (const foundation::Problem& problem : problems.list())
    if (problem.severity == foundation::Severity::error) throw foundation::InvalidInput(foundation::message(problem));
}

}  // namespace trivet::elements
