// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/design/front_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/documents/csv_field.h"
#include "trivet/documents/text_table.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/results/format/axis_words.h"
#include "trivet/results/format/json_parts.h"

namespace trivet::results {
namespace {

using study::DesignFront;
using study::FrontPoint;

std::string with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() || unit == "1" ? name : name + " [" + unit + "]";
}

std::string points_text(const DesignFront& front) {
  const bool two = front.objectives.size() == 2;
  std::vector<std::string> header = {"point"};
  for (const study::FrontObjective& one : front.objectives) header.push_back(with_unit(one.name, one.unit));
  for (const project::DesignAxis& axis : front.parameters) header.push_back(with_unit(axis.name, axis_unit(axis)));
  if (two) header.emplace_back("1 % more of the first: less of the second");
  header.emplace_back("residual");
  header.emplace_back("");
  TextTable table(header);
  for (std::size_t k = 0; k < front.points.size(); ++k) {
    const FrontPoint& point = front.points[k];
    std::vector<std::string> row = {std::to_string(k + 1)};
    for (const double amplitude : point.amplitudes) row.push_back(fmt::format("{:.6g}", amplitude));
    for (const double value : point.values) row.push_back(fmt::format("{:.6g}", value));
    if (two) row.push_back(point.exchange ? fmt::format("{:.3g} %", *point.exchange) : "");
    row.push_back(fmt::format("{:.1g}", point.residual));
    row.emplace_back(front.knee == k ? "knee" : "");
    table.add(row);
  }
  std::vector<std::string> row = {"given"};
  for (const study::FrontObjective& one : front.objectives)
    row.push_back(std::isinf(one.given) ? "∞" : fmt::format("{:.6g}", one.given));
  for (const auto& value : front.given) row.push_back(value ? fmt::format("{:.6g}", *value) : "differ");
  row.insert(row.end(), header.size() - row.size(), "");
  table.add(row);
  return table.text();
}

std::string left_out_text(const DesignFront& front) {
  std::string text;
  const auto say = [&](std::size_t count, const std::string& why) {
    if (count > 0) text += fmt::format("{} point{} left out: {}.\n", count, count == 1 ? "" : "s", why);
  };
  say(front.dominated, "another point is better in one result and as good in the others");
  say(front.coinciding, "the same as another point");
  say(front.not_found, "no design there meets the requirements");
  return text;
}

std::string knee_text(const DesignFront& front) {
  if (front.points.size() == 1) return "One design has the least of each result: there is nothing to choose.\n";
  if (!front.knee)
    return fmt::format(
        "No knee: the front does not bulge beyond the straight {} between its ends (each result from 0 at its least to "
        "1 at its most).\n",
        front.objectives.size() == 2 ? "line" : "plane");
  return fmt::format("Knee: point {}, {:.3g} of the range beyond the straight {} between the ends.\n", *front.knee + 1,
                     front.knee_distance, front.objectives.size() == 2 ? "line" : "plane");
}

}  // namespace

std::string front_text(const DesignFront& front) {
  std::vector<std::string> names;
  for (const study::FrontObjective& one : front.objectives) names.push_back(one.name);
  std::string text = "Front between the largest amplitudes of " + foundation::comma_separated(names) +
      " over the band: less of one is more of another\n\n" + points_text(front) + "\n" + knee_text(front);
  if (front.objectives.size() == 2 && front.points.size() > 2)
    text += fmt::format("Longest over shortest distance of neighbours: {:.3g}.\n", front.unevenness);
  text += left_out_text(front) + fmt::format("{} designs computed", front.evaluations);
  if (front.failed > 0) text += fmt::format(", {} of them without a result ({})", front.failed, front.first_failure);
  text += ".\n";
  if (!front.differenced.empty())
    text += fmt::format("Slopes by differences of values: {}; {} more designs computed for them.\n",
                        foundation::comma_separated(front.differenced), front.differences);
  return text + "A search finds the best of where it looked; it proves no global optimum.\n";
}

std::string front_settings(const DesignFront& front, std::size_t point) {
  std::string text;
  for (std::size_t j = 0; j < front.parameters.size(); ++j)
    for (const project::ParameterPlace& place : front.parameters[j].places) {
      const std::string value = fmt::format("{:.12g}", place.factor * front.points[point].values[j]);
      const std::string& unit = front.parameters[j].unit;
      text += fmt::format("--set '{} = {}'\n", place.path, unit.empty() ? value : "\"" + value + " " + unit + "\"");
    }
  return text;
}

std::string front_json(const DesignFront& front, const foundation::Problems& warnings) {
  json::Json result = json::front(front);
  result["warnings"] = json::warnings(warnings);
  return json::text(result, 1) + "\n";
}

json::Json json::front(const DesignFront& front) {
  Json result = {{"objectives", Json::array()},
                 {"parameters", Json::array()},
                 {"points", Json::array()},
                 {"knee", front.knee ? Json(*front.knee) : Json(nullptr)},
                 {"knee_distance", front.knee ? json::number(front.knee_distance) : Json(nullptr)},
                 {"unevenness", json::number(front.unevenness)},
                 {"dominated", front.dominated},
                 {"coinciding", front.coinciding},
                 {"not_found", front.not_found},
                 {"designs", front.evaluations},
                 {"failed", front.failed},
                 {"differenced", json::differenced(front.differenced, front.differences)}};
  for (const study::FrontObjective& one : front.objectives)
    result["objectives"].push_back({{"name", one.name},
                                    {"unit", one.unit},
                                    {"given", json::number(one.given)},
                                    {"least", json::number(one.least)},
                                    {"most", json::number(one.most)}});
  for (std::size_t j = 0; j < front.parameters.size(); ++j) {
    const project::DesignAxis& axis = front.parameters[j];
    Json places = Json::array();
    for (const project::ParameterPlace& place : axis.places)
      places.push_back({{"path", place.path}, {"factor", place.factor}});
    result["parameters"].push_back({{"name", axis.name},
                                    {"places", std::move(places)},
                                    {"unit", axis_unit(axis)},
                                    {"from", axis.from},
                                    {"to", axis.to},
                                    {"given", json::optional(front.given[j])}});
  }
  for (const FrontPoint& point : front.points)
    result["points"].push_back({{"amplitudes", json::list(point.amplitudes)},
                                {"values", json::list(point.values)},
                                {"residual", json::number(point.residual)},
                                {"exchange", json::optional(point.exchange)}});
  return result;
}

std::string front_csv(const study::DesignFront& front) {
  std::string text;
  for (const study::FrontObjective& objective : front.objectives)
    text += csv_field(objective.name + " [" + objective.unit + "]") + ",";
  for (const project::DesignAxis& axis : front.parameters)
    text += csv_field(axis.name + (axis_unit(axis).empty() ? "" : " [" + axis_unit(axis) + "]")) + ",";
  text += "residual,knee\n";
  for (std::size_t i = 0; i < front.points.size(); ++i) {
    for (const double amplitude : front.points[i].amplitudes) text += csv_number(amplitude) + ",";
    for (const double value : front.points[i].values) text += csv_number(value) + ",";
    text += csv_number(front.points[i].residual) + (front.knee == i ? ",1\n" : ",0\n");
  }
  return text;
}

}  // namespace trivet::results
