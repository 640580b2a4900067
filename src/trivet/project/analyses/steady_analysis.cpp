// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/analysis_types.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "trivet/project/analyses/analysis_reader.h"
#include "trivet/project/analyses/request_readers.h"
#include "trivet/project/text/shared_keys.h"

namespace trivet::project {
namespace {

/// `over`, `at` and `load_factor`.
void read_load_factor(TableReader& reader, const ResultNames& names, SteadyAnalysis& request) {
  const auto over = reader.choice("over", {"frequency", "load_factor"});
  request.over_load_factor = over && *over == "load_factor";
  if (!request.over_load_factor) {
    for (const char* key : {"at", "load_factor", "phase"})
      if (reader.has(key)) {
        reader.also_known({key});
        reader.error(key, "without over = \"load_factor\"", "the load factor is varied only then",
                     std::string("add it, or remove ") + key);
      }
    return;
  }
  if (const Node* table = reader.table("phase")) {
    TableReader phase(*table, reader.path() + ".phase", reader.problems());
    request.phase_of = phase.required_text("of");
    if (!request.phase_of.empty() && !names.component(request.phase_of, assembly::MotionQuantity::displacement))
      names.refuse(phase, "of", request.phase_of, "one displacement or rotation");
    constexpr double resonance = std::numbers::pi / 2;
    request.lag = phase.number("lag", Quantity::angle).value_or(resonance);
    if (std::abs(request.lag) > 2 * std::numbers::pi)
      phase.error("lag", fmt::format("{:.6g} degrees", request.lag * 180 / std::numbers::pi),
                  "a lag is less than a revolution; a number without a unit is in rad",
                  "write for instance \"90 deg\"");
    phase.finish();
    if (reader.has("at")) reader.error("at", "at beside phase", "the frequency follows the phase then", "remove one");
  } else {
    if (reader.has("band"))
      reader.error("band", "over the load factor", "the frequency is fixed then", "remove band, and give at");
    request.at = reader.required_number("at", Quantity::angular_frequency);
  }
  if (reader.has("at") && !(request.at > 0))
    reader.error("at", value_text(*reader.node("at"), 0), "it is > 0", "correct it");
  if (!reader.has("load_factor")) reader.missing("load_factor", "give its range: load_factor = [0.1, 2]");
  const auto range = reader.numbers("load_factor", Quantity::pure);
  if (!range) return;
  if (range->size() == 2 && (*range)[0] > 0 && (*range)[1] > (*range)[0]) {
    request.load_from = (*range)[0];
    request.load_to = (*range)[1];
  } else {
    reader.error("load_factor", fmt::format("[{:.6g}]", fmt::join(*range, ", ")),
                 "two numbers that rise from above 0 are expected", "for instance load_factor = [0.1, 2]");
  }
}

SteadyAnalysis read_steady(TableReader& reader, const ResultNames& names, const SymbolTable& symbols) {
  SteadyAnalysis request;
  std::vector<std::string> periodic = symbols.harmonic_excitations;
  for (const std::string& name : symbols.order_excitations)
    if (std::ranges::find(periodic, name) == periodic.end()) periodic.push_back(name);
  read_selection(reader, names, periodic, "harmonic or order", request.selection);
  request.band = read_band(reader, "band");
  if (request.band && !(request.band->from > 0))
    reader.error("band", "a band from 0", "the motions are followed over a frequency above 0",
                 "begin at a low frequency, such as a tenth of the first natural one");
  read_load_factor(reader, names, request);
  read_harmonics(reader, request.harmonics, request.tolerance);
  const auto branches = reader.choice("branches", {"connected", "all"});
  request.all_branches = branches && *branches == "all";
  request.deep = reader.boolean("deep").value_or(false);
  for (const auto& [key, is_set] : {std::pair("branches", request.all_branches), std::pair("deep", request.deep)})
    if (is_set && !request.phase_of.empty())
      reader.error(key, "with a phase", "at a phase one curve is followed, with one verdict on stability",
                   "remove it, or take over = \"frequency\"");
  return request;
}

void check_steady(const Analyses&, const model::System& system, foundation::Problems& problems) {
  require_nonlinear("analyses.steady", "take response, or give an element laws or a stop (docs/nonlinear.md)", system,
                    problems);
}

}  // namespace

const AnalysisReader steady_analysis = read_into<&Analyses::steady, read_steady>(
    {.drive = Drive::harmonic_or_orders,
     .check = check_steady,
     .keys = R"json({"description": "all periodic motions of a nonlinear machine under harmonic excitations or orders",
  "properties": {
   "of": {"$ref": "#/$defs/answers_of"},
   "quantity": {"$ref": "#/$defs/quantity"},
   "excitations": {"$ref": "#/$defs/selected_excitations"},
   "band": {"$ref": "#/$defs/band"},
   "over": {"enum": ["frequency", "load_factor"], "description": "what is varied (default: the frequency)"},
   "at": {"$ref": "#/$defs/number", "description": "rad/s: the frequency, over the load factor"},
   "phase": {"type": "object", "description": "instead of at: the frequency at which a displacement lags the excitation by a phase", "properties": {"of": {"type": "string", "description": "the displacement: BODY.x or BODY.POINT.z"}, "lag": {"$ref": "#/$defs/number", "description": "rad: behind the excitation (default: 90 degrees, phase resonance)"}}, "required": ["of"], "additionalProperties": false},
   "load_factor": {"type": "array", "items": {"type": "number", "exclusiveMinimum": 0}, "minItems": 2, "maxItems": 2, "description": "range of the factor on all excitations"},
   "harmonics": {"type": "integer", "minimum": 1, "maximum": 200, "description": "number of harmonics (default: as many as tolerance needs)"},
   "tolerance": {"$ref": "#/$defs/number", "description": "share of the deflections beyond the last harmonic, 0 to 1 (default: 1e-3)"},
   "branches": {"enum": ["connected", "all"], "description": "all: seek detached motions too (default: connected)"},
   "deep": {"type": "boolean", "description": "judge the stability of every point in two ways (default: false)"}}})json"});

}  // namespace trivet::project
