// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/engine/units.h"

#include "trivet/foundation/invalid_input.h"
#include "trivet/project/text/model_path.h"
#include "trivet/project/text/units.h"

namespace trivet::engine {

foundation::Expected<DisplayUnits> changed_units(const DisplayUnits& units,
                                                 const std::vector<std::pair<std::string, std::string>>& changes) {
  DisplayUnits changed = units;
  foundation::Problems wrong;
  for (const auto& [key, value] : changes) wrong.add(project::set_shown_unit(changed, key, value));
  if (wrong.has_errors()) return tl::make_unexpected(std::move(wrong));
  return changed;
}

double in_unit(double value, const std::string& from, const std::string& to) {
  if (const auto converted = project::in_unit({value, from}, to)) return *converted;
  for (const std::string& unit : {from, to})
    if (!project::is_known_unit(unit))
      throw foundation::InvalidInput("\"" + unit + "\" is not a unit; write it as in \"kN/mm\"");
  throw foundation::InvalidInput("\"" + to + "\" measures another quantity than \"" + from +
                                 "\"; give a unit of the same");
}

double angular_frequency(const std::string& text) {
  const auto value = project::to_si(text, project::Quantity::angular_frequency);
  if (!value)
    throw foundation::InvalidInput("\"" + text + "\": " + value.error() +
                                   "; give a number and its unit, as in \"5 Hz\" or \"31.4 rad/s\"");
  return *value;
}

std::vector<std::string> path_keys(const std::string& path) { return project::path_keys(path); }

}  // namespace trivet::engine
