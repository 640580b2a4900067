// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/analyses/operation_levels.h"

#include <fmt/format.h>

#include <functional>
#include <utility>

#include "trivet/results/format/result_writer.h"

namespace trivet::results {
namespace {

using study::OperatingLevel;

bool is_violated(const OperatingLevel& level) { return !level.met(); }

std::vector<Column> level_columns(const Rows<OperatingLevel>& row) {
  const auto of_line = [](auto number) {
    return [number](const OperatingLevel& l) { return l.line.empty() ? Json() : Json(std::invoke(number, l)); };
  };
  return {
      row("from", Kind::speed, "", [](const OperatingLevel& l) { return l.speed.from; }),
      row("to", Kind::speed, "", [](const OperatingLevel& l) { return l.speed.to; }),
      row("name", Kind::words, "result", [](const OperatingLevel& l) { return l.value.name; }),
      row("quantity", Kind::words, "", &OperatingLevel::quantity),
      row("unit", Kind::words, "", [](const OperatingLevel& l) { return l.value.unit; }),
      row("band", Kind::words, "band",
          [](const OperatingLevel& l) { return fmt::format("{:.4g} Hz", l.band.nominal_hz()); }),
      row("nominal_hz", Kind::number, "", [](const OperatingLevel& l) { return l.band.nominal_hz(); }, {.unit = "Hz"}),
      row("rms", Kind::quantity, "rms", [](const OperatingLevel& l) { return l.value.rms; }, {.digits = 4}),
      row("random", Kind::quantity, "random", of_line(&OperatingLevel::random), {.digits = 4}),
      row("at", Kind::speed, "at", [](const OperatingLevel& l) { return l.value.at; }),
      row("order", Kind::number, "most in order", [](const OperatingLevel& l) { return l.value.order; }),
      row("line", Kind::words, "limit line", &OperatingLevel::line),
      row("limit", Kind::quantity, "", of_line(&OperatingLevel::limit)),
      row("share", Kind::share, "of the line", of_line(&OperatingLevel::share)),
      row("remark", Kind::words, "remark",
          [](const OperatingLevel& l) -> std::string {
            return l.line.empty() ? "" : is_violated(l) ? "VIOLATED" : "met";
          },
          {.forms = for_people})};
}

}  // namespace

Table operating_levels(const study::OperationResult& found) {
  const Rows row(found.levels);
  return {.key = "bands",
          .axis = "level",
          .file = "operation_bands.csv",
          .rows = row.size(),
          .columns = level_columns(row),
          .csv = {"from [rpm]", "to [rpm]", "name", "quantity", "unit", "nominal_hz", "rms", "at [rpm]", "order",
                  "line", "limit", "share", "random"},
          .forms = for_programs};
}

Table shown_levels(const study::OperationResult& found, const assembly::Band& speed) {
  std::vector<OperatingLevel> list;
  bool has_lines = false, has_random = false;
  for (const OperatingLevel& level : found.levels) {
    if (level.speed.from != speed.from || level.speed.to != speed.to) continue;
    if (level.quantity != "velocity" && level.line.empty()) continue;
    has_lines = has_lines || !level.line.empty();
    has_random = has_random || level.random > 0;
    list.push_back(level);
  }
  std::vector<Use> columns = {"name", "band", "rms", "order"};
  if (has_random) columns.insert(columns.begin() + 3, "random");
  if (speed.from < speed.to) columns.insert(columns.begin() + 3, "at");
  if (has_lines) columns.insert(columns.end(), {"line", "share", "remark"});
  const std::string width = list.empty() ? "" : name(list.front().band.width);
  std::vector<bool> violated;
  std::vector<double> heights;
  for (const OperatingLevel& level : list) {
    violated.push_back(is_violated(level));
    heights.push_back(level.line.empty() ? level.value.rms : 1e3 * (1 + level.share()));  // judged ones first
  }
  const Rows row(std::move(list));
  return {.title = fmt::format("{} in each {} band at {}",
                               speed.from < speed.to ? "Largest root mean square" : "Root mean square", width,
                               study::speed_words(speed)),
          .rows = row.size(),
          .columns = level_columns(row),
          .people = std::move(columns),
          .most_rows = 60,
          .height = [heights = std::move(heights)](std::size_t i) { return heights[i]; },
          .mark = [violated = std::move(violated)](std::size_t i) { return violated[i] ? Mark::bad : Mark::plain; },
          .forms = on_screen | on_page};
}

}  // namespace trivet::results
