// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/request_readers.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numbers>
#include <utility>

#include "trivet/foundation/plain_text.h"
#include "trivet/project/analyses/isolation_reader.h"
#include "trivet/project/analyses/limits_reader.h"
#include "trivet/project/text/shared_keys.h"

namespace trivet::project {
namespace {

constexpr const char* example =
    "add limits = {\"BODY.x\" = \"1 mm\"}, no_peak = \"coordinates\", damping_ratio = 0.03 …";

/// Reports requirements on motions under an excitation that the model does not have.
void need(TableReader& reader, const std::string& key, bool there, const std::string& what, const std::string& remedy) {
  if (reader.has(key) && !there)
    reader.error(key, "no " + what + " in the model", "this requirement judges the motion that it causes",
                 "add " + remedy + ", or remove the requirement");
}

/// A limit that [limits] has too.
void refuse_doubled(TableReader& root, TableReader& reader, const Analyses& analyses, const Requirements& found) {
  const assembly::MotionQuantity usual =
      analyses.response ? analyses.response->selection.quantity : assembly::MotionQuantity::displacement;
  const Node* of_file = root.has("limits") ? root.node("limits") : nullptr;
  const Node* here = reader.node("limits");
  for (const AmplitudeLimit& limit : found.limits) {
    const Node* other = of_file ? of_file->find(limit.name) : nullptr;
    if (!other || limit.quantity != usual || !limit.has_common_scope()) continue;
    reader
        .error(
            "limits",
            fmt::format("{} also has a limit in [limits], line {}", foundation::quoted(limit.name), other->origin.line),
            "a result has one limit of one quantity", "keep one of the two")
        .origin = here->find(limit.name)->origin;
  }
}

double read_least(TableReader& reader, const std::string& key, double from, double below, const std::string& rule,
                  const std::string& remedy) {
  const auto value = reader.number(key, Quantity::pure);
  if (value && !(*value >= from && *value > 0 && *value < below))
    reader.error(key, fmt::format("{:.6g}", *value), rule, remedy);
  return value.value_or(0);
}

/// Windows that together reach from 0 to where no body of a machine moves as a rigid one.
void refuse_windows_without_gap(TableReader& reader, std::vector<assembly::Band> windows) {
  constexpr double highest = 2 * std::numbers::pi * 1e6;
  std::ranges::sort(windows, [](const auto& a, const auto& b) { return a.from < b.from; });
  double covered = 0;
  for (const assembly::Band& window : windows)
    if (window.from <= covered) covered = std::max(covered, window.to);
  if (covered >= highest)
    reader.error("avoid", fmt::format("windows that cover 0 … {:.4g} Hz", covered / (2 * std::numbers::pi)),
                 "they leave no natural frequency to any design, so nothing can meet them",
                 "leave a gap for the natural frequencies, or lower the end of the last window");
}

void read_natural_frequencies(TableReader& requirements, Requirements& result) {
  const Node* table = requirements.table("natural_frequencies");
  if (!table) return;
  TableReader reader(*table, requirements.path() + ".natural_frequencies", requirements.problems());
  const auto refuse = [&](const std::string& finding) {
    reader.error("avoid", finding, "a list of windows [from, to] with 0 ≤ from < to is expected",
                 "for instance avoid = [[\"22 Hz\", \"28 Hz\"]]");
  };
  if (const Node* avoid = reader.node("avoid")) {
    if (avoid->kind != Node::Kind::array || avoid->items.empty()) refuse("no list of windows");
    else
      for (const Node& window : avoid->items) {
        if (window.kind != Node::Kind::array || window.items.size() != 2) {
          refuse(value_text(window));
          continue;
        }
        const std::string where = reader.path() + ".avoid";
        const auto from = reader.scalar(window.items[0], where, Quantity::angular_frequency),
                   to = reader.scalar(window.items[1], where, Quantity::angular_frequency);
        if (!from || !to) continue;
        if (*from >= 0 && *to > *from) result.avoided.push_back({*from, *to});
        else refuse(fmt::format("{} … {}", value_text(window.items[0]), value_text(window.items[1])));
      }
    refuse_windows_without_gap(reader, result.avoided);
  }
  result.separation =
      read_least(reader, "separation", 1, 1e3, "a ratio of neighbouring natural frequencies is 1 … 1000",
                 "give the next frequency over this one, 1.15 for instance");
  reader.finish();
}

void read_decoupling(TableReader& requirements, const SymbolTable& symbols, Requirements& result) {
  const Node* table = requirements.table("decoupling");
  if (!table) return;
  TableReader reader(*table, requirements.path() + ".decoupling", requirements.problems());
  for (const std::string& body : table->keys) {
    const auto least = reader.number(body, Quantity::pure);
    if (std::ranges::find(symbols.bodies, body) == symbols.bodies.end()) {
      const std::string guess = foundation::nearest_name(body, symbols.bodies);
      reader.error(body, foundation::quoted(body), "no body has this name",
                   guess.empty() ? "name a body" : "did you mean \"" + guess + "\"?");
    } else if (least && !(*least > 0 && *least <= 1)) {
      reader.error(body, fmt::format("{:.4g} %", 100 * *least),
                   "a share of the kinetic energy is above 0 and at most 100 %", "for instance \"85 %\"");
    } else if (least) {
      result.decoupling.push_back({body, *least});
    }
  }
  reader.finish();
}

void read_names(TableReader& root, TableReader& reader, const std::string& key, const std::string& table,
                const std::string& what, std::vector<std::string>& result) {
  const auto names = reader.texts(key, R"(["NAME"])");
  if (!names) return;
  const Node* known = root.has(table) ? root.node(table) : nullptr;
  for (const std::string& name : *names) {
    if ((known && known->find(name)) || (name.empty() && table == "cases")) continue;
    const std::string guess = known ? foundation::nearest_name(name, known->keys) : "";
    reader.error(key, foundation::quoted(name), "no " + what + " has this name",
                 guess.empty() ? "check the name" : "did you mean \"" + guess + "\"?");
  }
  result = *names;
}

std::optional<model::Price> read_price(TableReader& reader) {
  const auto text = reader.text("price");
  if (!text) return std::nullopt;
  auto price = price_from(*text);
  if (price && price->amount > 0) return price;
  reader.error("price", foundation::quoted(*text), "a price is a number above 0 and a currency",
               "for instance price = \"120 EUR\"");
  return std::nullopt;
}

/// "M 50" (left, right), "M 75" (rear): mounts of a catalogue that a test finds, with their elements.
std::string mounts_that(const model::System& system, const std::function<bool(const model::Rating&)>& is_found) {
  std::vector<std::pair<std::string, std::string>> mounts;  // name, elements
  for (const model::Element& element : system.elements()) {
    if (!element.rating || !is_found(*element.rating)) continue;
    const auto known =
        std::ranges::find_if(mounts, [&](const auto& one) { return one.first == element.rating->mount; });
    if (known == mounts.end()) mounts.emplace_back(element.rating->mount, element.name);
    else known->second += ", " + element.name;
  }
  std::string words;
  for (const auto& [mount, elements] : mounts)
    words += (words.empty() ? "" : ", ") + foundation::quoted(mount) + " (" + elements + ")";
  return words;
}

/// Reports catalogue mounts with a fault that a requirement on all of them does not allow.
void refuse_mounts(const model::System& system, const std::string& key, const std::string& fault,
                   const std::function<bool(const model::Rating&)>& has_fault, const std::string& rule,
                   const std::string& remedy, foundation::Problems& problems) {
  if (const std::string mounts = mounts_that(system, has_fault); !mounts.empty())
    problems.error("requirements." + key, fault + mounts, rule, remedy + ", or remove " + key);
}

bool has_mounts(const model::System& system, const std::string& key, foundation::Problems& problems) {
  const bool any =
      std::ranges::any_of(system.elements(), [](const model::Element& element) { return element.rating.has_value(); });
  if (!any)
    problems.error("requirements." + key, "no mount of a catalogue", key + " judges the mounts of catalogues",
                   "use mounts of type \"catalogue:NAME\", or remove " + key);
  return any;
}

void check_price(const model::System& system, const std::string& currency, foundation::Problems& problems) {
  const std::string rule = "price is a limit on the sum over all catalogue mounts, in one currency";
  refuse_mounts(
      system, "price", "no price in the catalogue for ", [](const model::Rating& rating) { return !rating.price; },
      rule, "write price = \"12.50 " + currency + "\" in the catalogue", problems);
  refuse_mounts(
      system, "price", "the limit is in " + currency + ", not the price of ",
      [&](const model::Rating& rating) { return rating.price && rating.price->currency != currency; }, rule,
      "give the limit and all prices in one currency", problems);
}

}  // namespace

void read_requirements(TableReader& root, const ResultNames& names, const SymbolTable& symbols, Analyses& result) {
  const Node* table = root.table("requirements");
  if (!table) return;
  TableReader reader(*table, "requirements", root.problems());
  reader.also_known({"band", "excitations"});
  if (table->keys.empty()) reader.error("", "an empty table", "there is no requirement", example);
  Requirements found;
  read_scope(reader, symbols, result, found);
  const bool harmonic = !symbols.harmonic_excitations.empty();
  need(reader, "no_peak", harmonic, "harmonic excitation", "[excitations.NAME] with type = \"harmonic\"");
  for (const char* key : {"no_jump", "no_contact", "steady"})
    need(reader, key, harmonic || !symbols.order_excitations.empty(), "harmonic or order excitation",
         "[excitations.NAME] with type = \"harmonic\" or \"orders\"");
  need(reader, "rms", !symbols.random_excitations.empty(), "random excitation",
       "[excitations.NAME] with type = \"random\"");
  const bool moves_by_itself = result.transient.has_value();
  need(reader, "largest", !symbols.time_excitations.empty() || moves_by_itself, "excitation over time",
       "[excitations.NAME] with type = \"time\"");
  const bool loaded = root.has("gravity") || !symbols.constant_excitations.empty();
  for (const char* key : {"static", "mount_load"})
    need(reader, key, loaded, "gravity and no constant force", "gravity = [0, 0, -9.80665]");
  found.limits = read_amplitude_limits(reader, "limits", names, found.quantity, Levels::of_harmonic, &symbols);
  const auto by_orders = [](const AmplitudeLimit& limit) { return limit.speed.has_value(); };
  if (found.limits.empty() || !std::ranges::all_of(found.limits, by_orders))
    need(reader, "limits", harmonic, "harmonic excitation",
         symbols.order_excitations.empty() ? "[excitations.NAME] with type = \"harmonic\""
                                           : "[operation] with the speeds of the machine and write the limits below "
                                             "[operation.limits], or add speed = "
                                             "[\"300 rpm\", \"1000 rpm\"] to limits on each order alone");
  refuse_doubled(root, reader, result, found);
  found.no_peak = read_no_peak(reader, names, found.quantity);
  read_peak_shares(reader, found.min_prominence, found.peak_tolerance);
  read_names(root, reader, "limit_lines", "limit_lines", "limit line", found.limit_lines);
  if (const Node* lines = root.has("limit_lines") ? root.node("limit_lines") : nullptr;
      lines && !reader.has("limit_lines"))
    found.limit_lines = lines->keys;
  read_natural_frequencies(reader, found);
  found.damping_ratio =
      read_least(reader, "damping_ratio", 0, 1, "a damping ratio of a vibration is above 0 and below 1",
                 "for instance damping_ratio = 0.03");
  read_decoupling(reader, symbols, found);
  found.rms = read_amplitude_limits(reader, "rms", names, assembly::MotionQuantity::displacement, Levels::of_random);
  found.largest =
      read_amplitude_limits(reader, "largest", names, assembly::MotionQuantity::displacement, Levels::of_largest);
  found.no_jump = reader.boolean("no_jump").value_or(false);
  found.no_contact = reader.boolean("no_contact").value_or(false);
  found.steady =
      read_amplitude_limits(reader, "steady", names, assembly::MotionQuantity::displacement, Levels::of_largest);
  found.statics = read_amplitude_limits(reader, "static", names, assembly::MotionQuantity::displacement, Levels::none);
  for (const AmplitudeLimit& limit : found.statics)
    if (limit.quantity != assembly::MotionQuantity::displacement)
      reader.error("static", foundation::quoted(limit.name) + " as a velocity or an acceleration",
                   "at rest a point has a displacement only", "give a length or an angle");
  found.isolation = read_isolation(reader, symbols);
  if (result.operation) judge_at_operating_speeds(*result.operation, found.isolation);
  found.mount_load = reader.choice("mount_load", {"catalogue"}).has_value();
  found.price = read_price(reader);
  if (const auto mass = reader.number("mass", Quantity::mass)) {
    if (*mass > 0) found.mass = *mass;
    else
      reader.error("mass", fmt::format("{:.6g} kg", *mass), "the largest mass of all mounts together is above 0",
                   "for instance mass = \"4 kg\"");
  }
  read_names(root, reader, "hold_in", "cases", "case", found.hold_in);
  if (found.hold_in.empty())
    reader.error("hold_in", "an empty list", "a design has to hold in at least one case",
                 "name cases; \"\" is the base model, the default");
  reader.finish();
  result.requirements = std::move(found);
}

namespace {

void check_stops(const Requirements& required, const model::System& system, foundation::Problems& problems) {
  if (!required.no_contact) return;
  for (const model::Element& element : system.elements()) {
    for (const model::NonlinearPart& part : element.nonlinear_parts)
      for (const elements::ElasticForce& law : elements::only<elements::ElasticForce>(part.laws))
        if (std::holds_alternative<elements::GapStop>(law) && !part.is_inner()) return;
    for (const model::DistancePart& part : element.distance_parts)
      for (const elements::ElasticForce& law : elements::only<elements::ElasticForce>(part.law.laws))
        if (std::holds_alternative<elements::GapStop>(law)) return;
  }
  problems.error("requirements.no_contact", "a machine without stops", "it asks that no stop is touched",
                 "remove it, or give an element gap_stop or the type stop");
}

}  // namespace

void check_requirements(const model::System& system, const Analyses& request, foundation::Problems& problems) {
  if (!request.requirements) return;
  const Requirements& required = *request.requirements;
  check_isolation(required.isolation, system, problems);
  if (required.is_about_steady_motion()) check_stops(required, system, problems);
  if (required.is_about_steady_motion())
    require_nonlinear("requirements", "remove no_jump, no_contact and steady, or give an element laws or a stop",
                      system, problems);
  if (required.mount_load && has_mounts(system, "mount_load", problems))
    refuse_mounts(
        system, "mount_load", "no load range in the catalogue for ",
        [](const model::Rating& rating) { return !rating.has_load_range(); },
        "mount_load compares the static load of each catalogue mount with its range",
        "add static_load or load = {z = [\"0 N\", \"800 N\"]} to the catalogue", problems);
  if (required.mass > 0 && has_mounts(system, "mass", problems))
    refuse_mounts(
        system, "mass", "no mass in the catalogue for ", [](const model::Rating& rating) { return !rating.mass; },
        "mass is a limit on the sum over all catalogue mounts", "add mass = … to the catalogue", problems);
  if (required.price && has_mounts(system, "price", problems)) check_price(system, required.price->currency, problems);
}

}  // namespace trivet::project
