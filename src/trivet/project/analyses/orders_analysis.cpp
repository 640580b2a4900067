// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/analysis_types.h"

#include "trivet/project/analyses/analysis_reader.h"
#include "trivet/project/analyses/request_readers.h"
#include "trivet/project/text/shared_keys.h"

namespace trivet::project {
namespace {

OrdersAnalysis read_orders_analysis(TableReader& reader, const ResultNames& names, const SymbolTable& symbols) {
  OrdersAnalysis request;
  read_selection(reader, names, symbols.order_excitations, "order", request.selection);
  if (!reader.has("speed"))
    reader.missing("speed", "give the range of shaft speeds: speed = [\"600 rpm\", \"3000 rpm\"]");
  request.speed = read_band(reader, "speed").value_or(assembly::Band{0, 1});
  request.at = read_single_frequencies(reader);
  return request;
}

}  // namespace

const AnalysisReader orders_analysis = read_into<&Analyses::orders, read_orders_analysis>(
    {.drive = Drive::orders,
     .searches_peaks = true,
     .keys = R"json({"description": "response to the orders of a shaft over its speed",
  "properties": {
   "of": {"$ref": "#/$defs/answers_of"},
   "quantity": {"$ref": "#/$defs/quantity"},
   "excitations": {"$ref": "#/$defs/selected_excitations"},
   "speed": {"type": "array", "items": {"$ref": "#/$defs/number"}, "minItems": 2, "maxItems": 2,
     "description": "shaft speeds, rad/s or with a unit"},
   "at": {"type": "array", "items": {"$ref": "#/$defs/number"}, "minItems": 1,
     "description": "single speeds told besides, rad/s or with a unit"}},
  "required": ["speed"]})json"});

}  // namespace trivet::project
