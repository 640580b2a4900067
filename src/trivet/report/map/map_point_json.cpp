// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/map/map_point_json.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "trivet/documents/base64.h"
#include "trivet/foundation/index.h"
#include "trivet/report/map/map_picture.h"
#include "trivet/results/design/map_summary.h"
#include "trivet/results/format/axis_words.h"

namespace trivet::report {
namespace {

using Json = nlohmann::ordered_json;

/// Of the numbers of all maps of a page; base64 needs four characters for three bytes.
constexpr double most_bytes_of_curves = 2.4e6;

template <typename Number>
class Packed {
 public:
  static_assert(std::endian::native == std::endian::little, "the page reads little-endian numbers");
  void add(Number number) {
    const std::size_t at = bytes_.size();
    bytes_.resize(at + sizeof(Number));
    std::memcpy(&bytes_[at], &number, sizeof(Number));
  }
  [[nodiscard]] std::string text() const { return documents::base64(bytes_); }

 private:
  std::vector<std::uint8_t> bytes_;
};

/// Rows of a matrix one after the other; real and imaginary parts alternate unless all are real.
template <typename Number>
std::string packed(const Eigen::MatrixXcd& numbers, bool real) {
  Packed<Number> list;
  for (Eigen::Index i = 0; i < numbers.rows(); ++i)
    for (Eigen::Index k = 0; k < numbers.cols(); ++k) {
      list.add(static_cast<Number>(numbers(i, k).real()));
      if (!real) list.add(static_cast<Number>(numbers(i, k).imag()));
    }
  return list.text();
}

/// The stored values of an axis: as numbers, in words, and their positions in the frame.
Json axis_json(const project::DesignAxis& axis, const std::vector<int>& lines) {
  Json values = Json::array(), words = Json::array(), shares = Json::array();
  for (const int line : lines) {
    const double share = static_cast<double>(line) / (axis.points - 1);
    shares.push_back(share);
    values.push_back(axis.at(share));
    words.push_back(results::axis_value(axis.at(share), axis));
  }
  return {{"parameter", axis.parameter}, {"name", results::axis_name(axis)}, {"unit", axis.unit},
          {"points", axis.points},       {"values", std::move(values)},      {"words", std::move(words)},
          {"shares", std::move(shares)}};
}

Json rules_json(const study::DesignMap& map) {
  Json list = Json::array();
  for (const design::MapRule& rule : map.rules) {
    const bool limits_curve = rule.kind == design::DesignRule::Kind::amplitude && rule.in_case.empty();
    list.push_back({{"words", results::rule_words(map, rule)}});
    if (limits_curve) list.back().update({{"name", rule.channel}, {"unit", rule.unit}, {"limit", rule.allowed}});
  }
  return list;
}

/// Verdicts of the stored designs, as the map has them.
void add_verdicts(const study::DesignMap& map, const study::MapCurves& curves, Json& json) {
  Packed<float> margins;
  Packed<std::uint8_t> governing;
  for (std::size_t node = 0; node < curves.count(); ++node) {
    const design::DesignOutcome& outcome = map.outcomes[curves.design(node, map.grid)];
    margins.add(outcome.margin);
    governing.add(outcome.governing);
  }
  json["margins"] = margins.text();
  json["governing"] = governing.text();
  json["no_model"] = design::DesignOutcome::no_model;
  json["not_computed"] = design::DesignOutcome::not_computed;
}

/// Column and row of the best design, or of the middle.
Json first_place(const study::DesignMap& map, const study::MapCurves& curves) {
  const auto nx = to_size(map.grid.nx);
  const auto place = [](const std::vector<int>& lines, std::size_t line) {
    return std::ranges::find(lines, static_cast<int>(line)) - lines.begin();
  };
  if (!map.best) return {curves.columns.size() / 2, curves.rows.size() / 2};
  return {place(curves.columns, *map.best % nx), place(curves.rows, *map.best / nx)};
}

Json of_map(const study::DesignMap& map, const study::MapCurves& curves) {
  Json json{{"x", axis_json(map.request.x, curves.columns)}, {"y", axis_json(map.request.y, curves.rows)}};
  json["frame"] = {map_frame.corner.x, map_frame.corner.y, map_frame.width, map_frame.height};
  json["start"] = first_place(map, curves);
  json["rules"] = rules_json(map);
  add_verdicts(map, curves, json);
  if (!curves.reason.empty()) {
    json["reason"] = curves.reason;
    return json;
  }
  Packed<std::uint8_t> drawn;
  for (const char one : curves.drawn) drawn.add(one ? 1 : 0);
  Json results = Json::array();
  for (std::size_t c = 0; c < curves.names.size(); ++c)
    results.push_back({{"name", curves.names[c]}, {"unit", curves.units[c]}});
  json["curves"] = {{"band", {curves.band.from, curves.band.to}},
                    {"results", std::move(results)},
                    {"delays", curves.form.delays},
                    {"powers", curves.form.powers},
                    {"pairs", curves.form.pairs},
                    {"real", curves.real},
                    {"rounded", curves.rounded},
                    {"error", curves.worst_error},
                    {"drawn", drawn.text()},
                    {"denominators", packed<double>(curves.denominators, curves.real)},
                    {"numerators",
                     curves.rounded ? packed<float>(curves.numerators, curves.real)
                                    : packed<double>(curves.numerators, curves.real)}};
  return json;
}

}  // namespace

CaseMapCurves case_map_curves(const project::Project& project, const std::vector<study::CaseResults>& results,
                              const foundation::Progress& progress) {
  const auto maps = std::ranges::count_if(results, [](const study::CaseResults& one) { return one.map.has_value(); });
  CaseMapCurves all;
  for (std::size_t i = 0; i < results.size(); ++i) {
    all.emplace_back();
    if (results[i].map)
      all.back() = study::map_curves(project.cases[i], *results[i].map,
                                     most_bytes_of_curves / static_cast<double>(maps), progress);
  }
  return all;
}

bool has_map_point(const CaseMapCurves& curves) {
  return std::ranges::any_of(curves, [](const auto& one) { return one.has_value(); });
}

std::string map_point_json(const std::vector<study::CaseResults>& results, const CaseMapCurves& curves) {
  Json list = Json::array();
  for (std::size_t i = 0; i < curves.size(); ++i)
    list.push_back(curves[i] ? of_map(*results[i].map, *curves[i]) : Json(nullptr));
  return list.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace trivet::report
