// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/analyses/operation_limits.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "trivet/documents/shown_numbers.h"
#include "trivet/documents/text_table.h"
#include "trivet/results/format/result_writer.h"
#include "trivet/study/analyses/operating_limits.h"

namespace trivet::results {
namespace {

using study::OperatingLimit;
using study::OperatingSpeed;
using study::OperatingValue;

struct LimitRow {
  const OperatingSpeed* in;
  const OperatingLimit* what;
};

/// A number of a limit with its unit and its level.
std::string at_its_level(const OperatingLimit& limit, double number, const project::DisplayUnits& display) {
  DisplayUnit unit = display_unit(display, limit.value.unit);
  if (unit.unit != "1") unit.level = std::string(" ") + project::level_ending(limit.level);
  if (std::isnan(number)) return "–";
  return std::isfinite(number) ? value_text(without_round_off(number, limit.allowed), unit) : "∞";
}

/// "met", "VIOLATED (an upper bound: …)", "not judged: …"
std::string words_of_limit(const LimitRow& one) {
  const std::string remark = one.what->remark();
  if (!one.what->refusal.empty()) return "not judged: " + remark;
  if (one.what->met()) return "met";
  return remark.empty() ? "VIOLATED" : "VIOLATED (" + remark + ")";
}

std::vector<Column> limit_columns(const Rows<LimitRow>& row, const project::DisplayUnits& display = {}) {
  const auto of_value = [](auto member) { return [member](const LimitRow& one) { return one.what->value.*member; }; };
  return {
      row("name", Kind::words, "result", of_value(&OperatingValue::name)),
      row("quantity", Kind::words, "", [](const LimitRow& one) { return assembly::motion_name(one.what->quantity); }),
      row("unit", Kind::words, "", of_value(&OperatingValue::unit)),
      row("level", Kind::words, "", [](const LimitRow& one) { return project::level_ending(one.what->level); },
          {.forms = for_programs}),
      row("value", Kind::quantity, "", [](const LimitRow& one) { return one.what->judged(); }, {.forms = for_programs}),
      row("value", Kind::number, "value",
          [display](const LimitRow& one) { return at_its_level(*one.what, one.what->judged(), display); },
          {.forms = for_people}),
      row("allowed", Kind::quantity, "", [](const LimitRow& one) { return one.what->allowed; },
          {.forms = for_programs}),
      row("allowed", Kind::number, "limit",
          [display](const LimitRow& one) { return at_its_level(*one.what, one.what->allowed, display); },
          {.forms = for_people}),
      row("share", Kind::share, "of the limit", [](const LimitRow& one) { return one.what->share(); }),
      row("at", Kind::speed, "at", of_value(&OperatingValue::at)),
      row("met", Kind::yes_no, "", [](const LimitRow& one) { return one.what->met(); }, {.forms = for_programs}),
      row("reason", Kind::words, "", [](const LimitRow& one) { return one.what->remark(); }, {.forms = for_programs}),
      row("verdict", Kind::words, "verdict", [](const LimitRow& one) { return words_of_limit(one); },
          {.forms = for_people})};
}

}  // namespace

Table operating_limits(const study::OperationResult& found) {
  std::vector<LimitRow> list;
  for (const OperatingSpeed& at : found.speeds)
    for (const OperatingLimit& one : at.limits) list.push_back({&at, &one});
  const Rows row(std::move(list));
  std::vector<Column> columns = {row("from", Kind::speed, "", [](const LimitRow& one) { return one.in->speed.from; }),
                                 row("to", Kind::speed, "", [](const LimitRow& one) { return one.in->speed.to; })};
  std::ranges::move(limit_columns(row), std::back_inserter(columns));
  return {.key = "limits", .rows = row.size(), .columns = std::move(columns), .forms = in_json};
}

Table shown_limits(const OperatingSpeed& at, const project::DisplayUnits& display) {
  std::vector<LimitRow> list;
  for (const OperatingLimit& one : at.limits) list.push_back({&at, &one});
  const Rows row(std::move(list));
  std::vector<Use> columns = {"name", "value", "allowed", "share"};
  if (at.is_range()) columns.emplace_back("at");
  columns.emplace_back("verdict");
  return {.title = "Limits, all orders together, each at its level",
          .rows = row.size(),
          .columns = limit_columns(row, display),
          .people = std::move(columns),
          .mark = [&at](std::size_t i) { return at.limits[i].met() ? Mark::plain : Mark::bad; },
          .forms = for_people};
}

}  // namespace trivet::results
