// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "trivet/documents/html_table.h"
#include "trivet/report/drawing/axis_ticks.h"
#include "trivet/report/drawing/curve_groups.h"
#include "trivet/report/tables/result_tables.h"

namespace trivet::report {
namespace {

/// The columns of one kind: translations and rotations, or forces and moments.
struct Columns {
  const char* owner;
  std::array<const char*, 2> units;
  std::vector<std::string> labels;
};

const std::vector<Columns>& all_columns() {
  static const std::vector<Columns> list = {
      {"body or point", {"m", "rad"}, {"x", "y", "z", "θx", "θy", "θz"}},
      {"relative motion", {"m", "rad"}, {model::relative_components.begin(), model::relative_components.end()}},
      {"clearance", {"m", "rad"}, {model::approach_component}},
      {"forces of", {"N", "N m"}, {"Fx", "Fy", "Fz", "Mx", "My", "Mz"}}};
  return list;
}

bool belongs_to(const Columns& columns, const CurveGroup& group) {
  const std::vector<GroupedCurve>& any = group.upper.empty() ? group.lower : group.upper;
  return std::ranges::find(columns.labels, any.front().label) != columns.labels.end();
}

std::string static_table(const std::vector<response::StaticValue>& values, const std::vector<CurveGroup>& groups,
                         const Columns& columns, const project::DisplayUnits& display,
                         const results::LargestOfKind& kinds) {
  std::array<double, 2> largest = {0, 0};
  const auto shown = [&](const GroupedCurve& c) { return kinds.shown(values[c.curve].unit, values[c.curve].value); };
  for (const CurveGroup& g : groups) {
    for (const GroupedCurve& c : g.upper) largest[0] = std::max(largest[0], std::abs(shown(c)));
    for (const GroupedCurve& c : g.lower) largest[1] = std::max(largest[1], std::abs(shown(c)));
  }
  std::vector<UnitPrefix> prefixes;
  for (std::size_t kind = 0; kind < 2; ++kind)
    prefixes.push_back(unit_prefix(largest[kind], results::display_unit(display, columns.units[kind])));
  std::vector<Cell> headings = {{columns.owner}};
  for (std::size_t k = 0; k < columns.labels.size(); ++k)
    headings.push_back(right(fmt::format("{} [{}]", columns.labels[k], prefixes[k / 3].unit)));
  std::vector<Row> rows;
  for (const CurveGroup& g : groups) {
    rows.push_back({{{g.name}}, ""});
    for (std::size_t k = 0; k < columns.labels.size(); ++k) {
      const std::vector<GroupedCurve>& kind = k < 3 ? g.upper : g.lower;
      const auto found = std::ranges::find(kind, columns.labels[k], &GroupedCurve::label);
      if (found == kind.end()) {
        rows.back().cells.push_back(right("–"));
        continue;
      }
      rows.back().cells.push_back(aligned_cell(shown(*found) * prefixes[k / 3].factor));
    }
  }
  return html_table(headings, rows);
}

}  // namespace

std::string static_tables(const project::Case&, const study::CaseResults& results) {
  if (!results.statics) return "";
  const std::vector<response::StaticValue>& values = results.statics->values;
  const std::vector<CurveGroup> all = curve_groups(curve_names(values));
  results::LargestOfKind kinds;
  for (const response::StaticValue& value : values) kinds.add(value.unit, value.value);
  std::string html;
  for (const Columns& columns : all_columns()) {
    std::vector<CurveGroup> groups;
    std::ranges::copy_if(all, std::back_inserter(groups),
                         [&](const CurveGroup& group) { return belongs_to(columns, group); });
    if (!groups.empty())
      html += (html.empty() ? "" : "<p></p>") + static_table(values, groups, columns, results.display, kinds);
  }
  return html +
      hint(fmt::format("Under gravity and the constant forces. Round-off is shown as 0. Backward error of the "
                       "solution: {:.3g}.",
                       results.statics->backward_error));
}

}  // namespace trivet::report
