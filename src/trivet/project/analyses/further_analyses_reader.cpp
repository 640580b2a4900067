// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "trivet/foundation/plain_text.h"
#include "trivet/project/analyses/wanted_reader.h"
#include "trivet/project/text/idle_key.h"
#include "trivet/project/text/pairs_reader.h"

namespace trivet::project {
namespace {

constexpr double most_time_points = 20'000'000;

/// What one analysis needs in the model.
struct Needed {
  const std::vector<std::string>& names;
  std::string kind;     ///< "random"
  std::string remedy;   ///< what to add
};

void check_needed(TableReader& analyses, const std::string& key, const Needed& needed) {
  if (needed.names.empty()) analyses.error(key, "no " + needed.kind + " excitation in the model", "this answer needs one", needed.remedy);
}

RandomRequest read_random(TableReader& reader, const ResultNames& names, const Mentioned& mentioned) {
  RandomRequest request;
  read_wanted(reader, names, mentioned.random_excitations, "random", request.wanted);
  using excitation::Weighting;
  static const std::array<std::pair<const char*, Weighting>, 8> weightings = {{{"Wb", Weighting::Wb}, {"Wc", Weighting::Wc}, {"Wd", Weighting::Wd}, {"We", Weighting::We},
                                                                              {"Wf", Weighting::Wf}, {"Wj", Weighting::Wj}, {"Wk", Weighting::Wk}, {"Wm", Weighting::Wm}}};
  std::vector<std::string> words;
  for (const auto& weighting : weightings) words.emplace_back(weighting.first);
  using excitation::ContactPoint;
  static const std::array<std::pair<const char*, ContactPoint>, 4> contacts = {
      {{"seat", ContactPoint::seat_surface}, {"backrest", ContactPoint::backrest}, {"feet", ContactPoint::feet}, {"standing", ContactPoint::standing}}};
  for (const auto& contact : contacts) words.emplace_back(contact.first);
  const auto word = reader.choice("weighting", words);
  for (const auto& [name, contact] : contacts)
    if (word == name) request.contact = contact;
  if (word)
    for (const auto& [name, weighting] : weightings)
      if (*word == name) request.weighting = weighting;
  const std::vector<std::string>& of = request.wanted.of;
  if (word && std::all_of(of.begin(), of.end(), [&](const std::string& name) { return names.is_force(name); }))
    warn_of_idle_key(reader, "weighting", "\"" + *word + "\" of forces alone",
                     "people feel motions, and no motion is asked for", "remove it, or ask for motions");
  return request;
}

std::vector<std::pair<std::string, double>> read_initial(TableReader& reader, const std::string& key, const ResultNames& names, assembly::Quantity quantity) {
  std::vector<std::pair<std::string, double>> values;
  const Node* table = reader.table(key);
  if (!table) return values;
  TableReader inside(*table, reader.path() + "." + key, reader.problems());
  for (const std::string& name : table->keys) {
    const auto measured = names.component(name, quantity);
    const bool coordinate = measured && *measured != Quantity::force && *measured != Quantity::moment && std::count(name.begin(), name.end(), '.') == 1;
    if (!coordinate) {
      inside.error(name, "no such coordinate", "initial values belong to free coordinates of bodies, in quotes: \"BODY.z\"", "check the name");
      continue;
    }
    if (const auto value = inside.number(name, *measured)) values.emplace_back(name, *value);
  }
  return values;
}

TransientRequest read_transient(TableReader& reader, const ResultNames& names, const Mentioned& mentioned) {
  TransientRequest request;
  read_wanted(reader, names, mentioned.time_excitations, "time", request.wanted);
  request.from = reader.number("from", Quantity::time).value_or(0);
  request.to = reader.number("to", Quantity::time);
  request.step = reader.number("step", Quantity::time);
  if (request.to && !(*request.to > request.from)) reader.error("to", fmt::format("{:.6g} s", *request.to), "it ends after it begins", "give to above from");
  if (request.step && !(*request.step > 0)) reader.error("step", fmt::format("{:.6g} s", *request.step), "a step is > 0", "mend it");
  if (request.step && request.to && *request.step > *request.to - request.from && *request.to > request.from)
    reader.error("step", fmt::format("{:.6g} s", *request.step), "it is no longer than the time from from to to", "take a shorter step");
  if (request.step && request.to && *request.step > 0 && (*request.to - request.from) / *request.step > most_time_points)
    reader.error("step", fmt::format("{:.3g} points", (*request.to - request.from) / *request.step), fmt::format("at most {:.0f} points are computed at once", most_time_points), "take a longer step");
  request.nearest_linear_system = reader.boolean("nearest_linear_system").value_or(false);
  request.displacements = read_initial(reader, "initial_displacement", names, assembly::Quantity::displacement);
  request.velocities = read_initial(reader, "initial_velocity", names, assembly::Quantity::velocity);
  return request;
}

OrdersRequest read_orders_request(TableReader& reader, const ResultNames& names, const Mentioned& mentioned) {
  OrdersRequest request;
  read_wanted(reader, names, mentioned.order_excitations, "order", request.wanted);
  if (!reader.has("speed")) reader.missing("speed", "give the range of shaft speeds: speed = [\"600 rpm\", \"3000 rpm\"]");
  request.speed = read_band(reader, "speed").value_or(response::Band{0, 1});
  return request;
}

TransmissibilityRequest read_transmissibility(TableReader& reader, const Mentioned& mentioned) {
  TransmissibilityRequest request;
  request.force = reader.text("force").value_or("");
  const auto base = reader.direction("base");
  if (reader.has("force") == reader.has("base"))
    reader.error(reader.has("force") ? "base" : "force", reader.has("force") ? "force and base" : "neither force nor base", "a transmissibility is that of a force excitation or of a motion of the ground",
                 reader.has("force") ? "keep one" : "force = \"EXCITATION\", or base = \"z\"");
  if (reader.has("force") && !request.force.empty() && std::find(mentioned.harmonic_excitations.begin(), mentioned.harmonic_excitations.end(), request.force) == mentioned.harmonic_excitations.end()) {
    const std::string guess = foundation::nearest_name(request.force, mentioned.harmonic_excitations);
    reader.error("force", foundation::quoted(request.force), "no harmonic excitation has this name", guess.empty() ? "check the name" : "did you mean \"" + guess + "\"?");
  }
  if (base) request.direction.axis = *base;
  for (const char* key : {"rotation", "of"})
    if (reader.has("force") && reader.has(key)) reader.error(key, std::string(key) + " beside a force", "a force is compared with the force on the ground in its own direction", "remove it");
  request.direction.rotation = reader.boolean("rotation").value_or(false);
  std::vector<std::string> places = mentioned.bodies;
  places.insert(places.end(), mentioned.points.begin(), mentioned.points.end());
  request.of = reader.texts("of", R"(["BODY"])").value_or(mentioned.bodies);
  for (const std::string& name : request.of)
    if (std::find(places.begin(), places.end(), name) == places.end()) {
      const std::string guess = foundation::nearest_name(name, places);
      reader.error("of", foundation::quoted(name), "a motion is that of a body or BODY.POINT", guess.empty() ? "check the name" : "did you mean \"" + guess + "\"?");
    }
  request.band = read_band(reader, "band");
  return request;
}

ShockSpectrumRequest read_shock_spectrum(TableReader& reader, const Mentioned& mentioned) {
  ShockSpectrumRequest request;
  request.excitations = read_selected(reader, mentioned.time_excitations, "time");
  request.damping_ratio = reader.number("damping", Quantity::pure).value_or(0.05);
  if (!(request.damping_ratio >= 0 && request.damping_ratio < 1)) reader.error("damping", fmt::format("{:.6g}", request.damping_ratio), "a damping ratio is 0 … 1 (Q = 1/(2ζ); Q = 10 is 0.05)", "mend it");
  const auto band = read_band(reader, "band");
  if (!reader.has("band")) reader.missing("band", "give the natural frequencies: band = [\"5 Hz\", \"2000 Hz\"]");
  if (band && !(band->from > 0)) reader.error("band", "from 0", "natural frequencies are > 0", "raise the lower end");
  request.band = band.value_or(response::Band{1, 2});
  return request;
}

/// `rows` or `file` of S_a over natural period (default) or frequency.
EarthquakeRequest read_earthquake(TableReader& reader, const ResultNames& names) {
  EarthquakeRequest request;
  read_of(reader, names, request.wanted.of);
  const auto quantity = reader.choice("quantity", {"displacement", "velocity", "acceleration"});
  if (quantity == "velocity") request.wanted.quantity = assembly::Quantity::velocity;
  if (quantity == "acceleration") request.wanted.quantity = assembly::Quantity::acceleration;
  for (const std::string& word : request.wanted.of)
    if (word == "base" || word.starts_with("base.")) reader.error("of", "\"" + word + "\"", "an earthquake's answers are those of bodies and elements, against the ground", "remove it");
  if (!reader.has("direction")) reader.missing("direction", "say how the ground shakes: direction = \"x\"");
  request.direction = reader.direction("direction").value_or(Eigen::Vector3d::UnitX());
  const double damping = reader.number("damping", Quantity::pure).value_or(0.05);
  const bool over_period = reader.choice("over", {"period", "frequency"}).value_or("period") == "period";
  const auto rows = reader.has("rows") ? read_pairs(reader, "rows") : read_pairs_of_file(reader, over_period ? "period" : "frequency_hz", "acceleration");
  if (!rows) return request;
  const std::string source = reader.has("rows") ? "rows" : "file";
  std::vector<double> places(rows->col(0).begin(), rows->col(0).end()), accelerations(rows->col(1).begin(), rows->col(1).end());
  if (std::any_of(places.begin(), places.end(), [](double x) { return !(x > 0); })) {
    reader.error(source, "a period or frequency that is not > 0", "a spectrum over logarithmic axes begins above 0", "give a short period for the acceleration of the ground");
    return request;
  }
  if (std::adjacent_find(places.begin(), places.end(), std::greater_equal<>()) != places.end()) {
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

ShapesRequest read_shapes(TableReader& reader, const Mentioned& mentioned) {
  ShapesRequest request;
  request.excitations = read_selected(reader, mentioned.harmonic_excitations, "harmonic");
  if (!reader.has("at")) reader.missing("at", "give the frequencies: at = [\"25 Hz\"]");
  request.at = reader.numbers("at", Quantity::angular_frequency).value_or(std::vector<double>{});
  if (reader.has("at") && request.at.empty()) reader.error("at", "no frequency", "at least one is wanted", "for instance at = [\"25 Hz\"]");
  for (const double omega : request.at)
    if (!(omega > 0)) reader.error("at", fmt::format("{:.6g} rad/s", omega), "a shape is drawn at ω > 0", "mend it");
  return request;
}

}  // namespace

void read_further_analyses(TableReader& analyses, const ResultNames& names, const Mentioned& mentioned, Analyses& result) {
  const auto with = [&](const std::string& key, const std::optional<Needed>& needed, const auto& read) {
    const Node* node = analyses.table(key);
    if (!node) return;
    if (needed) check_needed(analyses, key, *needed);
    TableReader reader(*node, "analyses." + key, analyses.problems());
    read(reader);
    reader.finish();
  };
  const Needed random{mentioned.random_excitations, "random", "add [excitations.NAME] with type = \"random\""};
  const Needed orders{mentioned.order_excitations, "order", "add [excitations.NAME] with type = \"orders\" or \"unbalance\""};
  const Needed time{mentioned.time_excitations, "time", "add [excitations.NAME] with type = \"time\""};
  const Needed harmonic{mentioned.harmonic_excitations, "harmonic", "add [excitations.NAME] with type = \"harmonic\", \"unbalance\" or \"base\""};
  with("random", random, [&](TableReader& reader) { result.random = read_random(reader, names, mentioned); });
  with("transient", std::nullopt, [&](TableReader& reader) {
    result.transient = read_transient(reader, names, mentioned);
    if (!reader.has("initial_displacement") && !reader.has("initial_velocity")) check_needed(analyses, "transient", time);
  });
  with("orders", orders, [&](TableReader& reader) { result.orders = read_orders_request(reader, names, mentioned); });
  with("transmissibility", std::nullopt, [&](TableReader& reader) { result.transmissibility = read_transmissibility(reader, mentioned); });
  with("power", harmonic, [&](TableReader& reader) {
    PowerRequest request;
    request.excitations = read_selected(reader, mentioned.harmonic_excitations, "harmonic");
    request.band = read_band(reader, "band");
    result.power = request;
  });
  with("shapes", harmonic, [&](TableReader& reader) { result.shapes = read_shapes(reader, mentioned); });
  with("earthquake", std::nullopt, [&](TableReader& reader) { result.earthquake = read_earthquake(reader, names); });
  with("shock_spectrum", time, [&](TableReader& reader) { result.shock_spectrum = read_shock_spectrum(reader, mentioned); });
}

void read_limit_lines(TableReader& root, const ResultNames& names, Analyses& result) {
  const Node* table = root.table("limit_lines");
  if (!table) return;
  if (!result.response) root.error("limit_lines", "no response to compare with", "limit lines hold over the band of analyses.response", "add response = {…} to [analyses]");
  TableReader all(*table, "limit_lines", root.problems());
  for (const std::string& name : table->keys) {
    const Node* node = all.table(name);
    if (!node) continue;
    TableReader reader(*node, "limit_lines." + name, root.problems());
    LimitLineRequest request;
    request.of = reader.required_text("of");
    const auto quantity = reader.choice("quantity", {"displacement", "velocity", "acceleration"}).value_or("velocity");
    const auto wanted = quantity == "velocity" ? assembly::Quantity::velocity : quantity == "acceleration" ? assembly::Quantity::acceleration : assembly::Quantity::displacement;
    const auto measured = names.component(request.of, wanted);
    if (reader.has("of") && !measured) reader.error("of", foundation::quoted(request.of), "a limit line belongs to one component: \"BODY.x\", \"BODY.POINT.z\", \"ELEMENT.force.z\"", "check the name");
    request.line.name = name;
    request.line.rms = reader.choice("level", {"rms", "zero_to_peak"}).value_or("rms") == "rms";
    static constexpr std::array<const char*, 3> units = {"m", "m/s", "m/s²"}, turning = {"rad", "rad/s", "rad/s²"};
    if (measured && reader.has("quantity") && names.is_force(request.of))
      warn_of_idle_key(reader, "quantity", "\"" + quantity + "\" of a force", "it says how a motion is measured",
                       "remove it");
    if (measured) {
      const bool force = *measured == Quantity::force || *measured == Quantity::moment;
      const bool turns = request.of.size() > 3 && request.of[request.of.size() - 2] == 'r';
      request.line.unit = force ? (*measured == Quantity::force ? "N" : "N m") : (turns ? turning : units)[static_cast<std::size_t>(wanted)];
    }
    const auto rows = reader.has("rows") ? read_pairs(reader, "rows") : read_pairs_of_file(reader, "frequency_hz", "limit");
    reader.finish();
    if (!rows || !measured) continue;
    for (const double hertz : rows->col(0)) request.line.angular_frequency.push_back(2 * std::numbers::pi * hertz);
    request.line.limit.assign(rows->col(1).begin(), rows->col(1).end());
    const foundation::Problems findings = response::check(request.line, reader.has("rows") ? "rows" : "file");
    reader.add(findings);
    if (!findings.has_errors()) result.limit_lines.push_back(std::move(request));
  }
}

}  // namespace trivet::project
