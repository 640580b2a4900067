// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "trivet/foundation/plain_text.h"
#include "trivet/model/operating_excitation.h"
#include "trivet/project/analyses/analysis_reader.h"
#include "trivet/project/analyses/analysis_types.h"
#include "trivet/project/analyses/limits_reader.h"
#include "trivet/project/text/admissible_range.h"
#include "trivet/project/text/bands_reader.h"
#include "trivet/project/text/shared_keys.h"
#include "trivet/project/text/unit_slips.h"

namespace trivet::project {
namespace {

constexpr std::size_t most_operating_speeds = 100;
constexpr const char* speeds_example = R"(for instance speeds = ["980 rpm", ["600 rpm", "900 rpm"]])";

/// A speed with its unit: a bare 980 would be 980 rad/s, ten times what people mean.
std::optional<double> read_speed(TableReader& reader, const Node& value) {
  if (value.kind == Node::Kind::integer || value.kind == Node::Kind::real) {
    reader.error("speeds", value_text(value), "a speed needs its unit: rpm, 1/min, Hz or rad/s", speeds_example);
    return std::nullopt;
  }
  if (value.kind == Node::Kind::text)
    if (const auto given = to_si(value.text, Quantity::angular_frequency); !given) {
      const std::string remedy = unit_remedy(value.text, Quantity::angular_frequency, reader.path());
      reader.error("speeds", value_text(value), given.error() + "; a speed is in rpm, 1/min, Hz or rad/s",
                   remedy.starts_with("did you mean") ? remedy : speeds_example);
      return std::nullopt;
    }
  return reader.scalar(value, reader.path() + ".speeds", Quantity::angular_frequency);
}

void read_range_of_speeds(TableReader& reader, const Node& pair, std::vector<assembly::Band>& speeds) {
  if (pair.items.size() != 2) {
    reader.error("speeds", fmt::format("a list of {}", pair.items.size()),
                 "a range of speeds is [from, to] with 0 ≤ from < to", speeds_example);
    return;
  }
  const auto from = read_speed(reader, pair.items[0]), to = read_speed(reader, pair.items[1]);
  if (!from || !to) return;
  if (const auto broken = wrong_band(*from, *to))
    reader.error("speeds", fmt::format("{} … {}", value_text(pair.items[0]), value_text(pair.items[1])),
                 "a range of speeds is [from, to] with 0 ≤ from < to" +
                     (*from >= 0 && *from < *to ? ", and " + *broken : std::string()),
                 *to > 0 && *from > *to ? "exchange the ends" : speeds_example);
  else speeds.push_back({*from, *to});
}

/// @param items  as written  @param speeds  that were read from them, all if none is wrong
void report_repeated_speeds(TableReader& reader, const std::vector<Node>& items,
                            const std::vector<assembly::Band>& speeds) {
  if (items.size() != speeds.size()) return;
  for (std::size_t i = 1; i < speeds.size(); ++i) {
    const auto end = speeds.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find(speeds.begin(), end, speeds[i]) == end) continue;
    const Node& item = items[i];
    const std::string words = item.kind == Node::Kind::array
        ? fmt::format("{} … {}", value_text(item.items[0]), value_text(item.items[1]))
        : value_text(item);
    reader.error("speeds", words, "this speed is named twice, and each would be counted and judged twice",
                 "remove one of them");
  }
}

std::vector<assembly::Band> read_speeds(TableReader& reader) {
  std::vector<assembly::Band> speeds;
  const Node* list = reader.node("speeds");
  if (!list) {
    reader.missing("speeds", std::string("give the speeds at which the machine runs, ") + speeds_example);
    return speeds;
  }
  const std::vector<Node> one = {*list};
  const std::vector<Node>& items = list->kind == Node::Kind::array ? list->items : one;
  if (items.empty()) reader.error("speeds", "an empty list", "at least one speed is expected", speeds_example);
  if (items.size() > most_operating_speeds)
    reader.error("speeds", fmt::format("{} speeds", items.size()),
                 fmt::format("at most {} are computed", most_operating_speeds), "name ranges, or fewer speeds");
  for (const Node& item : items) {
    if (item.kind == Node::Kind::array) {
      read_range_of_speeds(reader, item, speeds);
      continue;
    }
    const auto speed = read_speed(reader, item);
    if (speed && !(*speed > 0)) reader.error("speeds", value_text(item), "a speed is > 0", speeds_example);
    else if (speed) speeds.push_back({*speed, *speed});
  }
  report_repeated_speeds(reader, items, speeds);
  return speeds;
}

OperationAnalysis read_operation(TableReader& reader, const ResultNames& names, const SymbolTable& symbols) {
  OperationAnalysis request;
  request.selection.of.clear();  // all coordinates and points
  request.speeds = read_speeds(reader);
  read_of(reader, names, request.selection.of);
  std::vector<std::string> known = symbols.harmonic_excitations;
  for (const std::string& name : symbols.order_excitations)
    if (std::ranges::find(known, name) == known.end()) known.push_back(name);
  request.selection.excitations = read_selected(reader, known, "harmonic or order");
  request.limits =
      read_amplitude_limits(reader, "limits", names, assembly::MotionQuantity::displacement, Levels::of_orders);
  request.bands = read_bands(reader, "bands");
  return request;
}

/// Reports a model in which nothing runs at a speed.
void check_operation(const Analyses& request, const model::System& system, foundation::Problems& problems) {
  if (!request.operation->selection.excitations.empty()) return;
  if (std::ranges::any_of(system.description().excitations, model::runs_with_machine)) return;
  std::vector<std::string> of_ground;
  for (const model::Excitation& one : system.description().excitations)
    if (std::holds_alternative<model::Harmonic>(one.course)) of_ground.push_back(foundation::quoted(one.name));
  const std::string names = foundation::comma_separated(of_ground);
  problems.error(
      "operation", "no excitation runs at a speed",
      fmt::format("the harmonic excitations of the model ({}) move the ground, which does not follow the "
                  "machine and counts only if operation.excitations names it",
                  names),
      fmt::format("write excitations = [{}], or add [excitations.NAME] with type = \"unbalance\", \"orders\" "
                  "or \"harmonic\" on a body",
                  names));
}

}  // namespace

const AnalysisReader operation_analysis = read_into<&Analyses::operation, read_operation>(
    {.at_top = true,
     .drive = Drive::harmonic_or_orders,
     .searches_peaks = true,
     .check = check_operation,
     .keys = R"json({"description": "results at the speeds at which the machine runs",
  "properties": {
   "speeds": {"anyOf": [{"type": "string"}, {"type": "array", "minItems": 1, "items": {"anyOf": [{"type": "string"},
     {"type": "array", "items": {"type": "string"}, "minItems": 2, "maxItems": 2}]}}],
     "description": "speeds at which the machine runs: \"980 rpm\"; a pair is a range"},
   "of": {"$ref": "#/$defs/answers_of"},
   "excitations": {"$ref": "#/$defs/selected_excitations",
     "description": "that run; default: orders, unbalances and harmonic forces on bodies"},
   "limits": {"$ref": "#/$defs/amplitude_limits",
     "description": "\"BODY.x\" = largest value at each of the speeds, all orders together, at its level (rms, 0-p, p-p; without one 0-p)"},
   "bands": {"$ref": "#/$defs/bands",
     "description": "also the root mean square of the orders in each band, judged by limit lines over such bands; default: those of the limit lines"}},
  "required": ["speeds"]})json"});

}  // namespace trivet::project
