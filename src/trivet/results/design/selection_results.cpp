// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/design/selection_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/documents/text_table.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/project/text/shared_keys.h"
#include "trivet/response/machinery/transmissibility.h"
#include "trivet/results/format/json_parts.h"

namespace trivet::results {
namespace {

using study::MountDesign;
using study::MountSelection;

std::string margin_words(const MountDesign& design) {
  if (!design.reason.empty()) return "not judged";
  return std::isinf(design.margin) ? "∞" : fmt::format("{:.4g}", design.margin);
}

std::string governing_words(const MountDesign& design) {
  if (!design.reason.empty()) return design.reason;
  return std::isinf(design.margin) ? "nothing limits it" : design.governing;
}

/// "0.393 (−8.11 dB)", or "6.41 (+16.1 dB) AMPLIFIES".
std::string transmitted_words(const std::optional<double>& transmissibility) {
  if (!transmissibility) return "";
  constexpr double round_off = 1e-9;  // a rigid machine transmits 1
  return fmt::format("{:.3g} ({:+.3g} dB){}", *transmissibility, response::transmissibility_level(*transmissibility),
                     *transmissibility > 1 + round_off ? " AMPLIFIES" : "");
}

/// What the first of the table is, if every requirement is met.
std::string first_words(study::MountOrder by) {
  switch (by) {
    case study::MountOrder::price:
      return "Cheapest combination of mounts with which every requirement is met";
    case study::MountOrder::mass:
      return "Lightest combination of mounts with which every requirement is met";
    case study::MountOrder::isolation:
      return "Best isolating combination of mounts with which every requirement is met";
    case study::MountOrder::margin:
      break;
  }
  return "Best combination of mounts: every requirement is met";
}

std::vector<std::string> design_header(const MountSelection& found) {
  std::vector<std::string> header = {""};
  for (const project::MountChoice& choice : found.choices) header.push_back(choice.name);
  for (const char* word :
       {"margin", "governing", "load", "sag after creep", "lowest", "highest", "transmits", "price", "mass"})
    header.emplace_back(word);
  return header;
}

std::vector<std::string> design_row(const MountSelection& found, const std::string& rank, const MountDesign& design) {
  std::vector<std::string> row = {rank};
  for (std::size_t c = 0; c < found.choices.size(); ++c)
    row.push_back(design.mounts.empty() ? "as given" : found.choices[c].mounts[design.mounts[c]]);
  const auto in_hertz = [](const std::optional<double>& omega) {
    return omega ? fmt::format("{:.4g} Hz", *omega / foundation::two_pi) : "";
  };
  constexpr double millimetres = 1e3;
  row.push_back(margin_words(design));
  row.push_back(governing_words(design));
  row.push_back(!design.load ? "" : std::isinf(*design.load) ? "∞" : fmt::format("{:.0f} %", 100 * *design.load));
  row.push_back(design.deflection ? fmt::format("{:.3g} mm", millimetres * *design.deflection) : "");
  row.push_back(in_hertz(design.lowest));
  row.push_back(in_hertz(design.highest));
  row.push_back(transmitted_words(design.transmissibility));
  row.push_back(design.price ? project::price_words(*design.price) : "");
  row.push_back(design.mass ? fmt::format("{:.4g} kg", *design.mass) : "");
  return row;
}

bool is_exchange(const MountSelection& found) { return found.all_combinations > found.combinations; }

std::string judged_text(const MountSelection& found) {
  std::string text = fmt::format("{} combination{} of mounts", found.combinations, found.combinations == 1 ? "" : "s");
  for (std::size_t i = 0; i < found.failed.size(); ++i)
    text += fmt::format("{}{} {}", i == 0 ? "; first failed requirement: " : ", ", found.failed[i].test,
                        found.failed[i].combinations);
  text += ". ";
  if (found.curves > 0)
    text +=
        fmt::format("Amplitudes and peaks of {} combinations were computed exactly, without models. ", found.curves);
  text += fmt::format("All requirements of {} were computed", found.judged);
  if (found.judged < found.combinations)
    text += "; a bound of the margin proves that no other combination can be in these tables";
  return text + ".\n";
}

std::string search_text(const MountSelection& found) {
  std::string text = is_exchange(found)
      ? fmt::format(
            "Best found of {} combinations, too many to judge all: mounts of a few choices at a time were "
            "exchanged and {} combinations judged, all requirements of {}. No such exchange gains anything; that "
            "proves nothing about the others.\n",
            found.all_combinations, found.combinations, found.judged)
      : judged_text(found);
  if (!found.without_curves.empty())
    text += "Amplitudes and peaks were computed one by one: " + found.without_curves + ".\n";
  if (!found.without_bounds.empty())
    text += (found.curves > 0 ? "Loads and natural frequencies were computed one by one: "
                              : "All had to be computed one by one: ") +
        found.without_bounds + ".\n";
  return text;
}

std::string options_text(const MountSelection& found) {
  std::string text;
  constexpr std::size_t shown = 12;
  for (std::size_t c = 0; c < found.choices.size(); ++c) {
    TextTable table({found.choices[c].name, "best margin", "", "governing"});
    std::size_t count = 0, left_out = 0;
    for (const study::MountOption& option : found.options) {
      if (option.choice != c) continue;
      if (++count > shown) {
        ++left_out;
        continue;
      }
      table.add({found.choices[c].mounts[option.mount], margin_words(option.best), option.best.met ? "" : "infeasible",
                 governing_words(option.best)});
    }
    text += table.text();
    if (left_out > 0) text += fmt::format("… and {} more with smaller margins; all are in --json\n", left_out);
    text += "\n";
  }
  return text;
}

json::Json design_json(const MountSelection& found, const MountDesign& design) {
  json::Json mounts = json::Json::object();
  for (std::size_t c = 0; c < design.mounts.size(); ++c)
    mounts[found.choices[c].name] = found.choices[c].mounts[design.mounts[c]];
  return {{"mounts", std::move(mounts)},
          {"margin", json::number(design.margin)},
          {"met", design.met},
          {"governing", design.governing},
          {"reason", design.reason},
          {"load", json::optional(design.load)},
          {"deflection", json::optional(design.deflection)},
          {"lowest_angular_frequency", json::optional(design.lowest)},
          {"highest_angular_frequency", json::optional(design.highest)},
          {"transmissibility", json::optional(design.transmissibility)},
          {"price", design.price ? json::Json(design.price->amount) : json::Json(nullptr)},
          {"currency", design.price ? design.price->currency : ""},
          {"mass", json::optional(design.mass)}};
}

}  // namespace

std::string selection_text(const MountSelection& found) {
  const MountDesign& first = found.best.front();
  std::string text = first.met
      ? first_words(found.by) + ", least margin " + margin_words(first) + "\n\n"
      : "NO combination of mounts meets every requirement; the largest least margin is " + margin_words(first) + "\n\n";
  TextTable table(design_header(found));
  for (std::size_t i = 0; i < found.best.size(); ++i)
    table.add(design_row(found, std::to_string(i + 1), found.best[i]));
  table.add(design_row(found, "given", found.given));
  return text + table.text() + "\n" +
      (is_exchange(found) ? "What each mount reaches with the others of the first combination:\n"
                          : "What each mount reaches with the best of the others:\n") +
      options_text(found) + search_text(found);
}

namespace {

/// One text as --set for a shell.
std::string setting(const std::string& path, const std::string& text) {
  std::string words = path + " = \"";
  for (const char c : text) words += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
  std::string quoted;
  for (const char c : words + "\"") quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return "--set '" + quoted + "'\n";
}

}  // namespace

std::string mount_settings(const std::vector<project::MountChoice>& choices, const std::vector<std::size_t>& mounts) {
  std::string text;
  for (std::size_t c = 0; c < choices.size(); ++c)
    for (const std::string& path : choices[c].paths) {
      text += setting(path, "catalogue:" + choices[c].mounts[mounts[c]]);
      if (choices[c].catalogue)
        text +=
            setting(path.substr(0, path.size() - std::string("type").size()) + "catalogue", choices[c].catalogue->text);
    }
  return text;
}

std::string selection_settings(const MountSelection& found) {
  return mount_settings(found.choices, found.best.front().mounts);
}

std::string selection_json(const MountSelection& found, const foundation::Problems& warnings) {
  using json::Json;
  Json result = {{"by", study::name(found.by)},
                 {"all_combinations", found.all_combinations},
                 {"combinations", found.combinations},
                 {"curves", found.curves},
                 {"without_curves", found.without_curves},
                 {"judged", found.judged},
                 {"without_bounds", found.without_bounds},
                 {"cases", found.cases},
                 {"failed", Json::array()},
                 {"choices", Json::array()},
                 {"given", design_json(found, found.given)},
                 {"best", Json::array()},
                 {"warnings", json::warnings(warnings)}};
  for (const MountSelection::Failed& one : found.failed)
    result["failed"].push_back({{"test", one.test}, {"combinations", one.combinations}});
  for (std::size_t c = 0; c < found.choices.size(); ++c) {
    Json mounts = Json::array();
    for (const study::MountOption& option : found.options)
      if (option.choice == c)
        mounts.push_back({{"mount", found.choices[c].mounts[option.mount]}, {"best", design_json(found, option.best)}});
    result["choices"].push_back(
        {{"name", found.choices[c].name}, {"elements", found.choices[c].elements}, {"mounts", std::move(mounts)}});
  }
  for (const MountDesign& design : found.best) result["best"].push_back(design_json(found, design));
  return json::text(result, 1) + "\n";
}

}  // namespace trivet::results
