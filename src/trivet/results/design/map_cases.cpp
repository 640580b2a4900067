// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/design/map_cases.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "trivet/results/design/map_summary.h"
#include "trivet/results/format/axis_words.h"

namespace trivet::results {
namespace {

using json::Json;
using study::DesignMap;

Sentence map_note(std::string words) { return {.parts = {std::move(words)}, .place = Sentence::Place::note}; }

std::string place_words(const std::optional<double>& value, const project::DesignAxis& axis) {
  return value ? axis_value(*value, axis) : std::string("not in the file");
}

std::string mark_name(const study::MapMark& mark) { return mark.name.empty() ? "base model" : mark.name; }

/// The verdict on every case with the rule that governs it: a row for each.
Table marks_table(const DesignMap& map) {
  using study::MapMark;
  const Rows row(map.marks);
  return {.rows = row.size(),
          .columns = {row("case", Kind::words, "case", mark_name),
                      row("x", Kind::words, axis_name(map.request.x),
                          [&map](const MapMark& mark) { return place_words(mark.x, map.request.x); }),
                      row("y", Kind::words, axis_name(map.request.y),
                          [&map](const MapMark& mark) { return place_words(mark.y, map.request.y); }),
                      row("margin", Kind::number, "margin",
                          [](const MapMark& mark) -> Json {
                            if (!mark.judged) return nullptr;
                            return mark.judged->governing.margin;
                          },
                          {.digits = 4}),
                      row("governed by", Kind::words, "governed by",
                          [&map](const MapMark& mark) -> std::string {
                            if (!mark.judged) return "–";
                            const auto& least = mark.judged->governing;
                            return std::isinf(least.margin) ? "no rule" : rule_words(map, map.rules[least.rule]);
                          }),
                      row("verdict", Kind::words, "verdict",
                          [](const MapMark& mark) {
                            if (!mark.judged) return "NOT COMPUTED";
                            if (mark.judged->governing.feasible()) return "met";
                            return mark.decides ? "VIOLATED" : "violated, not binding";
                          })},
          .forms = for_people};
}

}  // namespace

Group governing_on_map(const DesignMap& map) {
  Group group{.key = "", .parts = {}, .title = "Cases on the map"};
  if (map.marks.empty()) return group;
  group.parts.push_back({marks_table(map)});
  std::size_t findings = 0;
  std::string others;
  for (const study::MapMark& mark : map.marks) {
    const std::vector<std::string> words = verdict_words(map, mark);
    findings += words.size();
    if (!mark.of_this_model) others += (others.empty() ? "" : ", ") + mark_name(mark);
    if (mark.has_own_rules || !mark.judged) group.parts.push_back({map_note(mark_name(mark) + ": " + words.front())});
  }
  if (!others.empty()) group.parts.push_back({map_note("their models differ by more than the two numbers: " + others)});
  if (findings > 0)
    group.parts.push_back(
        {map_note(fmt::format("… {} finding{} on these cases, what each exceeds and where it peaks: --full", findings,
                              findings == 1 ? "" : "s"))});
  return group;
}

Group cases_on_map(const DesignMap& map) {
  Group group{.key = "", .parts = {}, .title = "Cases on the map"};
  for (const study::MapMark& mark : map.marks) {
    group.parts.push_back({Sentence{
        .parts = {fmt::format("{} ({}, {}): {}{}", mark_name(mark), place_words(mark.x, map.request.x),
                              place_words(mark.y, map.request.y),
                              !mark.judged                            ? "NOT COMPUTED"
                                  : mark.judged->governing.feasible() ? "meets every rule"
                                  : mark.decides                      ? "VIOLATES the rules"
                                                                      : "violates the rules, not binding in this case",
                              mark.of_this_model ? "" : "; its model differs by more than the two numbers")}}});
    for (const std::string& words : verdict_words(map, mark))
      group.parts.push_back({Sentence{.parts = {"    " + words}, .place = Sentence::Place::item}});
  }
  return group;
}

}  // namespace trivet::results
