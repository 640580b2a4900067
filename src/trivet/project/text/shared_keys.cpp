// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/shared_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <sstream>
#include <utility>

#include "trivet/project/text/admissible_range.h"
#include "trivet/project/text/model_path.h"

namespace trivet::project {

namespace {

bool is_one_of(const std::string& key, std::initializer_list<const char*> words) {
  return std::ranges::find(words, key) != words.end();
}

/// Quantity of a number of an element type: that of its copies in the elements of this type.
std::optional<Quantity> quantity_of_copies(const Node& number, const Node& document,
                                           const std::vector<std::string>& keys) {
  const Node* elements = document.find("elements");
  if (!elements) return std::nullopt;
  for (const Node& element : elements->items) {
    const Node* copy = node_at(element, {keys.begin() + 2, keys.end()});
    if (copy && copy->quantity && copy->origin.source == number.origin.source &&
        copy->origin.line == number.origin.line)
      return copy->quantity;
  }
  return std::nullopt;
}

}  // namespace

const std::vector<std::string>& numbers_with_default() {
  static const std::vector<std::string> keys = {"scale",          "stiffening",        "creep",
                                                "damping_factor", "mass_about_center", "modal_factor"};
  return keys;
}

std::optional<DefaultNumber> default_number(const std::vector<std::string>& keys) {
  const std::string& key = keys.back();
  if (std::ranges::find(numbers_with_default(), key) != numbers_with_default().end())
    return DefaultNumber{1, Quantity::pure};
  if (keys.size() < 2) return std::nullopt;
  const std::string& table = keys[keys.size() - 2];
  if (table == "stiffness_factor") return DefaultNumber{1, Quantity::pure};
  if (table == "moved" || table == "center_moved" || is_zero_by_default(table))
    return DefaultNumber{0, Quantity::length};
  if (table == "inertia_about_center")
    return DefaultNumber{is_one_of(key, {"xx", "yy", "zz"}) ? 1.0 : 0.0, Quantity::pure};
  return std::nullopt;
}

std::optional<Quantity> quantity_at(const Node& document, const std::vector<std::string>& keys) {
  const Node* number = node_at(document, keys);
  if (number && number->quantity) return number->quantity;
  if (number && keys.size() > 2 && keys.front() == "element_types")
    if (const auto quantity = quantity_of_copies(*number, document, keys)) return quantity;
  const auto plain = keys.empty() || (number && !written_number(*number)) ? std::nullopt : default_number(keys);
  return plain ? std::optional(plain->quantity) : std::nullopt;
}

void warn_at_key(TableReader& reader, const std::string& key, std::string finding, std::string rule,
                 std::string remedy) {
  const Node* node = reader.node(key);
  foundation::Problem& problem = reader.problems().warning(reader.path().empty() ? key : reader.path() + "." + key,
                                                           std::move(finding), std::move(rule), std::move(remedy));
  if (node) problem.origin = node->origin;
}

namespace {

std::optional<double> amount_from(const std::string& word) {
  double amount = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), amount);
  const bool whole = error == std::errc() && end == word.data() + word.size();
  return whole && std::isfinite(amount) && amount >= 0 ? std::optional(amount) : std::nullopt;
}

bool is_currency(const std::string& word) {
  constexpr std::size_t longest = 8;
  return !word.empty() && word.size() <= longest && word.find_first_of("0123456789.,-+/") == std::string::npos;
}

}  // namespace

std::optional<model::Price> price_from(const std::string& text) {
  std::istringstream words(text);
  std::string first, second, more;
  words >> first >> second;
  if (words >> more) return std::nullopt;
  if (is_currency(first)) std::swap(first, second);
  const auto amount = amount_from(first);
  if (!amount || !is_currency(second)) return std::nullopt;
  return model::Price{*amount, second};
}

std::string price_words(const model::Price& price) { return fmt::format("{:.6g} {}", price.amount, price.currency); }

namespace {

/// 0 is 0 in every unit.
bool has_mixed_units(const Node& list) {
  bool bare = false, with_unit = false;
  for (const Node& item : list.items) {
    if (item.kind == Node::Kind::text) with_unit = true;
    else if (item.number != 0) bare = true;
  }
  return bare && with_unit;
}

}  // namespace

std::optional<assembly::Band> read_band(TableReader& reader, const std::string& key) {
  const auto band = reader.numbers(key, Quantity::angular_frequency);
  if (!band) return std::nullopt;
  const Node& list = *reader.node(key);
  if (has_mixed_units(list)) {
    reader.error(key, "one end has a unit, the other has none", "both ends have a unit, or neither (rad/s)",
                 "give both a unit");
    return std::nullopt;
  }
  const std::string kind = key == "band" ? "band" : "range";
  const auto broken = band->size() == 2 ? wrong_band((*band)[0], (*band)[1])
                                        : std::optional<std::string>("[from, to] with 0 ≤ from < to");
  if (!broken) return assembly::Band{(*band)[0], (*band)[1]};
  const bool near = band->size() == 2 && (*band)[0] >= 0 && (*band)[1] > (*band)[0];
  reader.error(key,
               near                    ? fmt::format("{} to {}", canonical(list.items[0]), canonical(list.items[1]))
                   : band->size() == 2 ? fmt::format("{} to {}", value_text(list, 0), value_text(list, 1))
                                       : fmt::format("{} numbers", band->size()),
               "a " + kind + " is [from, to] with 0 ≤ from < to" + (near ? ", and " + *broken : ""),
               key == "band" ? "for instance [\"0 Hz\", \"50 Hz\"]" : "for instance [\"600 rpm\", \"3000 rpm\"]");
  return std::nullopt;
}

}  // namespace trivet::project
