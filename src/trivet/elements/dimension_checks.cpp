// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/dimension_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/part_size.h"

namespace trivet::elements {

bool check_length(foundation::Problems& problems, const std::string& key, double value) {
  if (foundation::is_part_size(value)) return true;
  const bool positive = value > 0 && std::isfinite(value);
  problems.error(key, fmt::format("{} = {:.6g} m", key, value),
                 positive ? foundation::part_size_rule : "it must be > 0",
                 positive ? "check the unit and the power of ten" : "give a length in metres");
  return false;
}

bool check_lengths(foundation::Problems& problems, std::initializer_list<std::pair<const char*, double>> lengths) {
  bool sound = true;
  for (const auto& [key, value] : lengths) sound = check_length(problems, key, value) && sound;
  return sound;
}

void check_slenderness(foundation::Problems& problems, const std::string& key, double width, double thickness) {
  const double ratio = std::max(width, thickness) / std::min(width, thickness);
  if (ratio > foundation::most_slender)
    problems.error(
        key, fmt::format("{:.6g} m compared with {:.6g} m: a ratio of {:.3g}", thickness, width, ratio),
        fmt::format("two lengths of one part differ by a factor of {:.0f} at most", foundation::most_slender),
        "check the unit and the power of ten");
}

void check_factor(foundation::Problems& problems, double dynamic_factor) {
  constexpr double usual_from = 1, usual_to = 4;
  const std::string value = fmt::format("dynamic_factor = {:.6g}", dynamic_factor);
  if (!(dynamic_factor > 0) || !std::isfinite(dynamic_factor))
    problems.error("dynamic_factor", value, "it must be > 0", "1 is the static stiffness");
  else if (dynamic_factor < usual_from || dynamic_factor > usual_to)
    problems.warning("dynamic_factor", value, "dynamic over static stiffness of rubber is between 1 and 4",
                     "check the number against a test");
}

void check_shape_factor(foundation::Problems& problems, double shape_factor) {
  constexpr double lowest = 0.25, highest = 20;
  if (shape_factor < lowest || shape_factor > highest)
    problems.warning("thickness", fmt::format("the shape factor is {:.4g}", shape_factor),
                     "the formulas were checked for shape factors from 0.25 to 20",
                     "use a finite-element mount or check the dimensions");
}

void require_sound(const foundation::Problems& problems) {
  for (const foundation::Problem& problem : problems.list())
    if (problem.severity == foundation::Severity::error) throw foundation::InvalidInput(foundation::message(problem));
}

}  // namespace trivet::elements
