// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/excitations/excitation_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "trivet/project/text/shared_keys.h"

namespace trivet::project {

namespace {

const std::vector<std::string> types = {"harmonic", "base", "unbalance", "orders", "random", "time", "constant"};

/// A force on a body, or with `base = true` a motion of the ground; its numbers are factors.
std::optional<model::Action> read_directed(TableReader& reader, const model::Description& description,
                                           const SymbolTable& symbols) {
  return reader.boolean("base").value_or(false)
      ? read_ground_motion(reader, description, symbols, ActionNumbers::factors)
      : read_force(reader, description, symbols, ActionNumbers::factors);
}

void read_constant(TableReader& reader, const std::string& name, model::Description& description,
                   const SymbolTable& symbols) {
  const auto action = read_force(reader, description, symbols, ActionNumbers::constants);
  for (const char* key : {"phase", "delay"})
    if (reader.has(key))
      reader.error(key, std::string("a ") + key, "a constant force has no phase or delay", "remove it");
  if (!action) return;
  spatial::Wrench wrench{action->amplitude.head<3>().real(), action->amplitude.tail<3>().real()};
  description.constant_forces.push_back({name, *action->body, action->at, wrench});
}

/// `coherence = [{with = "NAME", value = 0.6}, …]`, or one table of it.
std::vector<model::Random::Partner> read_partners(TableReader& reader) {
  std::vector<model::Random::Partner> partners;
  const Node* node = reader.node("coherence");
  if (!node) return partners;
  std::vector<const Node*> tables;
  if (node->kind == Node::Kind::table) tables.push_back(node);
  for (const Node& item : node->items)
    if (node->kind == Node::Kind::array && item.kind == Node::Kind::table) tables.push_back(&item);
  if (tables.empty() || (node->kind == Node::Kind::array && tables.size() < node->items.size()))
    reader.error("coherence", kind_name(node->kind),
                 "a table, or a list of tables, is expected: {with = \"NAME\", value = 0.6}", "write it in this form");
  for (const Node* one : tables) {
    TableReader inside(*one, reader.path() + ".coherence", reader.problems());
    model::Random::Partner partner;
    partner.other = inside.required_text("with");
    partner.coherence.at_zero = inside.required_number("value", Quantity::pure);
    if (partner.coherence.at_zero < 0 || partner.coherence.at_zero > 1)
      inside.error("value", fmt::format("coherence {:.6g}", partner.coherence.at_zero),
                   "γ² is between 0 (uncorrelated) and 1 (fully coherent)", "correct it");
    partner.coherence.decay = inside.number("decay", Quantity::pure).value_or(0);
    partner.coherence.distance = inside.number("distance", Quantity::length).value_or(0);
    partner.coherence.speed = inside.number("speed", Quantity::velocity).value_or(0);
    for (const char* key : {"distance", "speed"})
      if (inside.has(key) && !inside.has("decay"))
        inside.error(key, std::string(key) + " without decay", "together they set how coherence falls with frequency",
                     "add decay, or remove it");
    inside.finish();
    partners.push_back(partner);
  }
  return partners;
}

constexpr const char* zero_factors = "all components are 0";
constexpr const char* rule_of_factors = "they are factors on the history or spectrum: this excitation has no effect";
constexpr const char* remedy_of_factors = "give a direction, for instance [0, 0, 1]";

const char* key_of_factors(const TableReader& reader) {
  for (const char* key : {"force", "moment", "translation", "rotation"})
    if (reader.has(key)) return key;
  return "force";
}

void read_excitation(const Node& node, const std::string& name, model::Description& description, SymbolTable& symbols,
                     foundation::Problems& problems) {
  TableReader reader(node, "excitations." + name, problems);
  reader.required_text("type");
  const auto type = reader.choice("type", types);
  if (type == "constant") symbols.constant_excitations.push_back(name);
  else if (type == "random") symbols.random_excitations.push_back(name);
  else if (type == "time") symbols.time_excitations.push_back(name);
  else if (type == "orders") symbols.order_excitations.push_back(name);
  else symbols.harmonic_excitations.push_back(name);  // an unreadable type too: selecting it is not a second problem
  if (type == "unbalance") symbols.order_excitations.push_back(name);
  const auto add = [&](const std::optional<model::Action>& action, model::Course course, double service_speed = 0) {
    if (action) description.excitations.push_back({name, *action, std::move(course), service_speed});
  };
  if (!type) {  // the valid keys depend on the type
    static_cast<void>(read_place(reader, description, symbols));
    return;
  }
  if (type == "harmonic") add(read_force(reader, description, symbols, ActionNumbers::amplitudes), model::Harmonic{});
  if (type == "base")
    add(read_ground_motion(reader, description, symbols, ActionNumbers::amplitudes), model::Harmonic{});
  if (type == "constant") read_constant(reader, name, description, symbols);
  if (type == "unbalance") {
    auto action = read_place(reader, description, symbols);
    model::Action numbers = action.value_or(model::Action{});
    const double service_speed = read_unbalance(reader, numbers);
    if (action) add(numbers, model::Harmonic{2}, service_speed);
  }
  if (type == "orders") {
    const auto action = read_place(reader, description, symbols);
    if (auto orders = read_orders(reader)) add(action, std::move(*orders));
  }
  if (type == "random") {
    const auto action = read_directed(reader, description, symbols);
    if (action && action->amplitude.isZero(0))
      reader.error(key_of_factors(reader), zero_factors, rule_of_factors, remedy_of_factors);
    auto spectrum = read_spectrum(reader, "psd", action.value_or(model::Action{}));
    auto partners = read_partners(reader);
    if (spectrum) add(action, model::Random{std::move(*spectrum), std::move(partners)});
  }
  if (type == "time") {
    const auto action = read_directed(reader, description, symbols);
    if (action && action->amplitude.isZero(0))
      warn_at_key(reader, key_of_factors(reader), zero_factors, rule_of_factors,
                  remedy_of_factors);  // a case may set it to 0
    if (auto signal = read_history(reader, "history", action.value_or(model::Action{})))
      add(action, model::History{std::move(*signal)});
  }
  reader.finish();
}

}  // namespace

void read_excitations(TableReader& root, model::Description& description, SymbolTable& symbols) {
  description.gravity = root.vector("gravity", Quantity::acceleration);
  description.second_order = root.boolean("second_order").value_or(true);
  if (!description.second_order && !description.gravity && !root.has("cases"))
    warn_at_key(root, "second_order", "second_order = false without gravity",
                "it leaves out what the forces at rest under gravity add to the stiffness",
                "give gravity, or remove it");
  const Node* table = root.table("excitations");
  if (!table) return;
  for (std::size_t i = 0; i < table->keys.size(); ++i) {
    if (table->items[i].kind != Node::Kind::table) symbols.harmonic_excitations.push_back(table->keys[i]);
    if (table->items[i].kind == Node::Kind::table)
      read_excitation(table->items[i], table->keys[i], description, symbols, root.problems());
    else
      root.problems()
          .error("excitations." + table->keys[i], kind_name(table->items[i].kind), "an excitation is a table",
                 "write [excitations.NAME] and its type below")
          .origin = table->items[i].origin;
  }
}

}  // namespace trivet::project
