// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "trivet/foundation/plain_text.h"
#include "trivet/response/machinery/transmissibility.h"
#include "trivet/results/analyses/operation_levels.h"
#include "trivet/results/analyses/operation_limits.h"
#include "trivet/results/analyses/operation_words.h"
#include "trivet/results/format/result_writer.h"
#include "trivet/study/analyses/analysis_results.h"

/// What happens at the speeds at which a machine runs.
namespace trivet::results {
namespace {

using study::OperatingIsolation;
using study::OperatingMode;
using study::OperatingMotion;
using study::OperatingSpeed;
using study::OperatingValue;
using study::OperationResult;

/// Something at one of the speeds.
template <typename What>
struct AtSpeed {
  const OperatingSpeed* in;
  const What* what;
};

template <typename What>
std::vector<AtSpeed<What>> at_all_speeds(const OperationResult& found, std::vector<What> OperatingSpeed::* list) {
  std::vector<AtSpeed<What>> rows;
  for (const OperatingSpeed& at : found.speeds)
    for (const What& one : at.*list) rows.push_back({&at, &one});
  return rows;
}

/// The columns `from` and `to` of the speeds.
template <typename Row>
std::vector<Column> speed_columns(const Rows<Row>& row) {
  return {row("from", Kind::speed, "", [](const Row& one) { return one.in->speed.from; }),
          row("to", Kind::speed, "", [](const Row& one) { return one.in->speed.to; })};
}

std::vector<Column> joined_columns(std::vector<Column> first, std::vector<Column> then) {
  std::ranges::move(then, std::back_inserter(first));
  return first;
}

struct ValueRow {
  const OperatingSpeed* in;
  const OperatingValue* what;
  const char* quantity;
};

/// All values, for programs.
Table operating_values(const OperationResult& found) {
  std::vector<ValueRow> list;
  for (const OperatingSpeed& at : found.speeds) {
    for (const OperatingMotion& motion : at.motions) list.push_back({&at, &motion.displacement, "displacement"});
    for (const OperatingMotion& motion : at.motions) list.push_back({&at, &motion.velocity, "velocity"});
    for (const OperatingValue& force : at.forces) list.push_back({&at, &force, "force"});
  }
  const Rows row(std::move(list));
  return {
      .key = "values",
      .axis = "value",
      .file = "operation.csv",
      .rows = row.size(),
      .columns = joined_columns(
          speed_columns(row),
          {row("name", Kind::words, "", [](const ValueRow& one) { return one.what->name; }),
           row("quantity", Kind::words, "", [](const ValueRow& one) { return one.quantity; }),
           row("unit", Kind::words, "", [](const ValueRow& one) { return one.what->unit; }),
           row("amplitude", Kind::amplitude, "", [](const ValueRow& one) { return one.what->amplitude(); }),
           row("rms", Kind::quantity, "", [](const ValueRow& one) { return one.what->rms; }),
           row("bound", Kind::quantity, "", [](const ValueRow& one) { return one.what->bound; }),
           row("peak", Kind::quantity, "", [](const ValueRow& one) { return one.what->peak; }),
           row("span", Kind::quantity, "", [](const ValueRow& one) { return one.what->span; }),
           row("at", Kind::speed, "", [](const ValueRow& one) { return one.what->at; }),
           row("order", Kind::number, "", [](const ValueRow& one) { return one.what->order; }),
           row("reason", Kind::words, "", [](const ValueRow& one) { return one.what->reason; }, {.forms = in_json})}),
      .csv = {"from [rpm]", "to [rpm]", "name", "quantity", "unit", "amplitude", "rms", "bound", "peak", "span",
              "at [rpm]", "order"},
      .forms = for_programs};
}

std::vector<Column> isolation_columns(const Rows<AtSpeed<OperatingIsolation>>& row) {
  using One = AtSpeed<OperatingIsolation>;
  const auto number = [](auto of) {
    return [of](const One& one) { return one.what->reason.empty() ? Json(of(*one.what)) : Json(); };
  };
  return {
      row("excitation", Kind::words, "exciting force", [](const One& one) { return one.what->excitation; }),
      row("order", Kind::number, "order", [](const One& one) { return one.what->order; }),
      row("direction", Kind::words, "direction", [](const One& one) { return one.what->direction; }),
      row("unit", Kind::words, "", [](const One& one) { return one.what->unit; }),
      row("exciting", Kind::amplitude, "excites", number([](const OperatingIsolation& one) { return one.exciting; })),
      row("transmitted", Kind::amplitude, "transmitted",
          number([](const OperatingIsolation& one) { return one.transmitted(); })),
      row("transmissibility", Kind::number, "T",
          number([](const OperatingIsolation& one) { return one.transmissibility; }), {.digits = 4}),
      row("isolation", Kind::share, "isolation",
          number([](const OperatingIsolation& one) { return response::isolation_efficiency(one.transmissibility); })),
      row("isolation_db", Kind::number, "isolation",
          number([](const OperatingIsolation& one) { return response::isolation_level(one.transmissibility); }),
          {.unit = "dB", .digits = 3}),
      row("at", Kind::speed, "at", number([](const OperatingIsolation& one) { return one.at; })),
      row("reason", Kind::words, "", [](const One& one) { return one.what->reason; }, {.forms = for_programs}),
      row("remark", Kind::words, "remark",
          [](const One& one) -> std::string {
            return one.what->reason.empty() ? one.what->transmissibility > 1 ? "AMPLIFIED" : "isolated" : "not defined";
          },
          {.forms = for_people})};
}

Table operating_isolation(const OperationResult& found) {
  const Rows row(at_all_speeds(found, &OperatingSpeed::isolation));
  return {.key = "isolation",
          .axis = "isolation",
          .file = "operation_isolation.csv",
          .rows = row.size(),
          .columns = joined_columns(speed_columns(row), isolation_columns(row)),
          .csv = {"from [rpm]",
                  "to [rpm]",
                  "excitation",
                  "order",
                  "direction",
                  "unit",
                  "exciting",
                  "transmitted",
                  "transmissibility",
                  "isolation",
                  {"isolation [dB]", "isolation_db"},
                  "at [rpm]",
                  "reason"},
          .forms = for_programs};
}

std::vector<Column> mode_columns(const Rows<AtSpeed<OperatingMode>>& row) {
  using One = AtSpeed<OperatingMode>;
  return {row("mode", Kind::number, "mode", [](const One& one) { return one.what->mode; }),
          row("angular_frequency", Kind::frequency, "f", [](const One& one) { return one.what->angular_frequency; }),
          row("order", Kind::number, "order", [](const One& one) { return one.what->order; }),
          row("excitation_frequency", Kind::frequency, "excited at",
              [](const One& one) { return one.what->order * one.what->at; }),
          row("ratio", Kind::share, "of its f", [](const One& one) { return one.what->ratio; }),
          row("distance", Kind::share, "distance", [](const One& one) { return one.what->distance(); }),
          row("at", Kind::speed, "", [](const One& one) { return one.what->at; }),
          row("passes", Kind::yes_no, "", [](const One& one) { return one.what->passes; }, {.forms = for_programs}),
          row("near", Kind::yes_no, "", [](const One& one) { return one.what->is_near(); }, {.forms = for_programs}),
          row("modal_force_share", Kind::share, "share of the modal force",
              [](const One& one) { return one.what->modal_force_share; }),
          row("excited", Kind::yes_no, "", [](const One& one) { return one.what->excited; }, {.forms = for_programs}),
          row("remark", Kind::words, "remark", [](const One& one) { return nearness_remark(*one.what); },
              {.forms = for_people})};
}

Table operating_modes(const OperationResult& found) {
  const Rows row(at_all_speeds(found, &OperatingSpeed::modes));
  return {.key = "modes",
          .axis = "operating_mode",
          .file = "operation_modes.csv",
          .rows = row.size(),
          .columns = joined_columns(speed_columns(row), mode_columns(row)),
          .csv = {"from [rpm]",
                  "to [rpm]",
                  "mode",
                  {"frequency [Hz]", "angular_frequency [Hz]"},
                  "order",
                  {"excitation_frequency [Hz]", "excitation_frequency [Hz]"},
                  "ratio",
                  "distance",
                  "at [rpm]",
                  "passes",
                  "near",
                  "modal_force_share",
                  "excited"},
          .forms = for_programs};
}

// For people: the tables of one speed.

Table shown_isolation(const OperatingSpeed& at, bool several_orders) {
  std::vector<AtSpeed<OperatingIsolation>> list;
  for (const OperatingIsolation& one : at.isolation) list.push_back({&at, &one});
  const Rows row(std::move(list));
  std::vector<Use> columns = {"excitation", "direction", "exciting", "transmitted", "isolation", "isolation_db"};
  if (several_orders) columns.insert(columns.begin() + 1, "order");
  if (at.is_range()) columns.emplace_back("at");
  columns.emplace_back("remark");
  return {.title = "How much of the exciting forces does not reach the ground",
          .rows = row.size(),
          .columns = isolation_columns(row),
          .people = std::move(columns),
          .most_rows = 40,
          .height = [&at](std::size_t i) { return at.isolation[i].transmissibility; },
          .what_is_high = "least isolated",
          .mark =
              [&at](std::size_t i) {
                return !at.isolation[i].reason.empty()     ? Mark::doubt
                    : at.isolation[i].transmissibility > 1 ? Mark::bad
                                                           : Mark::plain;
              },
          .forms = for_people};
}

/// What people see of a value: of one order its amplitude, at the level of [display]; of several their root mean
/// square, because their peak is another number than √2 times it.
std::pair<Kind, double (*)(const OperatingValue&)> shown_values(bool several_orders) {
  if (several_orders) return {Kind::quantity, [](const OperatingValue& value) { return value.rms; }};
  return {Kind::amplitude, [](const OperatingValue& value) { return value.amplitude(); }};
}

Table shown_motions(const OperatingSpeed& at, bool several_orders) {
  const Rows row(at.motions);
  std::vector<Use> columns = {"name", "velocity", "displacement"};
  if (several_orders) columns.emplace_back("order");
  if (at.is_range()) columns.insert(columns.end(), {"at", "displacement_at"});
  const auto [kind, shown] = shown_values(several_orders);
  return {.title = at.is_range() ? "Largest motion" : "Motion",
          .rows = row.size(),
          .columns = {row("name", Kind::words, "result", [](const OperatingMotion& m) { return m.displacement.name; }),
                      row("unit", Kind::words, "", [](const OperatingMotion& m) { return m.displacement.unit; }),
                      row("velocity_unit", Kind::words, "", [](const OperatingMotion& m) { return m.velocity.unit; }),
                      row("velocity", kind, several_orders ? "velocity, rms" : "velocity",
                          [shown](const OperatingMotion& m) { return shown(m.velocity); },
                          {.unit = "@velocity_unit", .digits = 4}),
                      row("displacement", kind, several_orders ? "displacement, rms" : "displacement",
                          [shown](const OperatingMotion& m) { return shown(m.displacement); }, {.digits = 4}),
                      row("order", Kind::number, "most in order",
                          [](const OperatingMotion& m) { return m.velocity.order; }),
                      row("at", Kind::speed, "velocity at", [](const OperatingMotion& m) { return m.velocity.at; }),
                      row("displacement_at", Kind::speed, "displacement at",
                          [](const OperatingMotion& m) { return m.displacement.at; })},
          .people = std::move(columns),
          .most_rows = 60,
          .height = [&at](std::size_t i) { return at.motions[i].velocity.rms; },
          .forms = for_people};
}

/// The three forces of one place.
struct ForceOfPlace {
  std::string place;
  const OperatingValue* along[3] = {nullptr, nullptr, nullptr};
};

std::vector<ForceOfPlace> forces_of_places(const OperatingSpeed& at) {
  std::vector<ForceOfPlace> list;
  for (const OperatingValue& force : at.forces) {
    const std::size_t dot = force.name.rfind(".force.");
    if (dot == std::string::npos) continue;
    const std::string place = force.name.substr(0, dot);
    auto found = std::ranges::find(list, place, &ForceOfPlace::place);
    if (found == list.end()) found = list.insert(found, {.place = place});
    found->along[force.name.back() - 'x'] = &force;
  }
  return list;
}

Table shown_forces(const OperatingSpeed& at, bool several_orders) {
  const Rows row(forces_of_places(at));
  const auto [kind, shown] = shown_values(several_orders);
  const auto along = [&row, kind, shown](int axis, const char* name, const char* heading) {
    return row(
        name, kind, heading,
        [axis, shown](const ForceOfPlace& one) { return one.along[axis] ? Json(shown(*one.along[axis])) : Json(); },
        {.unit = "N", .digits = 4});
  };
  return {.title = std::string(at.is_range() ? "Largest forces" : "Forces") +
              " on the ground, in total and of each mount" + (several_orders ? ", rms" : ""),
          .rows = row.size(),
          .columns = {row("place", Kind::words, "on the ground by", &ForceOfPlace::place), along(0, "x", "x"),
                      along(1, "y", "y"), along(2, "z", "z")},
          .most_rows = 40,
          .one_prefix = true,
          .forms = for_people};
}

Table shown_modes(const OperatingSpeed& at) {
  std::vector<AtSpeed<OperatingMode>> list;
  for (const OperatingMode& one : at.modes) list.push_back({&at, &one});
  const Rows row(std::move(list));
  return {
      .title = fmt::format("Distance from resonance (near: within {:.0f} % of a natural frequency)",
                           100 * study::near_resonance),
      .rows = row.size(),
      .columns = mode_columns(row),
      .people = {"mode", "angular_frequency", "order", "excitation_frequency", "ratio", "distance", "remark"},
      .most_rows = 40,
      .height = [&at](std::size_t i) { return -std::abs(at.modes[i].distance()); },
      .what_is_high = "nearest",
      .mark = [&at](std::size_t i) { return at.modes[i].is_near() && at.modes[i].excited ? Mark::bad : Mark::plain; },
      .forms = for_people};
}

/// Why values are infinite.
std::string unbounded_words(const OperatingSpeed& at) {
  std::vector<std::string> reasons;
  const auto add = [&](const OperatingValue& value) {
    if (!value.reason.empty() && std::ranges::find(reasons, value.reason) == reasons.end())
      reasons.push_back(value.reason);
  };
  for (const OperatingMotion& motion : at.motions) add(motion.displacement), add(motion.velocity);
  for (const OperatingValue& force : at.forces) add(force);
  for (const study::OperatingLimit& limit : at.limits) add(limit.value);
  return reasons.empty() ? std::string() : fmt::format("Unbounded: {}", fmt::join(reasons, "; "));
}

std::string undefined_isolation(const OperatingSpeed& at) {
  std::vector<std::string> reasons;
  for (const OperatingIsolation& one : at.isolation)
    if (!one.reason.empty() && std::ranges::find(reasons, one.reason) == reasons.end()) reasons.push_back(one.reason);
  return reasons.empty() ? std::string() : fmt::format("Isolation not defined: {}", fmt::join(reasons, "; "));
}

Group shown_speed(const OperatingSpeed& at, bool several_orders, const project::DisplayUnits& display) {
  Group group{.key = "", .parts = {}, .title = "At " + study::speed_words(at.speed)};
  constexpr unsigned details = on_screen | on_page;
  if (!at.limits.empty()) group.parts.push_back({shown_limits(at, display)});
  group.parts.push_back({shown_isolation(at, several_orders)});
  group.parts.push_back(
      {Sentence{.parts = {undefined_isolation(at)}, .place = Sentence::Place::note, .forms = details}});
  group.parts.push_back({shown_motions(at, several_orders)});
  group.parts.push_back({shown_forces(at, several_orders)});
  group.parts.push_back({Sentence{.parts = {unbounded_words(at)}, .place = Sentence::Place::note, .forms = details}});
  group.parts.push_back({shown_modes(at)});
  for (Part& part : group.parts)
    if (auto* table = std::get_if<Table>(&part.content)) table->forms = details;
  return group;
}

Document operation_document(const project::Case& variant, const study::CaseResults& results) {
  const OperationResult& found = *results.operation;
  const bool several_orders = found.orders.size() > 1;
  Document document;
  document.add(Single{.name = "near", .value = study::near_resonance});
  document.add(Single{.name = "excitations", .value = found.excitations});
  document.add(Single{.name = "orders", .value = found.orders});
  document.add(Sentence{.parts = {"Excited by " + foundation::comma_separated(found.excitations) +
                                  (several_orders ? ": orders together, as their root mean square"
                                                  : std::string(" at the frequency of the speed"))},
                        .forms = on_screen | on_page});
  for (const OperatingSpeed& at : found.speeds) document.add(operation_sentence(at));
  document.add(operating_values(found));
  document.add(operating_isolation(found));
  document.add(operating_modes(found));
  document.add(operating_limits(found));
  if (!found.levels.empty()) document.add(operating_levels(found));
  for (const OperatingSpeed& at : found.speeds) {
    document.add(shown_speed(at, several_orders, variant.display));
    if (!found.levels.empty()) document.add(shown_levels(found, at.speed));
  }
  document.add(warnings_part(results));
  return document;
}

}  // namespace

const ResultWriter operation_results = {.document = operation_document,
                                        .files = {"operation.csv", "operation_isolation.csv", "operation_modes.csv"},
                                        .optional_file = {"operation_bands.csv", [](const study::CaseResults& results) {
                                                            return !results.operation->levels.empty();
                                                          }}};

}  // namespace trivet::results
