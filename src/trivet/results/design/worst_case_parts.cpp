// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/design/worst_case_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "trivet/foundation/index.h"
#include "trivet/results/design/sample_words.h"
#include "trivet/results/design/verdict_words.h"
#include "trivet/results/format/json_parts.h"

namespace trivet::results {
namespace {

using namespace documents;

struct WorstRow {
  const study::Sample* sample;
  const study::SampledCaseResult* in;
  const study::SampledRequirement* of;

  [[nodiscard]] const study::WorstDesign& worst() const { return *of->worst; }
};

Table worst_table(const study::Sample& sample) {
  std::vector<WorstRow> list;
  for (const study::SampledCaseResult& one : sample.cases)
    for (const study::SampledRequirement& of : one.requirements) list.push_back({&sample, &one, &of});
  const Rows row(std::move(list));
  const ColumnOptions shown = {.digits = 4};
  return {.rows = row.size(),
          .columns = {row("requirement", Kind::words, "worst found of",
                          [](const WorstRow& one) {
                            return requirement_words(one.of->given, one.in->display) + in_case_words(one.in->case_name);
                          }),
                      row(
                          "given", Kind::number, "margin in the file",
                          [](const WorstRow& one) { return one.of->given.margin; }, shown),
                      row(
                          "margin", Kind::number, "worst found", [](const WorstRow& one) { return one.worst().margin; },
                          shown),
                      row("place", Kind::words, "at",
                          [](const WorstRow& one) { return worst_place_words(*one.sample, one.worst()); }),
                      row("looked_at", Kind::number, "designs looked at",
                          [](const WorstRow& one) { return one.worst().looked_at; })},
          .forms = on_screen | on_page};
}

/// Requirements of which a drawn design is worse than the worst one that was found.
std::string beaten_searches(const study::Sample& sample) {
  std::string list;
  for (const study::SampledCaseResult& one : sample.cases)
    for (const study::SampledRequirement& requirement : one.requirements) {
      if (!requirement.drawn_is_worst()) continue;
      list += fmt::format("{}\"{}\"{} ({:.4g})", list.empty() ? "" : ", ",
                          requirement_words(requirement.given, one.display), in_case_words(one.case_name),
                          requirement.margin.extremes.least);
    }
  return list;
}

std::string search_words(const study::Sample& sample) {
  const study::WorstCaseSearch& search = *sample.worst_case_search;
  const auto unbounded = [](const project::Tolerance& one) {
    const auto [from, to] = numerics::ends(one.distribution);
    return !std::isfinite(from) || !std::isfinite(to);
  };
  const std::string beaten = beaten_searches(sample);
  return fmt::format(
      "The worst designs are those that a search found; there may be worse ones. It began with {} of the ranges of the "
      "drawn numbers and {} designs inside, and went down the slopes of each margin. {}{}",
      search.all_corners ? fmt::format("all {} corners", search.corners) : fmt::format("{} corners", search.corners),
      search.inside,
      std::ranges::any_of(sample.tolerances, unbounded)
          ? fmt::format("An unbounded end of a range is where {:g} % of the numbers are beyond it; designs beyond it "
                        "can be worse.",
                        100 * study::beyond_worst_range / 2)
          : std::string("The ranges contain all numbers that can be drawn."),
      beaten.empty() ? beaten
                     : " Of these a drawn design is worse than the one found, with this margin: " + beaten + ".");
}

}  // namespace

std::string worst_place_words(const study::Sample& sample, const study::WorstDesign& worst) {
  std::string words = worst.is_corner ? "a corner"
      : worst.at_ends == 0            ? "inside all ranges"
                                      : fmt::format("{} of {} numbers at an end", worst.at_ends, sample.draws);
  return worst.ended ? words : words + ", not ended";
}

std::string setting_words(const std::vector<study::NamedNumber>& numbers) {
  std::string words;
  for (const study::NamedNumber& one : numbers) {
    const std::string setting = fmt::format("{}={}", one.path, one.value);
    const bool plain = setting.find_first_not_of(
                           "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.=+-") == std::string::npos;
    std::string quoted;
    for (const char letter : setting) quoted += letter == '\'' ? std::string(R"('\'')") : std::string(1, letter);
    words += fmt::format("{}--set {}", words.empty() ? "" : " ", plain ? setting : "'" + quoted + "'");
  }
  return words;
}

Json numbers_json(const std::vector<study::NamedNumber>& list) {
  Json numbers = Json::object();
  for (const study::NamedNumber& one : list) numbers[one.path] = json::number(one.value);
  return numbers;
}

std::vector<Column> worst_columns(std::vector<const study::SampledRequirement*> list) {
  if (list.empty() || !list.front()->worst) return {};
  const Rows row(std::move(list));
  const auto worst = [](auto of) { return [of](const study::SampledRequirement* one) { return of(*one->worst); }; };
  using study::WorstDesign;
  const ColumnOptions data = {.forms = in_json | in_csv};
  return {row("worst_margin", Kind::number, "", worst([](const WorstDesign& w) { return w.margin; }), data),
          row("worst_is_corner", Kind::yes_no, "", worst([](const WorstDesign& w) { return w.is_corner; }), data),
          row("worst_at_ends", Kind::number, "", worst([](const WorstDesign& w) { return w.at_ends; }), data),
          row("worst_ended", Kind::yes_no, "", worst([](const WorstDesign& w) { return w.ended; }), data),
          row("worst_looked_at", Kind::number, "", worst([](const WorstDesign& w) { return w.looked_at; }), data),
          row("worst_numbers", Kind::words, "", worst([](const WorstDesign& w) { return numbers_json(w.numbers); }),
              {.forms = in_json}),
          row("worst_settings", Kind::words, "", worst([](const WorstDesign& w) { return setting_words(w.numbers); }),
              data)};
}

void add_worst_cases(const study::Sample& sample, Document& document) {
  if (!sample.worst_case_search) return;
  const study::WorstCaseSearch& search = *sample.worst_case_search;
  Group& group = document.add(Group{.key = "worst_found", .parts = {}});
  const auto single = [&](const char* name, Json value) {
    group.parts.push_back({Single{.name = name, .value = std::move(value)}});
  };
  const auto say = [&](std::string words) {
    group.parts.push_back({Sentence{.parts = {std::move(words)}, .forms = on_screen | on_page}});
  };
  single("all_corners", search.all_corners);
  single("corners", search.corners);
  single("inside", search.inside);
  single("beyond_range", study::beyond_worst_range);
  single("failed", search.failed);
  single("first_failure", search.first_failure);
  group.parts.push_back({worst_table(sample)});
  for (const study::SampledCaseResult& one : sample.cases)
    for (const study::SampledRequirement& of : one.requirements)
      say(fmt::format("{}{}: {}", requirement_words(of.given, one.display), in_case_words(one.case_name),
                      setting_words(of.worst->numbers)));
  say(search_words(sample));
  if (search.failed > 0)
    say(fmt::format(
        "{} design{} of the search could not be judged, which is worse than any margin. The first reason: {}.",
        search.failed, search.failed == 1 ? "" : "s", search.first_failure));
}

}  // namespace trivet::results
