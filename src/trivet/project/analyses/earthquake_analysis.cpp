// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/analysis_types.h"

#include <algorithm>
#include <functional>
#include <numbers>

#include "trivet/project/analyses/analysis_reader.h"
#include "trivet/project/text/pairs_reader.h"

namespace trivet::project {
namespace {

/// `rows` or `file` of S_a over natural period (default) or frequency.
EarthquakeAnalysis read_earthquake(TableReader& reader, const ResultNames& names, const SymbolTable&) {
  EarthquakeAnalysis request;
  read_of(reader, names, request.selection.of);
  const auto quantity = reader.choice("quantity", assembly::motion_names());
  if (quantity) request.selection.quantity = assembly::motion_quantity(*quantity);
  for (const std::string& word : request.selection.of)
    if (word == "base" || word.starts_with("base."))
      reader.error("of", "\"" + word + "\"",
                   "earthquake results are those of bodies and elements, relative to the ground", "remove it");
  if (!reader.has("direction"))
    reader.missing("direction", "give the direction of the ground motion: direction = \"x\"");
  request.direction = reader.direction("direction").value_or(Eigen::Vector3d::UnitX());
  const double damping = reader.number("damping", Quantity::pure).value_or(0.05);
  const bool over_period = reader.choice("over", {"period", "frequency"}).value_or("period") == "period";
  const ColumnQuantity place = over_period ? ColumnQuantity(Quantity::time) : in_hertz(),
                       acceleration = read_bare_unit(reader, Quantity::acceleration);
  const auto rows = reader.has("rows")
      ? read_pairs(reader, "rows", place, acceleration)
      : read_pairs_of_file(reader, over_period ? "period" : "frequency_hz", "acceleration", place, acceleration);
  if (!rows) return request;
  const std::string source = reader.has("rows") ? "rows" : "file";
  std::vector<double> places(rows->col(0).begin(), rows->col(0).end()),
      accelerations(rows->col(1).begin(), rows->col(1).end());
  for (double& one : accelerations) one *= acceleration.bare;
  if (std::ranges::any_of(places, [](double x) { return !(x > 0); })) {
    reader.error(source, "a period or frequency that is not > 0", "a spectrum on logarithmic axes begins above 0",
                 "give the peak ground acceleration at a short period, 0.01 s for instance");
    return request;
  }
  if (std::ranges::adjacent_find(places, std::greater_equal<>()) != places.end()) {
    reader.error(source, over_period ? "periods" : "frequencies", "they increase from row to row", "sort the rows");
    return request;
  }
  if (over_period) {
    request.spectrum = excitation::over_period(places, accelerations, damping);
  } else {
    for (double& hertz : places) hertz *= 2 * std::numbers::pi;
    request.spectrum = {places, accelerations, damping};
  }
  reader.add(excitation::check(request.spectrum, source));
  return request;
}

}  // namespace

const AnalysisReader earthquake_analysis = read_into<&Analyses::earthquake, read_earthquake>(
    {.keys = R"json({"description": "largest responses to an earthquake, from its response spectrum",
  "properties": {
   "of": {"$ref": "#/$defs/answers_of"},
   "quantity": {"$ref": "#/$defs/quantity"},
   "direction": {"$ref": "#/$defs/direction", "description": "of the motion of the ground"},
   "damping": {"$ref": "#/$defs/number", "description": "damping ratio of the spectrum (default: 0.05)"},
   "over": {"enum": ["period", "frequency"], "description": "first column of the spectrum (default: period)"},
   "rows": {"type": "array", "minItems": 2, "items": {"type": "array", "minItems": 2, "maxItems": 2,
     "items": {"$ref": "#/$defs/number"}}, "description": "period in s (or frequency in Hz) and S_a in m/s2, or with units"},
   "unit": {"type": "string", "description": "of S_a without a unit: \"g\" (default: SI)"},
   "file": {"type": "string", "description": "CSV with the columns period (or frequency_hz) and acceleration"},
   "period": {"type": "string", "description": "name of this column, if it is another"},
   "frequency_hz": {"type": "string", "description": "name of this column, if it is another"},
   "acceleration": {"type": "string", "description": "name of this column, if it is another"}},
  "required": ["direction"]})json"});

}  // namespace trivet::project
