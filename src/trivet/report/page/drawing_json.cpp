// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/page/drawing_json.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "trivet/report/drawing/axis_ticks.h"
#include "trivet/report/drawing/curve_groups.h"
#include "trivet/report/drawing/figures.h"
#include "trivet/report/drawing/plot_panel.h"

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

/// Names of a shown unit and of its multiples, from the smallest: [1e-9, "nm"], … [1e-3, "mm"], [1, "m"]. A unit of
/// [display] has no others: [1, "in p-p"].
Json multiples(const results::DisplayUnit& unit) {
  Json list = Json::array();
  for (int power = -9; power <= 6; power += 3) {
    const UnitPrefix prefix = unit_prefix(std::pow(10.0, power) / unit.factor, unit);
    if (list.empty() || list.back()[1] != prefix.unit) list.push_back({unit.factor / prefix.factor, prefix.unit});
  }
  return list;
}

/// @param si_unit  of the data; `factor` converts them
/// @param largest  of the data of this unit: a number below 1e-12 of it is round-off
Json shown_unit_json(const results::DisplayUnit& unit, const std::string& si_unit, double largest) {
  Json json{{"quantity", quantity_name(si_unit)}, {"multiples", multiples(unit)}};
  if (unit.factor != 1) json["factor"] = unit.factor;
  json["round_off"] = 1e-12 * largest * unit.factor;
  return json;
}

Json row(const std::vector<GroupedCurve>& curves) {
  Json list = Json::array();
  for (const GroupedCurve& c : curves) list.push_back({{"label", c.label}, {"curve", c.curve}});
  return list;
}

Json groups_json(const std::vector<CurveName>& names) {
  Json list = Json::array();
  for (const CurveGroup& group : curve_groups(names))
    list.push_back({{"name", group.name}, {"rows", {row(group.upper), row(group.lower)}}});
  return list;
}

/// The same with the decision for each row: is its amplitude axis logarithmic?
Json groups_json(const study::ResponseResult& response) {
  const std::vector<CurveName> names = curve_names(response.curves.curves);
  Json list = groups_json(names);
  std::size_t i = 0;
  for (const CurveGroup& group : curve_groups(names))
    list[i++]["logarithmic"] = {drawn_range(response, group.upper).is_wide(),
                                drawn_range(response, group.lower).is_wide()};
  return list;
}

Json rule_json(const AmplitudeRule& rule) {
  return {{"range", rule.range},
          {"dips", rule.dips},
          {"negligible", rule.negligible},
          {"round_off", rule.round_off},
          {"below", rule.below}};
}

}  // namespace

std::string drawing_json(const std::vector<study::CaseResults>& results, const CaseMapCurves& map_curves) {
  const project::DisplayUnits display = results.empty() ? project::DisplayUnits() : results.front().display;
  Json units = Json::object(), groups = Json::array();
  std::map<std::string, double> largest;
  for (const study::CaseResults& of_case : results) {
    groups.push_back(Json::array());
    if (!of_case.response) continue;
    const auto& curves = of_case.response->curves.curves;
    for (const response::Curve& curve : curves) {
      double& most = largest[curve.unit];
      for (const auto& value : curve.value)
        if (std::isfinite(std::abs(value))) most = std::max(most, std::abs(value));
    }
    groups.back() = groups_json(*of_case.response);
  }
  Json of_designs = Json::array();
  for (const auto& curves : map_curves) {
    std::vector<CurveName> names;
    for (std::size_t c = 0; curves && c < curves->names.size(); ++c) {
      names.push_back({curves->names[c], curves->units[c]});
      largest.try_emplace(curves->units[c], 0);
    }
    of_designs.push_back(groups_json(names));
  }
  for (const auto& [unit, most] : largest)
    units[unit] = shown_unit_json(results::amplitude_unit(display, unit), unit, most);
  Json drawing{{"strokes", strokes()},
               {"units", std::move(units)},
               {"groups", std::move(groups)},
               {"amplitude_rule", rule_json(amplitude_rule)}};
  if (!of_designs.empty()) drawing["design_groups"] = std::move(of_designs);
  drawing["frequency"] = {{"unit", results::frequency_unit(display)},
                          {"factor", results::shown_frequency(display, 1)},
                          {"label", results::frequency_heading(display)}};
  return drawing.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace trivet::report
