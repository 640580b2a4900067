// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/default_number.h"

#include <algorithm>
#include <array>

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

std::optional<DefaultNumber> default_number(const std::vector<std::string>& keys) {
  const std::string& key = keys.back();
  if (is_one_of(key, {"scale", "stiffening", "creep", "damping_factor", "mass_about_center", "modal_factor"}))
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

}  // namespace trivet::project
