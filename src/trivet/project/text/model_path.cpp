// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/model_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "trivet/foundation/index.h"
#include "trivet/project/text/changes.h"
#include "trivet/project/text/level.h"
#include "trivet/project/text/units.h"

namespace trivet::project {
namespace {

/// SI value of 1 in a unit, of which an amplitude may be at a level; none if the unit does not measure the quantity.
std::optional<double> si_factor(const std::string& unit, Quantity quantity) {
  if (unit.empty()) return 1.0;
  const auto factor = to_si_at_level("1 " + unit, quantity, Levels::of_harmonic);
  return factor ? std::optional(*factor) : std::nullopt;
}

}  // namespace

std::vector<std::string> path_keys(const std::string& path) {
  const auto parsed = parse_setting(path + "=0");
  std::vector<std::string> keys;
  if (!parsed) return keys;
  const Node* node = &*parsed;
  for (; node->kind == Node::Kind::table && node->keys.size() == 1; node = &node->items.front())
    keys.push_back(node->keys.front());
  return node->kind == Node::Kind::integer ? keys : std::vector<std::string>();
}

std::optional<std::size_t> component_of(const Node& array, const std::string& word) {
  const bool is_vector = array.kind == Node::Kind::array && array.items.size() == 3 &&
      std::ranges::none_of(array.items, [](const Node& item) {
                           return item.kind == Node::Kind::array || item.kind == Node::Kind::table;
                         });
  if (!is_vector || word.size() != 1 || word[0] < 'x' || word[0] > 'z') return std::nullopt;
  return to_size(word[0] - 'x');
}

bool is_zero_by_default(const std::string& key) { return key == "position" || key == "center_of_mass"; }

const Node* node_at(const Node& document, const std::vector<std::string>& keys) {
  const Node* node = &document;
  for (const std::string& key : keys) {
    if (!node) return nullptr;
    if (const auto component = component_of(*node, key)) node = &node->items[*component];
    else node = node->kind == Node::Kind::table ? node->find(key) : nullptr;
  }
  return node;
}

Node change_of(const std::vector<std::string>& keys, double value, const std::string& unit) {
  Node node;
  node.kind = unit.empty() ? Node::Kind::real : Node::Kind::text;
  if (unit.empty()) node.number = value;
  else node.text = fmt::format("{} {}", value, unit);
  for (std::size_t i = keys.size(); i-- > 0;) {
    Node table;
    table.keys = {keys[i]};
    table.items = {std::move(node)};
    node = std::move(table);
  }
  return node;
}

std::optional<WrittenNumber> written_number(const Node& node) {
  if (node.kind == Node::Kind::integer || node.kind == Node::Kind::real) return WrittenNumber{node.number, ""};
  if (node.kind != Node::Kind::text) return std::nullopt;
  const std::size_t start = node.text.find_first_not_of(" \t+");
  if (start == std::string::npos) return std::nullopt;
  double value = 0;
  const char* const end_of_text = node.text.data() + node.text.size();
  const auto [end, error] = std::from_chars(node.text.data() + start, end_of_text, value);
  if (error != std::errc()) return std::nullopt;
  std::string unit(end, end_of_text);
  unit.erase(0, unit.find_first_not_of(" \t"));
  unit.erase(unit.find_last_not_of(" \t") + 1);
  if (unit.empty()) return std::nullopt;
  return WrittenNumber{value, unit};
}

bool is_known_unit(const std::string& unit) {
  for (int q = static_cast<int>(Quantity::pure); q <= static_cast<int>(Quantity::mass_length); ++q)
    if (si_factor(unit, static_cast<Quantity>(q))) return true;
  return false;
}

std::optional<double> in_unit(const WrittenNumber& number, const std::string& unit) {
  if (number.unit == unit) return number.value;
  for (int q = static_cast<int>(Quantity::pure); q <= static_cast<int>(Quantity::mass_length); ++q) {
    const auto from = si_factor(number.unit, static_cast<Quantity>(q)), to = si_factor(unit, static_cast<Quantity>(q));
    if (from && to) return number.value * (*from / *to);
  }
  return std::nullopt;
}

}  // namespace trivet::project
