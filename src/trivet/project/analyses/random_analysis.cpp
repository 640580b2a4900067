// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/analysis_types.h"

#include <algorithm>
#include <array>

#include "trivet/project/analyses/analysis_reader.h"
#include "trivet/project/text/bands_reader.h"
#include "trivet/project/text/shared_keys.h"

namespace trivet::project {
namespace {

RandomAnalysis read_random(TableReader& reader, const ResultNames& names, const SymbolTable& symbols) {
  RandomAnalysis request;
  read_selection(reader, names, symbols.random_excitations, "random", request.selection);
  using excitation::Weighting;
  static const std::array<std::pair<const char*, Weighting>, 8> weightings = {{{"Wb", Weighting::Wb},
                                                                               {"Wc", Weighting::Wc},
                                                                               {"Wd", Weighting::Wd},
                                                                               {"We", Weighting::We},
                                                                               {"Wf", Weighting::Wf},
                                                                               {"Wj", Weighting::Wj},
                                                                               {"Wk", Weighting::Wk},
                                                                               {"Wm", Weighting::Wm}}};
  std::vector<std::string> words;
  for (const auto& weighting : weightings) words.emplace_back(weighting.first);
  using excitation::ContactPoint;
  static const std::array<std::pair<const char*, ContactPoint>, 4> contacts = {{{"seat", ContactPoint::seat_surface},
                                                                                {"backrest", ContactPoint::backrest},
                                                                                {"feet", ContactPoint::feet},
                                                                                {"standing", ContactPoint::standing}}};
  for (const auto& contact : contacts) words.emplace_back(contact.first);
  const auto word = reader.choice("weighting", words);
  for (const auto& [name, contact] : contacts)
    if (word == name) request.contact = contact;
  if (word)
    for (const auto& [name, weighting] : weightings)
      if (*word == name) request.weighting = weighting;
  request.bands = read_bands(reader, "bands");
  const std::vector<std::string>& of = request.selection.of;
  if (word && std::ranges::all_of(of, [&](const std::string& name) { return names.is_force(name); }))
    warn_at_key(reader, "weighting", "\"" + *word + "\" of forces alone",
                "it applies to motions only, and no motion is requested", "remove it, or request motions");
  return request;
}

}  // namespace

const AnalysisReader random_analysis = read_into<&Analyses::random, read_random>(
    {.drive = Drive::random, .keys = R"json({"description": "root mean squares under the random excitations",
  "properties": {
   "of": {"$ref": "#/$defs/answers_of"},
   "quantity": {"$ref": "#/$defs/quantity"},
   "excitations": {"$ref": "#/$defs/selected_excitations"},
   "weighting": {"enum": ["Wb", "Wc", "Wd", "We", "Wf", "Wj", "Wk", "Wm", "seat", "backrest", "feet",
     "standing"],
     "description": "of ISO 2631, one for all results; or the place of a person: the weighting of each axis there"},
   "bands": {"$ref": "#/$defs/bands"}}})json"});

}  // namespace trivet::project
