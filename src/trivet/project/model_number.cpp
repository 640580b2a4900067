// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/model_number.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "trivet/foundation/invalid_input.h"
#include "trivet/project/project.h"
#include "trivet/project/text/model_path.h"
#include "trivet/project/text/shared_keys.h"

namespace trivet::project {
namespace {

/// Adds the tables and values of another change.
void merge(Node& change, Node more) {
  for (std::size_t i = 0; i < more.keys.size(); ++i) {
    Node* same = change.find(more.keys[i]);
    if (same && same->kind == Node::Kind::table && more.items[i].kind == Node::Kind::table) {
      merge(*same, std::move(more.items[i]));
    } else {
      change.keys.push_back(more.keys[i]);
      change.items.push_back(std::move(more.items[i]));
    }
  }
}

}  // namespace

ModelNumber::ModelNumber(const std::vector<ParameterPlace>& places, std::string unit) : unit_(std::move(unit)) {
  for (const ParameterPlace& place : places) {
    places_.push_back({path_keys(place.path), place.factor});
    if (places_.back().keys.empty())
      throw foundation::InvalidInput("\"" + place.path + "\" is not the path of a number");
  }
}

std::optional<double> ModelNumber::read(const Place& place, const Case& variant) const {
  const Node* node = node_at(variant.written, place.keys);
  if (!node && place.keys.back() != "scale")
    node = node_at(variant.document, place.keys);  // from its type, except a scale, which multiplies
  if (!node) {
    const auto plain = default_number(place.keys);
    return plain ? in_unit({plain->value, ""}, unit_) : std::nullopt;
  }
  const auto written = written_number(*node);
  return written ? in_unit(*written, unit_) : std::nullopt;
}

std::vector<std::optional<double>> ModelNumber::values(const Case& variant) const {
  std::vector<std::optional<double>> result;
  for (const Place& place : places_) {
    auto& value = result.emplace_back(read(place, variant));
    if (value) *value /= place.factor;
  }
  return result;
}

std::optional<double> ModelNumber::read(const Case& variant) const {
  constexpr double same = 1e-9;  // relative: 0.4 m written as 400 mm
  std::optional<double> value;
  for (const std::optional<double>& here : values(variant)) {
    if (!here) return std::nullopt;
    if (value && std::abs(*here - *value) > same * std::abs(*value)) return std::nullopt;
    if (!value) value = here;
  }
  return value;
}

Node ModelNumber::change(double value) const {
  Node all = change_of(places_.front().keys, places_.front().factor * value, unit_);
  for (std::size_t i = 1; i < places_.size(); ++i)
    merge(all, change_of(places_[i].keys, places_[i].factor * value, unit_));
  return all;
}

}  // namespace trivet::project
