// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/limits_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>

#include "trivet/foundation/index.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/project/analyses/limit_line_level.h"
#include "trivet/project/analyses/named_limit_lines.h"
#include "trivet/project/analyses/selection_reader.h"
#include "trivet/project/text/bands_reader.h"
#include "trivet/project/text/level_slips.h"
#include "trivet/project/text/model_path.h"
#include "trivet/project/text/pairs_reader.h"
#include "trivet/project/text/shared_keys.h"

namespace trivet::project {

namespace {

/// Does a text begin with a number with a decimal comma: "4,5 mm/s rms"?
bool has_decimal_comma(const std::string& text) {
  const std::size_t end = text.find_first_not_of("0123456789");
  return end != std::string::npos && end > 0 && text[end] == ',';
}

/// Reads a number, or a text with a unit that distinguishes displacement, velocity and acceleration.
/// @param key  of the value, for messages
void read_limit(TableReader& reader, const std::string& key, const Node& value, const ResultNames& names,
                assembly::MotionQuantity usual, Levels levels, std::vector<AmplitudeLimit>& limits,
                const std::string& name) {
  if (value.kind == Node::Kind::text)
    if (const auto level = split_level(value.text).level)
      if (const auto reason = reason_against(levels, *level))
        return static_cast<void>(reader.error(key, value_text(value), *reason,
                                              "convert the limit, without " + std::string(level_ending(*level))));
  if (value.kind == Node::Kind::text)
    for (const assembly::MotionQuantity quantity : assembly::motion_quantities) {
      const auto si = to_si_at_level(value.text, *names.component(name, quantity), levels);
      if (!si) continue;
      if (!(*si > 0)) reader.error(key, value_text(value), "a limit is > 0", "change it");
      limits.push_back({name, quantity, *si, {}, {}, {}, {}, split_level(value.text).level});
      return;
    }
  if (value.kind == Node::Kind::text && levels != Levels::none)
    for (const assembly::MotionQuantity quantity : assembly::motion_quantities)
      if (const auto slip = level_slip(value.text, *names.component(name, quantity)))
        return static_cast<void>(reader.error(key, value_text(value), slip->rule, slip->remedy));
  if (value.kind == Node::Kind::text && has_decimal_comma(value.text))
    return static_cast<void>(
        reader.error(key, value_text(value), "write a decimal point, not a comma", "as in \"4.5 mm/s rms\""));
  if (value.kind == Node::Kind::text && written_number(value)) {
    std::string units;
    for (const assembly::MotionQuantity quantity : assembly::motion_quantities) {
      const std::string unit = si_unit(*names.component(name, quantity));
      if (units.find(unit) == std::string::npos) units += (units.empty() ? "" : " or ") + unit;
    }
    reader.error(key, value_text(value), "the limit of this result needs a unit of its kind",
                 "give " + units + ", or a multiple");
    return;
  }
  const auto amplitude = reader.scalar(value, reader.path() + "." + key, *names.component(name, usual), levels);
  if (amplitude && !(*amplitude > 0))
    reader.error(key, fmt::format("{:.6g} {}", *amplitude, si_unit(*names.component(name, usual))), "a limit is > 0",
                 "change it");
  if (amplitude) limits.push_back({name, usual, *amplitude, {}, {}, {}});
}

/// A limit at a speed of the machine belongs to [operation.limits]. @returns true if it was written as one
bool refuse_speed_of_machine(TableReader& reader, const std::string& name, const Node& table) {
  const Node *at = table.find("at"), *speed = table.find("speed");
  const bool of_operation = reader.path().starts_with("operation");
  const bool is_at_one = at || (speed && (speed->kind != Node::Kind::array || of_operation));
  if (!is_at_one) return false;
  TableReader inside(table, reader.path() + "." + name, reader.problems());
  const std::string limit = foundation::quoted(name) + " = \"4.5 mm/s rms\"";
  inside.error(at ? "at" : "speed", value_text(at ? *at : *speed),
               of_operation ? "a limit of [operation.limits] holds at all speeds of [operation]"
                            : "a limit at the speeds of the machine, all orders together, is in [operation.limits]",
               of_operation ? "write " + limit
                            : "write [operation] with speeds = [\"980 rpm\"], and below [operation.limits] " + limit);
  return true;
}

/// {limit = "4.5 mm/s", band = ["20 Hz", "26 Hz"], excitations = ["run"]}: a limit in a band, and under excitations, of
/// its own.
void read_scoped_limit(TableReader& reader, const std::string& name, const Node& table, const ResultNames& names,
                       assembly::MotionQuantity usual, Levels levels, const SymbolTable& symbols,
                       std::vector<AmplitudeLimit>& limits) {
  TableReader inside(table, reader.path() + "." + name, reader.problems());
  const std::size_t before = limits.size();
  if (const Node* limit = inside.node("limit")) read_limit(inside, "limit", *limit, names, usual, levels, limits, name);
  else inside.missing("limit", "give the largest amplitude: {limit = \"4.5 mm/s\", band = [\"20 Hz\", \"26 Hz\"]}");
  const auto band = read_band(inside, "band");
  std::optional<std::vector<std::string>> excitations;
  const auto speed = read_band(inside, "speed");
  if (band && inside.has("speed"))
    inside.error("speed", "band and speed",
                 "a limit is that of harmonic excitations in a band, or of orders over speeds",
                 "keep one; a list of limits has both");
  if (inside.has("speed") && symbols.order_excitations.empty())
    inside.error("speed", "no orders in the model", "this limit judges the motion under each order of a shaft",
                 "add [excitations.NAME] with type = \"orders\" or \"unbalance\", or give a band");
  if (inside.has("excitations"))
    excitations = inside.has("speed") ? read_selected(inside, symbols.order_excitations, "orders")
                                      : read_selected_harmonic(inside, symbols);
  inside.finish();
  for (std::size_t i = before; i < limits.size(); ++i) {
    limits[i].band = band;
    limits[i].excitations = excitations;
    limits[i].speed = speed;
  }
}

/// Reports two limits of one quantity: the larger one has no effect. Of several orders each level is another number.
void check_limits_differ(TableReader& reader, const std::string& name, const Node& list, Levels levels,
                         const std::vector<AmplitudeLimit>& limits) {
  for (std::size_t i = 0; i < limits.size(); ++i)
    for (std::size_t j = i + 1; j < limits.size(); ++j)
      if (limits[i].name == name && limits[j].name == name && limits[i].quantity == limits[j].quantity &&
          limits[i].band == limits[j].band && limits[i].excitations == limits[j].excitations &&
          limits[i].speed == limits[j].speed &&
          (levels != Levels::of_orders || level_of(limits[i]) == level_of(limits[j])))
        return static_cast<void>(reader.error(name, fmt::format("{} limits", list.items.size()),
                                              "the larger of two limits of one quantity has no effect",
                                              "keep the smaller"));
}

}  // namespace

std::vector<AmplitudeLimit> read_amplitude_limits(TableReader& owner, const std::string& key, const ResultNames& names,
                                                  assembly::MotionQuantity usual, Levels levels,
                                                  const SymbolTable* scoped) {
  std::vector<AmplitudeLimit> limits;
  const Node* table = owner.table(key);
  if (!table) return limits;
  TableReader reader(*table, owner.path() + "." + key, owner.problems());
  std::vector<std::string> place_of_table = path_keys(owner.path());
  place_of_table.push_back(key);
  const auto read_one = [&](const std::string& name, const Node& value, std::optional<std::size_t> item = {}) {
    const std::size_t before = limits.size();
    std::vector<std::string> place = place_of_table;
    place.push_back(name);
    if (item) place.push_back(std::to_string(*item));
    if (value.kind == Node::Kind::table && refuse_speed_of_machine(reader, name, value)) return;
    if (scoped && value.kind == Node::Kind::table) {
      place.emplace_back("limit");
      read_scoped_limit(reader, name, value, names, usual, levels, *scoped, limits);
    } else {
      read_limit(reader, name, value, names, usual, levels, limits, name);
    }
    for (std::size_t i = before; i < limits.size(); ++i) limits[i].place = place;
  };
  for (std::size_t i = 0; i < table->keys.size(); ++i) {
    const std::string& name = table->keys[i];
    const Node& value = *reader.node(name);
    if (!names.component(name, usual)) {
      refuse_limit(reader, names, name);
    } else if (value.kind == Node::Kind::array && value.items.empty()) {
      reader.error(name, "an empty list", "a list of limits has at least one", "write one, or remove the line");
    } else if (value.kind == Node::Kind::array) {
      for (std::size_t item = 0; item < value.items.size(); ++item) read_one(name, value.items[item], item);
      check_limits_differ(reader, name, value, levels, limits);
    } else {
      read_one(name, value);
    }
  }
  reader.finish();
  return limits;
}

std::vector<std::string> read_no_peak(TableReader& owner, const ResultNames& names, assembly::MotionQuantity quantity) {
  const auto words = owner.texts("no_peak", R"("coordinates", or ["BODY.x", "ELEMENT.force.z"])");
  if (!words) return {};
  for (const std::string& word : *words) {
    if (names.is_group(word) || names.component(word, quantity)) continue;
    if (names.is_guided(word)) {
      owner.error("no_peak", foundation::quoted(word),
                  "this coordinate is not in `free` of its body, so it does not move",
                  "name a free coordinate, or remove it");
      continue;
    }
    names.refuse(owner, "no_peak", word, "coordinates, a body, BODY.POINT, an element or one component of these");
  }
  return *words;
}

std::optional<assembly::MotionQuantity> read_quantity(TableReader& reader) {
  const auto word = reader.choice("quantity", assembly::motion_names());
  if (!word) return std::nullopt;
  return assembly::motion_quantity(*word);
}

namespace {

/// The tones at the speeds of the machine are judged in bands of the same width alone.
void warn_of_other_bands(TableReader& reader, bool named, const LimitLineRequest& request) {
  const std::string width = excitation::name(*request.bands);
  warn_at_key(reader, named ? "line" : "bands", "not judged at the operating speeds",
              "the line bounds the root mean square in " + width +
                  " bands, and [operation] has others: only the random vibration is compared with it",
              "give all lines and [operation] the same bands");
}

/// Are the orders at the speeds of the machine judged in such bands? [operation] takes those of its first line if it
/// names none.
bool has_bands(const Analyses& analyses, excitation::BandWidth bands) {
  return analyses.operation && analyses.operation->bands.value_or(bands) == bands;
}

/// Does a case add the speeds at which lines over bands are judged? The base model has nothing to compare with them.
bool a_case_has_speeds(TableReader& root) {
  const Node* cases = root.has("cases") ? root.node("cases") : nullptr;
  return cases && std::ranges::any_of(cases->items, [](const Node& one) { return one.find("operation") != nullptr; });
}

/// `bands` of a limit line, and the random excitations that it judges; a named line is in third octaves.
/// @returns false if it has an error
bool read_bands_of_line(TableReader& root, TableReader& reader, const SymbolTable& symbols, const Analyses& analyses,
                        bool named, LimitLineRequest& request) {
  if (!named && !reader.has("bands")) return true;
  request.bands = read_bands(reader, "bands");
  if (named && !reader.has("bands")) request.bands = excitation::BandWidth::third_octave;
  if (named && request.bands == excitation::BandWidth::octave)
    reader.error("bands", "\"octave\"", "the named lines are published for third octaves", "remove the key");
  else if (request.bands && symbols.random_excitations.empty() && !has_bands(analyses, *request.bands) &&
           !a_case_has_speeds(root))
    reader.error(
        named ? "line" : "bands", "no random excitation in the model",
        "a line over bands bounds the root mean square in each band, of a random vibration or of the orders "
        "at the speeds of [operation]; a sweep of one harmonic after the other has none",
        fmt::format("add [excitations.NAME] with type = \"random\", or {}, or "
                    "remove bands to compare the response",
                    analyses.operation ? fmt::format("bands = \"{}\" to [operation]", excitation::name(*request.bands))
                                       : "[operation] with the speeds of the machine"));
  else if (request.bands) {
    if (analyses.operation && !has_bands(analyses, *request.bands)) warn_of_other_bands(reader, named, request);
    if (analyses.random) request.excitations = analyses.random->selection.excitations;
    return true;
  }
  return false;
}

/// `line = "VC-E"`: its points from the table of published lines.
bool read_named_line(TableReader& reader, Quantity measured, LimitLineRequest& request) {
  const std::string name = reader.required_text("line");
  const NamedLimitLine* line = named_limit_line(name);
  const bool has_points = reader.has("rows") || reader.has("file");
  if (has_points) reader.also_known({"rows", "file", "frequency_hz", "limit", "unit"});
  for (const char* key : {"rows", "file"})
    if (line && reader.has(key))
      reader.error(key, "line and " + std::string(key), "a named line has its points", "keep one of the two");
  if (reader.has("line") && !line)
    reader.error("line", foundation::quoted(name), "the named lines are " + names_of_limit_lines(),
                 has_points ? "remove the key: a line with points of its own has the name of its table"
                            : "name one of these, or give the points of your line as rows");
  if (line && measured != Quantity::velocity)
    reader.error("line", foundation::quoted(name) + " for " + foundation::quoted(request.of),
                 "the named lines bound velocities of translation along x, y or z",
                 "judge such a component, without another quantity");
  reader.finish();
  if (!line || measured != Quantity::velocity) return false;
  for (const auto& [hertz, velocity] : line->points) {
    request.line.angular_frequency.push_back(2 * std::numbers::pi * hertz);
    request.line.limit.push_back(velocity);
  }
  request.source = line->source;
  return !reader.has("rows") && !reader.has("file");
}

/// A line over bands bounds random vibration, if the model has any, and the orders at the speeds of the machine.
void add_line(LimitLineRequest request, const SymbolTable& symbols, Analyses& result) {
  if (request.bands && result.operation) {
    if (!result.operation->bands) result.operation->bands = request.bands;
    result.operation->lines.push_back(request);
  }
  if (!request.bands || !symbols.random_excitations.empty()) result.limit_lines.push_back(std::move(request));
}

/// SI unit of the limits of a line.
std::string unit_of_limits(const std::string& of, Quantity measured, assembly::MotionQuantity quantity) {
  static constexpr std::array<const char*, 3> units = {"m", "m/s", "m/s²"}, turning = {"rad", "rad/s", "rad/s²"};
  if (measured == Quantity::force) return "N";
  if (measured == Quantity::moment) return "N m";
  const bool turns = of.size() > 3 && of[of.size() - 2] == 'r';
  return (turns ? turning : units)[static_cast<std::size_t>(quantity)];
}

/// `rows` of a line, or those of its file. @returns false if there are none without an error
bool read_points_of_line(TableReader& reader, Quantity measured, LimitLineRequest& request) {
  const Levels levels = request.bands ? Levels::of_random : Levels::of_harmonic;
  const ColumnQuantity level = read_bare_unit(
      reader, ColumnQuantity(measured).at_levels(levels, request.line.rms ? Level::rms : Level::amplitude));
  const auto rows = reader.has("rows") ? read_pairs(reader, "rows", in_hertz(), level)
                                       : read_pairs_of_file(reader, "frequency_hz", "limit", in_hertz(), level);
  reader.finish();
  if (!rows) return false;
  for (const double hertz : rows->col(0)) request.line.angular_frequency.push_back(2 * std::numbers::pi * hertz);
  for (const double limit : rows->col(1)) request.line.limit.push_back(level.bare * limit);
  const foundation::Problems findings = assembly::check(request.line, reader.has("rows") ? "rows" : "file");
  reader.add(findings);
  return !findings.has_errors();
}

/// The component that a line bounds, by its quantity; none with an error.
std::optional<Quantity> read_component_of_line(TableReader& reader, const ResultNames& names, const std::string& of,
                                               assembly::MotionQuantity quantity) {
  const auto measured = names.component(of, quantity);
  if (reader.has("of") && !measured) {
    const std::string guess = foundation::nearest_name(of, names.components());
    reader.error("of", foundation::quoted(of),
                 "a limit line belongs to one component: \"BODY.x\", \"BODY.POINT.z\", \"ELEMENT.force.z\"",
                 guess.empty() ? "check the name" : "did you mean \"" + guess + "\"?");
  }
  return measured;
}

/// One line. None if it has an error.
std::optional<LimitLineRequest> read_limit_line(TableReader& root, TableReader& reader, const std::string& name,
                                                const ResultNames& names, const SymbolTable& symbols,
                                                const Analyses& analyses) {
  LimitLineRequest request;
  request.of = reader.required_text("of");
  const bool named = reader.has("line");
  const bool bands_missing = !read_bands_of_line(root, reader, symbols, analyses, named, request);
  const auto quantity = read_quantity(reader).value_or(assembly::MotionQuantity::velocity);
  const auto measured = read_component_of_line(reader, names, request.of, quantity);
  if (!measured || bands_missing) return std::nullopt;  // the unit of its rows is not known
  request.line.name = name;
  request.line.rms = read_level_of_line(reader, request.bands.has_value()) == Level::rms;
  if (request.bands && !request.line.rms) {
    reader.error("level", "\"zero_to_peak\"", "the level of a band is a root mean square",
                 "convert the limits to rms and remove the key");
    return std::nullopt;
  }
  if (reader.has("quantity") && names.is_force(request.of))
    warn_at_key(reader, "quantity", foundation::quoted(assembly::motion_name(quantity)) + " of a force",
                "it applies to motions only", "remove it");
  request.line.unit = unit_of_limits(request.of, *measured, quantity);
  const bool complete =
      named ? read_named_line(reader, *measured, request) : read_points_of_line(reader, *measured, request);
  return complete ? std::optional(std::move(request)) : std::nullopt;
}

/// Lines over frequency compare the response of the file, or that in the band of the requirements.
void require_response(TableReader& root, const Node& table, const Analyses& analyses) {
  const Node* requirements = root.has("requirements") ? root.node("requirements") : nullptr;
  const auto over_response = [&](const std::string& name) {
    const Node* line = table.find(name);
    return !line || line->kind != Node::Kind::table || !(line->find("bands") || line->find("line"));
  };
  if (!analyses.response && !(requirements && requirements->find("band")) &&
      std::ranges::any_of(table.keys, over_response))
    root.error("limit_lines", "no response to compare with",
               "limit lines apply to the band of analyses.response, or to that of the requirements",
               "add response = {…} to [analyses]");
}

}  // namespace

void read_limit_lines(TableReader& root, const ResultNames& names, const SymbolTable& symbols, Analyses& result) {
  const Node* table = root.table("limit_lines");
  if (!table) return;
  require_response(root, *table, result);
  TableReader all(*table, "limit_lines", root.problems());
  for (const std::string& name : table->keys) {
    const Node* node = all.table(name);
    if (!node) continue;
    TableReader reader(*node, "limit_lines." + name, root.problems());
    if (auto line = read_limit_line(root, reader, name, names, symbols, result))
      add_line(std::move(*line), symbols, result);
  }
}

}  // namespace trivet::project
