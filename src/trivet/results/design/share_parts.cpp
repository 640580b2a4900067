// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/design/share_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

#include "trivet/results/design/sample_words.h"
#include "trivet/results/design/verdict_words.h"
#include "trivet/results/format/json_parts.h"

namespace trivet::results {
namespace {

using numerics::ConfidenceInterval;
using study::Sample;
using study::SampledCaseResult;

/// One set of drawn numbers and one requirement.
struct ShareRow {
  const Sample* sample;
  const study::RequirementShares* of;
  std::size_t set;

  [[nodiscard]] const SampledCaseResult& in() const { return sample->cases[of->in_case]; }
  [[nodiscard]] const study::RequirementResult& requirement() const { return in().requirements[of->requirement].given; }
  [[nodiscard]] const numerics::VarianceShare& share() const { return of->sets[set]; }
};

/// Sets of numbers of each requirement, those with the largest total shares first.
Table share_table(const Sample& sample) {
  std::vector<ShareRow> list;
  for (const study::RequirementShares& one : sample.shares->list)
    for (const std::size_t set : by_total_share(one)) list.push_back({&sample, &one, set});
  const Rows row(std::move(list));
  const auto number = [&](const char* name, auto member, double ConfidenceInterval::* of) {
    return row(name, Kind::share, "", [=](const ShareRow& one) { return (one.share().*member).*of; },
               {.forms = in_json});
  };
  using numerics::VarianceShare;
  return {.key = "list",
          .rows = row.size(),
          .columns = {row("case", Kind::words, "", [](const ShareRow& one) { return one.in().case_name; },
                          {.forms = in_json}),
                      row("requirement", Kind::words, "",
                          [](const ShareRow& one) { return one.requirement().words.text(); }, {.forms = in_json}),
                      row("requirement", Kind::words, "value of",
                          [](const ShareRow& one) {
                            return requirement_words(one.requirement(), one.in().display) +
                                in_case_words(one.in().case_name);
                          },
                          {.forms = for_people}),
                      row("number", Kind::words, "drawn number",
                          [](const ShareRow& one) { return one.sample->shares->sets[one.set].name.words(); }),
                      row("numbers", Kind::number, "",
                          [](const ShareRow& one) { return one.sample->shares->sets[one.set].draws.size(); },
                          {.forms = in_json}),
                      number("first", &VarianceShare::first, &ConfidenceInterval::estimate),
                      number("first_from", &VarianceShare::first, &ConfidenceInterval::from),
                      number("first_to", &VarianceShare::first, &ConfidenceInterval::to),
                      number("total", &VarianceShare::total, &ConfidenceInterval::estimate),
                      number("total_from", &VarianceShare::total, &ConfidenceInterval::from),
                      number("total_to", &VarianceShare::total, &ConfidenceInterval::to),
                      row("alone", Kind::words, "share alone",
                          [](const ShareRow& one) { return share_words(one.share().first); }, {.forms = for_people}),
                      row("together", Kind::words, "with others",
                          [](const ShareRow& one) { return share_words(one.share().total); }, {.forms = for_people})},
          .forms = in_json | on_screen | on_page};
}

/// Requirements without shares, and why.
Table without_shares(const Sample& sample) {
  std::vector<ShareRow> list;
  for (const study::RequirementShares& one : sample.shares->list)
    if (!one.reason.empty()) list.push_back({&sample, &one, 0});
  const Rows row(std::move(list));
  return {.key = "without",
          .rows = row.size(),
          .columns = {row("case", Kind::words, "", [](const ShareRow& one) { return one.in().case_name; },
                          {.forms = in_json}),
                      row("requirement", Kind::words, "",
                          [](const ShareRow& one) { return one.requirement().words.text(); }, {.forms = in_json}),
                      row("requirement", Kind::words, "no shares of",
                          [](const ShareRow& one) {
                            return requirement_words(one.requirement(), one.in().display) +
                                in_case_words(one.in().case_name);
                          },
                          {.forms = for_people}),
                      row("reason", Kind::words, "because", [](const ShareRow& one) { return one.of->reason; })},
          .forms = in_json | on_screen | on_page};
}

}  // namespace

std::vector<std::size_t> by_total_share(const study::RequirementShares& shares) {
  std::vector<std::size_t> order(shares.sets.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater(), [&](std::size_t s) { return shares.sets[s].total.estimate; });
  return order;
}

void add_shares(const Sample& sample, Document& document) {
  if (!sample.shares) return;
  const study::SampledShares& shares = *sample.shares;
  Group& group = document.add(Group{.key = "shares", .parts = {}});
  const auto add = [&](const char* name, Json value) {
    group.parts.push_back({Single{.name = name, .value = std::move(value)}});
  };
  add("pairs", shares.pairs);
  add("left_out", shares.left_out);
  add("reason", shares.reason);
  const std::string words = !shares.reason.empty()
      ? "No shares of the variance: " + shares.reason + "."
      : fmt::format("Shares of the variance of each value, with {} confidence, from {} pairs of designs:",
                    confidence_words(), shares.pairs);
  group.parts.push_back({Sentence{.parts = {words}, .forms = on_screen | on_page}});
  if (shares.left_out > 0)
    group.parts.push_back({Sentence{
        .parts = {fmt::format("Up to {} of the pairs are left out: a design could not be judged, or its value is "
                              "unbounded.",
                              shares.left_out)},
        .forms = on_screen | on_page}});
  Table table = share_table(sample);
  if (!shares.reason.empty()) table.forms = in_json;
  group.parts.push_back({std::move(table)});
  group.parts.push_back({without_shares(sample)});
}

}  // namespace trivet::results
