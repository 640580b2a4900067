// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "trivet/documents/text_table.h"
#include "trivet/project/text/shared_keys.h"
#include "trivet/results/design/optimization_results.h"
#include "trivet/results/format/result_writer.h"

/// Mounts that were chosen together with the numbers.
namespace trivet::results {
namespace {

using study::Optimization;

std::string mounts_words(const study::OptimizedMounts& mounts, const std::vector<std::size_t>& chosen) {
  std::string text;
  for (std::size_t c = 0; c < chosen.size(); ++c)
    text += (c ? ", " : "") + mounts.choices[c].name + " = " + mounts.choices[c].mounts[chosen[c]];
  return text;
}

Json mounts_json(const study::OptimizedMounts& mounts) {
  const auto names = [&](const std::vector<std::size_t>& chosen) {
    Json list = Json::object();
    for (std::size_t c = 0; c < chosen.size(); ++c) list[mounts.choices[c].name] = mounts.choices[c].mounts[chosen[c]];
    return list;
  };
  Json others = Json::array();
  for (const study::OptimizedMounts::Other& other : mounts.others)
    others.push_back({{"chosen", names(other.mounts)}, {"objective", json::number(other.objective)}});
  Json result = {{"chosen", names(mounts.chosen)},
                 {"combinations", mounts.combinations},
                 {"considered", mounts.considered},
                 {"optimized", mounts.optimized},
                 {"others", std::move(others)}};
  if (!mounts.price) return result;
  result["price"] = json::number(mounts.price->amount);
  result["price_before"] = mounts.price_before ? json::number(mounts.price_before->amount) : Json();
  result["currency"] = mounts.price->currency;
  result["some_met"] = mounts.some_met;
  return result;
}

}  // namespace

void add_mounts(const Optimization& found, Document& document) {
  if (!found.mounts) return;
  const study::OptimizedMounts& mounts = *found.mounts;
  std::vector<std::string> chosen;
  for (std::size_t c = 0; c < mounts.choices.size(); ++c) chosen.push_back(mounts.choices[c].mounts[mounts.chosen[c]]);
  document.add(Single{.name = "mounts", .value = mounts_json(mounts)});
  document.add(Words{.axis = "choice", .list = names_of(mounts.choices)});
  document.add(Words{.axis = "choice", .list = std::move(chosen), .name = "choice.mount"});
}

std::vector<std::string> mounts_lines(const Optimization& found) {
  if (!found.mounts) return {};
  const study::OptimizedMounts& mounts = *found.mounts;
  std::vector<std::string> lines = {"Mounts: " + mounts_words(mounts, mounts.chosen)};
  if (mounts.price)
    lines.push_back(fmt::format(
        "Price of all mounts: {} → {}. The numbers of {} of {} combinations were optimised, the cheapest first{}.",
        mounts.price_before ? project::price_words(*mounts.price_before) : "not known",
        project::price_words(*mounts.price), mounts.optimized, mounts.combinations,
        mounts.some_met || mounts.optimized == mounts.combinations
            ? ""
            : "; dearer ones were not tried: allow more with combinations"));
  else
    lines.push_back(fmt::format(
        "Best found of {} combinations of mounts: {} were considered with a few numbers, and the numbers of the best "
        "{} optimised.",
        mounts.combinations, mounts.considered, mounts.optimized));
  for (const study::OptimizedMounts::Other& other : mounts.others)
    lines.push_back(fmt::format(
        "next: {} with {}",
        mounts.price ? project::price_words({other.objective, mounts.price->currency}) : number_text(other.objective),
        mounts_words(mounts, other.mounts)));
  return lines;
}

}  // namespace trivet::results
