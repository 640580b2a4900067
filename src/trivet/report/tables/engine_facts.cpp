// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/tables/engine_facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "trivet/project/text/document.h"

namespace trivet::report {
namespace {

using project::Node;

struct EngineKey {
  std::string_view key, words, unit;  ///< unit of a bare number
};
constexpr std::array<EngineKey, 15> keys = {{{"layout", "layout", ""},
                                             {"cylinders", "cylinders", ""},
                                             {"strokes", "strokes of a cycle", ""},
                                             {"bank_angle", "angle between the banks", " rad"},
                                             {"bank_offset", "offset of the second bank", " m"},
                                             {"spacing", "spacing of the cylinders", " m"},
                                             {"firing_order", "firing order", ""},
                                             {"crank_radius", "crank radius", " m"},
                                             {"rod_length", "rod length", " m"},
                                             {"oscillating_mass", "oscillating mass of a cylinder", " kg"},
                                             {"rotating_mass", "rotating mass of a cylinder", " kg"},
                                             {"counterweight", "counterweight of a cylinder", " kg m"},
                                             {"crank", "axis of the crank", ""},
                                             {"up", "up", ""},
                                             {"highest_order", "highest order", ""}}};

/// As the file has it, without quotes: "72 mm", "1, 5, 3, 6, 2, 4".
std::string given_text(const Node& node, std::string_view unit) {
  if (node.kind == Node::Kind::text) return node.text;
  if (node.kind != Node::Kind::array) return project::value_text(node) + std::string(unit);
  std::string text;
  for (const Node& item : node.items) text += (text.empty() ? "" : ", ") + given_text(item, "");
  return text;
}

/// Rows of order, amplitude and phase of one cylinder, in one fact.
void add_gas_torque(const Node& rows, std::vector<model::Fact>& facts) {
  std::string text;
  for (const Node& row : rows.items)
    if (row.items.size() == 3)
      text += (text.empty() ? "" : "; ") + given_text(row.items[1], " N m") + " at " +
          given_text(row.items[2], " rad") + " in order " + given_text(row.items[0], "");
  if (!text.empty()) facts.push_back({"gas torque of a cylinder", text});
}

}  // namespace

std::vector<model::Fact> engine_facts(const project::Case& variant, const std::string& excitation) {
  const Node* engine = variant.written.find("excitations");
  if (engine) engine = engine->find(excitation);
  if (engine) engine = engine->find("engine");
  std::vector<model::Fact> facts;
  if (!engine) return facts;
  for (const EngineKey& one : keys)
    if (const Node* value = engine->find(one.key))
      facts.push_back({std::string(one.words), given_text(*value, one.unit)});
  if (const Node* rows = engine->find("gas_torque")) add_gas_torque(*rows, facts);
  if (const Node* pressure = engine->find("pressure"))
    for (std::size_t i = 0; i < pressure->keys.size(); ++i)
      facts.push_back({"cylinder pressure, " + pressure->keys[i],
                       given_text(pressure->items[i], pressure->keys[i] == "bore" ? " m" : "")});
  return facts;
}

}  // namespace trivet::report
