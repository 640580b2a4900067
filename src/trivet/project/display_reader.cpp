// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/display_reader.h"

namespace trivet::project {

ShownUnits read_display(TableReader& root) {
  ShownUnits units;
  const Node* table = root.table("display");
  if (!table) return units;
  TableReader reader(*table, "display", root.problems());
  for (const char* key : {"length", "force", "angle", "mass", "frequency", "level"}) {
    const auto value = reader.text(key);
    if (!value) continue;
    const foundation::Problems found = set_shown_unit(units, key, *value);
    for (const foundation::Problem& problem : found.list())
      reader.error(key, problem.finding, problem.rule, problem.remedy);
  }
  reader.finish();
  return units;
}

}  // namespace trivet::project
