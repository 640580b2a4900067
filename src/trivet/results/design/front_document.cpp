// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "trivet/foundation/plain_text.h"
#include "trivet/results/design/optimization_results.h"
#include "trivet/results/design/search_parts.h"
#include "trivet/results/format/axis_words.h"
#include "trivet/results/format/result_writer.h"

/// A front: amplitudes in SI, parameters in their units.
namespace trivet::results {
namespace {

using study::DesignFront;
using study::FrontObjective;
using study::FrontPoint;

Table objective_table(const DesignFront& front) {
  const Rows row(front.objectives);
  Table table{.key = "objectives",
              .axis = "objective",
              .rows = row.size(),
              .columns = {row("name", Kind::words, "largest amplitude", &FrontObjective::name),
                          row("unit", Kind::words, "", &FrontObjective::unit)},
              .arrays = {{"objective", "name"}, "unit", "given", "least", "most"}};
  add_largest(row, Kind::amplitude, "given", "given", &FrontObjective::given, table.columns);
  add_largest(row, Kind::amplitude, "least", "least of the front", &FrontObjective::least, table.columns);
  add_largest(row, Kind::amplitude, "most", "most", &FrontObjective::most, table.columns);
  return table;
}

Table front_parameters(const DesignFront& front) {
  std::vector<SearchedParameter> list;
  for (std::size_t j = 0; j < front.parameters.size(); ++j) list.push_back({&front.parameters[j], front.given[j]});
  return {.key = "parameters", .axis = "parameter", .rows = list.size(), .columns = parameter_columns(list)};
}

Table front_points(const DesignFront& front) {
  const Rows row(front.points);
  const ColumnOptions lists = {.unit = unit_of_the_row, .forms = in_json | in_arrays};
  Table table{
      .key = "points",
      .axis = "point",
      .plain_names = true,
      .file = "optimum.csv",
      .rows = row.size(),
      .columns = {row.lists("amplitudes", "", "objective", {}, &FrontPoint::amplitudes, lists),
                  row.lists("values", "", "parameter", {}, &FrontPoint::values, lists),
                  row("point", Kind::number, "point", [](std::size_t k) { return k + 1; }, {.forms = for_people})}};
  const auto add = [&](Column column) { table.columns.push_back(std::move(column)); };
  for (std::size_t i = 0; i < front.objectives.size(); ++i) {
    const FrontObjective& one = front.objectives[i];
    add(row(one.name + " [" + one.unit + "]", Kind::amplitude, one.name,
            [i](const FrontPoint& p) { return p.amplitudes[i]; }, {.unit = one.unit, .forms = in_csv | for_people}));
  }
  for (std::size_t j = 0; j < front.parameters.size(); ++j) {
    const std::string unit = axis_unit(front.parameters[j]);
    const std::string heading = front.parameters[j].name + (unit.empty() ? "" : " [" + unit + "]");
    add(row(heading, Kind::number, heading, [j](const FrontPoint& p) { return p.values[j]; },
            {.forms = in_csv | for_people}));
  }
  add(row("residual", Kind::number, "residual", &FrontPoint::residual, {.digits = 1}));
  add(row("exchange", Kind::number, front.objectives.size() == 2 ? "1 % more of the first: less of the second [%]" : "",
          &FrontPoint::exchange, {.digits = 3, .forms = everywhere & ~in_csv}));
  add(row("knee", Kind::number, "", [&front](std::size_t k) { return front.knee == k ? 1 : 0; },
          {.forms = in_csv | in_arrays}));
  add(row("remark", Kind::words, front.knee ? "remark" : "",
          [&front](std::size_t k) { return front.knee == k ? "knee" : ""; }, {.forms = for_people}));
  return table;
}

std::string knee_words(const DesignFront& front) {
  if (front.points.size() == 1) return "One design has the least of each result: there is nothing to choose.";
  const char* straight = front.objectives.size() == 2 ? "line" : "plane";
  if (!front.knee)
    return fmt::format(
        "No knee: the front does not bulge beyond the straight {} between its ends (each result from 0 at its least to "
        "1 at its most).",
        straight);
  return fmt::format("Knee: point {}, {:.3g} of the range beyond the straight {} between the ends.", *front.knee + 1,
                     front.knee_distance, straight);
}

std::vector<std::string> front_notes(const DesignFront& front) {
  std::vector<std::string> notes = {knee_words(front)};
  if (front.objectives.size() == 2 && front.points.size() > 2)
    notes.push_back(fmt::format("Longest over shortest distance of neighbours: {:.3g}.", front.unevenness));
  const auto say = [&](std::size_t count, const char* why) {
    if (count > 0) notes.push_back(fmt::format("{} point{} left out: {}.", count, count == 1 ? "" : "s", why));
  };
  say(front.dominated, "another point is better in one result and as good in the others");
  say(front.coinciding, "the same as another point");
  say(front.not_found, "no design there meets the requirements");
  notes.push_back(computed_words(front.evaluations, front.failed, front.first_failure));
  notes.push_back(differences_words(front.differenced, front.differences));
  return notes;
}

}  // namespace

Document front_document(const DesignFront& front) {
  Document document;
  document.add(Sentence{.parts = {"Front between the largest amplitudes of " +
                                  foundation::comma_separated(names_of(front.objectives)) +
                                  " over the band. Less of one result is more of another."}});
  document.add(objective_table(front));
  document.add(front_parameters(front));
  document.add(front_points(front));
  document.add(Single{.name = "knee", .value = cell(front.knee)});
  document.add(Single{.name = "knee_distance", .value = front.knee ? json::number(front.knee_distance) : Json()});
  document.add(Single{.name = "unevenness", .value = json::number(front.unevenness)});
  document.add(Single{.name = "dominated", .value = front.dominated});
  document.add(Single{.name = "coinciding", .value = front.coinciding});
  document.add(Single{.name = "not_found", .value = front.not_found});
  document.add(Single{.name = "designs", .value = front.evaluations});
  document.add(Single{.name = "failed", .value = front.failed});
  document.add(differenced_part(front.differenced, front.differences));
  add_search_lines(front_notes(front), document);
  return document;
}

std::string front_settings(const DesignFront& front, std::size_t point) {
  std::string text;
  for (std::size_t j = 0; j < front.parameters.size(); ++j)
    text += parameter_settings(front.parameters[j], front.points[point].values[j]);
  return text;
}

}  // namespace trivet::results
