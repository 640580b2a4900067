// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/elements/adjustments_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "trivet/foundation/index.h"
#include "trivet/model/adjustments.h"

namespace trivet::project {
namespace {

/// A factor > 0; 1 if it is missing or wrong.
double read_factor(TableReader& reader, const std::string& key) {
  const auto factor = reader.number(key, Quantity::pure);
  if (!factor) return 1;
  if (*factor > 0) return *factor;
  reader.error(key, fmt::format("{:.6g}", *factor), "a factor is > 0; 1 leaves the model as it is",
               "give a positive number");
  return 1;
}

/// {x = …, y = …, z = …}, missing ones 0.
Eigen::Vector3d read_shift(TableReader& reader, const std::string& key) {
  Eigen::Vector3d by = Eigen::Vector3d::Zero();
  const Node* table = reader.table(key);
  if (!table) return by;
  TableReader inside(*table, reader.path() + "." + key, reader.problems());
  for (int j = 0; j < 3; ++j) by(j) = inside.number(std::string(1, "xyz"[j]), Quantity::length).value_or(0);
  inside.finish();
  return by;
}

/// Adds a change of the element of that name, if that could be read.
template <typename Change>
void change_element(SymbolTable& symbols, const std::string& name, const Change& change) {
  symbols.adjustments.push_back([name, change](model::Description& description) {
    const auto& elements = description.elements;
    const auto found = std::ranges::find(elements, name, &model::Element::name);
    if (found != elements.end()) change(description, to_size(found - elements.begin()));
  });
}

void read_stiffness_factor(TableReader& reader, const model::Element& element, bool complete, SymbolTable& symbols) {
  const Node* table = reader.table("stiffness_factor");
  if (!table) return;
  TableReader inside(*table, reader.path() + ".stiffness_factor", reader.problems());
  if (complete && element.law.nominal_stiffness.isZero(0))
    inside.error("", "an element without stiffness", "there is nothing to scale", "remove it");
  const double all = read_factor(inside, "all");
  spatial::Vector6 factors;
  for (std::size_t j = 0; j < 6; ++j) {
    const std::string key = model::coordinate_names[j];
    factors(to_index(j)) = read_factor(inside, key);
    if (inside.has(key) && !model::has_plain_stiffness(element))
      inside.error(key, "a factor for one direction of an element with mass or frequency-dependent stiffness",
                   "such an element has one factor for its whole stiffness", "use `all`, or `scale` of the element");
  }
  inside.finish();
  if (all != 1)
    change_element(symbols, element.name, [gain = all - 1](model::Description& d, std::size_t e) {
      model::add_deformation_stiffness(d, e, gain);
    });
  if (!factors.isOnes(0))
    change_element(symbols, element.name, [factors](model::Description& d, std::size_t e) {
      model::scale_stiffness_by_direction(d, e, factors);
    });
}

}  // namespace

void read_element_adjustments(TableReader& reader, const model::Element& element, bool complete, SymbolTable& symbols) {
  read_stiffness_factor(reader, element, complete, symbols);
  const double damping = read_factor(reader, "damping_factor");
  if (complete && reader.has("damping_factor") && !model::has_damping(element))
    reader.error("damping_factor", "an element without damping", "there is nothing to scale",
                 "give it a damping, or remove the factor");
  if (damping != 1)
    change_element(symbols, element.name,
                   [damping](model::Description& d, std::size_t e) { model::scale_damping(d, e, damping); });
  const Eigen::Vector3d by = read_shift(reader, "moved");
  if (!by.isZero(0))
    change_element(symbols, element.name,
                   [by](model::Description& d, std::size_t e) { model::move_element(d, e, by); });
}

void read_body_adjustments(TableReader& reader, const model::Body& body, std::size_t index, SymbolTable& symbols) {
  const double mass = read_factor(reader, "mass_about_center");
  if (mass != 1)
    symbols.adjustments.push_back([index, mass](model::Description& d) { model::scale_mass(d, index, mass); });
  const Eigen::Vector3d by = read_shift(reader, "center_moved");
  if (!by.isZero(0))
    symbols.adjustments.push_back([index, by](model::Description& d) { model::move_center_of_mass(d, index, by); });
  const Node* table = reader.table("inertia_about_center");
  if (!table) return;
  TableReader inside(*table, reader.path() + ".inertia_about_center", reader.problems());
  if (!body.has_inertia)
    inside.error("", "a body without inertia", "there is nothing to change", "give it an inertia, or remove this");
  // Products first: they are shares of the moments as described.
  for (const auto& [i, j] : {std::pair{0, 1}, {0, 2}, {1, 2}, {0, 0}, {1, 1}, {2, 2}}) {
    const std::string key = {"xyz"[i], "xyz"[j]};
    const double share = i == j ? read_factor(inside, key) - 1 : inside.number(key, Quantity::pure).value_or(0);
    if (share != 0)
      symbols.adjustments.push_back(
          [index, i = i, j = j, share](model::Description& d) { model::change_inertia(d, index, i, j, share); });
  }
  inside.finish();
}

void read_damping_adjustment(TableReader& reader, SymbolTable& symbols) {
  const double factor = read_factor(reader, "modal_factor");
  if (reader.has("modal_factor") && !reader.has("modal"))
    reader.error("modal_factor", "a factor without modal damping", "there is nothing to scale",
                 "give modal = …, or remove the factor");
  if (factor != 1)
    symbols.adjustments.push_back([factor](model::Description& d) { model::scale_modal_damping(d, factor); });
}

}  // namespace trivet::project
