// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/design/selection_document.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>

#include "trivet/documents/text_table.h"
#include "trivet/project/text/shared_keys.h"
#include "trivet/response/machinery/transmissibility.h"
#include "trivet/results/format/json_parts.h"

namespace trivet::results {
namespace {

using study::MountDesign;
using study::MountSelection;

/// A design, and what it is called: its rank, or the mount that it is the best with.
struct NamedDesign : MountDesign {
  std::string name;
};

std::string margin_words(const MountDesign& design) {
  return design.reason.empty() ? number_text(design.margin, 4) : "not judged";
}

std::string governing_words(const MountDesign& design) {
  if (!design.reason.empty()) return design.reason;
  return std::isinf(design.margin) ? "nothing limits it" : design.governing_for_people;
}

/// T and the level of isolation: "0.393 (8.11 dB)", or "6.41 (-16.1 dB) AMPLIFIES".
std::string transmitted_words(const MountDesign& design) {
  if (!design.transmissibility) return "–";
  constexpr double round_off = 1e-9;  // a rigid machine transmits 1
  const double transmitted = *design.transmissibility;
  return fmt::format("{:.3g} ({:.3g} dB){}", transmitted, response::isolation_level(transmitted),
                     transmitted > 1 + round_off ? " AMPLIFIES" : "");
}

std::string best_in(study::MountOrder by) {
  return by == study::MountOrder::price    ? "Cheapest"
      : by == study::MountOrder::mass      ? "Lightest"
      : by == study::MountOrder::isolation ? "Best isolating"
                                           : "Best";
}

/// Designs as rows for people, and as JSON objects.
Table design_table(const MountSelection& found, const std::string& heading, std::vector<NamedDesign> designs) {
  const Rows row(std::move(designs));
  const ColumnOptions shown = {.digits = 4, .forms = for_people};
  const auto mounts = [&found](const MountDesign& design) {
    Json chosen = Json::object();
    for (std::size_t c = 0; c < design.mounts.size(); ++c)
      chosen[found.choices[c].name] = found.choices[c].mounts[design.mounts[c]];
    return chosen;
  };
  const ColumnOptions in_file = {.forms = in_csv};
  std::vector<Column> columns = {row("name", Kind::words, heading, &NamedDesign::name, shown),
                                 row("rank", Kind::words, "", &NamedDesign::name, in_file),
                                 row("mounts", Kind::words, "", mounts, {.forms = in_json})};
  for (std::size_t c = 0; c < found.choices.size(); ++c) {
    const std::string& name = found.choices[c].name;
    const auto mount = [&choice = found.choices[c], c](const MountDesign& design) {
      return design.mounts.empty() ? "as given" : choice.mounts[design.mounts[c]];
    };
    columns.push_back(row("mount", Kind::words, name, mount, shown));
    columns.push_back(row(name, Kind::words, "", mount, in_file));
  }
  const auto add = [&](const char* name, Kind kind, const char* head, auto value, ColumnOptions options = {}) {
    columns.push_back(row(name, kind, head, value, std::move(options)));
  };
  add("margin", Kind::number, "", &MountDesign::margin);
  add("margin_words", Kind::number, "margin", margin_words, shown);
  add("met", Kind::yes_no, "feasible", &MountDesign::met);
  add("governing", Kind::words, "", &MountDesign::governing);
  add("governing_words", Kind::words, "governing", governing_words, shown);
  add("reason", Kind::words, "", &MountDesign::reason);
  add("load", Kind::share, "load", &MountDesign::load);
  add("deflection", Kind::quantity, "sag after creep", &MountDesign::deflection, {.unit = "m", .digits = 3});
  add("lowest_angular_frequency", Kind::frequency, "lowest", &MountDesign::lowest, {.digits = 4});
  add("highest_angular_frequency", Kind::frequency, "highest", &MountDesign::highest, {.digits = 4});
  add("transmissibility", Kind::number, "", &MountDesign::transmissibility);
  add("transmits", Kind::words, "transmits (isolation)", transmitted_words, shown);
  add("price", Kind::number, "", [](const MountDesign& d) { return d.price ? Json(d.price->amount) : Json(); });
  add("currency", Kind::words, "", [](const MountDesign& d) { return d.price ? d.price->currency : ""; });
  add(
      "price_words", Kind::number, "price",
      [](const MountDesign& d) { return d.price ? project::price_words(*d.price) : "–"; }, shown);
  add("mass", Kind::number, "mass", &MountDesign::mass, {.unit = "kg", .digits = 4});
  return {.key = whole_json, .rows = row.size(), .columns = std::move(columns)};
}

Json design_json(const MountSelection& found, const MountDesign& design) {
  return as_json({{{design_table(found, "", {{design, ""}})}}}).front();
}

std::vector<NamedDesign> best_with_each(const MountSelection& found, std::size_t choice) {
  std::vector<NamedDesign> designs;
  for (const study::MountOption& one : found.options)
    if (one.choice == choice) designs.push_back({one.best, found.choices[choice].mounts[one.mount]});
  return designs;
}

Json choices_json(const MountSelection& found) {
  Json choices = Json::array();
  for (const project::MountChoice& choice : found.choices) {
    Json mounts = Json::array();
    for (const NamedDesign& one : best_with_each(found, choices.size()))
      mounts.push_back({{"mount", one.name}, {"best", design_json(found, one)}});
    choices.push_back({{"name", choice.name}, {"elements", choice.elements}, {"mounts", std::move(mounts)}});
  }
  return choices;
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
  return text + ".";
}

void add_search(const MountSelection& found, Document& document) {
  const auto say = [&](std::string words) { document.add(Sentence{.parts = {std::move(words)}}); };
  say(is_exchange(found)
          ? fmt::format("Best found of {} combinations, too many to judge all: mounts of a few choices at a time were "
                        "exchanged and {} combinations judged, all requirements of {}. No such exchange gains "
                        "anything; that proves nothing about the others.",
                        found.all_combinations, found.combinations, found.judged)
          : judged_text(found));
  if (!found.without_curves.empty())
    say("Amplitudes and peaks were computed one by one: " + found.without_curves + ".");
  if (!found.without_bounds.empty())
    say((found.curves > 0 ? "Loads and natural frequencies were computed one by one: "
                          : "All had to be computed one by one: ") +
        found.without_bounds + ".");
}

/// The best designs beside the given one, and what each mount reaches.
void add_designs(const MountSelection& found, std::vector<NamedDesign> best, Document& document) {
  const NamedDesign& first = best.front();
  document.add(Sentence{
      .parts = {first.met
                    ? best_in(found.by) + " combination of mounts with which every requirement is met, least margin "
                    : "NO combination of mounts meets every requirement; the largest least margin is ",
                margin_words(first)}});
  best.push_back({found.given, "given"});
  const bool any = std::ranges::any_of(best, [](const NamedDesign& one) { return one.transmissibility.has_value(); });
  Table& ranked = document.add(design_table(found, "rank", std::move(best)));
  ranked.file = "select.csv";
  ranked.forms = for_people | in_csv;
  document.add(Sentence{.parts = {any ? "transmits: " + found.transmissibility : ""}, .place = Sentence::Place::note});
  Group& options = document.add(Group{.title = is_exchange(found)
                                          ? "What each mount reaches with the others of the first combination:"
                                          : "What each mount reaches with the best of the others:"});
  for (std::size_t c = 0; c < found.choices.size(); ++c) {
    Table table = design_table(found, found.choices[c].name, best_with_each(found, c));
    table.people = {"name", "margin_words", "met", "governing_words"};
    table.most_rows = 12;
    table.forms = for_people;
    options.parts.push_back({std::move(table)});
  }
  add_search(found, document);
}

}  // namespace

Document selection_document(const MountSelection& found, const foundation::Problems& warnings) {
  std::vector<NamedDesign> best;
  for (const MountDesign& design : found.best) best.push_back({design, std::to_string(best.size() + 1)});
  Document document;
  const auto add = [&](const char* name, Json value) { document.add(Single{.name = name, .value = std::move(value)}); };
  add("by", study::name(found.by));
  add("all_combinations", found.all_combinations);
  add("combinations", found.combinations);
  add("curves", found.curves);
  add("without_curves", found.without_curves);
  add("judged", found.judged);
  add("without_bounds", found.without_bounds);
  add("cases", found.cases);
  const Rows failed(found.failed);
  document.add(Table{.key = "failed",
                     .rows = failed.size(),
                     .columns = {failed("test", Kind::words, "", &MountSelection::Failed::test),
                                 failed("combinations", Kind::number, "", &MountSelection::Failed::combinations)}});
  add("choices", choices_json(found));
  add("given", design_json(found, found.given));
  add("best", as_json({{{design_table(found, "", best)}}}));
  add("warnings", json::warnings(warnings));
  add_designs(found, std::move(best), document);
  return document;
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

}  // namespace trivet::results
