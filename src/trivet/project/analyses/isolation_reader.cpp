// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/isolation_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <system_error>

#include "trivet/foundation/plain_text.h"
#include "trivet/project/text/shared_keys.h"

namespace trivet::project {
namespace {

constexpr const char* isolation_example = R"(isolation = {at = "1480 rpm", least = "80 %"})";

/// "14 dB" → 14; none for a text without this unit.
std::optional<double> decibels(const std::string& text) {
  constexpr std::string_view unit = "dB";
  const std::size_t end = text.find_last_not_of(' ');
  if (end == std::string::npos || end < unit.size() || text.compare(end + 1 - unit.size(), unit.size(), unit) != 0)
    return std::nullopt;
  const std::size_t last = text.find_last_not_of(' ', end - unit.size());
  if (last == std::string::npos) return std::nullopt;
  double number = 0;
  const char* const begin = text.data() + text.find_first_not_of(' ');
  const auto [rest, error] = std::from_chars(begin, text.data() + last + 1, number);
  return error == std::errc() && rest == text.data() + last + 1 ? std::optional(number) : std::nullopt;
}

/// `least`: a share 1 − T of 1, or a level −20 lg T.
void read_least_isolation(TableReader& reader, Isolation& result) {
  if (!reader.has("least")) return reader.missing("least", "give the least isolation: least = \"80 %\", or \"14 dB\"");
  const Node& least = *reader.node("least");
  if (const auto level = least.kind == Node::Kind::text ? decibels(least.text) : std::nullopt) {
    constexpr double highest = 400;  // [dB]: below this share a force is round-off
    result.in_decibels = true;
    result.transmitted = std::pow(10, -*level / 20);
    if (!(*level >= 0 && *level <= highest))
      reader.error("least", fmt::format("{:.6g} dB", *level),
                   fmt::format("an isolation is 20 lg (1/T), 0 … {:.0f} dB", highest), "for instance \"14 dB\"");
    return;
  }
  const auto share = reader.number("least", Quantity::pure);
  if (!share) return;
  result.transmitted = 1 - *share;
  if (!(*share >= 0 && *share < 1))
    reader.error("least", fmt::format("{:.6g} %", 100 * *share),
                 "an isolation is the share 1 − T of a force that does not reach the ground, 0 … below 100 %",
                 "for instance \"80 %\" or \"14 dB\"");
}

/// `at`: one frequency or several; `band`: a range of them.
void read_frequencies(TableReader& reader, Isolation& result) {
  if (reader.has("at") && reader.has("band"))
    reader.error("band", "at and band", "isolation is required at speeds or over a range of them", "keep one");
  if (const auto band = read_band(reader, "band")) result.at.push_back(*band);
  if (!reader.has("at")) return;
  const Node& at = *reader.node("at");
  const std::string where = reader.path() + ".at";
  std::vector<const Node*> list;
  if (at.kind == Node::Kind::array) {
    for (const Node& item : at.items) list.push_back(&item);
    if (list.empty())
      reader.error("at", "an empty list", "isolation is required at one speed or more", isolation_example);
  } else {
    list.push_back(&at);
  }
  for (const Node* item : list) {
    const auto omega = reader.scalar(*item, where, Quantity::angular_frequency);
    if (omega && !(*omega > 0)) reader.error("at", value_text(*item), "a speed is > 0", isolation_example);
    else if (omega) result.at.push_back({*omega, *omega});
  }
}

void check_place(TableReader& reader, const std::string& key, const std::string& name,
                 const std::vector<std::string>& known, const std::string& rule) {
  if (std::ranges::find(known, name) != known.end()) return;
  const std::string guess = foundation::nearest_name(name, known);
  reader.error(key, foundation::quoted(name), rule,
               guess.empty() ? "check the name" : "did you mean \"" + guess + "\"?");
}

void read_base(TableReader& reader, const SymbolTable& symbols, Isolation& result) {
  if (const auto base = reader.direction("base")) result.base.axis = *base;
  result.base.rotation = reader.boolean("rotation").value_or(false);
  result.of = reader.texts("of", R"(["BODY"])").value_or(symbols.bodies);
  std::vector<std::string> places = symbols.bodies;
  places.insert(places.end(), symbols.points.begin(), symbols.points.end());
  for (const std::string& name : result.of)
    if (!symbols.bodies_unknown) check_place(reader, "of", name, places, "`of` names bodies or BODY.POINT");
  if (reader.has("force"))
    reader.error("base", "force and base",
                 "an isolation is that of a force from the ground or of a place from its motion",
                 "keep one; a list of tables has several");
  if (!reader.has("at") && !reader.has("band"))
    reader.missing("at", std::string("give a speed or a band: ") + isolation_example);
}

void read_forces(TableReader& reader, const SymbolTable& symbols, Isolation& result) {
  for (const char* key : {"rotation", "of"})
    if (reader.has(key)) {
      static_cast<void>(reader.node(key));
      reader.error(key, std::string(key) + " without base", "a force is compared with the force on the ground",
                   "remove it, or add base = \"z\"");
    }
  if (const auto forces = reader.texts("force", R"("EXCITATION")")) {
    if (forces->empty())
      reader.error("force", "an empty list", "at least one force is isolated",
                   "name a harmonic excitation, or remove it");
    for (const std::string& name : *forces)
      if (std::ranges::find(symbols.order_excitations, name) != symbols.order_excitations.end() &&
          std::ranges::find(symbols.harmonic_excitations, name) == symbols.harmonic_excitations.end())
        reader.error("force", foundation::quoted(name), "this excitation is of type \"orders\", not one harmonic force",
                     "name an unbalance or a harmonic force; to judge the orders add a limit on \"ground.force.z\" to "
                     "[operation.limits]");
      else check_place(reader, "force", name, symbols.harmonic_excitations, "no harmonic excitation has this name");
    result.forces = *forces;
  } else if (!reader.has("force") && symbols.harmonic_excitations.empty()) {
    reader.error(
        "", "no harmonic excitation in the model", "an isolation is that of a force from the ground",
        "add [excitations.NAME] with type = \"unbalance\" or \"harmonic\", or base = \"z\" for a motion of the ground");
  }
}

Isolation read_one_isolation(TableReader& reader, const SymbolTable& symbols) {
  Isolation result;
  read_least_isolation(reader, result);
  read_frequencies(reader, result);
  if (reader.has("base")) read_base(reader, symbols, result);
  else read_forces(reader, symbols, result);
  if (reader.has("base")) static_cast<void>(reader.node("force"));
  reader.finish();
  return result;
}

const model::Excitation* excitation_named(const model::System& system, const std::string& name) {
  for (const model::Excitation& excitation : system.description().excitations)
    if (excitation.name == name) return &excitation;
  return nullptr;
}

}  // namespace

std::vector<Isolation> read_isolation(TableReader& requirements, const SymbolTable& symbols) {
  std::vector<Isolation> result;
  const Node* node = requirements.node("isolation");
  if (!node) return result;
  const std::string path = requirements.path() + ".isolation";
  std::vector<std::pair<const Node*, std::string>> tables;
  if (node->kind == Node::Kind::table) tables.emplace_back(node, path);
  for (std::size_t i = 0; node->kind == Node::Kind::array && i < node->items.size(); ++i)
    if (node->items[i].kind == Node::Kind::table) tables.emplace_back(&node->items[i], fmt::format("{}[{}]", path, i));
  if (tables.empty() || (node->kind == Node::Kind::array && tables.size() < node->items.size()))
    requirements.error("isolation", kind_name(node->kind), "a table, or a list of tables, is expected",
                       isolation_example);
  for (const auto& [table, where] : tables) {
    TableReader reader(*table, where, requirements.problems());
    result.push_back(read_one_isolation(reader, symbols));
  }
  return result;
}

void judge_at_operating_speeds(const OperationAnalysis& operation, std::vector<Isolation>& isolation) {
  if (!operation.selection.excitations.empty()) return;  // others keep their own speed
  for (Isolation& one : isolation)
    if (one.at.empty() && !one.is_of_base()) one.at = operation.speeds;
}

std::vector<std::string> isolated_forces(const Isolation& isolation, const model::System& system) {
  if (isolation.is_of_base() || !isolation.forces.empty()) return isolation.forces;
  std::vector<std::string> forces;
  for (const model::Excitation& excitation : system.description().excitations)
    if (excitation.action.body && std::holds_alternative<model::Harmonic>(excitation.course))
      forces.push_back(excitation.name);
  return forces;
}

std::vector<assembly::Band> isolated_at(const Isolation& isolation, const model::System& system,
                                        const std::string& force) {
  if (!isolation.at.empty()) return isolation.at;
  const model::Excitation* excitation = excitation_named(system, force);
  if (!excitation || !(excitation->service_speed > 0)) return {};
  return {{excitation->service_speed, excitation->service_speed}};
}

void check_isolation(const std::vector<Isolation>& isolation, const model::System& system,
                     foundation::Problems& problems) {
  const std::string place = "requirements.isolation";
  for (const Isolation& one : isolation) {
    if (one.is_of_base()) continue;
    const std::vector<std::string> forces = isolated_forces(one, system);
    if (forces.empty())
      problems.error(place, "no harmonic force on a body", "an isolation is that of a force from the ground",
                     "add an unbalance or a harmonic force, or base = \"z\" for a motion of the ground");
    for (const std::string& force : forces) {
      if (const std::string reason = model::reason_without_transmission(system, force); !reason.empty())
        problems.error(place, foundation::quoted(force), reason, "name forces that have one: force = [\"EXCITATION\"]");
      else if (isolated_at(one, system, force).empty())
        problems.error(place, "neither at nor band",
                       foundation::quoted(force) + " has no service_speed either, and there is no [operation]",
                       std::string("give a speed: ") + isolation_example);
    }
  }
}

}  // namespace trivet::project
