// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/map/map_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/foundation/plain_text.h"
#include "trivet/results/format/axis_words.h"

namespace trivet::report {
namespace {

/// Is an axis too short for ticks with complete numbers?
bool is_narrow(const project::DesignAxis& axis) {
  return axis.to - axis.from < 1e-5 * std::max(std::abs(axis.from), std::abs(axis.to));
}

bool in_frame(const study::DesignMap& map, const study::MapMark& mark) {
  const double x = map.request.x.share(*mark.x), y = map.request.y.share(*mark.y);
  return x >= 0 && x <= 1 && y >= 0 && y <= 1;
}

}  // namespace

std::string axis_label(const project::DesignAxis& axis) {
  const std::string unit = results::axis_unit(axis);
  std::string words = results::axis_name(axis) + (is_narrow(axis) ? fmt::format(" − {}", axis.from) : "");
  if (results::is_pure_number(axis)) return words;
  return fmt::format("{} [{}]", words, unit.empty() ? "SI units" : unit);
}

Axis drawn_axis(const project::DesignAxis& axis) {
  if (is_narrow(axis))
    return {0, axis.to - axis.from, false, axis_label(axis)};  // a logarithmic axis this short is practically linear
  return {axis.from, axis.to, axis.logarithmic, axis_label(axis)};
}

bool is_drawn(const study::DesignMap& map, const study::MapMark& mark) {
  return mark.placed() && mark.of_this_model && mark.judged && in_frame(map, mark);
}

std::vector<std::string> undrawn_cases(const study::DesignMap& map) {
  std::vector<std::string> outside, another, failed;
  for (const study::MapMark& mark : map.marks) {
    if (is_drawn(map, mark)) continue;
    const std::string name = mark.name.empty() ? "base model" : mark.name;
    if (!mark.judged) {
      failed.push_back(name);
      continue;
    }
    const char* verdict = mark.judged->governing.feasible() ? "meets every rule" : "violates a rule";
    if (!mark.placed() || !mark.of_this_model) another.push_back(fmt::format("{} ({})", name, verdict));
    else
      outside.push_back(fmt::format("{} ({}, {}: {})", name, results::axis_value(*mark.x, map.request.x),
                                    results::axis_value(*mark.y, map.request.y), verdict));
  }
  std::vector<std::string> sentences;
  if (!outside.empty()) sentences.push_back("Outside the frame: " + foundation::comma_separated(outside, 6) + ".");
  if (!another.empty())
    sentences.push_back("Not drawn because they differ from this map by more than the two numbers: " +
                        foundation::comma_separated(another, 6) + ".");
  if (!failed.empty())
    sentences.push_back("Not drawn because they could not be computed: " + foundation::comma_separated(failed, 6) +
                        ".");
  return sentences;
}

}  // namespace trivet::report
