// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/map_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "trivet/study/design_parameter.h"

namespace trivet::report {
namespace {

struct KeyWords {
  const char* key;
  const char* words;
  const char* unit;   // of a bare number
};

constexpr std::array<KeyWords, 11> known_keys = {{{"scale", "stiffness scale", ""},
                                                  {"stiffening", "dynamic stiffening", ""},
                                                  {"proportional", "proportional damping δ", "s"},
                                                  {"loss_factor", "loss factor", ""},
                                                  {"mass", "mass", "kg"},
                                                  {"xx", "moment of inertia xx", "kg m²"},
                                                  {"yy", "moment of inertia yy", "kg m²"},
                                                  {"zz", "moment of inertia zz", "kg m²"},
                                                  {"xy", "product of inertia xy", "kg m²"},
                                                  {"xz", "product of inertia xz", "kg m²"},
                                                  {"yz", "product of inertia yz", "kg m²"}}};

const KeyWords* known(const std::vector<std::string>& keys) {
  const auto found = std::find_if(known_keys.begin(), known_keys.end(), [&](const KeyWords& k) { return !keys.empty() && keys.back() == k.key; });
  return found == known_keys.end() ? nullptr : &*found;
}

/// "A, B and 3 more"
std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t most = 6;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, names.size()); ++i) text += (i == 0 ? "" : ", ") + names[i];
  return names.size() > most ? text + fmt::format(" and {} more", names.size() - most) : text;
}

bool in_frame(const study::DesignMap& map, const study::MapMark& mark) {
  const double x = map.request.x.share(*mark.x), y = map.request.y.share(*mark.y);
  return x >= 0 && x <= 1 && y >= 0 && y <= 1;
}

}  // namespace

std::string axis_name(const study::MapAxis& axis) {
  const std::vector<std::string> keys = study::path_keys(axis.parameter);
  if (axis.name != axis.parameter || keys.size() < 2) return axis.name;
  std::string words = keys.back();
  std::replace(words.begin(), words.end(), '_', ' ');
  if (const KeyWords* k = known(keys)) words = k->words;
  return keys.size() > 2 ? words + " of " + keys[1] : words;
}

std::string axis_label(const study::MapAxis& axis) {
  const std::vector<std::string> keys = study::path_keys(axis.parameter);
  const std::string unit = !axis.unit.empty() ? axis.unit : known(keys) ? known(keys)->unit : "SI units";
  return unit.empty() ? axis_name(axis) : fmt::format("{} [{}]", axis_name(axis), unit);
}

std::string value_words(double value, const study::MapAxis& axis) { return fmt::format("{:.5g}{}", value, axis.unit.empty() ? "" : " " + axis.unit); }

bool is_drawn(const study::DesignMap& map, const study::MapMark& mark) { return mark.placed() && mark.of_this_model && mark.judged && in_frame(map, mark); }

std::vector<std::string> undrawn_cases(const study::DesignMap& map) {
  std::vector<std::string> outside, another, failed;
  for (const study::MapMark& mark : map.marks) {
    if (is_drawn(map, mark)) continue;
    const std::string name = mark.name.empty() ? "base model" : mark.name;
    if (!mark.judged) failed.push_back(name);
    else if (!mark.placed() || !mark.of_this_model) another.push_back(name);
    else outside.push_back(fmt::format("{} ({}, {})", name, value_words(*mark.x, map.request.x), value_words(*mark.y, map.request.y)));
  }
  std::vector<std::string> sentences;
  if (!outside.empty()) sentences.push_back("Outside the frame: " + listed(outside) + ".");
  if (!another.empty()) sentences.push_back("Not drawn because they differ from this map in more than the two numbers: " + listed(another) + ".");
  if (!failed.empty()) sentences.push_back("Not drawn because they could not be computed: " + listed(failed) + ".");
  return sentences;
}

}  // namespace trivet::report
