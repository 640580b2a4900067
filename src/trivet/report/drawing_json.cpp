// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/drawing_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "trivet/report/axis_ticks.h"
#include "trivet/report/curve_groups.h"
#include "trivet/report/plot_panel.h"

namespace trivet::report {
namespace {

using Json = nlohmann::ordered_json;

Json strokes() {
  Json list = Json::array();
  for (std::size_t series = 0; series < different_strokes; ++series) {
    const SeriesStyle style = series_style(series);
    list.push_back({{"colour", style.colour}, {"dash", style.dash}});
  }
  return list;
}

/// Names of a unit and of its multiples, from the smallest: [1e-9, "nm"], … [1e-3, "mm"], [1, "m"].
Json multiples(const std::string& unit) {
  Json list = Json::array();
  for (int power = -9; power <= 6; power += 3) {
    const UnitPrefix prefix = unit_prefix(std::pow(10.0, power), unit);
    if (list.empty() || list.back()[1] != prefix.unit) list.push_back({1 / prefix.factor, prefix.unit});
  }
  return list;
}

Json row(const std::vector<GroupedCurve>& curves) {
  Json list = Json::array();
  for (const GroupedCurve& c : curves) list.push_back({{"label", c.label}, {"curve", c.curve}});
  return list;
}

}  // namespace

std::string drawing_json(const std::vector<study::Answers>& answers) {
  Json units = Json::object(), groups = Json::array();
  for (const study::Answers& of_case : answers) {
    groups.push_back(Json::array());
    if (!of_case.response) continue;
    const auto& curves = of_case.response->curves.curves;
    for (const response::Curve& curve : curves)
      units[curve.unit] = {{"quantity", quantity_name(curve.unit)}, {"multiples", multiples(curve.unit)}};
    for (const CurveGroup& group : curve_groups(curve_names(curves)))
      groups.back().push_back({{"name", group.name}, {"rows", {row(group.upper), row(group.lower)}}});
  }
  return Json{{"strokes", strokes()}, {"units", std::move(units)}, {"groups", std::move(groups)}}.dump(
      -1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace trivet::report
